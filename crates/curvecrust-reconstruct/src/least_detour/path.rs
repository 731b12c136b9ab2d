//! Alternating paths: edges of a matching that are removed and added by turns.

use super::constants::DEPTH;
use super::matching::NONE;

/// The number of steps of the longest path: it may begin with two removals.
const LONGEST: usize = 2 * DEPTH + 2;

/// A step of a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Step {
    Remove(u32, u32),
    Add(u32, u32),
}

/// Edges that are removed and added alternately.
#[derive(Clone, Copy, Debug)]
pub(super) struct Path {
    steps: [Step; LONGEST],
    pub(super) len: usize,
}

impl Path {
    pub(super) const EMPTY: Self = Self {
        steps: [Step::Remove(NONE, NONE); LONGEST],
        len: 0,
    };

    pub(super) fn steps(&self) -> &[Step] {
        &self.steps[..self.len]
    }

    pub(super) fn push(&mut self, step: Step) {
        self.steps[self.len] = step;
        self.len += 1;
    }

    pub(super) fn removes(&self, v: u32, w: u32) -> bool {
        let steps = self.steps().iter();
        let mut removed = steps.filter_map(|step| match *step {
            Step::Remove(a, b) => Some([a, b]),
            Step::Add(..) => None,
        });
        removed.any(|ends| ends == [v, w] || ends == [w, v])
    }

    pub(super) fn adds(&self, v: u32, w: u32) -> bool {
        let either = [Step::Add(v, w), Step::Add(w, v)];
        self.steps().iter().any(|step| either.contains(step))
    }
}
