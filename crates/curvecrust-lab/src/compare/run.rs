//! Cells on all threads, written in their order: rows and times of complete cells only.
//!
//! Each thread has a pool of one thread of its own, so that an algorithm's run time holds nothing
//! of another's. The files grow in the order of the plan; after an interruption, they
//! are the start of what one run would have written.

use super::cell::{self, Fixtures, Job};
use super::drawn::Drawn;
use super::experiment::Input;
use super::plan::Plan;
use super::progress;
use super::records;
use super::scale;
use super::trial::{self, Done};
use crate::compare::rows::{Row, Timing};
use anyhow::{Context, ensure};
use indicatif::ProgressBar;
use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc;

/// Runs what is not there yet; false if it was stopped before the end.
pub(super) fn run(
    plan: &Plan,
    fixtures: &Fixtures,
    folder: &Path,
    threads: usize,
    done: usize,
    stop: &AtomicBool,
) -> anyhow::Result<bool> {
    let mut rows = append(&folder.join("rows.csv"))?;
    let mut times = append(&folder.join("times.csv"))?;
    let jobs = &plan.jobs[done..];
    // Run times of large inputs are measured one at a time.
    let alone = jobs
        .iter()
        .any(|job| matches!(job.input, Input::Planted { .. }));
    let workers = if alone { 1 } else { threads.min(jobs.len()) };
    let bar = progress::bar(jobs.iter().map(|job| u64::from(job.trials)).sum());
    let next = AtomicUsize::new(0);
    let (send, receive) = mpsc::channel();
    let mut written = 0;
    std::thread::scope(|scope| -> anyhow::Result<()> {
        for _ in 0..workers {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
            let (send, next, bar) = (send.clone(), &next, &bar);
            scope.spawn(move || {
                let work = Work {
                    plan,
                    jobs,
                    fixtures,
                    threads,
                    stop,
                    next,
                    bar,
                };
                pool.install(|| work.all(&send));
            });
        }
        drop(send);
        // Cells that came before one that is still running.
        let mut early: BTreeMap<usize, Done> = BTreeMap::new();
        for (index, done) in receive {
            let done = done.inspect_err(|_| stop.store(true, Ordering::Relaxed))?;
            early.insert(index, done);
            while let Some(done) = early.remove(&written) {
                // Times first: a cell is there when its rows are.
                let lines = records::table(&done.times).to_csv_lines()?;
                times.write_all(lines.as_bytes())?;
                let lines = records::table(&done.rows).to_csv_lines()?;
                rows.write_all(lines.as_bytes())?;
                written += 1;
            }
        }
        Ok(())
    })?;
    bar.finish_and_clear();
    Ok(written == jobs.len())
}

type Sent = (usize, anyhow::Result<Done>);

/// What a worker needs.
struct Work<'a> {
    plan: &'a Plan,
    jobs: &'a [Job],
    fixtures: &'a Fixtures,
    /// How many threads other processes are to have.
    threads: usize,
    stop: &'a AtomicBool,
    next: &'a AtomicUsize,
    bar: &'a ProgressBar,
}

impl Work<'_> {
    /// Takes one job after the other, until none is left.
    fn all(&self, send: &mpsc::Sender<Sent>) {
        loop {
            let index = self.next.fetch_add(1, Ordering::Relaxed);
            let Some(job) = self.jobs.get(index) else {
                return;
            };
            self.bar.set_message(job.experiment.name.clone());
            let Some(done) = self.one(job).transpose() else {
                return;
            };
            let place = || format!("{}, {} at {}", job.experiment.name, job.series(), job.x);
            if send.send((index, done.with_context(place))).is_err() {
                return;
            }
            self.bar.inc(u64::from(job.trials));
        }
    }

    fn one(&self, job: &Job) -> anyhow::Result<Option<Done>> {
        let goes_on = || !self.stop.load(Ordering::Relaxed);
        let seed = self.plan.seed.unwrap_or(job.experiment.seed);
        let algorithms = self.plan.algorithms_of(job);
        match (&job.input, &job.outlines) {
            (Input::Planted { .. }, _) => scale::run(job, seed, algorithms, self.threads, &goes_on),
            (_, Some(outlines)) => {
                let draw = |trial, _| outlines.draw(trial as usize, cell::rounded(job.x));
                trial::run(job, seed, algorithms, &draw, &goes_on)
            }
            (_, None) => {
                let cell = job.prepare(self.fixtures)?;
                let draw = |_, seed| {
                    let curves = Arc::clone(&cell.curves);
                    cell.draw(seed).map(|sampled| Drawn { sampled, curves })
                };
                trial::run(job, seed, algorithms, &draw, &goes_on)
            }
        }
    }
}

fn append(path: &Path) -> anyhow::Result<fs::File> {
    let file = fs::OpenOptions::new().append(true).open(path);
    file.with_context(|| format!("cannot write {}", path.display()))
}

/// Begins anew: files with headers only.
pub(super) fn begin(plan: &Plan, folder: &Path) -> anyhow::Result<()> {
    fs::create_dir_all(folder).with_context(|| format!("cannot make {}", folder.display()))?;
    for (name, text) in [
        ("rows.csv", records::table::<Row>(&[]).to_csv()?),
        ("times.csv", records::table::<Timing>(&[]).to_csv()?),
        ("plan.txt", plan.fingerprint()),
    ] {
        let path = folder.join(name);
        fs::write(&path, text).with_context(|| format!("cannot write {}", path.display()))?;
    }
    Ok(())
}

/// Cuts what an interrupted run left back to its complete cells, and says how many these are.
pub(super) fn resume(plan: &Plan, folder: &Path) -> anyhow::Result<usize> {
    let read = |name: &str| {
        let path = folder.join(name);
        fs::read_to_string(&path)
            .with_context(|| format!("nothing to resume: cannot read {}", path.display()))
    };
    ensure!(
        read("plan.txt")? == plan.fingerprint(),
        "{} holds another run: give the same options, or leave out --resume",
        folder.display()
    );
    let text = whole_lines(read("rows.csv")?);
    let rows: Vec<Row> = records::read(&text)?;
    let (mut complete, mut kept) = (0, 0);
    for job in &plan.jobs {
        let series = job.series();
        let is_own = |row: &Row| {
            row.experiment == job.experiment.name
                && row.series == series
                && row.x.to_bits() == job.x.to_bits()
        };
        let count = plan.rows_of(job);
        let there = rows
            .get(kept..kept + count)
            .is_some_and(|cell| cell.iter().all(is_own));
        if !there {
            break;
        }
        kept += count;
        complete += 1;
    }
    let rows = &rows[..kept];
    let lines = records::table(rows).to_csv()?;
    // An algorithm that failed has no time.
    let timed = rows.iter().filter(|row| row.error.is_none()).count();
    let times = whole_lines(read("times.csv")?);
    let times: String = times.split_inclusive('\n').take(1 + timed).collect();
    fs::write(folder.join("times.csv"), times)?;
    fs::write(folder.join("rows.csv"), lines)?;
    Ok(complete)
}

/// Without a line that was not finished. (A row with a line break in its error may lose its start
/// with it; reading says so.)
fn whole_lines(mut text: String) -> String {
    text.truncate(text.rfind('\n').map_or(0, |at| at + 1));
    text
}
