//! How large a document becomes when its entities are replaced.
//!
//! The reader of XML bounds how deep and how often entities refer to each other, but not how often
//! a long one is used: a document of a megabyte could grow to a hundred gigabytes.

use std::collections::HashMap;

/// Entities in each other that are followed: the reader refuses more than 10.
const DEEPEST: usize = 64;

/// The bytes that the general entities of an XML document stand for, each as often as it is
/// referred to: at least as many as a reader would put into their places. Text that is no XML has
/// none. Entities that refer to each other more than 64 times in a row stand for [`usize::MAX`].
///
/// ```
/// use curvecrust_curve::svg::expansion;
///
/// let document = "<!DOCTYPE svg [<!ENTITY d 'M 0 0 H 1'>]><svg><path d='&d;'/><path
/// d='&d;'/></svg>"; assert_eq!(expansion(document), 18);
/// assert_eq!(expansion("<svg>&lt;&#65;</svg>"), 0);
/// ```
#[must_use]
pub fn expansion(document: &str) -> usize {
    let mut entities = Entities::default();
    for declaration in document.split("<!ENTITY").skip(1) {
        if let Some((name, value)) = declared(declaration) {
            // Of two with one name the longer: which of them counts is for the reader to say.
            let known = entities.values.entry(name).or_default();
            if value.len() > known.len() {
                *known = value;
            }
        }
    }
    if entities.values.is_empty() {
        return 0;
    }
    entities.all_in(document, DEEPEST)
}

/// The name and the value of a declaration, from behind its keyword.
fn declared(declaration: &str) -> Option<(&str, &str)> {
    let (name, rest) = declaration
        .trim_start()
        .split_once(|c: char| c.is_ascii_whitespace())?;
    let rest = rest.trim_start();
    let quote = rest.chars().next().filter(|c| ['"', '\''].contains(c))?;
    let (value, _) = rest[1..].split_once(quote)?;
    Some((name, value))
}

#[derive(Default)]
struct Entities<'a> {
    values: HashMap<&'a str, &'a str>,
    /// The sizes known so far; 0 while inside of one, whose loop the reader refuses.
    sizes: HashMap<&'a str, usize>,
}

impl<'a> Entities<'a> {
    /// The bytes that all references in a text stand for, which may be so deep.
    fn all_in(&mut self, text: &'a str, depth: usize) -> usize {
        let mut bytes = 0usize;
        for reference in text.split('&').skip(1) {
            if let Some((name, _)) = reference.split_once(';') {
                bytes = bytes.saturating_add(self.size(name, depth));
            }
        }
        bytes
    }

    fn size(&mut self, name: &'a str, depth: usize) -> usize {
        if let Some(&size) = self.sizes.get(name) {
            return size;
        }
        let Some(&value) = self.values.get(name) else {
            return 0;
        };
        let Some(depth) = depth.checked_sub(1) else {
            return usize::MAX;
        };
        self.sizes.insert(name, 0);
        let size = value.len().saturating_add(self.all_in(value, depth));
        self.sizes.insert(name, size);
        size
    }
}
