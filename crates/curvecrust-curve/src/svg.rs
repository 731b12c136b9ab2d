//! SVG documents: the geometry that they draw, in double precision.
//!
//! A [`Drawing`] is the geometry of a document and nothing of its paint: a shape counts with or
//! without fill and stroke, clips and masks cut off nothing, markers and dashes are not drawn.
//! Coordinates are those of the user space inside the root element, which is what its content is
//! written in; its `viewBox`, size and transform only place that on a page. `y` grows as in the
//! document.
//!
//! - **Read** are paths and the basic shapes, with circles, ellipses and rounded corners by the
//!   same arcs as in path data; `g`, `a`, `use`, `symbol`, `switch` and nested `svg` with their
//!   transforms, viewports and units; and `display` and `visibility`, by attributes and style
//!   sheets. All is computed in double precision.
//! - **Not part of the curve** is what SVG does not draw as a shape: hidden elements (`display`,
//!   `visibility`), what is drawn only by reference (`defs`, `clipPath`, `pattern`, ...), text and
//!   images. Subpaths of a single point draw nothing and are left out; [`Drawing::points`] lists
//!   them. No file is ever opened.
//! - **Refused** is what would be left out or misplaced without anyone noticing: attributes that
//!   are malformed or out of range, lengths in units of a font, geometry in CSS, references to
//!   nothing.
//! - **Chosen** are all elements, or by a [`Selection`] some of them.
//! - **Bounded**, for documents that nobody vouches for: the [`expansion`] of entities and their
//!   number, attributes of an element, declarations of style, levels of elements, elements and
//!   segments drawn, before any of it is laid out. Nothing outside of the document is ever read.
//!
//! The XML is read by roxmltree, path data, lengths and transforms by svgtypes, style sheets by
//! simplecss. usvg, which builds on these three, computes in single precision.

mod bounds;
mod css;
mod drawing;
mod entities;
mod layout;
mod selection;
mod shapes;
mod strict;
mod style;
pub mod value;
mod walk;

use crate::error::DENSE_LIMIT;
pub use bounds::{MAX_ATTRIBUTES, MAX_ELEMENTS, MAX_ENTITIES, MAX_PREFIXES, check_bounds};
pub use drawing::{Drawing, ElementName};
pub use entities::expansion;
pub use selection::Selection;
pub use style::MAX_DECLARATIONS;

const SVG: &str = "http://www.w3.org/2000/svg";

/// The largest [`expansion`] of a document that is read: 16 MiB.
pub const MAX_EXPANSION: usize = 1 << 24;

/// Segments drawn: more than that cannot be discretised.
const MAX_SEGMENTS: usize = DENSE_LIMIT;
