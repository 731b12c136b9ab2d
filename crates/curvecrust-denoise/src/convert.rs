//! Results in the frame and the order of the points that were given.

use glam::DVec2;

use curvecrust_geometry::{EdgeSet, PointSet, Similarity};
use curvecrust_reconstruct::Reconstruction;

use crate::fitted::{Fitted, FittedCurve, Place};
use crate::model::{Arc, Model};
use crate::spline::{Fit, Spline, breaks};

/// The result for clean points, of which some stay; the edges are between these.
pub(crate) fn clean(points: &PointSet, stays: &[bool], edges: EdgeSet) -> Fitted {
    let ids: Vec<usize> = (0..points.len()).filter(|&i| stays[i]).collect();
    let left: Vec<DVec2> = ids.iter().map(|&i| points.points()[i]).collect();
    let mut places = vec![None; points.len()];
    let mut curves = Vec::new();
    if let Ok(found) = PointSet::new(left).map(|left| Reconstruction::new(&left, edges.clone())) {
        let chains = found
            .as_ref()
            .map(Reconstruction::chains)
            .unwrap_or_default();
        let mut along: Vec<(Vec<usize>, bool)> = chains
            .iter()
            .map(|nested| {
                let vertices = nested.chain.vertices().iter();
                (
                    vertices.map(|v| ids[v.index()]).collect(),
                    nested.chain.is_closed(),
                )
            })
            .collect();
        along.sort_by_key(|(vertices, _)| std::cmp::Reverse(vertices.len()));
        for (curve, (vertices, closed)) in along.iter().enumerate() {
            for (k, &v) in vertices.iter().enumerate() {
                let parameter = k as f64;
                places[v] = Some(Place {
                    curve,
                    parameter,
                    distance: 0.0,
                });
            }
            curves.push(polyline(points, vertices, *closed));
        }
    }
    let edges = EdgeSet::new(
        points.len(),
        edges.edges().iter().filter_map(|edge| {
            let [a, b] = edge.ends().map(|v| ids.get(v.index()).copied());
            let id = |i: Option<usize>| i.and_then(curvecrust_geometry::PointId::new);
            curvecrust_geometry::Edge::new(id(a)?, id(b)?)
        }),
    );
    Fitted {
        curves,
        places,
        edges: Some(edges),
    }
}

/// Straight cubics from point to point.
fn polyline(points: &PointSet, vertices: &[usize], closed: bool) -> FittedCurve {
    let at = |v: &usize| points.points()[*v];
    let after = vertices
        .iter()
        .skip(1)
        .chain(vertices.first().filter(|_| closed));
    let straight = |(a, b): (DVec2, DVec2)| [a, a.lerp(b, 1.0 / 3.0), a.lerp(b, 2.0 / 3.0), b];
    let cubics: Vec<_> = vertices
        .iter()
        .map(at)
        .zip(after.map(at))
        .map(straight)
        .collect();
    let joints = cubics.len() + 1;
    FittedCurve {
        cubics,
        closed,
        corners: Vec::new(),
        sigma: vec![0.0; joints],
        standard_error: vec![0.0; joints],
        points: vertices.len(),
    }
}

/// The result for noisy points, given in the order and the frame of the model.
pub(crate) fn noisy(
    count: usize,
    order: &[usize],
    to_unit: Similarity,
    model: Option<&Model>,
) -> Fitted {
    let mut places = vec![None; count];
    let Some(model) = model else {
        return Fitted {
            curves: Vec::new(),
            places,
            edges: None,
        };
    };
    let mut points = vec![0; model.arcs.len()];
    for assigned in model.assigned.iter().flatten() {
        points[assigned.arc] += 1;
    }
    let mut by_size: Vec<usize> = (0..model.arcs.len()).collect();
    by_size.sort_by_key(|&arc| std::cmp::Reverse(points[arc]));
    let joints = |arc: &Arc| breaks(arc.from, arc.to);
    let joints: Vec<Vec<f64>> = model.arcs.iter().map(joints).collect();
    let mut curve_of = vec![0; model.arcs.len()];
    let mut curves = Vec::new();
    for (curve, &arc) in by_size.iter().enumerate() {
        curve_of[arc] = curve;
        let fitted = fitted_curve(&model.arcs[arc].fit, &joints[arc], points[arc], to_unit);
        curves.push(fitted);
    }
    for (&i, assigned) in order.iter().zip(&model.assigned) {
        places[i] = assigned.map(|a| Place {
            curve: curve_of[a.arc],
            parameter: parameter(&joints[a.arc], a.parameter),
            distance: to_unit.invert_length(a.distance),
        });
    }
    Fitted {
        curves,
        places,
        edges: None,
    }
}

/// The cubics between joints.
fn fitted_curve(fit: &Fit, joints: &[f64], points: usize, to_unit: Similarity) -> FittedCurve {
    let cubics: Vec<[DVec2; 4]> = fit
        .spline
        .beziers(joints)
        .into_iter()
        .map(|cubic| cubic.map(|p| to_unit.invert(p)))
        .collect();
    let lengths = |value: &dyn Fn(f64) -> f64| {
        joints
            .iter()
            .map(|&t| to_unit.invert_length(value(t)))
            .collect()
    };
    FittedCurve {
        closed: fit.spline.closed(),
        corners: corners(&fit.spline, joints),
        sigma: lengths(&|t| fit.spread.at(t)),
        standard_error: lengths(&|t| fit.standard_error(t)),
        points,
        cubics,
    }
}

/// Those of the joints of cubics that are creases, ends of an open curve aside.
#[expect(clippy::float_cmp, reason = "joints between ends are whole numbers")]
fn corners(spline: &Spline, joints: &[f64]) -> Vec<usize> {
    let joint_at = |&crease: &usize| joints.iter().position(|&t| t == crease as f64);
    let is_inner = |&k: &usize| spline.closed() || (1..joints.len() - 1).contains(&k);
    let corners = spline.creases().iter().filter_map(joint_at);
    corners.filter(is_inner).collect()
}

/// The parameter on cubics with these joints for one of the spline.
fn parameter(joints: &[f64], t: f64) -> f64 {
    let after = joints.partition_point(|&joint| joint <= t);
    match (after.checked_sub(1), joints.get(after)) {
        (Some(k), Some(&next)) => k as f64 + (t - joints[k]) / (next - joints[k]),
        (Some(k), None) => k as f64,
        (None, _) => 0.0,
    }
}
