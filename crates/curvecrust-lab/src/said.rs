//! What other programs say.

use crate::root::root;
use std::process::Command;

/// What a program prints, run at the root, without white space around; nothing if it cannot be run or
/// prints nothing.
#[must_use]
pub fn said(program: &str, arguments: &[&str]) -> Option<String> {
    let output = Command::new(program)
        .args(arguments)
        .current_dir(root())
        .output();
    let text = output.map(|o| String::from_utf8_lossy(&o.stdout).trim().to_owned());
    text.ok().filter(|text| !text.is_empty())
}
