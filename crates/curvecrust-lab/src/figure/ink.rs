//! How each kind of layer looks.

use curvecrust::{DVec2, geometry::Segment};
use svg::node::element::path::Data;
use svg::node::element::{Circle, Group, Path, Rectangle, Text};

use super::{Ball, Layer, Polyline};

/// The style sheet of all figures. Layers differ by width, shape and lightness, not by colour alone,
/// so that they can be told apart in grey too; on dark pages the paper is dark.
pub const STYLE: &str = "\
.paper { fill: #fff } \
.caption, .legend, .label { font: 17px 'Noto Sans', 'DejaVu Sans', sans-serif; fill: #1c1c1c } \
.legend { font-size: 15px } \
.caption { text-anchor: middle } \
.label { font-style: italic; text-anchor: middle; stroke: #fff; stroke-width: 4; stroke-linejoin: round; paint-order: stroke } \
.curve, .axis, .edges, .construction, .leaf, .junction { fill: none; stroke-linejoin: round; stroke-linecap: round } \
.curve { stroke: #b4b4b4; stroke-width: 5 } \
.axis { stroke: #3f86d6; stroke-width: 1.2 } \
.edges { stroke: #c0261c; stroke-width: 2 } \
.point { fill: #111 } .mark { fill: #fff; stroke: #111; stroke-width: 1.6 } \
.leaf, .junction { stroke: #0a5fb4; stroke-width: 2.4 } \
.ball { fill: #6fb6e8; fill-opacity: 0.12; stroke: #1d5f94; stroke-width: 0.7; stroke-opacity: 0.6 } \
.region { fill: #d7301f; fill-opacity: 0.45; stroke: #a11; stroke-width: 2.2; stroke-linejoin: round } \
.construction { stroke: #444; stroke-width: 1.3; stroke-dasharray: 6 4 } \
@media (prefers-color-scheme: dark) { \
.paper { fill: #15181c } \
.caption, .legend, .label { fill: #e8e8e8 } \
.curve { stroke: #666d76 } \
.axis { stroke: #6ab0f5 } \
.edges { stroke: #ff7b6b } \
.label { stroke: #15181c } \
.point { fill: #f6f6f6 } .mark { fill: #15181c; stroke: #f6f6f6 } \
.leaf, .junction { stroke: #7cc0ff } \
.ball { fill: #3b8fce; stroke: #9fd0f5 } \
.region { fill: #ff6a55; stroke: #ff9d8f } \
.construction { stroke: #b9bec5 } }";

/// From a point to the middle of its name, in pixels.
const BESIDE: f64 = 16.0;

/// Where data go on the page: `low` to `at`.
#[derive(Clone, Copy)]
pub(super) struct Place {
    pub(super) low: DVec2,
    pub(super) scale: f64,
    pub(super) at: DVec2,
}

impl Place {
    fn pixels(self, p: DVec2) -> (f64, f64) {
        let p = (p - self.low) * self.scale + self.at;
        (rounded(p.x), rounded(p.y))
    }
}

impl Layer {
    /// Its name in the legend, empty for what needs none.
    pub(super) fn name(&self) -> &'static str {
        match self {
            Self::Curve(_) => "curve",
            Self::MedialAxis(_) => "medial axis",
            Self::Edges(_) => "reconstruction",
            Self::Points(_) => "sample",
            Self::Marks(_) => "point of the curve",
            Self::Leaves(_) => "fewer than two edges",
            Self::Junctions(_) => "more than two edges",
            Self::Balls(_) => "tangent balls",
            Self::Region(_) => "to be covered",
            Self::Construction(_) => "what bounds it",
            Self::Labels(_) => "",
        }
    }

    pub(super) fn is_empty(&self) -> bool {
        match self {
            Self::Curve(parts) | Self::Construction(parts) => parts.is_empty(),
            Self::MedialAxis(segments) | Self::Edges(segments) => segments.is_empty(),
            Self::Points(points)
            | Self::Marks(points)
            | Self::Leaves(points)
            | Self::Junctions(points)
            | Self::Region(points) => points.is_empty(),
            Self::Balls(balls) => balls.is_empty(),
            Self::Labels(labels) => labels.is_empty(),
        }
    }

    /// A mark of this kind for the legend, in a box of 34 by 20 pixels.
    pub(super) fn swatch(&self) -> Self {
        let ends = [DVec2::new(3.0, 10.0), DVec2::new(31.0, 10.0)];
        let middle = vec![DVec2::new(17.0, 10.0)];
        let line = vec![(ends.to_vec(), false)];
        let segment = vec![Segment::new(ends[0], ends[1])];
        let corners = [(6.0, 4.0), (28.0, 4.0), (28.0, 16.0), (6.0, 16.0)];
        match self {
            Self::Curve(_) => Self::Curve(line),
            Self::MedialAxis(_) => Self::MedialAxis(segment),
            Self::Edges(_) => Self::Edges(segment),
            Self::Points(_) => Self::Points(middle),
            Self::Marks(_) => Self::Marks(middle),
            Self::Leaves(_) => Self::Leaves(middle),
            Self::Junctions(_) => Self::Junctions(middle),
            Self::Balls(_) => Self::Balls(
                [12.0, 17.0, 22.0]
                    .map(|x| Ball {
                        centre: DVec2::new(x, 10.0),
                        radius: 7.0,
                    })
                    .to_vec(),
            ),
            Self::Region(_) => Self::Region(corners.map(DVec2::from).to_vec()),
            Self::Construction(_) => Self::Construction(line),
            Self::Labels(_) => Self::Labels(Vec::new()),
        }
    }
}

pub(super) fn draw(layer: &Layer, place: Place) -> Group {
    let group = Group::new();
    match layer {
        Layer::Curve(parts) => group.add(path("curve", lines(parts, place))),
        Layer::Construction(parts) => group.add(path("construction", lines(parts, place))),
        Layer::MedialAxis(segments) => group.add(path("axis", strokes(segments, place))),
        Layer::Edges(segments) => group.add(path("edges", strokes(segments, place))),
        Layer::Region(points) => group.add(path("region", line(Data::new(), points, true, place))),
        Layer::Points(points) => circles(points, "point", dot(points, place), place),
        Layer::Marks(points) => circles(points, "mark", 3.6, place),
        Layer::Leaves(points) => circles(points, "leaf", 8.0, place),
        Layer::Junctions(points) => points.iter().fold(group, |group, &p| {
            let (x, y) = place.pixels(p);
            let square = Rectangle::new().set("class", "junction");
            let square = square.set("x", rounded(x - 7.0)).set("y", rounded(y - 7.0));
            group.add(square.set("width", 14).set("height", 14))
        }),
        Layer::Balls(balls) => balls.iter().fold(group, |group, ball| {
            let (x, y) = place.pixels(ball.centre);
            let radius = rounded(ball.radius * place.scale);
            group.add(circle("ball", (x, y), radius))
        }),
        Layer::Labels(labels) => labels.iter().fold(group, |group, label| {
            let (x, y) = place.pixels(label.at);
            let aside = BESIDE * label.towards.normalize_or_zero();
            let text = Text::new(label.name.as_str()).set("class", "label");
            // Lower by half the height of a small letter.
            let (x, y) = (rounded(x + aside.x), rounded(y + aside.y + 5.0));
            group.add(text.set("x", x).set("y", y))
        }),
    }
}

/// The radius of the dots of points: smaller where many of them are close, so that they are told apart.
fn dot(points: &[DVec2], place: Place) -> f64 {
    let nearest = |p: &DVec2| {
        let squared = points.iter().map(|q| p.distance_squared(*q));
        squared.filter(|d| *d > 0.0).fold(f64::INFINITY, f64::min)
    };
    let mut squared: Vec<f64> = points.iter().map(nearest).collect();
    squared.sort_unstable_by(f64::total_cmp);
    // Of ten dots one may touch another, and of fewer one pair.
    let close = squared.get((squared.len() / 10).max(2)).copied();
    let radius = place.scale * close.unwrap_or(f64::INFINITY).sqrt() / 2.2;
    rounded(radius.clamp(2.0, 3.6))
}

fn path(class: &str, data: Data) -> Path {
    Path::new().set("class", class).set("d", data)
}

fn circle(class: &str, (x, y): (f64, f64), radius: f64) -> Circle {
    let circle = Circle::new().set("class", class);
    circle.set("cx", x).set("cy", y).set("r", radius)
}

fn circles(points: &[DVec2], class: &str, radius: f64, place: Place) -> Group {
    points.iter().fold(Group::new(), |group, &p| {
        group.add(circle(class, place.pixels(p), radius))
    })
}

fn lines(parts: &[Polyline], place: Place) -> Data {
    let add = |data, (points, closed): &Polyline| line(data, points, *closed, place);
    parts.iter().fold(Data::new(), add)
}

fn line(mut data: Data, points: &[DVec2], closed: bool, place: Place) -> Data {
    for (i, &p) in points.iter().enumerate() {
        let at = place.pixels(p);
        data = if i == 0 {
            data.move_to(at)
        } else {
            data.line_to(at)
        };
    }
    if closed { data.close() } else { data }
}

fn strokes(segments: &[Segment], place: Place) -> Data {
    segments.iter().fold(Data::new(), |data, segment| {
        data.move_to(place.pixels(segment.a))
            .line_to(place.pixels(segment.b))
    })
}

pub(super) fn rounded(value: f64) -> f64 {
    (value * 100.0).round() / 100.0
}
