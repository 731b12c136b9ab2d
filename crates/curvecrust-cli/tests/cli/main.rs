//! The program as people run it: the built binary, on files.
#![allow(clippy::unwrap_used, reason = "a test, its helpers included")]

mod bad_input;
mod curves;
mod formats;
mod harness;
mod reconstruct;
mod sample;
mod whole_files;
