//! Figures: panels in rows, each with a caption, of layers over each other.
//!
//! Coordinates are those of the data, y downwards as in SVG; each panel is scaled to fit. Numbers
//! are written to a hundredth of a pixel, so that the same data give the same bytes everywhere.
//! A legend below the panels explains the marks of the layers that occur.

mod layer;

use crate::drawing::{Within, document, text};
use curvecrust::{DVec2, geometry::Segment};
use svg::node::element::Group;

use layer::{Place, draw};

/// Points joined in order; the flag joins the last with the first.
pub type Polyline = (Vec<DVec2>, bool);

/// A disk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// Its centre.
    pub centre: DVec2,
    /// Its radius, in the unit of the data.
    pub radius: f64,
}

/// A name beside a point.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// The point.
    pub at: DVec2,
    /// On which side of it the name stands: a direction, of any length.
    pub towards: DVec2,
    /// The name.
    pub name: String,
}

/// What is drawn in a panel, from the back to the front.
#[derive(Clone, Debug, PartialEq)]
pub enum Layer {
    /// A smooth curve as dense points, one polyline a component.
    Curve(Vec<Polyline>),
    /// The medial axis.
    MedialAxis(Vec<Segment>),
    /// The edges of a reconstruction.
    Edges(Vec<Segment>),
    /// Sample points.
    Points(Vec<DVec2>),
    /// Points of the curve that are no samples.
    Marks(Vec<DVec2>),
    /// Leaves and isolated points, in rings.
    Leaves(Vec<DVec2>),
    /// Points with three edges or more, in squares.
    Junctions(Vec<DVec2>),
    /// Tangent balls, seen through each other.
    Balls(Vec<Ball>),
    /// What the balls have to cover, as closed polygons.
    Region(Vec<DVec2>),
    /// Lines and circles that help to see, dashed.
    Construction(Vec<Polyline>),
    /// Names beside points.
    Labels(Vec<Label>),
}

/// A picture and what it shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// Below it; lines of about 38 letters.
    pub caption: String,
    /// Two opposite corners of what is shown, smaller coordinates first; `None` for all curves and
    /// points. Curves and points outside are drawn too, and may run over the edge.
    pub frame: Option<[DVec2; 2]>,
    /// What is drawn.
    pub layers: Vec<Layer>,
}

/// Panels in rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// For readers who cannot see it.
    pub title: String,
    /// How many panels stand in a row.
    pub columns: usize,
    /// Row by row, from left to right.
    pub panels: Vec<Panel>,
}

/// Width of a panel in pixels.
const WIDTH: f64 = 340.0;
/// Around the drawing in a panel.
const MARGIN: f64 = 16.0;
/// From one line of text to the next.
const LINE: f64 = 22.0;
/// Of the mark that stands in the legend before its name.
const SWATCH: DVec2 = DVec2::new(34.0, 20.0);
/// Of a letter in the legend, about: enough for none to touch.
const LETTER: f64 = 8.6;

impl Figure {
    /// The figure as an SVG document that stands alone.
    #[must_use]
    pub fn to_svg(&self) -> String {
        let columns = self.columns.clamp(1, self.panels.len().max(1));
        let width = WIDTH * columns as f64;
        let mut page = Group::new();
        let mut top = 0.0;
        for row in self.panels.chunks(columns) {
            let height = row.iter().map(Panel::height).fold(0.0, f64::max);
            let lines = row.iter().map(|panel| panel.caption.lines().count()).max();
            for (i, panel) in row.iter().enumerate() {
                let corner = DVec2::new(WIDTH * i as f64, top);
                let lowered = DVec2::new(corner.x, top + (height - panel.height()) / 2.0);
                page = page.add(panel.drawing(lowered));
                for (k, line) in panel.caption.lines().enumerate() {
                    let at = corner + DVec2::new(WIDTH / 2.0, height + LINE * (k as f64 + 0.5));
                    page = page.add(text("caption", at, line));
                }
            }
            top += height + LINE * lines.unwrap_or(0) as f64 + MARGIN / 2.0;
        }
        let (legend, bottom) = self.legend_rows(width, top);
        document(&self.title, DVec2::new(width, bottom), Within::File)
            .add(page)
            .add(legend)
            .to_string()
            + "\n"
    }

    /// The drawings of the panels alone, one document each, for pages that set the captions
    /// themselves.
    #[must_use]
    pub fn drawings(&self) -> Vec<String> {
        let drawing = |panel: &Panel| {
            document(
                &panel.caption,
                DVec2::new(WIDTH, panel.height()),
                Within::Page,
            )
            .add(panel.drawing(DVec2::ZERO))
            .to_string()
        };
        self.panels.iter().map(drawing).collect()
    }

    /// What the marks mean: each as a document like [`drawings`](Self::drawings), and its name.
    #[must_use]
    pub fn legend(&self) -> Vec<(String, &'static str)> {
        let mark = |layer: &Layer| {
            let document =
                document("", SWATCH, Within::Page).add(draw(&layer.swatch(), SWATCH_PLACE));
            (document.to_string(), layer.name())
        };
        self.kinds().into_iter().map(mark).collect()
    }

    /// A layer of every kind that has a name and occurs, in the order of their first occurrence.
    fn kinds(&self) -> Vec<&Layer> {
        let mut kinds: Vec<&Layer> = Vec::new();
        for layer in self.panels.iter().flat_map(|panel| &panel.layers) {
            let name = layer.name();
            if !name.is_empty() && !layer.is_empty() && kinds.iter().all(|k| k.name() != name) {
                kinds.push(layer);
            }
        }
        kinds
    }

    /// The legend in rows of at most `width`, from `top` on, and where it ends.
    fn legend_rows(&self, width: f64, top: f64) -> (Group, f64) {
        let mut group = Group::new();
        let mut at = DVec2::new(MARGIN, top);
        for layer in self.kinds() {
            let letters = layer.name().chars().count() as f64;
            let advance = SWATCH.x + LETTER * letters + MARGIN;
            if at.x > MARGIN && at.x + advance > width {
                at = DVec2::new(MARGIN, at.y + LINE);
            }
            let place = Place {
                at: at + SWATCH_PLACE.at,
                ..SWATCH_PLACE
            };
            let beside = at + DVec2::new(SWATCH.x + 5.0, SWATCH.y / 2.0 + 5.0);
            group =
                group
                    .add(draw(&layer.swatch(), place))
                    .add(text("legend", beside, layer.name()));
            at.x += advance;
        }
        (group, at.y + LINE + MARGIN / 2.0)
    }
}

/// A swatch is drawn in pixels.
const SWATCH_PLACE: Place = Place {
    low: DVec2::ZERO,
    scale: 1.0,
    at: DVec2::ZERO,
};

impl Panel {
    fn drawing(&self, corner: DVec2) -> Group {
        let place = self.place();
        let place = Place {
            at: place.at + corner,
            ..place
        };
        let draw = |group: Group, layer| group.add(draw(layer, place));
        self.layers.iter().fold(Group::new(), draw)
    }

    fn height(&self) -> f64 {
        let [low, high] = self.shown();
        (high.y - low.y) * self.place().scale + 2.0 * MARGIN
    }

    fn place(&self) -> Place {
        let [low, high] = self.shown();
        let extent = high - low;
        let inside = WIDTH - 2.0 * MARGIN;
        let scale = inside / extent.x.max(extent.y / 1.5).max(f64::MIN_POSITIVE);
        // In the middle, where the height decides the scale.
        let left = MARGIN + (inside - extent.x * scale) / 2.0;
        Place {
            low,
            scale,
            at: DVec2::new(left, MARGIN),
        }
    }

    fn shown(&self) -> [DVec2; 2] {
        let framed = self.layers.iter().flat_map(|layer| match layer {
            Layer::Curve(parts) => parts.iter().flat_map(|part| part.0.clone()).collect(),
            Layer::Points(points) => points.clone(),
            _ => Vec::new(),
        });
        self.frame.unwrap_or_else(|| {
            let (low, high) = bounds(&framed.collect::<Vec<_>>());
            if low.cmple(high).all() {
                [low, high]
            } else {
                [DVec2::ZERO, DVec2::ONE]
            }
        })
    }
}

/// The lowest and the highest coordinates of points; infinite and in the wrong order without any.
pub(crate) fn bounds(points: &[DVec2]) -> (DVec2, DVec2) {
    let none = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    let grow = |(low, high): (DVec2, DVec2), &p: &DVec2| (low.min(p), high.max(p));
    points.iter().fold(none, grow)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn figure() -> Figure {
        let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 2.0), (0.0, 2.0)].map(DVec2::from);
        let panel = |caption: &str| Panel {
            caption: caption.to_owned(),
            frame: None,
            layers: vec![
                Layer::Curve(vec![(square.to_vec(), true)]),
                Layer::Points(square.to_vec()),
                Layer::Leaves(Vec::new()),
            ],
        };
        Figure {
            title: "squares < circles".to_owned(),
            columns: 2,
            panels: vec![panel("one"), panel("two\nlines"), panel("three")],
        }
    }

    #[test]
    fn panels_stand_in_rows_with_their_captions_and_a_legend() {
        let svg = figure().to_svg();
        assert!(svg.contains("<title>squares &lt; circles</title>"), "{svg}");
        for word in ["one", "two", "lines", "three"] {
            assert_eq!(svg.matches(&format!("\n{word}\n")).count(), 1, "{svg}");
        }
        assert!(svg.contains("width=\"680\""), "two panels of 340 wide");
        // Four points in each of three panels, and one in the legend.
        assert_eq!(svg.matches("class=\"point\"").count(), 13);
        assert_eq!(svg, figure().to_svg());
    }

    #[test]
    fn the_legend_names_what_occurs_and_nothing_else() {
        let names: Vec<_> = figure().legend().into_iter().map(|mark| mark.1).collect();
        assert_eq!(names, ["curve", "sample"]);
    }

    #[test]
    fn nothing_to_draw_is_an_empty_picture() {
        let empty = Panel {
            caption: String::new(),
            frame: None,
            layers: vec![Layer::Edges(Vec::new())],
        };
        let figure = Figure {
            title: "none".to_owned(),
            columns: 0,
            panels: vec![empty],
        };
        let svg = figure.to_svg();
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
    }
}
