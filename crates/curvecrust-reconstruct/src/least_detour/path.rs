//! Alternating paths: edges of a matching that are removed and added by turns.

use super::constants::DEPTH;
use super::search_graph::{NO_ARC, SearchGraph};

/// The number of steps of the longest path: it may begin with two removals.
const LONGEST: usize = 2 * DEPTH + 2;

/// A step of a path, with an arc of the edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Step {
    Remove(usize),
    Add(usize),
}

/// Edges that are removed and added alternately.
#[derive(Clone, Copy, Debug)]
pub(super) struct Path {
    steps: [Step; LONGEST],
    pub(super) len: usize,
}

impl Path {
    pub(super) const EMPTY: Self = Self {
        steps: [Step::Remove(NO_ARC); LONGEST],
        len: 0,
    };

    pub(super) fn steps(&self) -> &[Step] {
        &self.steps[..self.len]
    }

    pub(super) fn push(&mut self, step: Step) {
        self.steps[self.len] = step;
        self.len += 1;
    }

    /// The steps that undo it.
    pub(super) fn undone(&self) -> impl Iterator<Item = Step> + Clone + '_ {
        self.steps().iter().map(|step| match *step {
            Step::Remove(arc) => Step::Add(arc),
            Step::Add(arc) => Step::Remove(arc),
        })
    }

    /// The nodes that it touches, in its order.
    pub(super) fn nodes(&self, graph: &SearchGraph<'_>) -> impl Iterator<Item = u32> {
        self.steps().iter().flat_map(|step| match *step {
            Step::Remove(arc) | Step::Add(arc) => graph.ends(arc),
        })
    }

    pub(super) fn removes(&self, graph: &SearchGraph<'_>, arc: usize) -> bool {
        let either = [arc, graph.twin(arc)].map(Step::Remove);
        self.steps().iter().any(|step| either.contains(step))
    }

    pub(super) fn adds(&self, graph: &SearchGraph<'_>, arc: usize) -> bool {
        let either = [arc, graph.twin(arc)].map(Step::Add);
        self.steps().iter().any(|step| either.contains(step))
    }
}
