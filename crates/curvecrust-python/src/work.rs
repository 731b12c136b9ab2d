//! Long work, without Python's lock and so that Ctrl-C ends it.

use crate::errors::{defect, value_error};
use curvecrust::geometry::{Interrupt, Interrupted};
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::num::NonZeroUsize;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

/// How often Python is asked whether somebody pressed Ctrl-C, and gets the progress of the work.
const POLL: Duration = Duration::from_millis(40);

/// How a piece of work is to run.
pub(crate) struct Run<'a, 'py> {
    pub(crate) py: Python<'py>,
    /// The number of threads; one for each processor by default.
    pub(crate) threads: Option<NonZeroUsize>,
    /// What hears how much is done of how much, which is 0 where nobody knows.
    pub(crate) progress: Option<&'a Bound<'py, PyAny>>,
}

/// How far the work is.
#[derive(Default)]
pub(crate) struct Progressed {
    done: AtomicUsize,
    total: AtomicUsize,
}

impl Progressed {
    pub(crate) fn report(&self, done: usize, total: usize) {
        self.total.store(total, Ordering::Relaxed);
        self.done.store(done, Ordering::Relaxed);
    }
}

impl<'py> Run<'_, 'py> {
    /// On all processors, without a listener.
    pub(crate) fn plain(py: Python<'py>) -> Self {
        Self {
            py,
            threads: None,
            progress: None,
        }
    }

    /// Does the work on a pool of threads while this thread waits and lets Python run.
    ///
    /// If Python raises meanwhile, as by Ctrl-C, this returns at once, and the work ends soon.
    pub(crate) fn work<T: Send + 'static>(
        &self,
        work: impl FnOnce(&Progressed) -> PyResult<T> + Send + 'static,
    ) -> PyResult<T> {
        if cfg!(target_family = "wasm") {
            // There are no threads, and no signals.
            return work(&Progressed::default());
        }
        let pool = pool(self.threads)?;
        let (interrupt, progressed) = (Interrupt::new(), Arc::new(Progressed::default()));
        let (send, mut result) = channel();
        let (switch, shown) = (interrupt.clone(), Arc::clone(&progressed));
        pool.spawn(move || {
            let work = AssertUnwindSafe(|| interrupt.run(|| work(&progressed)));
            // Nobody waits any more after Ctrl-C.
            let _ = send.send(catch_unwind(work));
        });
        loop {
            let waiting = &mut result;
            match self.py.detach(move || waiting.recv_timeout(POLL)) {
                Ok(Ok(Ok(done))) => return done,
                Ok(Ok(Err(Interrupted))) => return Err(value_error(Interrupted)),
                Ok(Err(payload)) => return Err(defect(&*payload)),
                Err(RecvTimeoutError::Disconnected) => return Err(defect(&"the work is lost")),
                Err(RecvTimeoutError::Timeout) => {}
            }
            if let Err(raised) = self.py.check_signals().and_then(|()| self.tell(&shown)) {
                switch.stop();
                return Err(raised);
            }
        }
    }

    fn tell(&self, shown: &Progressed) -> PyResult<()> {
        let Some(listener) = self.progress else {
            return Ok(());
        };
        let [done, total] = [&shown.done, &shown.total].map(|n| n.load(Ordering::Relaxed));
        listener.call1((done, total)).map(drop)
    }
}

/// The pool of all calls that do not say how many threads, and the process that it belongs to.
static SHARED: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// A pool of this many threads.
///
/// The threads of a process do not live on in one that it forks, as `multiprocessing` does: there a
/// new pool replaces the one that is dead.
fn pool(threads: Option<NonZeroUsize>) -> PyResult<Arc<ThreadPool>> {
    let build = |count: usize| {
        let pool = ThreadPoolBuilder::new().num_threads(count);
        let pool = pool.thread_name(|index| format!("curvecrust-{index}"));
        pool.build().map(Arc::new).map_err(value_error)
    };
    if let Some(count) = threads {
        return build(count.get());
    }
    let process = std::process::id();
    let mut shared = SHARED.lock().unwrap_or_else(PoisonError::into_inner);
    match &*shared {
        Some((of, pool)) if *of == process => Ok(Arc::clone(pool)),
        _ => {
            let pool = build(0)?;
            if let Some(dead) = shared.replace((process, Arc::clone(&pool))) {
                // To drop it would be to wait for threads that are not there.
                std::mem::forget(dead);
            }
            Ok(pool)
        }
    }
}
