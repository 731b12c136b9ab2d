//! What a folder of tiles is for, and how its points are cut into tiles.

use super::input::Fingerprint;
use super::records;
use super::way::Way;
use anyhow::{Context, bail};
use curvecrust::tiles::{Axis, Cut, Partition};
use serde::{Deserialize, Serialize};
use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};

/// The name of the file that holds the plan.
const PLAN: &str = "plan.json";

/// The name of the file that a run locks.
const LOCK: &str = "lock";

/// Another one makes folders that this program cannot go on with.
const VERSION: u32 = 2;

/// What is reconstructed: a folder is for one such job.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Job {
    pub(super) version: u32,
    pub(super) algorithm: String,
    /// The rows that are points.
    pub(super) points: u64,
    pub(super) sizes: Sizes,
    pub(super) input: Fingerprint,
}

/// How many points are worked on at once.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Sizes {
    /// About how many points a tile has.
    pub(super) tile: usize,
    /// The rows of a chunk.
    pub(super) chunk: usize,
}

/// A job and its tiles.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Plan {
    pub(super) job: Job,
    /// For each cut `0` for x or `1` for y, and where; for each tile null.
    cuts: Vec<Option<(u8, f64)>>,
}

impl Job {
    pub(super) fn new(algorithm: &str, points: usize, sizes: Sizes, input: Fingerprint) -> Self {
        Self {
            version: VERSION,
            algorithm: algorithm.to_owned(),
            points: points as u64,
            sizes,
            input,
        }
    }
}

impl Plan {
    pub(super) fn new(job: Job, partition: &Partition) -> Self {
        let cut = |cut: Cut| {
            let axis = match cut.axis {
                Axis::X => 0,
                Axis::Y => 1,
            };
            (axis, cut.at)
        };
        let cuts = partition.cuts().into_iter().map(|c| c.map(cut)).collect();
        Self { job, cuts }
    }

    pub(super) fn partition(&self) -> Partition {
        let cut = |(axis, at): (u8, f64)| Cut {
            axis: if axis == 0 { Axis::X } else { Axis::Y },
            at,
        };
        let cuts: Vec<_> = self.cuts.iter().map(|c| c.map(cut)).collect();
        Partition::from_cuts(&cuts)
    }
}

/// A folder that this run alone works in.
pub(super) struct Folder {
    path: PathBuf,
    /// Locked as long as it is open.
    _lock: File,
}

impl Folder {
    /// Opens a folder, or makes a new one. A folder with other files is refused.
    pub(super) fn open(path: &Path) -> anyhow::Result<Self> {
        let context = || format!("cannot use the folder {}", path.display());
        if !path.exists() {
            fs::create_dir(path).with_context(context)?;
        }
        if !path.join(PLAN).exists() {
            for entry in fs::read_dir(path).with_context(context)? {
                let name = entry.with_context(context)?.file_name();
                let temporary = records::temporary(Path::new(PLAN));
                if name != LOCK && name != temporary.as_os_str() {
                    bail!(
                        "{}: it holds {}, but no tiles: give a new or an empty folder",
                        context(),
                        name.display()
                    );
                }
            }
        }
        let lock = File::create(path.join(LOCK)).with_context(context)?;
        if matches!(lock.try_lock(), Err(fs::TryLockError::WouldBlock)) {
            bail!("{}: another run works in it", context());
        }
        Ok(Self {
            path: path.to_owned(),
            _lock: lock,
        })
    }

    /// The plan of an earlier run, which must be for the same job; `None` in a new folder.
    pub(super) fn plan(&self, job: &Job) -> anyhow::Result<Option<Plan>> {
        let path = self.path.join(PLAN);
        if !path.exists() {
            return Ok(None);
        }
        let context = || format!("cannot read {}", path.display());
        let text = fs::read(&path).with_context(context)?;
        let plan: Plan = serde_json::from_slice(&text).with_context(context)?;
        if plan.job != *job {
            bail!(
                "the folder {} is for another job: {}; give another folder, or delete this one",
                self.path.display(),
                difference(&plan.job, job)
            );
        }
        Ok(Some(plan))
    }

    pub(super) fn write_plan(&self, plan: &Plan) -> anyhow::Result<()> {
        let text = serde_json::to_vec(plan)?;
        records::write(&self.path.join(PLAN), |out| out.write_all(&text))
    }

    /// The points of some rows, by tiles.
    pub(super) fn chunk(&self, number: usize) -> PathBuf {
        self.path.join(format!("chunk-{number:06}"))
    }

    /// What was found in a tile.
    pub(super) fn result(&self, tile: usize) -> PathBuf {
        self.path.join(format!("tile-{tile:06}.result"))
    }

    /// The edges of a tile that needed samples of others.
    pub(super) fn stars(&self, tile: usize) -> PathBuf {
        self.path.join(format!("tile-{tile:06}.stars"))
    }

    /// Where the edges of a tile are.
    pub(super) fn edges(&self, tile: usize, way: Way) -> PathBuf {
        match way {
            Way::Choices(_) => self.result(tile),
            Way::Stars(_) => self.stars(tile),
        }
    }

    /// The samples of a tile, along a Hilbert curve.
    pub(super) fn samples(&self, tile: usize) -> PathBuf {
        self.path.join(format!("tile-{tile:06}.samples"))
    }

    /// The pieces of curves of a tile.
    pub(super) fn pieces(&self, tile: usize) -> PathBuf {
        self.path.join(format!("tile-{tile:06}.pieces"))
    }

    /// The curves that lie in several tiles.
    pub(super) fn across(&self) -> PathBuf {
        self.path.join("joined.pieces")
    }

    /// The numbers of the curves of a list: those of a tile, or the ones across tiles as the last.
    pub(super) fn ranks(&self, list: usize) -> PathBuf {
        self.path.join(format!("list-{list:06}.ranks"))
    }

    /// How many rings lie around each ring of a list.
    pub(super) fn nesting(&self, list: usize) -> PathBuf {
        self.path.join(format!("list-{list:06}.nesting"))
    }

    /// All that is known about the curves of a list.
    pub(super) fn curves(&self, list: usize) -> PathBuf {
        self.path.join(format!("list-{list:06}.curves"))
    }

    /// The edges that no tile could decide alone.
    pub(super) fn joined(&self) -> PathBuf {
        self.path.join("joined.result")
    }
}

/// What differs between the job of a folder and another one.
fn difference(theirs: &Job, ours: &Job) -> String {
    if theirs.version != ours.version {
        String::from("another version of this program made it")
    } else if theirs.algorithm != ours.algorithm {
        format!("it runs {}, not {}", theirs.algorithm, ours.algorithm)
    } else if theirs.input.bytes == ours.input.bytes && theirs.sizes != ours.sizes {
        String::from("it has another --memory")
    } else {
        String::from("its input has another size or other columns, or was changed at another time")
    }
}
