//! What the steps give and the runner reports.

/// How a step went.
#[derive(Debug)]
pub(crate) enum Outcome {
    Passed,
    /// The step passed by this one of several ways.
    PassedBy(String),
    /// What failed.
    Failed(String),
    /// What is absent.
    Skipped(String),
}
