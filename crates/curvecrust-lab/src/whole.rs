//! Files that are there whole or not at all.

use anyhow::Context;
use std::fs;
use std::path::Path;

/// Writes beside the target and renames: a reader never sees half a file.
///
/// # Errors
/// If the file cannot be written: with its path.
pub fn write_whole(path: &Path, text: impl AsRef<[u8]>) -> anyhow::Result<()> {
    let beside = path.with_extension("part");
    let written = fs::write(&beside, text).and_then(|()| fs::rename(&beside, path));
    if written.is_err() {
        // What is left of it, if anything; the error to report is the first.
        let _ = fs::remove_file(&beside);
    }
    written.with_context(|| format!("cannot write {}", path.display()))
}
