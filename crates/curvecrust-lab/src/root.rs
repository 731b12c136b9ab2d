//! Where the repository is.

use std::path::{Path, PathBuf};

/// The root of the repository this program was built in, whatever the working directory.
#[must_use]
pub fn root() -> PathBuf {
    let lab = Path::new(env!("CARGO_MANIFEST_DIR"));
    lab.ancestors().nth(2).unwrap_or(lab).to_path_buf()
}
