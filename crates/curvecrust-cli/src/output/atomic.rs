//! Files that are written completely or not at all.

use anyhow::{Context, anyhow, bail};
use std::fs::{self, File, Metadata};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, Once, PoisonError};
use tempfile::{Builder, NamedTempFile, TempPath};

/// The name of a temporary file starts and ends like this.
const TEMPORARY: (&str, &str) = (".curvecrust-", ".part");

/// Links that are followed from one to the next, as in Linux.
const MOST_LINKS: usize = 40;

/// The temporary file that is being written, which is removed on an interrupt. It is locked while
/// the file is created, renamed or removed.
static UNFINISHED: Mutex<Option<PathBuf>> = Mutex::new(None);

/// A file that can be written, as far as this is known beforehand.
#[derive(Debug)]
pub(super) struct Target {
    /// The path that was given.
    path: PathBuf,
    /// Where it leads, if it is a link.
    file: PathBuf,
    kind: Kind,
    force: bool,
}

#[derive(Debug)]
enum Kind {
    /// There is no file yet.
    New,
    /// A regular file is overwritten.
    Replaced(Metadata),
    /// What is no regular file, such as a pipe, is written to directly.
    Device,
}

impl Target {
    /// Fails where [`write`](Self::write) could not but fail, before any work is done.
    pub(super) fn new(path: PathBuf, force: bool) -> anyhow::Result<Self> {
        let context = || format!("cannot write {}", path.display());
        let file = followed(&path).with_context(context)?;
        let kind = match fs::metadata(&file) {
            Ok(found) if found.is_dir() => bail!("{}: it is a folder", context()),
            Ok(found) if !found.is_file() => Kind::Device,
            Ok(_) if !force => return Err(exists(&path)),
            Ok(found) => Kind::Replaced(found),
            Err(_) => Kind::New,
        };
        let folder = folder(&file);
        if !folder.is_dir() {
            bail!("{}: there is no folder {}", context(), folder.display());
        }
        let target = Self {
            path: path.clone(),
            file,
            kind,
            force,
        };
        target.try_out().with_context(context)?;
        Ok(target)
    }

    /// Creates a temporary file, as for writing, and removes it again.
    fn try_out(&self) -> anyhow::Result<()> {
        let folder = folder(&self.file);
        match &self.kind {
            Kind::Device => return Ok(()),
            Kind::New => drop(create(folder)?),
            Kind::Replaced(found) => {
                let links = hard_links(found);
                if links > 1 {
                    bail!(
                        "it has {links} names (hard links), of which only this one would be replaced: \
                         remove it first"
                    );
                }
                take_over(create(folder)?.as_file(), found)?;
            }
        }
        remove_leftovers(folder);
        Ok(())
    }

    /// Writes to a temporary file beside the target and renames it: nobody ever sees half a file.
    pub(super) fn write(
        &self,
        content: impl FnOnce(&mut (dyn Write + Send)) -> io::Result<()>,
    ) -> anyhow::Result<()> {
        let written = match &self.kind {
            Kind::Device => File::create(&self.file).and_then(|file| buffered(file, content)),
            Kind::New => self.replace(None, content),
            Kind::Replaced(found) => self.replace(Some(found), content),
        };
        match written {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => Err(exists(&self.path)),
            written => written.with_context(|| format!("cannot write {}", self.path.display())),
        }
    }

    fn replace(
        &self,
        replaced: Option<&Metadata>,
        content: impl FnOnce(&mut (dyn Write + Send)) -> io::Result<()>,
    ) -> io::Result<()> {
        let (file, temporary) = create_until_interrupted(folder(&self.file))?;
        let written = buffered(&file, content).and_then(|()| match replaced {
            Some(replaced) => take_over(&file, replaced),
            None => Ok(()),
        });
        let mut unfinished = unfinished();
        *unfinished = None;
        // On an error the temporary file is removed as it is dropped.
        written?;
        if self.force {
            temporary.persist(&self.file)?;
        } else {
            temporary.persist_noclobber(&self.file)?;
        }
        Ok(())
    }
}

/// Writes through a buffer, and reports whether everything was taken. A reader that closes its end
/// of a pipe has had enough: the rest is not written, and that is no error.
pub(super) fn buffered(
    out: impl Write + Send,
    content: impl FnOnce(&mut (dyn Write + Send)) -> io::Result<()>,
) -> io::Result<()> {
    let mut out = BufWriter::with_capacity(1 << 16, out);
    match content(&mut out).and_then(|()| out.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => {
            // What is still in the buffer must not be written again.
            let _ = out.into_parts();
            Ok(())
        }
        written => written,
    }
}

fn exists(path: &Path) -> anyhow::Error {
    anyhow!("{} exists: pass --force to overwrite it", path.display())
}

/// The file that a path stands for, at the end of all links; it need not exist.
fn followed(path: &Path) -> io::Result<PathBuf> {
    let mut path = path.to_owned();
    for _ in 0..MOST_LINKS {
        match fs::read_link(&path) {
            // A relative link starts at its folder, an absolute one replaces it.
            Ok(target) => path = path.parent().unwrap_or(&path).join(target),
            Err(_) => return Ok(path),
        }
    }
    Err(io::Error::other("its links lead to each other"))
}

/// The folder of a file.
fn folder(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

/// A temporary file in a folder, readable by whom a new file would be. It is locked, so that no
/// other run takes it for a leftover.
fn create(folder: &Path) -> io::Result<NamedTempFile> {
    let mut builder = Builder::new();
    builder.prefix(TEMPORARY.0).suffix(TEMPORARY.1);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // What the umask leaves of it.
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    loop {
        let created = builder.tempfile_in(folder).map_err(without_path)?;
        // Some file systems have no locks.
        let _ = created.as_file().lock();
        // Before it was locked, another run may have removed it.
        if fs::exists(created.path())? {
            return Ok(created);
        }
    }
}

/// The same; if the program is interrupted, the file is removed.
fn create_until_interrupted(folder: &Path) -> io::Result<(File, TempPath)> {
    static CLEAN_UP: Once = Once::new();
    CLEAN_UP.call_once(|| {
        // Where signals cannot be caught, the next run removes the file.
        let _ = ctrlc::set_handler(|| {
            if let Some(path) = unfinished().take() {
                let _ = fs::remove_file(path);
            }
            std::process::exit(130);
        });
    });
    let mut unfinished = unfinished();
    let (file, path) = create(folder)?.into_parts();
    *unfinished = Some(path.to_path_buf());
    Ok((file, path))
}

/// Removes the temporary files of runs that were killed. That some stay is no reason to fail.
fn remove_leftovers(folder: &Path) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let is_ours = name
            .to_str()
            .is_some_and(|name| name.starts_with(TEMPORARY.0) && name.ends_with(TEMPORARY.1));
        if is_ours && entry.file_type().is_ok_and(|kind| kind.is_file()) {
            let lock = File::open(entry.path()).map(|file| file.try_lock());
            // A file without a lock is one that nobody writes.
            if matches!(lock, Ok(Ok(()))) {
                let _ = fs::remove_file(entry.path());
            }
        }
    }
}

/// Gives a file the owner, the group and the permissions of the one that it replaces.
fn take_over(file: &File, replaced: &Metadata) -> io::Result<()> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::{MetadataExt, fchown};
        let new = file.metadata()?;
        let owners = |file: &Metadata| (file.uid(), file.gid());
        if owners(&new) != owners(replaced) {
            let (user, group) = owners(replaced);
            fchown(file, Some(user), Some(group)).map_err(|_| {
                io::Error::other(
                    "it has another owner or group, which a new file cannot be given: remove it first",
                )
            })?;
        }
    }
    file.set_permissions(replaced.permissions())
}

/// The number of names that a file has.
fn hard_links(file: &Metadata) -> u64 {
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        file.nlink()
    }
    #[cfg(not(unix))]
    {
        let _ = file;
        1
    }
}

/// Why a file could not be created, without the name of the temporary one.
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
