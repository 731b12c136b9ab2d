//! Scans in LAZ: any bytes behind a header that says that its points are packed.
//!
//! `laz` 0.13 calls itself once for each sequence of GPS times that a point switches to, and damaged
//! data switch again and again, until the stack is full. The program has a process of its own for
//! that; here it is a thread whose stack has room for all that so few bytes can ask for.

#![no_main]

use libfuzzer_sys::fuzz_target;
use std::thread;

/// The stack, in bytes; only what is used takes memory.
const STACK: usize = 1 << 32;

/// The most bytes that are tried.
const MOST: usize = 4096;

fuzz_target!(|bytes: &[u8]| {
    let packed = bytes.get(104).is_some_and(|format| format & 0x80 != 0);
    if !bytes.starts_with(b"LASF") || !packed || bytes.len() > MOST {
        return;
    }
    let bytes = bytes.to_vec();
    let read = move || curvecrust_cli::count_points(bytes, "las", false);
    let thread = thread::Builder::new().stack_size(STACK).spawn(read);
    let read = thread.expect("a thread can be started").join();
    // Fit for a terminal.
    if let Err(message) = read.expect("no input makes it panic") {
        assert!(!message.chars().any(|c| c.is_control() && c != '\n'));
    }
});
