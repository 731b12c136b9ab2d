//! What the page calls in the module: three functions on two buffers.
//!
//! The page asks for a buffer with [`curvecrust_input`], writes a message there, calls
//! [`curvecrust_answer`], and reads [`curvecrust_answer_length`] bytes at the address it returns.
//! These plain exports need no generated glue and no tool beside cargo. Addresses go out and none
//! comes in, so that no wrong call of the page can reach memory.

#![allow(
    unsafe_code,
    unreachable_pub,
    reason = "exported names could clash with others, and are reached from outside alone"
)]

use crate::engine::Engine;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The one engine of a module, and the messages in and out.
#[derive(Default)]
struct State {
    engine: Engine,
    input: Vec<u8>,
    answer: Vec<u8>,
}

static STATE: Mutex<Option<State>> = Mutex::new(None);

fn with_state<T>(act: impl FnOnce(&mut State) -> T) -> T {
    let mut state: MutexGuard<'_, Option<State>> =
        STATE.lock().unwrap_or_else(PoisonError::into_inner);
    act(state.get_or_insert_default())
}

/// A buffer of `length` bytes for the next message: its address, or 0 if there is no memory.
#[unsafe(no_mangle)]
pub extern "C" fn curvecrust_input(length: usize) -> *mut u8 {
    with_state(|state| {
        state.input = Vec::new();
        if Vec::<u8>::new().try_reserve_exact(length).is_err() {
            return std::ptr::null_mut();
        }
        // Zeros that are asked for with the memory need not be written.
        state.input = vec![0; length];
        state.input.as_mut_ptr()
    })
}

/// Answers the message in the buffer: the address of the answer.
#[unsafe(no_mangle)]
pub extern "C" fn curvecrust_answer() -> *const u8 {
    with_state(|state| {
        // The old answer goes first: both at once would need twice the memory.
        state.answer = Vec::new();
        state.answer = state.engine.answer(&std::mem::take(&mut state.input));
        state.answer.as_ptr()
    })
}

/// The number of bytes of the last answer.
#[unsafe(no_mangle)]
pub extern "C" fn curvecrust_answer_length() -> usize {
    with_state(|state| state.answer.len())
}
