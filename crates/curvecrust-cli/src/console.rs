//! What people read while a command runs: stderr, which is theirs alone.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::fmt::Display;
use std::io::{IsTerminal, Write};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::Duration;

/// Messages and progress on stderr. That nobody can read them is no reason to fail.
#[derive(Debug)]
pub(crate) struct Console {
    quiet: bool,
}

impl Console {
    pub(crate) fn new(quiet: bool) -> Self {
        Self { quiet }
    }

    /// A line about what was done, unless `--quiet` was given.
    pub(crate) fn say(&self, line: impl Display) {
        if !self.quiet {
            let _ = writeln!(std::io::stderr(), "{line}");
        }
    }

    /// Why the command could not be carried out.
    pub(crate) fn error(&self, error: &anyhow::Error) {
        let message = printable(&format!("error: {error:#}"));
        let _ = writeln!(std::io::stderr(), "{message}");
    }

    /// Carries out a piece of work, which may tell how much of how much is done. If it takes longer
    /// than a second, and on a terminal, it is shown.
    pub(crate) fn during<T>(
        &self,
        what: &str,
        work: impl FnOnce(&(dyn Fn(usize, usize) + Sync)) -> T,
    ) -> T {
        let shown = !self.quiet && std::io::stderr().is_terminal();
        if !shown {
            return work(&|_done, _of| {});
        }
        let progress = Progress::after_a_second(what.to_owned());
        work(&|done, of| {
            progress.bar.set_length(of as u64);
            progress.bar.set_position(done as u64);
        })
    }
}

/// A message, which may quote a file, without what would steer a terminal.
pub(crate) fn printable(message: &str) -> String {
    let mut printable = String::with_capacity(message.len());
    for c in message.chars() {
        if c.is_control() && c != '\n' {
            printable.extend(c.escape_default());
        } else {
            printable.push(c);
        }
    }
    printable
}

/// A bar, and the thread that shows it until it is told to stop, which dropping does.
struct Progress {
    bar: ProgressBar,
    stop: Option<Sender<()>>,
    thread: Option<JoinHandle<()>>,
}

impl Progress {
    fn after_a_second(what: String) -> Self {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
        let (stop, stopped) = channel();
        let shown = bar.clone();
        let thread = std::thread::spawn(move || {
            let second = stopped.recv_timeout(Duration::from_secs(1));
            if second == Err(RecvTimeoutError::Timeout) {
                let template = match shown.length() {
                    Some(_) => "{spinner} {msg} {bar:30} {percent} % ({elapsed})",
                    None => "{spinner} {msg} ({elapsed})",
                };
                let style = ProgressStyle::with_template(template);
                shown.set_style(style.unwrap_or_else(|_| ProgressStyle::default_spinner()));
                shown.set_message(what);
                shown.set_draw_target(ProgressDrawTarget::stderr());
                shown.enable_steady_tick(Duration::from_millis(100));
                let _ = stopped.recv();
                shown.finish_and_clear();
            }
        });
        Self {
            bar,
            stop: Some(stop),
            thread: Some(thread),
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.stop.take();
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}
