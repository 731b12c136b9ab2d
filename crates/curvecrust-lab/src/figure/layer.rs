//! How each kind of layer looks.

use curvecrust::{DVec2, geometry::Segment};
use svg::node::element::Group;
use svg::node::element::path::Data;

use super::{Ball, Layer, Polyline};
use crate::drawing::{circle, path, polyline, rectangle, rounded, text};

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
    fn pixels(self, p: DVec2) -> DVec2 {
        let p = (p - self.low) * self.scale + self.at;
        DVec2::new(rounded(p.x), rounded(p.y))
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
    let at = |p: &DVec2| place.pixels(*p);
    let circles = |class: &str, points: &[DVec2], radius: f64| {
        let circle = |group: Group, p| group.add(circle(class, at(p), radius));
        points.iter().fold(Group::new(), circle)
    };
    match layer {
        Layer::Curve(parts) => group.add(path("curve", lines(parts, place))),
        Layer::Construction(parts) => group.add(path("construction", lines(parts, place))),
        Layer::MedialAxis(segments) => group.add(path("medial-axis", strokes(segments, place))),
        Layer::Edges(segments) => group.add(path("edges", strokes(segments, place))),
        Layer::Region(points) => {
            let data = polyline(Data::new(), points.iter().map(at), true);
            group.add(path("region", data))
        }
        Layer::Points(points) => circles("point", points, dot(points, place)),
        Layer::Marks(points) => circles("mark", points, 3.6),
        Layer::Leaves(points) => circles("leaf", points, 8.0),
        Layer::Junctions(points) => points.iter().fold(group, |group, p| {
            group.add(rectangle("junction", at(p) - 7.0, DVec2::splat(14.0)))
        }),
        Layer::Balls(balls) => balls.iter().fold(group, |group, ball| {
            group.add(circle("ball", at(&ball.centre), ball.radius * place.scale))
        }),
        Layer::Labels(labels) => labels.iter().fold(group, |group, label| {
            // Lower by half the height of a small letter.
            let aside = BESIDE * label.towards.normalize_or_zero() + DVec2::new(0.0, 5.0);
            group.add(text("label", at(&label.at) + aside, &label.name))
        }),
    }
}

/// The radius of the dots of points: smaller where many of them are close, so that they do not
/// overlap.
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
    radius.clamp(2.0, 3.6)
}

fn lines(parts: &[Polyline], place: Place) -> Data {
    parts.iter().fold(Data::new(), |data, (points, closed)| {
        polyline(data, points.iter().map(|&p| place.pixels(p)), *closed)
    })
}

fn strokes(segments: &[Segment], place: Place) -> Data {
    segments.iter().fold(Data::new(), |data, segment| {
        polyline(data, [segment.a, segment.b].map(|p| place.pixels(p)), false)
    })
}
