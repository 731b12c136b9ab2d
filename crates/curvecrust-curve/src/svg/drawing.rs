//! What a document draws, and which element draws what.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::fmt;

use curvecrust_geometry::Segment;
use glam::DVec2;
use roxmltree::{Document, Node, ParsingOptions};

use super::css::Sheets;
use super::layout::{Drawn, Layout};
use super::selection::Selection;
use super::{SVG, bounds, style, walk};
use crate::bezier::{CubicBezier, bounds as bezier_bounds};
use crate::bezier_path::BezierPath;
use crate::error::CurveError;

/// How near a place is to a stroke that passes it, as a share of the extent of all.
const AT: f64 = 1e-3;
/// The chords of a segment, which are nearer to it than a tenth of that.
const CHORDS: u32 = 64;

/// The strokes of a document, in the order of drawing and not yet checked for smoothness.
///
/// ```
/// use curvecrust_curve::svg::Drawing;
///
/// let svg = "<svg xmlns='http://www.w3.org/2000/svg'>
///     <ellipse id='e' rx='10' ry='4'/></svg>";
/// let drawing = Drawing::new(svg)?;
/// assert_eq!(drawing.element(0).unwrap().to_string(), "<ellipse id=\"e\"> in line 2");
/// # Ok::<(), curvecrust_curve::CurveError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Drawing {
    components: Vec<BezierPath>,
    /// The index of the element that draws each component.
    drawn_by: Vec<usize>,
    elements: Vec<ElementName>,
    /// Indices of elements.
    points: Vec<usize>,
    /// Indices of elements.
    unpainted: Vec<usize>,
}

impl Drawing {
    /// All that a document draws.
    ///
    /// # Errors
    /// What is wrong with the document, with its element and line where it has one.
    pub fn new(document: &str) -> Result<Self, CurveError> {
        Self::selected(document, &Selection::default())
    }

    /// What the elements draw that are selected; what the others hold is not looked at.
    ///
    /// # Errors
    /// Those of [`new`](Self::new), and names that no element has.
    pub fn selected(document: &str, selection: &Selection) -> Result<Self, CurveError> {
        let xml = parse_xml(document)?;
        let root = xml.root_element();
        if !root.has_tag_name((SVG, "svg")) {
            let name = root.tag_name().name().to_owned();
            return Err(CurveError::NotSvg { name });
        }
        style::check(&xml)?;
        selection.check(&xml)?;
        let by_id = walk::by_id(&xml);
        let shapes = walk::shapes(root, &by_id, selection)?;
        bounds::check_elements(root, |id| by_id.get(id).map(Node::id))?;
        let layout = Layout {
            by_id: &by_id,
            sheets: &Sheets::of(&xml),
            selection,
            shapes,
            marks: HashMap::new(),
            drawn: Drawn::default(),
        };
        Ok(Self::of(layout.document(root)?))
    }

    fn of(drawn: Drawn<'_, '_>) -> Self {
        let nodes = drawn.components.iter().map(|(node, _)| node);
        // By their places, so that lines are counted in one go.
        let mut places = BTreeMap::new();
        for node in nodes.chain(&drawn.points).chain(&drawn.unpainted) {
            places.insert((node.range().start, node.id().get()), *node);
        }
        let (mut line, mut counted) = (1, 0);
        let mut index_of = HashMap::new();
        let mut elements = Vec::with_capacity(places.len());
        for ((start, _), node) in places {
            let text = node.document().input_text().as_bytes();
            let before = text.get(counted..start).unwrap_or_default();
            line += before.iter().filter(|&&byte| byte == b'\n').count();
            counted = counted.max(start);
            index_of.insert(node.id(), elements.len());
            elements.push(ElementName {
                tag: node.tag_name().name().to_owned(),
                id: node.attribute("id").map(str::to_owned),
                line,
            });
        }
        let index = |node: &Node<'_, '_>| index_of.get(&node.id()).copied().unwrap_or_default();
        Self {
            drawn_by: drawn
                .components
                .iter()
                .map(|(node, _)| index(node))
                .collect(),
            points: drawn.points.iter().map(index).collect(),
            unpainted: drawn.unpainted.iter().map(index).collect(),
            components: drawn.components.into_iter().map(|(_, path)| path).collect(),
            elements,
        }
    }

    /// The strokes, which a [`Curve`](crate::Curve) has as its components.
    #[must_use]
    pub fn components(&self) -> &[BezierPath] {
        &self.components
    }

    /// The element that draws a component; `None` if there is no such component.
    #[must_use]
    pub fn element(&self, component: usize) -> Option<&ElementName> {
        self.elements.get(*self.drawn_by.get(component)?)
    }

    /// The elements whose strokes pass a place, within a thousandth of the extent of all, in the
    /// order of drawing.
    ///
    /// ```
    /// use curvecrust_curve::svg::Drawing;
    /// use glam::dvec2;
    ///
    /// let svg = "<svg xmlns='http://www.w3.org/2000/svg'>
    ///     <circle id='c' r='2'/><path id='p' d='M 1 0 H 9'/></svg>";
    /// let drawing = Drawing::new(svg)?;
    /// assert_eq!(drawing.elements_at(dvec2(2.0, 0.0)).len(), 2);
    /// assert_eq!(drawing.elements_at(dvec2(0.0, 2.0)).len(), 1);
    /// # Ok::<(), curvecrust_curve::CurveError>(())
    /// ```
    #[must_use]
    pub fn elements_at(&self, place: DVec2) -> Vec<&ElementName> {
        let (low, high) = bezier_bounds(self.components.iter().flat_map(BezierPath::segments));
        let tolerance = AT * (high - low).max_element();
        let components = self.components.iter().zip(&self.drawn_by);
        let here = components.filter(|(path, _)| {
            let mut segments = path.segments().iter();
            segments.any(|segment| passes(segment, place, tolerance))
        });
        let here: BTreeSet<usize> = here.map(|(_, &element)| element).collect();
        here.iter().map(|&index| &self.elements[index]).collect()
    }

    /// The elements with subpaths of a single point, which draw nothing and are left out; each as
    /// often as it is used.
    pub fn points(&self) -> impl ExactSizeIterator<Item = &ElementName> {
        self.points.iter().map(|&index| &self.elements[index])
    }

    /// The elements whose fill and stroke both are `none`, by themselves or by what they are in:
    /// they draw nothing and are left out; each as often as it is used. Where all are so, all are
    /// drawn.
    ///
    /// ```
    /// use curvecrust_curve::svg::Drawing;
    ///
    /// let svg = "<svg xmlns='http://www.w3.org/2000/svg' fill='none' stroke='blue'>
    ///     <path id='page' stroke='none' d='M 0 0 H 9 V 9 Z'/><circle r='2'/></svg>";
    /// let drawing = Drawing::new(svg)?;
    /// assert_eq!((drawing.components().len(), drawing.unpainted().len()), (1, 1));
    /// # Ok::<(), curvecrust_curve::CurveError>(())
    /// ```
    pub fn unpainted(&self) -> impl ExactSizeIterator<Item = &ElementName> {
        self.unpainted.iter().map(|&index| &self.elements[index])
    }

    /// An error about components, with the element that draws them, if it is one.
    pub(crate) fn with_element(&self, error: CurveError) -> CurveError {
        match error
            .component()
            .and_then(|component| self.element(component))
        {
            Some(element) => error.within(element.to_string()),
            None => error,
        }
    }
}

/// Whether a segment passes a place within a distance, by its chords.
fn passes(segment: &CubicBezier, place: DVec2, tolerance: f64) -> bool {
    let (low, high) = segment.bounding_box();
    let outside = (low - place).max(place - high);
    outside.max_element() <= tolerance
        && (0..CHORDS).any(|i| {
            let end = |i: u32| segment.point(f64::from(i) / f64::from(CHORDS));
            Segment::new(end(i), end(i + 1)).distance(place) <= tolerance
        })
}

/// What messages call an element of a document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ElementName {
    tag: String,
    id: Option<String>,
    line: usize,
}

impl fmt::Display for ElementName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { tag, id, line } = self;
        match id {
            Some(id) => write!(f, "<{tag} id=\"{id}\"> in line {line}"),
            None => write!(f, "<{tag}> in line {line}"),
        }
    }
}

fn parse_xml(text: &str) -> Result<Document<'_>, CurveError> {
    bounds::check_bounds(text)?;
    let options = ParsingOptions {
        allow_dtd: true,
        ..ParsingOptions::default()
    };
    Document::parse_with_options(text, options).map_err(|error| {
        let position = error.pos();
        let message = error.to_string();
        let suffix = format!(" at {position}");
        CurveError::Xml {
            line: position.row,
            column: position.col,
            message: message.strip_suffix(&suffix).unwrap_or(&message).to_owned(),
        }
    })
}
