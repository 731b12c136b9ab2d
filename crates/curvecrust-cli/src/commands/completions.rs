//! `curvecrust completions`: what shells need.

use super::Outcome;
use crate::{args, output};
use clap::CommandFactory;
use clap_complete::Shell;

pub(crate) fn run(shell: Shell) -> anyhow::Result<Outcome> {
    let mut script = Vec::new();
    let mut command = args::Cli::command();
    clap_complete::generate(shell, &mut command, "curvecrust", &mut script);
    output::to_stdout(|out| out.write_all(&script))?;
    Ok(Outcome::Fine)
}
