//! Scans in LAZ: any bytes behind a header that says that its points are packed.
//!
//! `laz` 0.13 panics at some damaged data. It also calls itself once for each sequence of GPS times
//! that a point switches to, and damaged data switch again and again, until the stack is full. The
//! program has a process of its own for that; here it is a thread whose stack has room for all that
//! so few bytes can ask for, and which may panic in `laz` alone.

#![no_main]

use libfuzzer_sys::fuzz_target;
use std::panic::{self, PanicHookInfo};
use std::sync::Once;
use std::thread;

/// The stack, in bytes; only what is used takes memory.
const STACK: usize = 1 << 32;

/// The most bytes that are tried.
const MOST: usize = 4096;

static HOOK: Once = Once::new();

fn is_in_laz(panic: &PanicHookInfo<'_>) -> bool {
    let place = panic.location();
    place.is_some_and(|place| place.file().contains("/laz-"))
}

fuzz_target!(|bytes: &[u8]| {
    HOOK.call_once(|| {
        let find = panic::take_hook();
        panic::set_hook(Box::new(move |panic| {
            if !is_in_laz(panic) {
                find(panic);
            }
        }));
    });
    let packed = bytes.get(104).is_some_and(|format| format & 0x80 != 0);
    if !bytes.starts_with(b"LASF") || !packed || bytes.len() > MOST {
        return;
    }
    let bytes = bytes.to_vec();
    let read = move || curvecrust_cli::count_points(bytes, "las", false);
    let thread = thread::Builder::new().stack_size(STACK).spawn(read);
    // Fit for a terminal.
    if let Ok(Err(message)) = thread.expect("a thread can be started").join() {
        assert!(!message.chars().any(|c| c.is_control() && c != '\n'));
    }
});
