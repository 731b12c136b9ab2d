//! The program as people run it: the built binary, on files.
#![allow(
    clippy::panic,
    clippy::unwrap_used,
    clippy::print_stderr,
    reason = "a test, its helpers included"
)]

#[cfg(feature = "npz")]
mod archives;
mod bad_documents;
mod bad_input;
#[cfg(feature = "parquet")]
mod columns;
mod content;
mod curves;
#[cfg(feature = "las")]
mod decoder;
mod docs;
mod drawings;
mod files;
mod fit;
mod formats;
#[cfg(feature = "wkb")]
mod geometries;
mod harness;
mod kept;
#[cfg(target_os = "linux")]
mod memory;
#[cfg(feature = "ply")]
mod models;
mod pictures;
mod point_files;
mod polylines;
mod processes;
mod puzzle;
mod python;
mod reconstruct;
mod sample;
#[cfg(feature = "las")]
mod scans;
#[cfg(feature = "shapefile")]
mod shapes;
mod tables;
#[cfg(feature = "parquet")]
mod tables_in_tiles;
mod tiles;
