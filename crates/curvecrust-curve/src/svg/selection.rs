//! Which elements of a document are drawn: all, or those that a user names.

use std::collections::HashSet;

use roxmltree::{Document, Node};

use super::strict::unsupported;
use crate::error::CurveError;

const INKSCAPE: &str = "http://www.inkscape.org/namespaces/inkscape";

/// Elements by their names: an `id`, one of the classes, or the label of a layer of Inkscape.
///
/// A name stands for every element that has it, with all that is in it. The default selects all.
///
/// ```
/// use curvecrust_curve::svg::{Drawing, Selection};
///
/// let svg = "<svg xmlns='http://www.w3.org/2000/svg'>
///     <rect id='background' width='9' height='9'/><circle cx='4' cy='4' r='2'/></svg>";
/// let selection = Selection { exclude: vec!["background".to_owned()], ..Selection::default() };
/// assert_eq!(Drawing::selected(svg, &selection)?.components().len(), 1);
/// # Ok::<(), curvecrust_curve::CurveError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Selection {
    /// Only these are drawn; all, if there are none.
    pub select: Vec<String>,
    /// These are not drawn, nor looked at.
    pub exclude: Vec<String>,
}

impl Selection {
    /// Whether an element is named among those to be drawn.
    pub(super) fn selects(&self, node: Node<'_, '_>) -> bool {
        !self.select.is_empty() && names(node).any(|name| self.select.iter().any(|s| s == name))
    }

    /// Whether an element is named among those not to be drawn.
    pub(super) fn excludes(&self, node: Node<'_, '_>) -> bool {
        !self.exclude.is_empty() && names(node).any(|name| self.exclude.iter().any(|s| s == name))
    }

    /// Refuses names that no element has.
    pub(super) fn check(&self, document: &Document<'_>) -> Result<(), CurveError> {
        let asked = || self.select.iter().chain(&self.exclude);
        if asked().next().is_none() {
            return Ok(());
        }
        let known: HashSet<&str> = document.descendants().flat_map(names).collect();
        match asked().find(|name| !known.contains(name.as_str())) {
            None => Ok(()),
            Some(name) => Err(unsupported(format!(
                "no element has the id, the class or the label \"{name}\": give one that is there"
            ))),
        }
    }
}

/// All names of an element.
fn names<'a>(node: Node<'a, '_>) -> impl Iterator<Item = &'a str> {
    let classes = node.attribute("class").unwrap_or_default();
    let one = [node.attribute("id"), node.attribute((INKSCAPE, "label"))];
    one.into_iter()
        .flatten()
        .chain(classes.split_ascii_whitespace())
}
