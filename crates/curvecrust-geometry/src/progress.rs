//! How far a long task is.

use std::fmt;

/// A listener to a long task: it hears how much is done, and of how much.
///
/// The task chooses what it counts; the total may change while the task learns how much there is
/// to do. The default hears nothing. A listener changes no result.
///
/// ```
/// use curvecrust_geometry::Progress;
///
/// let show = |done: usize, total: usize| println!("{done} of {total}");
/// Progress::new(&show).report(3, 10);
/// Progress::default().report(3, 10);
/// ```
#[derive(Clone, Copy, Default)]
pub struct Progress<'a> {
    listener: Option<&'a (dyn Fn(usize, usize) + Sync)>,
}

impl<'a> Progress<'a> {
    /// Calls a function with what is done and the total.
    #[must_use]
    pub fn new(listener: &'a (dyn Fn(usize, usize) + Sync)) -> Self {
        Self {
            listener: Some(listener),
        }
    }

    /// Tells the listener, if there is one, that `done` of `total` are done.
    pub fn report(self, done: usize, total: usize) {
        if let Some(listener) = self.listener {
            listener(done, total);
        }
    }
}

impl fmt::Debug for Progress<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self.listener {
            Some(_) => "Progress(listener)",
            None => "Progress(none)",
        })
    }
}
