//! Which kind of XML content is, by its root element.

use crate::format::Format;
use crate::points::quote::quoted;
use crate::points::{Flaw, Problem};

/// The format of a document; its start is known.
pub(super) fn format(head: &[u8]) -> Result<Format, Flaw> {
    Ok(match root(head) {
        Some(b"gpx") => Format::Gpx,
        Some(b"kml") => Format::Kml,
        Some(b"svg") | None => Format::Svg,
        Some(other) => return Err(Problem::OtherXml(quoted(other)).into()),
    })
}

/// The name of the root element without its prefix; `None` while it has not been seen.
pub(super) fn root(head: &[u8]) -> Option<&[u8]> {
    let mut rest = head.trim_ascii_start();
    loop {
        rest = match rest {
            [b'<', b'?', ..] => after(rest, b"?>")?,
            [b'<', b'!', b'-', b'-', ..] => after(rest, b"-->")?,
            [b'<', b'!', ..] => after_declaration(rest)?,
            [b'<', name @ ..] => {
                let is_end = |byte: &u8| byte.is_ascii_whitespace() || b"/>".contains(byte);
                let name = &name[..name.iter().position(is_end)?];
                return name.rsplit(|&byte| byte == b':').next();
            }
            _ => return None,
        }
        .trim_ascii_start();
    }
}

fn after<'a>(text: &'a [u8], end: &[u8]) -> Option<&'a [u8]> {
    let at = text.windows(end.len()).position(|window| window == end)?;
    Some(&text[at + end.len()..])
}

/// What follows a document type, which may have declarations of its own in brackets.
fn after_declaration(text: &[u8]) -> Option<&[u8]> {
    let end = text.iter().position(|byte| b"[>".contains(byte))?;
    match text[end] {
        b'[' => after(after(text, b"]")?, b">"),
        _ => Some(&text[end + 1..]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_root_is_the_first_element() {
        for (text, name) in [
            ("<svg>", "svg"),
            (
                "<?xml version='1.0'?>\n<!-- <gpx> -->\n<k:kml x='1'>",
                "kml",
            ),
            ("<!DOCTYPE svg [<!ENTITY e '1'>]><svg/>", "svg"),
            ("<!DOCTYPE html>\n<html>", "html"),
        ] {
            assert_eq!(root(text.as_bytes()), Some(name.as_bytes()), "{text}");
        }
        for text in [
            "",
            "<",
            "<sv",
            "<!-- <svg>",
            "<?xml <svg>",
            "<!DOCTYPE svg [",
            "1 2",
        ] {
            assert_eq!(root(text.as_bytes()), None, "{text}");
        }
    }
}
