//! The explorer in a browser: reconstruction and sampling as WebAssembly, for the page in `page/`.
//!
//! The page sends a [message](mod@message) and gets one back: a header in JSON, and numbers in
//! binary. An [`Engine`] answers it, and keeps the curve that was loaded last, so that dragging a
//! slider measures nothing again. Every answer is a result or an error in words; none is a panic.
//! `cargo xtask web` builds the page.

mod engine;
mod error;
mod exports;
pub mod message;
mod points;

pub use engine::Engine;
pub use error::Error;
