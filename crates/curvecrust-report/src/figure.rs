//! Figures: panels side by side, each with a caption, of layers over each other.
//!
//! Coordinates are those of the data, y downwards as in SVG; each panel is scaled to fit. Numbers are
//! written to a hundredth of a pixel, so that the same data give the same bytes everywhere.

use curvecrust_geometry::{DVec2, Segment};
use svg::Document;
use svg::node::element::path::Data;
use svg::node::element::{Circle, Path, Rectangle, Style, Text};

/// What is drawn in a panel, from the back to the front.
#[derive(Clone, Debug, PartialEq)]
pub enum Layer {
    /// A smooth curve as dense points, one polyline a component; the flag closes it.
    Curve(Vec<(Vec<DVec2>, bool)>),
    /// The medial axis.
    MedialAxis(Vec<Segment>),
    /// The edges of a reconstruction.
    Edges(Vec<Segment>),
    /// Sample points.
    Points(Vec<DVec2>),
}

/// A picture and what it shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// One line below it.
    pub caption: String,
    /// What is drawn.
    pub layers: Vec<Layer>,
}

/// Panels in a row.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// For readers who cannot see it.
    pub title: String,
    /// From left to right.
    pub panels: Vec<Panel>,
}

/// Width of a panel in pixels.
const WIDTH: f64 = 320.0;
/// Around the drawing in a panel.
const MARGIN: f64 = 14.0;
/// Below it, for the caption.
const CAPTION: f64 = 30.0;

/// The colours tell the layers apart in grey too, and on white as on black.
const STYLE: &str = "\
rect { fill: #fff } \
text { font: 15px sans-serif; fill: #222; text-anchor: middle } \
path { fill: none; stroke-linejoin: round; stroke-linecap: round } \
.curve { stroke: #9a9a9a; stroke-width: 4 } \
.axis { stroke: #4a90d9; stroke-width: 1 } \
.edges { stroke: #c0261c; stroke-width: 1.6 } \
circle { fill: #111 }";

impl Figure {
    /// The figure as an SVG document.
    #[must_use]
    pub fn to_svg(&self) -> String {
        let frames: Vec<Frame> = self.panels.iter().map(Frame::around).collect();
        let height = frames.iter().map(|frame| frame.height).fold(0.0, f64::max);
        let size = (WIDTH * self.panels.len() as f64, height + CAPTION);
        let mut document = Document::new()
            .set("viewBox", (0, 0, rounded(size.0), rounded(size.1)))
            .set("width", rounded(size.0))
            .set("height", rounded(size.1))
            .set("role", "img")
            .add(svg::node::element::Title::new(self.title.as_str()))
            .add(Style::new(STYLE))
            .add(Rectangle::new().set("width", "100%").set("height", "100%"));
        for (i, (panel, frame)) in self.panels.iter().zip(frames).enumerate() {
            let left = WIDTH * i as f64;
            let to_page =
                |p: DVec2| frame.place(p) + DVec2::new(left, (height - frame.height) / 2.0);
            for layer in &panel.layers {
                document = draw(document, layer, to_page);
            }
            let caption = Text::new(panel.caption.as_str())
                .set("x", rounded(left + WIDTH / 2.0))
                .set("y", rounded(height + CAPTION * 0.4));
            document = document.add(caption);
        }
        document.to_string() + "\n"
    }
}

/// How the data of a panel are placed on it.
struct Frame {
    low: DVec2,
    scale: f64,
    height: f64,
}

impl Frame {
    /// Around curves and points; what else there is may run out of the picture.
    fn around(panel: &Panel) -> Self {
        let mut low = DVec2::INFINITY;
        let mut high = DVec2::NEG_INFINITY;
        let mut include = |p: DVec2| {
            low = low.min(p);
            high = high.max(p);
        };
        for layer in &panel.layers {
            match layer {
                Layer::Curve(parts) => parts
                    .iter()
                    .flat_map(|part| &part.0)
                    .for_each(|&p| include(p)),
                Layer::Points(points) => points.iter().for_each(|&p| include(p)),
                Layer::MedialAxis(_) | Layer::Edges(_) => {}
            }
        }
        let extent = (high - low).max(DVec2::ZERO);
        let inside = WIDTH - 2.0 * MARGIN;
        let scale = inside / extent.x.max(extent.y / 1.5).max(f64::MIN_POSITIVE);
        let height = extent.y * scale + 2.0 * MARGIN;
        // In the middle, where the height decides the scale.
        low.x -= (inside / scale - extent.x) / 2.0;
        Self { low, scale, height }
    }

    fn place(&self, p: DVec2) -> DVec2 {
        (p - self.low) * self.scale + DVec2::splat(MARGIN)
    }
}

fn draw(document: Document, layer: &Layer, to_page: impl Fn(DVec2) -> DVec2) -> Document {
    let path = |class: &str, data: Data| Path::new().set("class", class).set("d", data);
    match layer {
        Layer::Curve(parts) => {
            let mut data = Data::new();
            for (points, closed) in parts {
                for (i, &p) in points.iter().enumerate() {
                    let at = pixels(to_page(p));
                    data = if i == 0 {
                        data.move_to(at)
                    } else {
                        data.line_to(at)
                    };
                }
                if *closed {
                    data = data.close();
                }
            }
            document.add(path("curve", data))
        }
        Layer::MedialAxis(segments) => document.add(path("axis", strokes(segments, to_page))),
        Layer::Edges(segments) => document.add(path("edges", strokes(segments, to_page))),
        Layer::Points(points) => points.iter().fold(document, |document, &p| {
            let (x, y) = pixels(to_page(p));
            document.add(Circle::new().set("cx", x).set("cy", y).set("r", 3))
        }),
    }
}

fn strokes(segments: &[Segment], to_page: impl Fn(DVec2) -> DVec2) -> Data {
    segments.iter().fold(Data::new(), |data, segment| {
        data.move_to(pixels(to_page(segment.a)))
            .line_to(pixels(to_page(segment.b)))
    })
}

fn pixels(p: DVec2) -> (f64, f64) {
    (rounded(p.x), rounded(p.y))
}

fn rounded(value: f64) -> f64 {
    (value * 100.0).round() / 100.0
}
