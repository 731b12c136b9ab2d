//! How this program is started again, as a process of its own.

use std::ffi::OsString;
use std::sync::OnceLock;

/// The words of the command.
static WORDS: OnceLock<Vec<OsString>> = OnceLock::new();

/// Settles the words of the command for this process; later ones do not count.
pub(crate) fn set(words: Vec<OsString>) {
    let _ = WORDS.set(words);
}

/// The words of the command: the program and its first arguments. There are none where the program
/// does not know how it was started.
#[cfg(feature = "las")]
pub(crate) fn words() -> Option<&'static [OsString]> {
    WORDS.get().map(Vec::as_slice)
}
