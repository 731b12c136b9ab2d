//! The first walk over a document: whatever may be drawn is sound, ends, and is not too deep.

use std::collections::HashMap;

use roxmltree::{Document, Node, NodeId};

use super::SVG;
use super::selection::Selection;
use super::shapes::{Shape, Shapes};
use super::strict::{Check, check_sheets, is_drawing, is_shape, label, link, refused, unsupported};
use crate::error::CurveError;

/// Elements within each other, `use` included; each takes room on the stack.
const MAX_DEPTH: usize = 128;

/// The elements by their names; as in browsers, the first of a name counts.
pub(super) type ById<'a, 'input> = HashMap<&'a str, Node<'a, 'input>>;

pub(super) fn by_id<'a, 'input>(document: &'a Document<'input>) -> ById<'a, 'input> {
    let mut by_id = HashMap::new();
    for node in document.descendants() {
        if let Some(id) = node.attribute("id") {
            by_id.entry(id).or_insert(node);
        }
    }
    by_id
}

/// The shapes that look the same wherever they are drawn, once all that is selected is known to be
/// sound.
pub(super) fn shapes(
    root: Node<'_, '_>,
    by_id: &ById<'_, '_>,
    selection: &Selection,
) -> Result<Shapes, CurveError> {
    check_sheets(root)?;
    let mut walk = Walk {
        by_id,
        check: Check::of(root),
        selection,
        heights: HashMap::new(),
        shapes: HashMap::new(),
    };
    walk.element(root, 0, selection.select.is_empty())?;
    Ok(walk.shapes)
}

struct Walk<'a, 'input, 'm> {
    by_id: &'m ById<'a, 'input>,
    check: Check,
    selection: &'m Selection,
    /// How deep the elements seen so far are, selected or not, `use` included; `None` while inside
    /// of them.
    heights: HashMap<(NodeId, bool), Option<usize>>,
    shapes: Shapes,
}

impl<'a, 'input> Walk<'a, 'input, '_> {
    /// Checks what an element draws, and returns how many levels that has.
    fn element(
        &mut self,
        node: Node<'a, 'input>,
        depth: usize,
        is_in_selected: bool,
    ) -> Result<usize, CurveError> {
        if !is_drawing(node) || self.selection.excludes(node) {
            return Ok(0);
        }
        let is_selected = is_in_selected || self.selection.selects(node);
        if is_shape(node) && !is_selected {
            return Ok(0);
        }
        let key = (node.id(), is_selected);
        let height = match self.heights.get(&key) {
            Some(&height) => height.unwrap_or(0),
            None if depth > MAX_DEPTH => 0,
            None => {
                self.heights.insert(key, None);
                let height = 1 + self.first_visit(node, depth, is_selected)?;
                self.heights.insert(key, Some(height));
                height
            }
        };
        if depth + height > MAX_DEPTH {
            let what = format!("it is more than {MAX_DEPTH} levels deep: simplify the document");
            return Err(unsupported(what).within(label(node)));
        }
        Ok(height)
    }

    fn first_visit(
        &mut self,
        node: Node<'a, 'input>,
        depth: usize,
        is_selected: bool,
    ) -> Result<usize, CurveError> {
        let here = |error: CurveError| error.within(label(node));
        self.check.element(node).map_err(here)?;
        if node.has_tag_name((SVG, "use")) {
            let target = self.target(node, is_selected).map_err(here)?;
            return target.map_or(Ok(0), |t| self.element(t, depth + 1, is_selected));
        }
        if let Some(shape) = Shape::anywhere(node).map_err(here)? {
            self.shapes.insert(node.id(), shape);
        }
        let mut height = 0;
        for child in node.children() {
            height = height.max(self.element(child, depth + 1, is_selected)?);
        }
        Ok(height)
    }

    /// The element that a `use` element refers to; one that is not selected may refer to nothing.
    fn target(
        &self,
        node: Node<'a, 'input>,
        is_selected: bool,
    ) -> Result<Option<Node<'a, 'input>>, CurveError> {
        let Some(link) = link(node) else {
            return Ok(None);
        };
        let id = link.value().strip_prefix('#').unwrap_or_default();
        let is_open = |node: &Node<'_, '_>| {
            let is_open = |selected| self.heights.get(&(node.id(), selected)) == Some(&None);
            is_open(is_selected)
        };
        let message = match self.by_id.get(id) {
            None if !is_selected => return Ok(None),
            None => "is no element of the document: correct or remove it",
            Some(target) if is_open(target) => "contains this element itself: correct or remove it",
            Some(&target) => return Ok(Some(target)),
        };
        Err(refused(&link, message))
    }
}
