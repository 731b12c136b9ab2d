//! Where the repository is.

use std::path::{Path, PathBuf};

/// The root of the repository this program was built in, whatever the working directory.
pub(crate) fn root() -> PathBuf {
    let xtask = Path::new(env!("CARGO_MANIFEST_DIR"));
    xtask.parent().unwrap_or(xtask).to_path_buf()
}
