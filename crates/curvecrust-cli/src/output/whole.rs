//! Files that are there whole or not at all.

use anyhow::{Context, anyhow, bail};
use std::fs::{self, File, Metadata};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, Once, PoisonError};
use tempfile::{Builder, TempPath};

/// The temporary file that is being written, for who interrupts the program. It is locked while
/// the file comes into being, gets its name or goes.
static UNFINISHED: Mutex<Option<PathBuf>> = Mutex::new(None);

/// Fails early where [`write`] could not but fail: after hours of work it would be a pity.
pub(super) fn check(path: &Path, force: bool) -> anyhow::Result<()> {
    let found = fs::metadata(path).ok();
    match found {
        Some(found) if found.is_dir() => bail!("cannot write {}: it is a folder", path.display()),
        Some(found) if found.is_file() && !force => Err(exists(path)),
        Some(_) => Ok(()),
        None if folder(path).is_dir() => Ok(()),
        None => bail!(
            "cannot write {}: there is no folder {}",
            path.display(),
            folder(path).display()
        ),
    }
}

/// Writes to a temporary file beside the target and renames it: nobody ever sees half a file. What is
/// no regular file, such as a pipe, is written to directly.
pub(super) fn write(
    path: &Path,
    force: bool,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> anyhow::Result<()> {
    let written = match fs::metadata(path) {
        Ok(found) if !found.is_file() => File::create(path).and_then(|f| buffered(f, content)),
        // Where a link leads, not the link itself.
        Ok(found) => {
            fs::canonicalize(path).and_then(|path| replace(&path, force, Some(&found), content))
        }
        Err(_) => replace(path, force, None, content),
    };
    match written {
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => Err(exists(path)),
        written => written.with_context(|| format!("cannot write {}", path.display())),
    }
}

/// Writes through a buffer, and sees whether all went out.
pub(super) fn buffered(
    out: impl Write,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let mut out = BufWriter::with_capacity(1 << 16, out);
    content(&mut out)?;
    out.flush()
}

fn exists(path: &Path) -> anyhow::Error {
    anyhow!("{} exists: pass --force to overwrite it", path.display())
}

/// The folder of a file.
fn folder(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

fn replace(
    path: &Path,
    force: bool,
    replaced: Option<&Metadata>,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let (file, temporary) = create_beside(path)?;
    let written = buffered(&file, content).and_then(|()| match replaced {
        Some(replaced) => file.set_permissions(replaced.permissions()),
        None => Ok(()),
    });
    let mut unfinished = unfinished();
    *unfinished = None;
    // On an error the temporary file goes as it is dropped.
    written?;
    if force {
        temporary.persist(path)?;
    } else {
        temporary.persist_noclobber(path)?;
    }
    Ok(())
}

/// A temporary file in the folder of the target, readable by whom a new file would be.
fn create_beside(path: &Path) -> io::Result<(File, TempPath)> {
    static CLEAN_UP: Once = Once::new();
    CLEAN_UP.call_once(|| {
        // Where signals cannot be caught, a temporary file may be left.
        let _ = ctrlc::set_handler(|| {
            if let Some(path) = unfinished().take() {
                let _ = fs::remove_file(path);
            }
            std::process::exit(130);
        });
    });
    let mut builder = Builder::new();
    builder.prefix(".curvecrust-").suffix(".part");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // What the umask leaves of it.
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    let mut unfinished = unfinished();
    let created = builder.tempfile_in(folder(path)).map_err(without_path)?;
    let (file, path) = created.into_parts();
    *unfinished = Some(path.to_path_buf());
    Ok((file, path))
}

/// Why a file could not come into being, without the name of the temporary one.
fn without_path(error: io::Error) -> io::Error {
    use io::ErrorKind::{NotFound, PermissionDenied, ReadOnlyFilesystem, StorageFull};
    match error.kind() {
        kind @ (NotFound | PermissionDenied | ReadOnlyFilesystem | StorageFull) => kind.into(),
        _ => error,
    }
}

fn unfinished() -> MutexGuard<'static, Option<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}
