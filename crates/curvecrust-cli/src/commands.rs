//! The commands, one file each.

pub(crate) mod algorithms;
mod bare_points;
mod curves;
pub(crate) mod lfs;
pub(crate) mod reconstruct;
pub(crate) mod sample;

/// How a command that could be carried out ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// All is well.
    Fine,
    /// A condition does not hold, or an evaluation found faults: exit status 1.
    Failed,
}

impl Outcome {
    pub(crate) fn fine_if(all_is_well: bool) -> Self {
        if all_is_well {
            Self::Fine
        } else {
            Self::Failed
        }
    }
}
