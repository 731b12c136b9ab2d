//! `cargo xtask fetch-paper-data`: the curves and points of the paper's authors, for measuring
//! only.
//!
//! They are under the GPL and never enter this repository: git ignores the folder they are laid in.

mod cpp;
mod git;
mod install;
#[cfg(test)]
mod tests;

use anyhow::{Context, anyhow, bail, ensure};
use curvecrust_curve::Curve;
use curvecrust_lab::root;
use git::Repository;
use install::{File, files_below, install};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

const AUTHORS: Repository<'_> = Repository {
    git: "git",
    url: "https://github.com/stefango74/hnn-crust-sgp16.git",
    commit: "ef67f83",
};
const SOURCE: &str = "src/TestReconstruct2D.cpp";
const CURVES: [&str; 4] = ["parallel", "teaser", "bunny", "cat"];
const POINTS: [&str; 3] = ["crocodile-conf", "ventilator", "mushroom"];
const NOTE: &str = "\
# Curves and points of the paper's authors

Data of the program published with \"Curve Reconstruction with Many Fewer Samples\" (Ohrhallinger,
Mitchell, Wimmer, SGP 2016): <https://github.com/stefango74/hnn-crust-sgp16>, commit ef67f83.

**Licence: GPL-3.0**, unlike this project. They are here for measuring only: git ignores this folder,
and nothing of it may be copied into the project. `cargo xtask fetch-paper-data` lays it out, from that
repository or from the folder given by `--from`, and replaces it as a whole.

- `curves/*.svg`: one path each, taken from the string of that name in `src/TestReconstruct2D.cpp`.
- `points/*.p2d`: one point a line, `x y`.
";

/// What was typed.
#[derive(clap::Args)]
pub(crate) struct Args {
    /// Take a local clone, or a folder of curves/*.svg and points/*.p2d, instead of cloning from
    /// the network
    #[arg(long, value_name = "DIR")]
    from: Option<PathBuf>,
    /// Replace fixtures/paper even if it holds files of another origin
    #[arg(long)]
    force: bool,
}

/// Reads everything first, then lays it out.
pub(crate) fn run(args: &Args) -> anyhow::Result<ExitCode> {
    let files = match &args.from {
        Some(folder) => read(folder)?,
        None => {
            eprintln!("cloning {}", AUTHORS.url);
            fetch(&AUTHORS)?
        }
    };
    let target = root().join("fixtures").join("paper");
    let replaced = install(&files, &target, args.force)?;
    println!(
        "{} {}: {} curves, {} point sets (GPL-3.0, for measuring only: see NOTE.md there)",
        if replaced { "replaced" } else { "wrote" },
        target.display(),
        CURVES.len(),
        POINTS.len()
    );
    Ok(ExitCode::SUCCESS)
}

fn fetch(repository: &Repository<'_>) -> anyhow::Result<Vec<File>> {
    let scratch = tempfile::tempdir().context("cannot create a temporary folder")?;
    let clone = scratch.path().join("clone");
    repository.clone_into(&clone).map_err(|error| {
        let Repository { url, commit, .. } = repository;
        anyhow!(
            "{error:#}\n\
             By hand, where there is network and git:\n  \
             git clone {url} DIR\n  \
             git -C DIR checkout {commit}\n\
             then: cargo xtask fetch-paper-data --from DIR"
        )
    })?;
    read(&clone)
}

/// The files to lay out, from a clone or from a folder that is laid out already.
fn read(folder: &Path) -> anyhow::Result<Vec<File>> {
    let shown = folder.display();
    fs::read_dir(folder).with_context(|| format!("cannot read the folder {shown}"))?;
    let mut files = if folder.join(SOURCE).is_file() {
        read_clone(folder)?
    } else if folder.join("curves").is_dir() || folder.join("points").is_dir() {
        read_laid_out(folder)?
    } else {
        bail!(
            "{shown} is neither a clone of {} (no {SOURCE}) nor a folder of curves/*.svg and points/*.p2d",
            AUTHORS.url
        );
    };
    files.push((String::from("NOTE.md"), String::from(NOTE)));
    Ok(files)
}

fn read_clone(clone: &Path) -> anyhow::Result<Vec<File>> {
    let path = clone.join(SOURCE);
    let source = read_text(&path)?;
    let mut files = Vec::new();
    for name in CURVES {
        let svg = curve_of(&source, name).with_context(|| format!("in {}", path.display()))?;
        files.push((curve_file(name), svg));
    }
    let present = files_below(clone)?;
    for name in POINTS {
        let file = format!("{name}.p2d");
        let Some(path) = present.iter().find(|path| path.ends_with(&file)) else {
            bail!("no {file} anywhere in {}", clone.display());
        };
        files.push((points_file(name), read_points(path)?));
    }
    Ok(files)
}

fn read_laid_out(folder: &Path) -> anyhow::Result<Vec<File>> {
    let names = CURVES.map(curve_file).into_iter();
    let missing: Vec<String> = names
        .chain(POINTS.map(points_file))
        .filter(|name| !folder.join(name).is_file())
        .collect();
    ensure!(
        missing.is_empty(),
        "{} lacks {}",
        folder.display(),
        missing.join(", ")
    );
    let mut files = Vec::new();
    for name in CURVES.map(curve_file) {
        let text = read_svg(&folder.join(&name))?;
        files.push((name, text));
    }
    for name in POINTS.map(points_file) {
        let text = read_points(&folder.join(&name))?;
        files.push((name, text));
    }
    Ok(files)
}

fn curve_file(name: &str) -> String {
    format!("curves/{name}.svg")
}

fn points_file(name: &str) -> String {
    format!("points/{name}.p2d")
}

fn read_text(path: &Path) -> anyhow::Result<String> {
    let bytes = fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
    // Only comments may hold anything but ASCII.
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

fn read_points(path: &Path) -> anyhow::Result<String> {
    let text = read_text(path)?;
    let is_point = |line: &str| {
        let numbers: Result<Vec<f64>, _> = line.split_whitespace().map(str::parse).collect();
        numbers.is_ok_and(|xy| xy.len() == 2 && xy.iter().all(|v| v.is_finite()))
    };
    ensure!(
        text.lines().any(is_point),
        "{} holds no point: no line is `x y`",
        path.display()
    );
    Ok(text)
}

fn read_svg(path: &Path) -> anyhow::Result<String> {
    let text = read_text(path)?;
    Curve::from_svg(&text).with_context(|| format!("{} holds no curve", path.display()))?;
    Ok(text)
}

/// An SVG of the path data that a C++ source gives the string `name`.
fn curve_of(source: &str, name: &str) -> anyhow::Result<String> {
    let strings = cpp::strings(source, name);
    let mut curves = Vec::new();
    let mut refused = anyhow!("no string literal named {name}");
    for data in &strings {
        match Curve::from_path_data(data) {
            Ok(curve) => curves.push((data.trim(), curve)),
            Err(error) => {
                let error = anyhow::Error::new(error);
                refused = error.context(format!("the string {name} is no curve"));
            }
        }
    }
    match &curves[..] {
        [] => Err(refused),
        [(data, curve)] => Ok(svg(name, data, curve)),
        _ => bail!("several path strings named {name}"),
    }
}

/// An SVG of one path, which fills the page but for a margin.
fn svg(name: &str, path_data: &str, curve: &Curve) -> String {
    let (low, high) = curve.bounding_box();
    let margin = 0.02 * curve.extent();
    let (corner, size) = (low - margin, high - low + 2.0 * margin);
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{:.3} {:.3} {:.3} {:.3}\">\n  \
         <path id=\"{name}\" fill=\"none\" stroke=\"black\" d=\"{path_data}\"/>\n\
         </svg>\n",
        corner.x, corner.y, size.x, size.y
    )
}
