//! The threads to compute with.

use crate::console::Console;
use std::num::NonZeroUsize;
use std::sync::mpsc::{Sender, channel};
use std::thread;

/// More threads than this for each processor only wait for each other.
const MOST_PER_PROCESSOR: usize = 4;

/// Starts as many threads as were asked for, or one for each processor, the calling one among them.
///
/// Where the system starts fewer, as in a container that limits them, these do the work: at least
/// the calling one.
pub(crate) fn start(asked: Option<NonZeroUsize>, console: &Console) -> anyhow::Result<()> {
    let processors = thread::available_parallelism().map_or(1, NonZeroUsize::get);
    let most = MOST_PER_PROCESSOR * processors;
    let count = match asked.map(NonZeroUsize::get) {
        Some(asked) if asked > most => {
            console.note(format_args!(
                "--threads {asked} is limited to {most}, {MOST_PER_PROCESSOR} for each processor"
            ));
            most
        }
        Some(asked) => asked,
        None => from_environment().unwrap_or(processors).min(most),
    };
    let workers: Vec<_> = (1..count).map_while(|_| worker()).collect();
    let started = workers.len() + 1;
    if started < count {
        console.note(format_args!(
            "only {started} of {count} threads could be started"
        ));
    }
    let mut workers = workers.into_iter();
    rayon::ThreadPoolBuilder::new()
        .num_threads(started)
        .use_current_thread()
        .spawn_handler(|worker| {
            // There is one for each; it waits for what it is sent.
            let _ = workers.next().map(|waiting| waiting.send(worker));
            Ok(())
        })
        .build_global()?;
    Ok(())
}

/// The number that rayon itself would use.
fn from_environment() -> Option<usize> {
    let number = std::env::var("RAYON_NUM_THREADS").ok()?.parse().ok()?;
    Some(number).filter(|&number| number > 0)
}

/// A thread that waits for the worker that it is to be.
fn worker() -> Option<Sender<rayon::ThreadBuilder>> {
    let (send, receive) = channel::<rayon::ThreadBuilder>();
    let run = move || {
        if let Ok(worker) = receive.recv() {
            worker.run();
        }
    };
    thread::Builder::new().spawn(run).ok()?;
    Some(send)
}
