//! `cargo xtask docs`: the files under docs that are made, not written.

use curvecrust_lab::{docs, root, write_atomically};
use std::process::ExitCode;

/// What was typed.
#[derive(clap::Args)]
pub(crate) struct Args {
    /// Write nothing; exit with status 1 if a file is not what would be written
    #[arg(long)]
    check: bool,
}

/// Writes or checks every generated file.
pub(crate) fn run(args: &Args) -> anyhow::Result<ExitCode> {
    let mut stale = false;
    for (name, text) in docs::made()? {
        let path = root().join(&name);
        if !args.check {
            write_atomically(&path, &text)?;
            println!("wrote {name}");
        } else if std::fs::read_to_string(&path).ok().as_ref() != Some(&text) {
            println!("{name} is stale: run cargo xtask docs");
            stale = true;
        }
    }
    Ok(ExitCode::from(u8::from(stale)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn generated_files_are_fresh() {
        assert_eq!(run(&Args { check: true }).unwrap(), ExitCode::SUCCESS);
    }
}
