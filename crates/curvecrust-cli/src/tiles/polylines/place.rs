//! The folder of the result, which is there completely or not at all.

use crate::tiles::records;
use anyhow::{Context, bail};
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// The table of curves.
const TABLE: &str = "curves.npy";

/// A folder that can be written, as far as this is known beforehand.
#[derive(Debug)]
pub(crate) struct Place {
    path: PathBuf,
    /// Files are written into this one, which is renamed.
    temporary: PathBuf,
}

impl Place {
    /// A folder that is new or empty, or one of an earlier result, to be replaced with `force`.
    pub(crate) fn new(path: PathBuf, force: bool) -> anyhow::Result<Self> {
        let temporary = records::temporary(&path);
        let place = Self { path, temporary };
        let context = || place.context();
        let parent = place.path.parent().filter(|p| !p.as_os_str().is_empty());
        if let Some(parent) = parent.filter(|parent| !parent.is_dir()) {
            bail!("{}: there is no folder {}", context(), parent.display());
        }
        let result = names(&place.path).with_context(context)?;
        if !result.is_empty() && !force {
            bail!(
                "{} exists: pass --force to overwrite it",
                place.path.display()
            );
        }
        names(&place.temporary).with_context(context)?;
        Ok(place)
    }

    /// Makes the folder into which files are written.
    pub(super) fn begin(&self) -> anyhow::Result<Folder> {
        remove(&self.temporary)
            .and_then(|()| Ok(fs::create_dir(&self.temporary)?))
            .with_context(|| self.context())?;
        Ok(Folder(self.temporary.clone()))
    }

    /// Puts the folder in its place.
    pub(super) fn finish(&self) -> anyhow::Result<()> {
        remove(&self.path)
            .and_then(|()| Ok(fs::rename(&self.temporary, &self.path)?))
            .with_context(|| self.context())
    }

    fn context(&self) -> String {
        format!("cannot write the folder {}", self.path.display())
    }
}

/// The folder into which files are written.
pub(super) struct Folder(PathBuf);

impl Folder {
    /// The table of all curves.
    pub(super) fn table(&self) -> PathBuf {
        self.0.join(TABLE)
    }

    /// The table of the pieces of a tile.
    pub(super) fn pieces(&self, tile: usize) -> PathBuf {
        self.0.join(format!("tile-{tile:06}.pieces.npy"))
    }

    /// The points of the pieces of a tile.
    pub(super) fn points(&self, tile: usize) -> PathBuf {
        self.0.join(format!("tile-{tile:06}.points.npy"))
    }
}

/// The files of a result; none if there is no such folder. A folder with other files is refused.
fn names(folder: &Path) -> anyhow::Result<Vec<PathBuf>> {
    let entries = match fs::read_dir(folder) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Vec::new()),
        entries => entries?,
    };
    let mut paths = Vec::new();
    for entry in entries {
        let entry = entry?;
        let name = entry.file_name();
        if !name.to_str().is_some_and(is_of_result) {
            bail!(
                "it holds {}, which is no part of such a result: give a new or an empty folder",
                name.display()
            );
        }
        paths.push(entry.path());
    }
    Ok(paths)
}

/// Whether a file of a result has such a name, also while it is written.
fn is_of_result(name: &str) -> bool {
    let name = name.strip_suffix(".part").unwrap_or(name);
    let number = || {
        let rest = name.strip_prefix("tile-")?;
        rest.strip_suffix(".pieces.npy")
            .or(rest.strip_suffix(".points.npy"))
    };
    name == TABLE || number().is_some_and(|n| n.bytes().all(|byte| byte.is_ascii_digit()))
}

/// Removes a folder with a result, if it is there.
fn remove(folder: &Path) -> anyhow::Result<()> {
    for path in names(folder)? {
        fs::remove_file(path)?;
    }
    match fs::remove_dir(folder) {
        Err(error) if error.kind() != ErrorKind::NotFound => Err(error.into()),
        _ => Ok(()),
    }
}
