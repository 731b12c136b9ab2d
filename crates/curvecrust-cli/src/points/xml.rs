//! What the readers of GPX and KML share.

use super::svg::document;
use super::{Flaw, Place, Problem};
use roxmltree::{Document, Node};

/// The document, if its root element has the name; else the problem.
pub(super) fn with_root<'a>(
    bytes: &'a [u8],
    root: &str,
    otherwise: fn() -> Problem,
) -> Result<Document<'a>, Flaw> {
    let text = str::from_utf8(bytes).map_err(|_| otherwise())?;
    let document = document(text)?;
    if document.root_element().tag_name().name() == root {
        Ok(document)
    } else {
        Err(otherwise().into())
    }
}

/// The line that an element starts in.
pub(super) fn line_of(node: Node<'_, '_>) -> Place {
    let at = node.document().text_pos_at(node.range().start);
    Place::Line(at.row.into())
}
