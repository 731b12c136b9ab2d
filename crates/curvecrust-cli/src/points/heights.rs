//! Heights on the way through a file: kept on request, else only noticed.

use super::quote::quoted;
use super::value::number;
use super::{Problem, ReadOptions};
use crate::number::Number;

/// What notes say of points with more than two numbers.
pub(crate) const LEFT_OUT: &str = "heights are left out";

/// The heights of the points that were read so far.
pub(super) struct Heights {
    /// A height for every point; `None` if they are not wanted.
    kept: Option<Vec<f64>>,
    /// Whether any point has a height that says something: 0 stands for none in many files.
    any: bool,
}

impl Heights {
    pub(super) fn new(options: &ReadOptions) -> Self {
        Self {
            kept: options.heights.then(Vec::new),
            any: false,
        }
    }

    /// Whether they are kept.
    pub(super) fn are_kept(&self) -> bool {
        self.kept.is_some()
    }

    /// Takes that of the next point, if it has one.
    pub(super) fn take(&mut self, height: Option<f64>) -> Result<(), Problem> {
        self.any |= height.is_some_and(|height| height.abs() > 0.0);
        if let Some(kept) = &mut self.kept {
            let height = height.ok_or(Problem::NoHeight)?;
            if !height.is_finite() {
                return Err(Problem::NotFinite(Number(height).to_string()));
            }
            kept.push(height);
        }
        Ok(())
    }

    /// That which a word stands for, which need not be a number if none is wanted.
    pub(super) fn of_word(
        &self,
        word: Option<&[u8]>,
        has_decimal_commas: bool,
    ) -> Result<Option<f64>, Problem> {
        let Some(word) = word else { return Ok(None) };
        match number(word, has_decimal_commas) {
            None if self.are_kept() => Err(Problem::NotANumber(quoted(word))),
            height => Ok(height),
        }
    }

    /// Forgets that of the last point.
    pub(super) fn pop(&mut self) {
        if let Some(kept) = &mut self.kept {
            kept.pop();
        }
    }

    /// The heights that are kept, else what the user should know of those that are not.
    pub(super) fn finish(self) -> (Option<Vec<f64>>, Option<String>) {
        let note = self.any && self.kept.is_none();
        (self.kept, note.then(|| LEFT_OUT.to_owned()))
    }
}
