//! `cargo xtask python`: the Python package, its tests, its pages and its benchmark.
//!
//! Nothing is installed but under `target/python`: the tools that build, kept from run to run, and
//! an environment made anew each time, as a user's is.

use crate::ci::cargo::{outcome, succeeds};
use crate::ci::outcome::Outcome;
use anyhow::{Context, ensure};
use curvecrust_lab::root;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};

/// What was typed.
#[derive(clap::Args)]
pub(crate) struct Args {
    #[command(subcommand)]
    task: Option<Task>,
}

#[derive(clap::Subcommand)]
enum Task {
    /// Build the wheel, and the source archive that it is built from, under target/python/wheels
    Wheel,
    /// Build the wheel, install it into a fresh environment, and run all tests and lints there
    Test,
    /// Build the pages under target/python/site
    Docs,
    /// Measure the wheel beside other packages
    Bench {
        /// Files of rings: each line an object of JSON whose `rings` are lists of points in order
        files: Vec<PathBuf>,
    },
}

/// Carries out a task; builds the wheel if none is named.
pub(crate) fn run(args: &Args) -> anyhow::Result<ExitCode> {
    let done = match &args.task {
        None | Some(Task::Wheel) => with_wheel(|_| Ok(Outcome::Passed)),
        Some(Task::Test) => with_wheel(tested),
        Some(Task::Docs) => with_wheel(pages),
        Some(Task::Bench { files }) => bench(files),
    }?;
    Ok(match done {
        Outcome::Passed | Outcome::PassedBy(_) => ExitCode::SUCCESS,
        Outcome::Failed(why) => {
            eprintln!("error: {why}");
            ExitCode::FAILURE
        }
        Outcome::Skipped(why) => {
            eprintln!("error: {why}");
            ExitCode::from(2)
        }
    })
}

/// All tests and lints of the package, then its pages, with one wheel.
pub(crate) fn test_and_docs() -> anyhow::Result<Outcome> {
    with_wheel(|wheel| match tested(wheel)? {
        Outcome::Passed => pages(wheel),
        other => Ok(other),
    })
}

/// Tests and lints, in an environment of their own.
fn tested(wheel: &Path) -> anyhow::Result<Outcome> {
    let environment = match Environment::fresh("test", wheel, &["test"])? {
        Ok(environment) => environment,
        Err(outcome) => return Ok(outcome),
    };
    let wheel = wheel.to_string_lossy();
    let all: [&[&str]; 6] = [
        &["ruff", "check", "."],
        &["ruff", "format", "--check", "."],
        &["mypy", "python"],
        &["mypy.stubtest", "curvecrust._curvecrust"],
        &["abi3audit", "--strict", &wheel],
        &[
            "pytest",
            "-q",
            "tests",
            "README.md",
            "--pyargs",
            "curvecrust",
        ],
    ];
    first_failure(all.iter().map(|arguments| environment.module(arguments)))
}

/// The pages, with the notebooks executed.
fn pages(wheel: &Path) -> anyhow::Result<Outcome> {
    let environment = match Environment::fresh("docs", wheel, &["docs", "geo"])? {
        Ok(environment) => environment,
        Err(outcome) => return Ok(outcome),
    };
    let site = folder().join("site");
    environment.module(&["mkdocs", "build", "-q", "-s", "-d", &site.to_string_lossy()])
}

fn bench(files: &[PathBuf]) -> anyhow::Result<Outcome> {
    with_wheel(|wheel| {
        let environment = match Environment::fresh("bench", wheel, &["bench"])? {
            Ok(environment) => environment,
            Err(outcome) => return Ok(outcome),
        };
        let mut command = environment.python();
        command.arg("benches/beside.py");
        for file in files {
            let file = fs::canonicalize(file);
            command.arg(file.context("cannot find a file of rings")?);
        }
        outcome(command, "python benches/beside.py")
    })
}

/// The first of several outcomes that did not pass.
fn first_failure(
    outcomes: impl Iterator<Item = anyhow::Result<Outcome>>,
) -> anyhow::Result<Outcome> {
    for outcome in outcomes {
        match outcome? {
            Outcome::Passed => {}
            other => return Ok(other),
        }
    }
    Ok(Outcome::Passed)
}

/// Builds the wheel and goes on with it, where there are Python and maturin.
fn with_wheel(next: impl FnOnce(&Path) -> anyhow::Result<Outcome>) -> anyhow::Result<Outcome> {
    let usable = "import sys, venv, ensurepip; sys.exit(sys.version_info < (3, 10))";
    if !succeeds(Command::new("python3").args(["-c", usable])) {
        let why = "no Python 3.10 or later with venv and pip";
        return Ok(Outcome::Skipped(why.to_owned()));
    }
    let tools = Environment::new("tools");
    if !succeeds(tools.python().args(["-m", "maturin", "--version"])) {
        tools.create()?;
        if let Some(skipped) = tools.install(["maturin>=1.9.4,<2"])? {
            return Ok(skipped);
        }
    }
    let wheels = folder().join("wheels");
    if wheels.exists() {
        fs::remove_dir_all(&wheels).context("cannot clear target/python/wheels")?;
    }
    let mut maturin = tools.python();
    maturin.args(["-m", "maturin", "build", "--release", "--sdist", "--out"]);
    maturin.arg(&wheels);
    // The source archive is unpacked to a new place each time; what it needs is built once.
    let target = folder().join("build");
    forget_own_crates(&target.join("release/.fingerprint"))?;
    maturin.env("CARGO_TARGET_DIR", target);
    match outcome(maturin, "maturin build --release --sdist")? {
        Outcome::Passed => {}
        failed => return Ok(failed),
    }
    let files = fs::read_dir(&wheels).context("cannot read target/python/wheels")?;
    let paths = files.filter_map(|file| Some(file.ok()?.path()));
    let found: Vec<PathBuf> = paths
        .filter(|path| path.extension() == Some(OsStr::new("whl")))
        .collect();
    let [wheel] = &found[..] else {
        anyhow::bail!("{} wheels under target/python/wheels", found.len());
    };
    next(wheel)
}

/// Makes cargo build the crates of the workspace anew. It would take them for unchanged: in the
/// archive all files have one time, which is before that of every build.
fn forget_own_crates(fingerprints: &Path) -> anyhow::Result<()> {
    let Ok(entries) = fs::read_dir(fingerprints) else {
        return Ok(());
    };
    for entry in entries {
        let entry = entry.context("cannot read target/python/build")?;
        if entry
            .file_name()
            .to_string_lossy()
            .starts_with("curvecrust")
        {
            fs::remove_dir_all(entry.path()).context("cannot clear target/python/build")?;
        }
    }
    Ok(())
}

/// Where all of it is.
fn folder() -> PathBuf {
    root().join("target/python")
}

/// A virtual environment under `target/python`.
struct Environment {
    folder: PathBuf,
}

impl Environment {
    fn new(name: &str) -> Self {
        Self {
            folder: folder().join(name),
        }
    }

    /// A new one with the wheel and the packages of some of its extras; or why there is none.
    fn fresh(name: &str, wheel: &Path, extras: &[&str]) -> anyhow::Result<Result<Self, Outcome>> {
        let environment = Self::new(name);
        environment.create()?;
        let wheel = format!("{}[{}]", wheel.display(), extras.join(","));
        Ok(match environment.install([&wheel])? {
            None => Ok(environment),
            Some(skipped) => Err(skipped),
        })
    }

    fn create(&self) -> anyhow::Result<()> {
        let mut command = Command::new("python3");
        command.args(["-m", "venv", "--clear"]).arg(&self.folder);
        let status = command.stdin(Stdio::null()).status();
        let status = status.context("cannot run python3")?;
        ensure!(status.success(), "cannot make {}", self.folder.display());
        Ok(())
    }

    /// Installs packages; or says that it cannot.
    fn install<'a>(
        &self,
        packages: impl IntoIterator<Item = &'a (impl AsRef<OsStr> + ?Sized + 'a)>,
    ) -> anyhow::Result<Option<Outcome>> {
        let mut pip = self.python();
        pip.args([
            "-m",
            "pip",
            "install",
            "--quiet",
            "--disable-pip-version-check",
        ]);
        pip.args(packages);
        Ok(match outcome(pip, "pip install")? {
            Outcome::Passed => None,
            _ => Some(Outcome::Skipped(
                "pip cannot install what this needs".to_owned(),
            )),
        })
    }

    /// Its Python, in the folder of the package.
    fn python(&self) -> Command {
        let program = if cfg!(windows) {
            "Scripts/python.exe"
        } else {
            "bin/python"
        };
        let mut command = Command::new(self.folder.join(program));
        command.current_dir(root().join("crates/curvecrust-python"));
        command.stdin(Stdio::null());
        command
    }

    /// Runs a module with arguments.
    fn module(&self, arguments: &[&str]) -> anyhow::Result<Outcome> {
        let mut command = self.python();
        command.arg("-m").args(arguments);
        outcome(command, &format!("python -m {}", arguments.join(" ")))
    }
}
