//! A bar with the time left, where somebody can see it.

use indicatif::{ProgressBar, ProgressStyle};

/// A progress bar over a number of trials.
pub(super) fn bar(total: u64) -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:32} {percent:>3} %  {msg}, {eta} left")
        .unwrap_or_else(|_| ProgressStyle::default_bar());
    ProgressBar::new(total).with_style(style)
}
