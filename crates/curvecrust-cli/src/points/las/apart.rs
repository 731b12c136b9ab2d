//! Packed points by a process of their own: damaged data may make the crate `laz` call itself until
//! the stack is full, and this ends a process.
//!
//! The program starts itself again. The other process reads the file from its stdin and writes
//! [`frames`] to its stdout. It ends when nobody reads them any more.

use super::frames::{self, Frame, Frames};
use super::{Part, Problem, decode};
use crate::again;
use crate::input::{Seekable, Source};
use crate::points::Flaw;
use std::ffi::OsString;
use std::io::{self, ErrorKind, Write};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread;

/// The first argument of the other process; no command has this name.
const NAME: &str = "__decode-laz";

/// Its second argument: whether its stdin is the file or a pipe.
const FILE: &str = "file";
const PIPE: &str = "pipe";

/// The stack of the thread that unpacks, in bytes. Sound data need a small part of it.
const STACK: usize = 1 << 19;

/// The process that unpacks. It ends when this is dropped.
pub(super) struct Decoder(Child);

impl Decoder {
    /// Starts it for a source; `None` where no process can be started.
    pub(super) fn start(source: &Source) -> Option<Self> {
        let (program, words) = again::words()?.split_first()?;
        let file = source.file().ok()?;
        let kind = if file.is_some() { FILE } else { PIPE };
        Command::new(program)
            .args(words)
            .args([NAME, kind])
            .stdin(file.map_or_else(Stdio::piped, Stdio::from))
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .ok()
            .map(Self)
    }

    /// Takes what it finds in the source, part by part.
    pub(super) fn read(
        mut self,
        source: Source,
        take: &mut dyn FnMut(Part<'_>) -> Result<(), Flaw>,
    ) -> Result<(), Flaw> {
        if let Some(stdin) = self.0.stdin.take() {
            source.hand_on(stdin)?;
        }
        let pipe = self.0.stdout.take().ok_or(ErrorKind::BrokenPipe);
        let mut frames = Frames::new(pipe.map_err(io::Error::from)?);
        loop {
            match frames.next() {
                Some(Frame::Part(part)) => take(part)?,
                Some(Frame::Flaw(flaw)) => return Err(flaw),
                Some(Frame::End) => return Ok(()),
                None => break,
            }
        }
        // It does not say anything any more; it may still run.
        let _ = self.0.kill();
        Err(Problem::Laz(how_it_ended(self.0.wait()?)).into())
    }
}

impl Drop for Decoder {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

fn how_it_ended(status: ExitStatus) -> String {
    #[cfg(unix)]
    if let Some(signal) = std::os::unix::process::ExitStatusExt::signal(&status) {
        return format!("signal {signal} ended its decoder");
    }
    match status.code() {
        Some(code) => format!("its decoder ended with status {code}"),
        None => "its decoder ended".to_owned(),
    }
}

/// Does the work of the other process if the arguments of this one ask for it, and returns the exit
/// code.
pub(crate) fn serve(args: &[OsString]) -> Option<u8> {
    let (name, kind) = (args.get(1)?, args.get(2)?);
    if name != NAME {
        return None;
    }
    let work = match kind.to_str() {
        Some(FILE) => || unpack(Seekable::standard_file()),
        _ => || unpack(Seekable::standard_pipe()),
    };
    let thread = thread::Builder::new().stack_size(STACK).spawn(work);
    Some(match thread {
        Ok(thread) => thread.join().unwrap_or(101),
        Err(_) => work(),
    })
}

/// Writes what is found in a source to stdout.
fn unpack(source: io::Result<Seekable>) -> u8 {
    let mut out = io::stdout().lock();
    let mut bytes = Vec::new();
    let mut say = |frame: Frame<'_>| -> io::Result<()> {
        frames::encode(&frame, &mut bytes);
        out.write_all(&bytes)?;
        out.flush()
    };
    let found = source.map_err(Flaw::from);
    let found = found.and_then(|source| decode(source, &mut |part| Ok(say(Frame::Part(part))?)));
    // Where nobody reads, this fails too.
    let message = say(found.map_or_else(Frame::Flaw, |()| Frame::End));
    u8::from(message.is_err())
}
