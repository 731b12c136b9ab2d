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

/// The lines of a document: the reader of XML would count them from its start for each element.
pub(super) struct Lines(Vec<usize>);

impl Lines {
    pub(super) fn new(document: &Document<'_>) -> Self {
        let ends = document.input_text().match_indices('\n');
        Self(ends.map(|(at, _)| at).collect())
    }

    /// The line that an element starts in.
    pub(super) fn of(&self, node: Node<'_, '_>) -> Place {
        let start = node.range().start;
        Place::Line(self.0.partition_point(|&end| end < start) as u64 + 1)
    }
}
