//! `curvecrust algorithms`: the list of them.

use super::Outcome;
use crate::output;
use curvecrust::reconstruct::{ALGORITHMS, AlgorithmInfo, Guarantee};
use serde::Serialize;
use std::io::{self, Write};

/// What `--json` prints; the schema is stable, and in `docs/formats.md`.
#[derive(Serialize)]
struct Object {
    algorithms: Vec<Entry>,
}

/// One algorithm.
#[derive(Serialize)]
struct Entry {
    name: &'static str,
    citation: &'static str,
    guarantees: Vec<String>,
    cost: &'static str,
    honours_termini: bool,
}

pub(crate) fn run(json: bool) -> anyhow::Result<Outcome> {
    let infos = ALGORITHMS.iter().map(|algorithm| algorithm.info());
    if json {
        let algorithms = infos.map(entry).collect();
        output::print_json(&Object { algorithms })?;
    } else {
        output::to_stdout(|out| infos.into_iter().try_for_each(|info| write(out, info)))?;
    }
    Ok(Outcome::Fine)
}

fn entry(info: AlgorithmInfo) -> Entry {
    Entry {
        name: info.name,
        citation: info.citation,
        guarantees: info.guarantees.iter().map(Guarantee::to_string).collect(),
        cost: info.cost,
        honours_termini: info.honours_termini,
    }
}

fn write(out: &mut dyn Write, info: AlgorithmInfo) -> io::Result<()> {
    let entry = entry(info);
    let guarantees = match &entry.guarantees[..] {
        [] => String::from("no condition is known under which it is correct"),
        some => format!(
            "claimed correct for closed smooth curves with {}",
            some.join(" or ")
        ),
    };
    let termini = if entry.honours_termini {
        "; takes --terminus"
    } else {
        ""
    };
    writeln!(out, "{}", entry.name)?;
    writeln!(out, "    {}", entry.citation)?;
    writeln!(out, "    {guarantees}; {}{termini}", entry.cost)
}
