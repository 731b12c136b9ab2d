//! Tiles, as they were typed.

use std::num::NonZeroUsize;
use std::path::PathBuf;

/// Where and how points are reconstructed that memory cannot hold.
#[derive(Debug, clap::Args)]
pub(crate) struct Tiles {
    /// Work tile by tile in this folder, within limited memory; a run that was stopped
    /// continues. For hnn-crust, nn-crust and crust, from npy, parquet or a folder of
    /// parquet files, to npy
    #[arg(
        long,
        value_name = "FOLDER",
        conflicts_with_all = [
            "json", "closed", "open", "curves", "terminus", "termini_from", "merge_duplicates",
            "merge_within", "vertices", "keep", "why",
        ]
    )]
    pub(crate) tiles: Option<PathBuf>,
    /// How much memory to use with --tiles
    #[arg(
        long,
        value_name = "SIZE",
        requires = "tiles",
        default_value = "2GB",
        value_parser = size
    )]
    pub(crate) memory: u64,
    /// Write the curves into this folder too, ordered and tile by tile, as NumPy arrays: curves.npy
    /// has a row for each curve. Without -o, they are all that is written
    #[arg(long, value_name = "FOLDER", requires = "tiles")]
    pub(crate) polylines: Option<PathBuf>,
    /// The points of a tile [default: as many as the memory allows]
    #[arg(long, value_name = "N", requires = "tiles", hide = true)]
    pub(crate) tile_points: Option<NonZeroUsize>,
}

/// A number of bytes, with a unit.
fn size(text: &str) -> Result<u64, String> {
    const UNITS: [(&str, u64); 9] = [
        ("KiB", 1 << 10),
        ("MiB", 1 << 20),
        ("GiB", 1 << 30),
        ("TiB", 1 << 40),
        ("kB", 1000),
        ("MB", 1_000_000),
        ("GB", 1_000_000_000),
        ("TB", 1_000_000_000_000),
        ("B", 1),
    ];
    let found = UNITS.iter().find_map(|&(unit, bytes)| {
        let number: f64 = text.strip_suffix(unit)?.trim().parse().ok()?;
        let size = number * bytes as f64;
        (1.0..1e18).contains(&size).then_some(size)
    });
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "between 1 and 1e18"
    )]
    found
        .map(|size| size as u64)
        .ok_or_else(|| String::from("give a size such as 500MB or 2GB"))
}
