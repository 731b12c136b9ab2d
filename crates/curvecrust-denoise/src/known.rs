//! Chains that agree with what is known about the curves.

use curvecrust_reconstruct::{Known, LeastDetour, Reconstructor, Shape};

use crate::chain::{Chain, Place, as_set, chains_of};
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
    through(&chains, places, &options.known()).unwrap_or(chains)
}

/// The chains of least detour through the places of some chains, in agreement with what is known;
/// `None` if there are none.
pub(crate) fn through(chains: &[Chain], places: &[Place], known: &Known) -> Option<Vec<Chain>> {
    let along = chains.iter().flat_map(|c| c.vertices.iter().copied());
    let mut used: Vec<usize> = along.collect();
    used.sort_unstable();
    let set = as_set(used.iter().map(|&v| places[v].at))?;
    let edges = LeastDetour.reconstruct_known(&set.points, known).ok()?;
    Some(chains_of(&edges, |v| used[set.origin[v]]))
}
