//! Lines that are too wide to read: comments and documents, which rustfmt leaves alone.

use super::outcome::Outcome;
use anyhow::Context;
use curvecrust_lab::{output_of, root};
use std::fs;

/// Characters on a line, as rustfmt has them for code.
const WIDTH: usize = 100;

/// Folders of generated files.
const GENERATED: [&str; 1] = ["docs/results/"];

/// Names every line of a comment or a document that is too wide.
pub(super) fn run() -> anyhow::Result<Outcome> {
    let Some(files) = output_of("git", &["ls-files"]) else {
        return Ok(Outcome::Skipped("no git repository".to_owned()));
    };
    let mut count = 0;
    for name in files.lines() {
        let Some(kind) = Kind::of(name) else { continue };
        let text = fs::read_to_string(root().join(name));
        let text = text.with_context(|| format!("cannot read {name}"))?;
        for (number, width) in too_wide(kind, &text) {
            eprintln!("{name}:{number}: {width} characters, at most {WIDTH} are allowed");
            count += 1;
        }
    }
    Ok(if count == 0 {
        Outcome::Passed
    } else {
        Outcome::Failed(format!("{count} lines are wider than {WIDTH} characters"))
    })
}

/// What is looked at in a file.
#[derive(Clone, Copy)]
enum Kind {
    /// Text but for code, tables and sentences on a line of their own.
    Markdown,
    /// Comments, which begin with this.
    Comments(&'static str),
}

impl Kind {
    fn of(name: &str) -> Option<Self> {
        if GENERATED.iter().any(|folder| name.starts_with(folder)) {
            return None;
        }
        match name.rsplit_once('.')?.1 {
            "md" => Some(Self::Markdown),
            "rs" => Some(Self::Comments("//")),
            "toml" | "yml" => Some(Self::Comments("#")),
            _ => None,
        }
    }
}

/// The lines that are too wide, counted from 1, with their widths. Rows of tables may be as wide as
/// they like, and so may what cannot be broken: a line of one word, such as an address.
fn too_wide(kind: Kind, text: &str) -> Vec<(usize, usize)> {
    let mut wide = Vec::new();
    let mut in_code = false;
    for (index, line) in text.lines().enumerate() {
        let content = match kind {
            Kind::Markdown => {
                let fence = line.trim_start().starts_with("```");
                in_code ^= fence;
                if in_code || fence || line.starts_with("    ") {
                    continue;
                }
                line
            }
            Kind::Comments(mark) => {
                let Some(content) = line.trim_start().strip_prefix(mark) else {
                    continue;
                };
                content.trim_start_matches(['/', '!', '#'])
            }
        };
        let content = content.trim();
        let width = line.chars().count();
        let whole = match kind {
            Kind::Markdown => is_one_sentence(content),
            Kind::Comments(_) => false,
        };
        if width > WIDTH && !whole && !content.starts_with('|') && content.contains(' ') {
            wide.push((index + 1, width));
        }
    }
    wide
}

/// Whether no sentence ends before the end of the line: a document may have each on its own line.
fn is_one_sentence(line: &str) -> bool {
    let mut words = line.split(' ').peekable();
    while let Some(word) = words.next() {
        // Initials and numbers of a list end no sentence.
        let ends = word.trim_start_matches('(').len() > 2 && word.ends_with(['.', '!', '?']);
        let begins = |next: &&str| next.starts_with(|c: char| c.is_uppercase() || c == '`');
        if ends && words.peek().is_some_and(begins) {
            return false;
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_are_wide_and_code_is_left_to_rustfmt() {
        let words = "word ".repeat(20);
        let rust = Kind::Comments("//");
        let text = format!("//! {words}\n    /// {words}\nlet code = \"{words}\";\n// short\n");
        assert_eq!(too_wide(rust, &text), [(1, 104), (2, 108)]);
        assert!(too_wide(rust, &format!("/// | {words} |\n")).is_empty());
        assert!(too_wide(rust, &format!("// {}\n", "a".repeat(200))).is_empty());
        assert_eq!(
            too_wide(Kind::Comments("#"), &format!("# {words}")),
            [(1, 102)]
        );
    }

    #[test]
    fn documents_are_wide_outside_of_code_and_tables() {
        let words = format!("{}Ends. Begins", "word ".repeat(19));
        assert!(too_wide(Kind::Markdown, &"word ".repeat(30)).is_empty());
        let text = format!("{words}\n```sh\n{words}\n```\n    {words}\n| {words} |\n- {words}\n");
        let found = too_wide(Kind::Markdown, &text);
        assert_eq!(found, [(1, 107), (7, 109)]);
    }
}
