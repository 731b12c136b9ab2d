//! Messages and progress on stderr, which is for people alone.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::fmt::Display;
use std::io::{IsTerminal, Write};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread::{Builder, JoinHandle};
use std::time::Duration;

/// Characters of a message; a file that is quoted may have many more.
const MOST: usize = 10_000;

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
    pub(crate) fn note(&self, line: impl Display) {
        if !self.quiet {
            let _ = writeln!(std::io::stderr(), "{}", printable(&line.to_string()));
        }
    }

    /// Why the command could not be carried out.
    pub(crate) fn error(&self, error: &anyhow::Error) {
        let message = printable(&format!("error: {error:#}"));
        let _ = writeln!(std::io::stderr(), "{message}");
    }

    /// Carries out a piece of work, which may report how much of how much is done. A bar on a
    /// terminal shows it if it takes longer than a second.
    pub(crate) fn during<T>(
        &self,
        what: &str,
        work: impl FnOnce(&(dyn Fn(usize, usize) + Sync)) -> T,
    ) -> T {
        let is_shown = !self.quiet && std::io::stderr().is_terminal();
        let progress = is_shown.then(|| Progress::after_a_second(printable(what)));
        match progress.flatten() {
            None => work(&|_done, _of| {}),
            Some(progress) => work(&|done, of| {
                progress.bar.set_length(of as u64);
                progress.bar.set_position(done as u64);
            }),
        }
    }
}

/// A message, which may quote a file or its name, as one line that a terminal can show.
pub(crate) fn printable(message: &str) -> String {
    let mut printable = String::with_capacity(message.len().min(MOST));
    for c in message.chars().take(MOST) {
        if c.is_control() {
            printable.extend(c.escape_default());
        } else {
            printable.push(c);
        }
    }
    if message.chars().nth(MOST).is_some() {
        printable.push_str("...");
    }
    printable
}

/// A bar, and the thread that shows it until the bar is dropped.
struct Progress {
    bar: ProgressBar,
    stop: Option<Sender<()>>,
    thread: Option<JoinHandle<()>>,
}

impl Progress {
    /// `None` where no thread can be started.
    fn after_a_second(what: String) -> Option<Self> {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
        let (stop, stopped) = channel();
        let shown = bar.clone();
        let show = move || {
            let mut wait = Duration::from_secs(1);
            while stopped.recv_timeout(wait) == Err(RecvTimeoutError::Timeout) {
                if shown.is_hidden() {
                    let template = match shown.length() {
                        Some(_) => "{spinner} {msg} {bar:30} {percent} % ({elapsed}, {eta} left)",
                        None => "{spinner} {msg} ({elapsed})",
                    };
                    let style = ProgressStyle::with_template(template);
                    shown.set_style(style.unwrap_or_else(|_| ProgressStyle::default_spinner()));
                    shown.set_message(what.clone());
                    shown.set_draw_target(ProgressDrawTarget::stderr());
                    wait = Duration::from_millis(100);
                }
                shown.tick();
            }
            shown.finish_and_clear();
        };
        let thread = Builder::new().spawn(show).ok()?;
        Some(Self {
            bar,
            stop: Some(stop),
            thread: Some(thread),
        })
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
