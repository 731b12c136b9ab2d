//! The steps, by name and order, and what each one runs.

use super::cargo::{cargo, cargo_with, has};
use super::outcome::Outcome;
use super::{advisories, fuzz, instructions, lines, packages, rust_version, tools, wasm, web};
use clap::ValueEnum;
use curvecrust_lab::root;

/// What is run, in this order. The first line of each is shown before the step runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Step {
    /// Format of all sources
    Format,
    /// Width of comments and documents
    Lines,
    /// Format of manifests and other TOML files, by taplo
    Toml,
    /// Spelling of sources and documents, by typos
    Typos,
    /// Lints, of the libraries and programs alone and with all tests and benches
    Clippy,
    /// Tests of the workspace
    Tests,
    /// Examples in the documentation
    Doctests,
    /// Documentation without a warning
    Docs,
    /// Each feature of each crate alone
    Features,
    /// The oldest Rust that the manifests promise
    RustVersion,
    /// The libraries for WebAssembly
    Wasm,
    /// The explorer, in a browser
    Web,
    /// Every crate as it would be published
    Package,
    /// The Python package: wheel, tests, lints and pages
    Python,
    /// Licences, bans and sources of all dependencies
    Deny,
    /// Known vulnerabilities of all dependencies, those of the fuzz targets included
    Advisories,
    /// The tables of the paper within their bounds
    ReproducePaper,
    /// The experiments of compare, at few trials
    Compare,
    /// The certificates of Theorem 2
    #[value(name = "theorem-2")]
    Theorem2,
    /// Instructions of the kernels against the committed baseline
    Instructions,
    /// Each fuzz target, for half a minute
    Fuzz,
}

impl Step {
    /// The steps of `cargo xtask test`, in the order in which they fail fastest: they need nothing
    /// but cargo.
    pub(super) const TEST: [Self; 6] = [
        Self::Format,
        Self::Lines,
        Self::Clippy,
        Self::Tests,
        Self::Doctests,
        Self::Docs,
    ];

    /// The name by which it is asked for.
    pub(super) fn name(self) -> String {
        let value = self.to_possible_value();
        value.map_or_else(String::new, |value| value.get_name().to_owned())
    }

    /// What it looks at.
    pub(super) fn about(self) -> String {
        let value = self.to_possible_value();
        let help = value.as_ref().and_then(|value| value.get_help());
        help.map(ToString::to_string).unwrap_or_default()
    }

    pub(super) fn run(self, renew_instructions: bool) -> anyhow::Result<Outcome> {
        match self {
            Self::Format => cargo("fmt --all -- --check"),
            Self::Lines => lines::run(),
            Self::Toml => tools::taplo(),
            Self::Typos => tools::typos(),
            Self::Clippy => match cargo("clippy --workspace -- -D warnings")? {
                Outcome::Passed => cargo("clippy --workspace --all-targets -- -D warnings"),
                alone => Ok(alone),
            },
            Self::Tests if has("nextest") => cargo("nextest run --workspace"),
            // Without the doctests, a step of their own, and the benches, which are no tests.
            Self::Tests => cargo("test --workspace --lib --bins --tests --examples"),
            Self::Doctests => cargo("test --workspace --doc"),
            Self::Docs => cargo_with(
                ("RUSTDOCFLAGS", "-Dwarnings"),
                "doc --workspace --no-deps --all-features",
            ),
            Self::Features => packages::each_feature_alone(),
            Self::RustVersion => rust_version::run(),
            Self::Wasm => wasm::run(),
            Self::Web => web::run(),
            Self::Package => packages::publishable(),
            Self::Python => crate::python::test_and_docs(),
            Self::Deny if !has("deny") => Ok(Outcome::Skipped("no cargo-deny".to_owned())),
            Self::Deny => cargo("deny check licenses bans sources"),
            Self::Advisories => advisories::run(),
            Self::ReproducePaper => reproduce_paper(),
            Self::Compare => cargo("xtask compare --quick"),
            Self::Theorem2 => cargo("xtask theorem-2 --check"),
            Self::Instructions => instructions::run(renew_instructions),
            Self::Fuzz => fuzz::run(),
        }
    }
}

/// The tables on the authors' curves, where these are at hand.
fn reproduce_paper() -> anyhow::Result<Outcome> {
    let beside = root().join("../shared/paper-data");
    if beside.is_dir() {
        let fetched = cargo("xtask fetch-paper-data --from ../shared/paper-data")?;
        if !matches!(fetched, Outcome::Passed) {
            return Ok(fetched);
        }
    } else if !root().join("fixtures/paper").is_dir() {
        let why = "no curves of the paper: cargo xtask fetch-paper-data lays them under fixtures";
        return Ok(Outcome::Skipped(why.to_owned()));
    }
    cargo("xtask reproduce-paper")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_step_says_what_it_looks_at() {
        for step in Step::value_variants() {
            assert!(step.about().len() > 10, "{}", step.name());
        }
    }

    #[test]
    fn the_steps_of_test_keep_the_order_of_all() {
        let all = Step::value_variants();
        let place = |step: &Step| all.iter().position(|other| other == step);
        assert!(Step::TEST.is_sorted_by_key(place));
    }
}
