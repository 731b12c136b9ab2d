//! The tasks of the project: `cargo xtask <task>`. One file per task; this one only dispatches.

#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a program for a terminal"
)]

mod bench;
mod ci;
mod compare;
mod counterexamples;
mod docs;
mod fetch_paper_data;
mod noise;
mod python;
mod reproduce_paper;
mod test;
mod theorem_2;
mod web;

use clap::{Parser, Subcommand};
use std::process::ExitCode;

/// Exit status: 0 when all is well, 1 when a check failed, 2 when the task could not be carried
/// out.
#[derive(Parser)]
#[command(
    name = "cargo xtask",
    bin_name = "cargo xtask",
    about = "The tasks of the project"
)]
struct Cli {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Check the whole workspace: format, lints, tests, doctests, docs
    Test(test::Args),
    /// What has to pass before a change goes in: all of it, or the steps that are named
    Ci(ci::Args),
    /// Lay the paper authors' curves and points (GPL-3.0) under fixtures/paper, which git ignores
    FetchPaperData(fetch_paper_data::Args),
    /// Measure against peers and goals, print the table, write it under target/bench
    Bench(bench::Args),
    /// Compare the reconstruction algorithms: experiments, tables, plots and a page
    Compare(compare::Args),
    /// Prove how sparse the samples are on which algorithms are known to fail, or find others
    Counterexamples(counterexamples::Args),
    /// Draw and write the generated files under docs, or check that they are fresh
    Docs(docs::Args),
    /// Fit curves to points that scatter about known ones: tables, and pictures of what went wrong
    Noise(noise::Args),
    /// The Python package: build its wheel, test it, build its pages, measure it
    Python(python::Args),
    /// Reproduce Tables 1 to 3 and the figures of "Curve Reconstruction with Many Fewer Samples"
    ReproducePaper(reproduce_paper::Args),
    /// Prove Theorem 2 for some rho by machine, write the certificates and check them
    #[command(name = "theorem-2")]
    Theorem2(theorem_2::Args),
    /// Build the explorer, a page of static files, under target/web
    Web(web::Args),
}

fn main() -> ExitCode {
    let outcome = match Cli::parse().task {
        Task::Test(args) => test::run(&args),
        Task::Ci(args) => ci::run(&args),
        Task::FetchPaperData(args) => fetch_paper_data::run(&args),
        Task::Bench(args) => bench::run(&args),
        Task::Compare(args) => compare::run(&args),
        Task::Counterexamples(args) => counterexamples::run(&args),
        Task::Docs(args) => docs::run(&args),
        Task::Noise(args) => noise::run(&args),
        Task::Python(args) => python::run(&args),
        Task::ReproducePaper(args) => reproduce_paper::run(&args),
        Task::Theorem2(args) => theorem_2::run(&args),
        Task::Web(args) => web::run(&args),
    };
    outcome.unwrap_or_else(|error| {
        eprintln!("error: {error:#}");
        ExitCode::from(2)
    })
}
