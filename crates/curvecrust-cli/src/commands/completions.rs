//! `curvecrust completions`: what shells need.

use super::Outcome;
use crate::{args, output};
use clap::CommandFactory;

pub(crate) fn run(args: &args::Completions) -> anyhow::Result<Outcome> {
    let mut script = Vec::new();
    let mut command = args::Cli::command();
    clap_complete::generate(args.shell, &mut command, "curvecrust", &mut script);
    output::to_stdout(|out| out.write_all(&script))?;
    Ok(Outcome::Fine)
}
