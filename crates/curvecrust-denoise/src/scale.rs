//! The scale of a point: the smallest neighbourhood that is not round.
//!
//! Points about a curve look like a round cloud as long as the neighbourhood is as small as the
//! noise, and like a stroke beyond. The exact test of sphericity in the plane tells the two apart:
//! for k points of a round normal cloud, V = 4 det S / (tr S)^2 of their scatter matrix S is below
//! v with probability v^((k - 2) / 2). Neither a distance nor a noise level goes in.
//!
//! Source: J. Mauchly, *Significance Test for Sphericity of a Normal n-Variate Distribution*, 1940.

use glam::DVec2;
use rayon::prelude::*;

use curvecrust_geometry::Interrupt;

use crate::robust::median;
use crate::tree::Tree;

/// The smallest neighbourhood that is tested, the point itself included.
const FEWEST: usize = 6;
/// The largest one.
const MOST: usize = 160;
/// How many neighbours of a point without a scale of its own are asked for theirs.
const ASKED: usize = 32;
/// By how many tests a false alarm is to be divided, a point.
const TESTS: f64 = 8.0;

/// Of more points than this some stand for those about them.
const MANY: usize = 5_000;
/// A point stands for those within this share of its radius.
const COVER: f64 = 0.35;

/// How wide the windows about points have to be.
pub(crate) struct Scales {
    /// By point; `None` where neither the point nor enough of its neighbours have a scale.
    pub(crate) radii: Vec<Option<f64>>,
    /// The point that stands for each, which may be itself.
    pub(crate) centres: Vec<usize>,
}

#[derive(Default)]
struct Neighbourhood {
    members: Vec<usize>,
    radius: Option<f64>,
}

/// The scale of each point.
///
/// `alarms` is the number of round neighbourhoods among all that may pass for strokes.
pub(crate) fn scales(points: &[DVec2], tree: &Tree, alarms: f64) -> Scales {
    let threshold = (alarms / (TESTS * points.len() as f64)).ln().min(-1.0);
    let (centres, around) = match points.len() > MANY {
        true => some(points, tree, threshold),
        false => all(points, tree, threshold),
    };
    let radius = |own: &Neighbourhood| {
        let radii = own
            .members
            .iter()
            .filter_map(|&j| around[centres[j]].radius);
        let mut radii: Vec<f64> = radii.collect();
        let enough = (own.members.len() / 4).max(2);
        if radii.len() >= enough {
            Some(median(&mut radii))
        } else {
            own.radius
        }
    };
    let own: Vec<Option<f64>> = around.par_iter().map(radius).collect();
    Scales {
        radii: centres.iter().map(|&c| own[c]).collect(),
        centres,
    }
}

/// Each point stands for itself.
fn all(points: &[DVec2], tree: &Tree, threshold: f64) -> (Vec<usize>, Vec<Neighbourhood>) {
    let interrupt = Interrupt::current();
    let around = points.par_iter().map(|&p| {
        interrupt.check();
        neighbourhood(points, tree, p, threshold)
    });
    ((0..points.len()).collect(), around.collect())
}

/// One point after the other stands for those about it that none stands for yet. The
/// neighbourhoods of others are empty.
fn some(points: &[DVec2], tree: &Tree, threshold: f64) -> (Vec<usize>, Vec<Neighbourhood>) {
    let interrupt = Interrupt::current();
    let mut centres: Vec<Option<usize>> = vec![None; points.len()];
    let mut around = Vec::with_capacity(points.len());
    for (i, &p) in points.iter().enumerate() {
        if centres[i].is_some() {
            around.push(Neighbourhood::default());
            continue;
        }
        interrupt.check();
        let own = neighbourhood(points, tree, p, threshold);
        for j in own.radius.map_or(Vec::new(), |r| tree.within(p, COVER * r)) {
            centres[j] = centres[j].or(Some(i));
        }
        centres[i] = Some(i);
        around.push(own);
    }
    let centres = centres.into_iter().enumerate();
    (centres.map(|(i, c)| c.unwrap_or(i)).collect(), around)
}

fn neighbourhood(points: &[DVec2], tree: &Tree, p: DVec2, threshold: f64) -> Neighbourhood {
    let (mut sum, mut squares, mut product) = (DVec2::ZERO, DVec2::ZERO, 0.0);
    let mut members = Vec::with_capacity(ASKED);
    for (j, squared) in tree.nearest(p).take(MOST) {
        let d = points[j] - p;
        sum += d;
        squares += d * d;
        product += d.x * d.y;
        members.push(j);
        let count = members.len() as f64;
        if members.len() < FEWEST {
            continue;
        }
        let scatter = squares - sum * sum / count;
        let mixed = product - sum.x * sum.y / count;
        let trace = scatter.x + scatter.y;
        let floor = 1e-14 * trace * trace;
        let determinant = (scatter.x * scatter.y - mixed * mixed).max(floor);
        let roundness = (4.0 * determinant / (trace * trace)).min(1.0);
        if 0.5 * (count - 2.0) * roundness.ln() < threshold {
            let radius = Some(squared.sqrt());
            return Neighbourhood { members, radius };
        }
    }
    members.truncate(ASKED);
    Neighbourhood {
        members,
        radius: None,
    }
}
