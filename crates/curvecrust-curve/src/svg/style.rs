//! Style that takes time out of proportion to apply: the reader compares each element with each
//! selector, and each declaration of an element with all before it.

use super::strict::{label, unsupported};
use crate::error::CurveError;
use roxmltree::{Document, Node};

/// Declarations in a `style` attribute or in a rule of a style sheet.
pub const MAX_DECLARATIONS: usize = 1_000;

/// Selectors and declarations of all style sheets, times elements: as many as this in any document,
const MAX_APPLICATIONS: u64 = 10_000_000;
/// and as many as this more for each of its bytes.
const APPLICATIONS_PER_BYTE: u64 = 64;

/// Bytes of a list of classes that take as long to look through as an element takes else.
const CLASS_BYTES: usize = 64;

/// Refuses style that is out of proportion.
pub(super) fn check(document: &Document<'_>) -> Result<(), CurveError> {
    let (mut elements, mut rules) = (0, 0);
    for node in document.descendants().filter(Node::is_element) {
        let classes = node.attribute("class").unwrap_or_default().len();
        elements += 1 + (classes / CLASS_BYTES) as u64;
        let style = node.attribute("style").unwrap_or_default();
        check_declarations(style).map_err(|error| error.within(label(node)))?;
        if node.tag_name().name() == "style" {
            let sheet: String = node.descendants().filter_map(|n| n.text()).collect();
            for rule in sheet.split('}') {
                check_declarations(rule).map_err(|error| error.within(label(node)))?;
            }
            let is_counted = |c: &char| ['{', ',', ';'].contains(c);
            rules += sheet.chars().filter(is_counted).count() as u64;
        }
    }
    let bytes = document.input_text().len() as u64;
    let most = MAX_APPLICATIONS + APPLICATIONS_PER_BYTE * bytes;
    if elements * rules > most {
        return Err(unsupported(format!(
            "its style sheets have {rules} selectors and declarations for {elements} elements: \
             simplify them"
        )));
    }
    Ok(())
}

fn check_declarations(style: &str) -> Result<(), CurveError> {
    if style.matches(';').count() > MAX_DECLARATIONS {
        return Err(unsupported(format!(
            "it has more than {MAX_DECLARATIONS} declarations of style: simplify it"
        )));
    }
    Ok(())
}
