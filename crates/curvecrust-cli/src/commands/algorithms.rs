//! `curvecrust algorithms`: the list of them.

use super::Outcome;
use crate::output;
use curvecrust::reconstruct::{ALGORITHMS, AlgorithmInfo, Basis, Guarantee};
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
    honours_known: bool,
    made_for: Scope,
    argued: bool,
}

/// The curves that an algorithm is made for.
#[derive(Serialize)]
struct Scope {
    closed: bool,
    open: bool,
    several: bool,
    corners: bool,
    crossings: bool,
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
        honours_known: info.honours_known,
        made_for: Scope {
            closed: info.scope.closed,
            open: info.scope.open,
            several: info.scope.several,
            corners: info.scope.corners,
            crossings: info.scope.crossings,
        },
        argued: info.basis == Basis::Argued,
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
    let argued = if entry.argued {
        ". The definition is argued: the publication was not available"
    } else {
        ""
    };
    let options = match (entry.honours_known, entry.honours_termini) {
        (true, true) => "; takes --closed, --open, --curves and --terminus",
        (true, false) => "; takes --closed, --open and --curves",
        (false, true) => "; takes --terminus",
        (false, false) => "",
    };
    writeln!(out, "{}", entry.name)?;
    writeln!(out, "    {}{argued}", entry.citation)?;
    writeln!(out, "    for curves: {}", info.scope)?;
    writeln!(out, "    {guarantees}; {}{options}", entry.cost)
}
