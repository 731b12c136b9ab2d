//! Ending a long computation early.

use std::cell::RefCell;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use thiserror::Error;

thread_local! {
    static CURRENT: RefCell<Interrupt> = const { RefCell::new(Interrupt { flag: None }) };
}

/// A switch that ends the computations that run under it.
///
/// Whoever wants to be able to stop runs the work by [`Interrupt::run`] on one thread and keeps a
/// clone, on which another thread calls [`Interrupt::stop`]. The libraries look at the switch many
/// times a second in all that takes long; the work then unwinds, like a panic without a message,
/// and `run` returns [`Interrupted`]. So no signature has to speak of it, and what nobody stops
/// pays nothing. A program that is built with `panic = "abort"` cannot use it.
///
/// The default is the switch that nobody can turn.
///
/// ```
/// use curvecrust_geometry::{Interrupt, Interrupted};
///
/// let interrupt = Interrupt::new();
/// assert_eq!(interrupt.run(|| 6 * 7), Ok(42));
/// let switch = interrupt.clone();
/// let stopped = interrupt.run(|| {
///     let current = Interrupt::current();
///     for round in 0.. {
///         current.check();
///         if round == 1000 {
///             switch.stop(); // Another thread would.
///         }
///     }
/// });
/// assert_eq!(stopped, Err(Interrupted));
/// ```
#[derive(Clone, Debug, Default)]
pub struct Interrupt {
    flag: Option<Arc<AtomicBool>>,
}

/// A computation was stopped before it had a result.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[error("interrupted")]
pub struct Interrupted;

impl Interrupt {
    /// A switch that [`stop`](Self::stop) turns.
    #[must_use]
    pub fn new() -> Self {
        Self {
            flag: Some(Arc::default()),
        }
    }

    /// The switch that the work of this thread runs under.
    ///
    /// The threads of a pool run under none: who hands them work calls this before, and they call
    /// [`check`](Self::check) on what it returned.
    #[must_use]
    pub fn current() -> Self {
        CURRENT.with_borrow(Self::clone)
    }

    /// Ends the work that runs under this switch or a clone of it, now or later.
    pub fn stop(&self) {
        if let Some(flag) = &self.flag {
            flag.store(true, Ordering::Relaxed);
        }
    }

    /// Does some work that [`stop`](Self::stop) ends.
    ///
    /// # Errors
    /// [`Interrupted`] if the work was stopped. Work that is done when `stop` is called has its
    /// result.
    ///
    /// # Panics
    /// If the work does.
    pub fn run<T>(&self, work: impl FnOnce() -> T) -> Result<T, Interrupted> {
        let _restore = Restore(CURRENT.replace(self.clone()));
        // What the work changes is dropped with it; what it borrows is the caller's to judge.
        catch_unwind(AssertUnwindSafe(work)).or_else(|payload| {
            if payload.is::<Interrupted>() {
                Err(Interrupted)
            } else {
                resume_unwind(payload)
            }
        })
    }

    /// Unwinds to [`run`](Self::run) if the work is to stop; otherwise this does nothing, in about
    /// a nanosecond.
    #[inline]
    pub fn check(&self) {
        if let Some(flag) = &self.flag
            && flag.load(Ordering::Relaxed)
        {
            resume_unwind(Box::new(Interrupted));
        }
    }
}

/// Puts back the switch that was there before, also when work panics.
struct Restore(Interrupt);

impl Drop for Restore {
    fn drop(&mut self) {
        CURRENT.set(std::mem::take(&mut self.0));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rayon::prelude::*;

    #[test]
    fn threads_of_a_pool_stop_too() {
        let interrupt = Interrupt::new();
        let switch = interrupt.clone();
        let stopped = interrupt.run(|| {
            let current = Interrupt::current();
            (0..10_000u32).into_par_iter().for_each(|i| {
                if i == 4321 {
                    switch.stop();
                }
                current.check();
            });
            current.check();
        });
        assert_eq!(stopped, Err(Interrupted));
    }

    #[test]
    fn other_work_goes_on() {
        let stopped = Interrupt::new();
        stopped.stop();
        assert_eq!(
            Interrupt::new().run(|| {
                let inner = stopped.run(|| Interrupt::current().check());
                assert_eq!(inner, Err(Interrupted));
                Interrupt::current().check();
            }),
            Ok(())
        );
        Interrupt::current().check();
    }

    #[test]
    #[should_panic(expected = "a defect")]
    fn panics_stay_panics() {
        let _ = Interrupt::new().run(|| panic!("a defect"));
    }
}
