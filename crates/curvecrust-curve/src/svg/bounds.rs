//! What a document may hold of what parsers take more time or memory for than it is long. It is
//! counted in the text, before any of them reads it.

use super::entities::expansion;
use super::strict::unsupported;
use super::{MAX_EXPANSION, SVG};
use crate::error::CurveError;
use roxmltree::{Document, Node, NodeId};
use std::collections::HashSet;
use std::collections::hash_map::{Entry, HashMap};

/// Entities that a document declares: each reference is looked up among all.
pub const MAX_ENTITIES: usize = 1_000;

/// Attributes of an element: each is compared with all before it.
pub const MAX_ATTRIBUTES: usize = 1_000;

/// Prefixes of namespaces that a document declares: each element that declares one compares all
/// that are in scope.
pub const MAX_PREFIXES: usize = 100;

/// Elements as they are drawn, once for each `use` of them.
pub const MAX_ELEMENTS: u64 = 1_000_000;

/// Checks the bounds that can be seen in the text of a document, well-formed or not: what its
/// entities stand for, how many there are, how many prefixes of namespaces, and how many attributes
/// elements have.
///
/// # Errors
/// [`CurveError::Unsupported`].
///
/// ```
/// use curvecrust_curve::svg::check_bounds;
///
/// assert!(check_bounds("<svg width='9'><path d='M 0 0 H 1'/></svg>").is_ok());
/// assert!(check_bounds(&format!("<svg {}/>", "a='' ".repeat(2_000))).is_err());
/// ```
pub fn check_bounds(document: &str) -> Result<(), CurveError> {
    if expansion(document) > MAX_EXPANSION {
        return Err(unsupported(format!(
            "its entities stand for more than {MAX_EXPANSION} bytes: write out what they stand for"
        )));
    }
    if document.matches("<!ENTITY").count() > MAX_ENTITIES {
        return Err(unsupported(format!(
            "it declares more than {MAX_ENTITIES} entities: write out what they stand for"
        )));
    }
    let after = document.split("xmlns:").skip(1);
    let prefixes = after.filter_map(|rest| rest.split(['=', ' ', '\'', '"', '<']).next());
    if prefixes.collect::<HashSet<_>>().len() > MAX_PREFIXES {
        return Err(unsupported(format!(
            "it declares more than {MAX_PREFIXES} prefixes of namespaces: remove those not used"
        )));
    }
    if let Some(at) = crowded_tag(document) {
        let line = document[..at].matches('\n').count() + 1;
        return Err(unsupported(format!(
            "an element in line {line} has more than {MAX_ATTRIBUTES} attributes: simplify it"
        )));
    }
    Ok(())
}

/// Where the first tag starts that has too many attributes, also one in the value of an entity.
/// What looks like a tag in a comment counts as well.
fn crowded_tag(document: &str) -> Option<usize> {
    let mut start = 0;
    // No tag holds this sign: in values it has to be escaped.
    for tag in document.split('<') {
        let mut count = 0;
        let mut quote = None;
        for c in tag.chars() {
            match quote {
                Some(mark) if mark == c => quote = None,
                Some(_) => {}
                None if c == '>' => break,
                None if c == '\'' || c == '"' => {
                    quote = Some(c);
                    count += 1;
                }
                None => {}
            }
        }
        if count > MAX_ATTRIBUTES {
            return Some(start);
        }
        start += tag.len() + 1;
    }
    None
}

/// Refuses documents whose elements, each counted once for each `use` of it, are too many.
pub(super) fn check_elements(
    root: Node<'_, '_>,
    target: impl Fn(&str) -> Option<NodeId>,
) -> Result<(), CurveError> {
    if drawn_elements(root, target) > MAX_ELEMENTS {
        return Err(too_many_elements());
    }
    Ok(())
}

pub(super) fn too_many_elements() -> CurveError {
    unsupported(format!(
        "it has more than {MAX_ELEMENTS} elements, each drawn once per use: simplify the document"
    ))
}

/// The elements of SVG in a subtree, those that `use` refers to as often as it does. Loops, which
/// are refused elsewhere, count once.
fn drawn_elements(root: Node<'_, '_>, target: impl Fn(&str) -> Option<NodeId>) -> u64 {
    let document: &Document<'_> = root.document();
    let mut counts: HashMap<NodeId, u64> = HashMap::new();
    let mut open = vec![(root, false)];
    while let Some((node, is_counted_below)) = open.pop() {
        let used = node
            .attributes()
            .filter(|attribute| attribute.name() == "href" && node.tag_name().name() == "use")
            .filter_map(|attribute| attribute.value().strip_prefix('#'))
            .filter_map(&target)
            .filter_map(|id| document.get_node(id));
        let below = node.children().filter(Node::is_element).chain(used);
        if is_counted_below {
            let count = |node: Node<'_, '_>| counts.get(&node.id()).copied().unwrap_or(0);
            let is_svg = matches!(node.tag_name().namespace(), None | Some(SVG));
            let sum = below
                .map(count)
                .fold(u64::from(is_svg), u64::saturating_add);
            counts.insert(node.id(), sum);
        } else if let Entry::Vacant(entry) = counts.entry(node.id()) {
            // Until it is known, it counts as nothing for those inside of it.
            entry.insert(0);
            open.push((node, true));
            open.extend(below.map(|node| (node, false)));
        }
    }
    counts.get(&root.id()).copied().unwrap_or(0)
}
