//! The part of the Python package that is Rust: arrays in, arrays out.
//!
//! [`module`] lists what Python sees, as `curvecrust._curvecrust`; the functions and classes that
//! users call stand in `python/curvecrust` and make objects of these arrays. [`work`] runs all that
//! takes long without Python's lock, so that other threads of Python go on and Ctrl-C ends it.

mod arrays;
mod curve;
mod errors;
mod evaluate;
mod fit;
mod lfs;
mod methods;
mod module;
mod program;
mod reconstruct;
mod sample;
mod tiles;
mod work;
