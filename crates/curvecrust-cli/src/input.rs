//! Where data come from: a file, or stdin by the name `-`.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Cursor, ErrorKind, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// Bytes that are looked at in one go before a source is read.
const HEAD: usize = 4096;
/// Bytes that are looked at at most; a file may start with a long comment.
const LONGEST_HEAD: usize = 1 << 24;
/// Read from the system at once.
const BUFFER: usize = 1 << 16;

/// An opened source, of which the first bytes are known.
pub(crate) struct Source {
    head: Vec<u8>,
    rest: Box<dyn BufRead>,
    /// The file itself and its path, if it is one that can be read from any place.
    file: Option<(File, PathBuf)>,
}

/// All of a source, from any place.
pub(crate) enum Seekable {
    /// A file.
    File(File),
    /// What cannot be read from any place, such as a pipe, is held in memory.
    Memory(Cursor<Vec<u8>>),
}

impl Source {
    /// Opens it and reads its first bytes.
    pub(crate) fn open(path: &Path) -> io::Result<Self> {
        if is_standard(path) {
            Self::new(io::stdin().lock())
        } else {
            let file = File::open(path)?;
            let again = match file.metadata()?.is_file() {
                true => Some((file.try_clone()?, path.to_owned())),
                false => None,
            };
            let source = Self::new(BufReader::with_capacity(BUFFER, file))?;
            Ok(Self {
                file: again,
                ..source
            })
        }
    }

    /// Reads its first bytes; the byte order mark of UTF-8 is left out.
    pub(crate) fn new(mut rest: impl BufRead + 'static) -> io::Result<Self> {
        let mut head = Vec::with_capacity(HEAD);
        rest.by_ref().take(HEAD as u64).read_to_end(&mut head)?;
        if head.starts_with(b"\xef\xbb\xbf") {
            head.drain(..3);
        }
        let rest = Box::new(rest);
        Ok(Self {
            head,
            rest,
            file: None,
        })
    }

    /// The first bytes, all there are if they are few.
    pub(crate) fn head(&self) -> &[u8] {
        &self.head
    }

    /// Reads until the first bytes are enough, or all there are.
    pub(crate) fn peek(&mut self, is_enough: impl Fn(&[u8]) -> bool) -> io::Result<&[u8]> {
        while self.head.len() < LONGEST_HEAD && !is_enough(&self.head) {
            let more = self.head.len().max(HEAD) as u64;
            if self.rest.by_ref().take(more).read_to_end(&mut self.head)? == 0 {
                break;
            }
        }
        Ok(&self.head)
    }

    /// Everything, from the start.
    pub(crate) fn into_reader(self) -> impl BufRead {
        Cursor::new(self.head).chain(self.rest)
    }

    /// Hands everything on, until nobody takes it.
    pub(crate) fn hand_on(self, mut to: impl Write) -> io::Result<()> {
        let mut all = self.into_reader();
        loop {
            let bytes = match all.fill_buf() {
                Err(error) if error.kind() == ErrorKind::Interrupted => continue,
                bytes => bytes?,
            };
            if bytes.is_empty() || to.write_all(bytes).is_err() {
                return Ok(());
            }
            let length = bytes.len();
            all.consume(length);
        }
    }

    /// Everything at once.
    pub(crate) fn into_bytes(mut self) -> io::Result<Vec<u8>> {
        self.rest.read_to_end(&mut self.head)?;
        Ok(self.head)
    }
}

impl Source {
    /// The file, at its start; `None` if it cannot be read from any place.
    pub(crate) fn file(&self) -> io::Result<Option<File>> {
        let Some((file, _)) = &self.file else {
            return Ok(None);
        };
        let mut file = file.try_clone()?;
        file.rewind()?;
        Ok(Some(file))
    }

    /// The data, to be read from any place; they are held in memory unless they are a file.
    pub(crate) fn into_seekable(self) -> io::Result<Seekable> {
        match self.file {
            Some((mut file, _)) => {
                file.rewind()?;
                Ok(Seekable::File(file))
            }
            None => Ok(Seekable::Memory(Cursor::new(self.into_bytes()?))),
        }
    }

    /// The start, of at most some length, of the file of the same name with another ending;
    /// `None` without one.
    pub(crate) fn beside(&self, ending: &str, most: u64) -> Option<Vec<u8>> {
        let (_, path) = self.file.as_ref()?;
        let file = File::open(path.with_extension(ending)).ok()?;
        let mut bytes = Vec::new();
        file.take(most).read_to_end(&mut bytes).ok()?;
        Some(bytes)
    }
}

impl Seekable {
    /// Stdin, which has to be a file.
    pub(crate) fn standard_file() -> io::Result<Self> {
        #[cfg(unix)]
        let file = std::os::fd::AsFd::as_fd(&io::stdin()).try_clone_to_owned();
        #[cfg(windows)]
        let file = std::os::windows::io::AsHandle::as_handle(&io::stdin()).try_clone_to_owned();
        #[cfg(not(any(unix, windows)))]
        let file: io::Result<File> = Err(ErrorKind::Unsupported.into());
        let mut file = File::from(file?);
        file.rewind()?;
        Ok(Self::File(file))
    }

    /// Stdin, held in memory.
    pub(crate) fn standard_pipe() -> io::Result<Self> {
        let mut bytes = Vec::new();
        io::stdin().lock().read_to_end(&mut bytes)?;
        Ok(Self::Memory(Cursor::new(bytes)))
    }

    /// The number of its bytes.
    pub(crate) fn size(&self) -> io::Result<u64> {
        match self {
            Self::File(file) => Ok(file.metadata()?.len()),
            Self::Memory(bytes) => Ok(bytes.get_ref().len() as u64),
        }
    }
}

impl Read for Seekable {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        match self {
            Self::File(file) => file.read(buffer),
            Self::Memory(bytes) => bytes.read(buffer),
        }
    }
}

impl Seek for Seekable {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        match self {
            Self::File(file) => file.seek(to),
            Self::Memory(bytes) => bytes.seek(to),
        }
    }
}

/// Whether a path means stdin or stdout.
pub(crate) fn is_standard(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// How messages call a source.
pub(crate) fn name(path: &Path) -> String {
    if is_standard(path) {
        String::from("stdin")
    } else {
        path.display().to_string()
    }
}
