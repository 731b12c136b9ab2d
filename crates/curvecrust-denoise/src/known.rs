//! Chains that agree with what is known about the curves.

use glam::DVec2;

use curvecrust_geometry::PointSet;
use curvecrust_reconstruct::{LeastDetour, Reconstructor, Shape};

use crate::chain::{Chain, Place};
use crate::options::Options;

/// The chains as they are known to be: those with the most places, and if they still disagree, the
/// chains of least detour through their places that agree.
///
/// If there are none, the chains as they are: an estimate is worth more than nothing.
pub(crate) fn agreeing(mut chains: Vec<Chain>, places: &[Place], options: &Options) -> Vec<Chain> {
    let wanted = options.curves.map(|n| n.get() as usize);
    if let Some(wanted) = wanted {
        chains.sort_by_key(|chain| std::cmp::Reverse(chain.vertices.len()));
        chains.truncate(wanted);
    }
    let agrees = |chain: &Chain| match options.shape {
        None => true,
        Some(shape) => chain.closed == (shape == Shape::Closed),
    };
    let enough = wanted.is_none_or(|wanted| wanted == chains.len());
    if enough && chains.iter().all(agrees) {
        return chains;
    }
    let mut used: Vec<usize> = chains
        .iter()
        .flat_map(|c| c.vertices.iter().copied())
        .collect();
    used.sort_unstable();
    let moved = used.iter().map(|&v| places[v].at + DVec2::ONE).collect();
    let Ok(merged) = PointSet::merging_duplicates(moved) else {
        return chains;
    };
    let Ok(edges) = LeastDetour.reconstruct_known(&merged.points, &options.known()) else {
        return chains;
    };
    let found = edges.chains().into_iter().map(|chain| Chain {
        closed: chain.is_closed(),
        vertices: chain
            .vertices()
            .iter()
            .map(|v| used[merged.origin[v.index()]])
            .collect(),
    });
    found.filter(|chain| chain.vertices.len() >= 3).collect()
}
