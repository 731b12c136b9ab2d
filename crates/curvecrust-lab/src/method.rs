//! The figures of `docs/method.md`: where least detour goes on after local rules, and where it
//! fails.

use crate::compare::true_curves::{TILES, arc};
use crate::figure::Figure;
use crate::paper::figures::marked;
use curvecrust::DVec2;
use curvecrust::geometry::{PointId, PointSet};
use curvecrust::reconstruct::{
    LeastDetour, Reconstructor, hnn_crust, least_detour, one_step_crust,
};
use std::f64::consts::{PI, TAU};

/// Two circles at a gap of 0.8 spacings.
pub(crate) fn near_strands() -> anyhow::Result<Figure> {
    let circle = |count: u32, phase: f64| {
        let radius = f64::from(count) / TAU;
        arc(DVec2::ZERO, radius, phase, phase + TAU, count)
    };
    // Five samples more make a radius that is 0.8 larger.
    let points = PointSet::new([circle(25, 0.0), circle(30, 0.1)].concat())?;
    Ok(Figure {
        title: "Two circles that are nearer to each other than their samples are".to_owned(),
        columns: 2,
        panels: vec![
            marked("HNN-Crust", &points, &hnn_crust(&points)),
            marked("Least detour", &points, &least_detour(&points)),
        ],
    })
}

/// Two legs that meet at 30 degrees, closed by an arc.
pub(crate) fn sharp_corner() -> anyhow::Result<Figure> {
    let half = PI / 12.0;
    let (leg, radius) = (10.0, 10.0 * half.tan());
    let along = |angle: f64| (1..10).map(move |i| f64::from(i) * DVec2::from_angle(angle));
    let centre = DVec2::new(leg / half.cos(), 0.0);
    let touch = PI / 2.0 + half;
    let points = [DVec2::ZERO]
        .into_iter()
        .chain(along(half))
        .chain(along(-half))
        .chain(arc(centre, radius, touch, -touch, 10))
        .chain([centre + radius * DVec2::from_angle(-touch)]);
    let points = PointSet::new(points.collect())?;
    Ok(Figure {
        title: "A corner of 30 degrees".to_owned(),
        columns: 2,
        panels: vec![
            marked("One-step crust", &points, &one_step_crust(&points).crust),
            marked("Least detour", &points, &least_detour(&points)),
        ],
    })
}

/// Half circles whose ends are about two spacings apart.
pub(crate) fn facing_ends() -> anyhow::Result<Figure> {
    let half_circle = |(x, y): (f64, f64)| {
        let centre = DVec2::new(x, -y);
        let mut points = arc(centre, 3.0, 0.0, -PI, 9);
        points.push(centre - DVec2::new(3.0, 0.0));
        points
    };
    let points = PointSet::new(TILES.map(half_circle).concat())?;
    Ok(Figure {
        title: "Ends that face each other, about two spacings apart".to_owned(),
        columns: 2,
        panels: vec![
            marked("HNN-Crust", &points, &hnn_crust(&points)),
            marked("Least detour", &points, &least_detour(&points)),
        ],
    })
}

/// An arc whose ends are three spacings apart and in line: a failure, and what mends it.
pub(crate) fn gap_ahead() -> anyhow::Result<Figure> {
    let spacing = TAU / 32.0;
    let points = PointSet::new(arc(DVec2::ZERO, 1.0, 0.0, 30.0 * spacing, 30))?;
    let termini = [0, 29].map(PointId::from);
    let with_ends = LeastDetour.reconstruct_open(&points, &termini)?;
    Ok(Figure {
        title: "A gap of three spacings, straight ahead".to_owned(),
        columns: 2,
        panels: vec![
            marked("Least detour", &points, &least_detour(&points)),
            marked("The same, with the ends given", &points, &with_ends),
        ],
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the captions of the page say.
    #[test]
    fn the_figures_show_what_is_said_of_them() {
        let captions = |figure: Figure| {
            let panels = figure.panels.into_iter();
            panels.map(|panel| panel.caption).collect::<Vec<_>>()
        };
        let closed = "leaves 0, isolated 0, junctions 0";
        for figure in [near_strands().unwrap(), sharp_corner().unwrap()] {
            let captions = captions(figure);
            assert!(captions[1].contains(closed), "{captions:?}");
        }
        let facing = captions(facing_ends().unwrap());
        assert!(!facing[0].contains("leaves 10,"), "{facing:?}");
        assert!(facing[1].contains("leaves 10,"), "{facing:?}");
        let gap = captions(gap_ahead().unwrap());
        assert!(gap[0].contains(closed), "{gap:?}");
        assert!(gap[1].contains("leaves 2,"), "{gap:?}");
    }
}
