//! Clones with git, which never asks for anything.

use anyhow::{Context, ensure};
use std::io::ErrorKind;
use std::path::Path;
use std::process::{Command, Stdio};

/// A commit of a repository, and the program to get it with.
pub(super) struct Repository<'a> {
    pub(super) git: &'a str,
    pub(super) url: &'a str,
    pub(super) commit: &'a str,
}

impl Repository<'_> {
    /// Checks the commit out into a new folder.
    pub(super) fn clone_into(&self, folder: &Path) -> anyhow::Result<()> {
        let mut clone = self.git();
        clone
            .args(["clone", "--quiet", "--no-checkout", "--", self.url])
            .arg(folder);
        succeed(&mut clone).with_context(|| format!("cloning {}", self.url))?;
        let mut checkout = self.git();
        checkout.current_dir(folder);
        checkout.args(["checkout", "--quiet", "--detach", self.commit]);
        succeed(&mut checkout).with_context(|| format!("checking out {}", self.commit))
    }

    fn git(&self) -> Command {
        let mut command = Command::new(self.git);
        command
            .stdin(Stdio::null())
            .env("GIT_TERMINAL_PROMPT", "0")
            .env("GIT_ASKPASS", "")
            .env("GIT_SSH_COMMAND", "ssh -o BatchMode=yes")
            // A network that answers nothing is an error, not a wait.
            .args(["-c", "http.lowSpeedLimit=1", "-c", "http.lowSpeedTime=30"]);
        // Set in hooks of git: they would point to another repository.
        for name in ["GIT_DIR", "GIT_WORK_TREE", "GIT_INDEX_FILE"] {
            command.env_remove(name);
        }
        command
    }
}

fn succeed(command: &mut Command) -> anyhow::Result<()> {
    let output = match command.output() {
        Err(error) if error.kind() == ErrorKind::NotFound => {
            return Err(error).context("there is no git on the PATH");
        }
        output => output.context("cannot start git")?,
    };
    let message = String::from_utf8_lossy(&output.stderr);
    ensure!(
        output.status.success(),
        "git failed ({}): {}",
        output.status,
        message.trim()
    );
    Ok(())
}
