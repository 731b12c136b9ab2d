//! Puts a folder in place: whole, or not at all.

use anyhow::{Context, bail};
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// A file to write: its path in the folder, and its text.
pub(super) type File = (String, String);

/// Writes the files to a fresh folder beside `target` and swaps it in; says whether it replaced
/// one.
///
/// Refuses, unless `force`, to replace a target that holds anything else than files of these names.
pub(super) fn install(files: &[File], target: &Path, force: bool) -> anyhow::Result<bool> {
    if !force {
        refuse_foreign(files, target)?;
    }
    let beside = target.parent().context("no folder to write to")?;
    fs::create_dir_all(beside).with_context(|| format!("cannot create {}", beside.display()))?;
    // On the same file system, so that a rename is enough.
    let stage = tempfile::Builder::new()
        .prefix(".paper-")
        .tempdir_in(beside)
        .with_context(|| format!("cannot write to {}", beside.display()))?;
    let (new, old) = (stage.path().join("new"), stage.path().join("old"));
    for (name, text) in files {
        let path = new.join(name);
        write(&path, text).with_context(|| format!("cannot write {}", path.display()))?;
    }
    let replaced = swap(&new, target, &old)
        .with_context(|| format!("cannot put {} in place", target.display()))?;
    stage
        .close()
        .context("all is in place, but a temporary folder beside it could not be removed")?;
    Ok(replaced)
}

fn write(path: &Path, text: &str) -> std::io::Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    fs::write(path, text)
}

/// Moves `target`, if there is one, to `old`, and `new` to `target`; undoes the first if the second
/// fails.
fn swap(new: &Path, target: &Path, old: &Path) -> std::io::Result<bool> {
    let replaced = match fs::rename(target, old) {
        Ok(()) => true,
        Err(error) if error.kind() == ErrorKind::NotFound => false,
        Err(error) => return Err(error),
    };
    if let Err(error) = fs::rename(new, target) {
        if replaced {
            fs::rename(old, target)?;
        }
        return Err(error);
    }
    Ok(replaced)
}

fn refuse_foreign(files: &[File], target: &Path) -> anyhow::Result<()> {
    let is_ours = |path: &Path| files.iter().any(|(name, _)| target.join(name) == path);
    if !target.try_exists().unwrap_or(true) {
        return Ok(());
    }
    let present = files_below(target)?;
    if let Some(foreign) = present.iter().find(|path| !is_ours(path)) {
        bail!(
            "{} is none of the files that would be written, and would be lost: \
             move it away, or pass --force to replace the whole folder",
            foreign.display()
        );
    }
    Ok(())
}

/// Everything below a folder that is not itself a folder, sorted; `.git` is passed over, links are
/// not followed.
pub(super) fn files_below(folder: &Path) -> anyhow::Result<Vec<PathBuf>> {
    let context = || format!("cannot read the folder {}", folder.display());
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).with_context(context)? {
        let entry = entry.with_context(context)?;
        if !entry.file_type().with_context(context)?.is_dir() {
            files.push(entry.path());
        } else if entry.file_name() != ".git" {
            files.extend(files_below(&entry.path())?);
        }
    }
    files.sort();
    Ok(files)
}
