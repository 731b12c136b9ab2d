//! Pictures (SVG) in the coordinates of the data, `y` downwards, so that they lie exactly over the
//! drawing that the data came from.
//!
//! A picture is data like every other output: numbers have all their digits, elements are written
//! one by one, so that a million points take no memory of their own, and colours are attributes,
//! which programs without style sheets read too.
//!
//! The crate `svg` is not used: a group of its elements holds them all, and a million points that
//! are written one by one take three times as long by its elements, as each is made of strings.
//!
//! Colours differ in lightness too, and lines from marks in shape, so that a picture can be read in
//! grey.

mod dots;
mod fitted;
mod frame;
mod lfs;
mod why;

use super::{Number, Places};
use curvecrust::DVec2;
use curvecrust::curve::Curve;
use curvecrust::denoise::Fitted;
use curvecrust::geometry::{PointSet, Segment};
use curvecrust::medial_axis::MeasuredCurve;
use curvecrust::reconstruct::{Dots, Explanation};
use frame::Frame;
use std::fmt;
use std::io::{self, Write};

/// A polyline, and whether it is closed.
pub(crate) type Path<'a> = (Places<'a>, bool);

/// What is drawn.
#[derive(Debug)]
pub(crate) enum Layer<'a> {
    /// A smooth curve.
    Curve(&'a Curve),
    /// A smooth curve, coloured by its local feature size.
    Lfs(&'a MeasuredCurve),
    /// The medial axis; what runs out of the picture is cut off.
    Axis(&'a [Segment]),
    /// Found edges.
    Edges(Vec<Path<'a>>),
    /// Found edges by the reasons for them, and the rejected partners of free ends.
    Why(&'a PointSet, &'a Explanation),
    /// Smooth curves fitted to points, with a band that shows how sure they are.
    Fitted(&'a Fitted),
    /// The points that curves were fitted to, outliers as rings.
    FittedPoints(&'a PointSet, &'a Fitted),
    /// Sample points.
    Points(&'a [DVec2]),
    /// The lines of the solution of a puzzle.
    Joins(&'a Dots),
    /// The dots of a puzzle, with its rules.
    Dots(&'a Dots),
    /// Where the sampling was too sparse.
    Marks {
        leaves: Places<'a>,
        isolated: Places<'a>,
        junctions: Places<'a>,
    },
}

/// Layers, the first one at the back.
#[derive(Debug, Default)]
pub(crate) struct Picture<'a> {
    pub(crate) layers: Vec<Layer<'a>>,
}

impl Picture<'_> {
    pub(crate) fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let frame = Frame::around(self);
        frame.open(out)?;
        for layer in &self.layers {
            layer.write(out, &frame)?;
        }
        writeln!(out, "</svg>")
    }
}

impl Layer<'_> {
    fn write(&self, out: &mut dyn Write, frame: &Frame) -> io::Result<()> {
        let pixel = frame.pixel;
        match self {
            Self::Curve(curve) => {
                open(out, "curve", "#b4b4b4", 5.0 * pixel)?;
                writeln!(out, r#"<path d="{}"/>"#, CurveData(curve))?;
            }
            Self::Lfs(measured) => lfs::write(out, measured, frame)?,
            Self::Axis(segments) => {
                open(out, "medial-axis", "#3d85d0", 1.5 * pixel)?;
                write!(out, r#"<path d=""#)?;
                for (i, s) in segments.iter().enumerate() {
                    let between = if i == 0 { "" } else { " " };
                    write!(out, "{between}{}", Data([s.a, s.b].into_iter(), false))?;
                }
                writeln!(out, r#""/>"#)?;
            }
            Self::Edges(paths) => {
                open(out, "edges", "#b3150d", 2.0 * pixel)?;
                for (points, closed) in paths {
                    writeln!(out, r#"<path d="{}"/>"#, Data(points.iter(), *closed))?;
                }
            }
            Self::Why(points, explanation) => why::write(out, points, explanation, frame)?,
            Self::Fitted(fitted) => fitted::curves(out, fitted, pixel)?,
            Self::FittedPoints(points, fitted) => fitted::points(out, points, fitted, pixel)?,
            Self::Points(points) => {
                let radius = point_radius(points.len()) * pixel;
                writeln!(out, r##"<g id="points" fill="#111">"##)?;
                for p in *points {
                    let (x, y, r) = (Number(p.x), Number(p.y), Number(radius));
                    writeln!(out, r#"<circle cx="{x}" cy="{y}" r="{r}"/>"#)?;
                }
            }
            Self::Joins(dots) => dots::lines(out, dots, pixel)?,
            Self::Dots(dots) => dots::write(out, dots, frame)?,
            Self::Marks {
                leaves,
                isolated,
                junctions,
            } => {
                open(out, "violations", "#e07b00", 2.5 * pixel)?;
                for (places, corners) in [(leaves, 24), (isolated, 4), (junctions, 3)] {
                    for p in places.iter() {
                        let mark = mark(p, corners, 10.0 * pixel);
                        writeln!(out, r#"<path d="{}"/>"#, Data(mark, true))?;
                    }
                }
            }
        }
        writeln!(out, "</g>")
    }
}

/// Opens a group of lines.
fn open(out: &mut dyn Write, id: &str, colour: &str, width: f64) -> io::Result<()> {
    writeln!(
        out,
        r#"<g id="{id}" fill="none" stroke="{colour}" stroke-width="{}" stroke-linejoin="round" stroke-linecap="round">"#,
        Number(width)
    )
}

/// The path data of a polyline, and whether it is closed.
struct Data<I>(I, bool);

impl<I: Iterator<Item = DVec2> + Clone> fmt::Display for Data<I> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(points, closed) = self;
        for (i, p) in points.clone().enumerate() {
            let command = match i {
                0 => "M",
                1 => " L",
                _ => "",
            };
            write!(f, "{command} {} {}", Number(p.x), Number(p.y))?;
        }
        f.write_str(if *closed { " Z" } else { "" })
    }
}

/// The path data of a smooth curve.
struct CurveData<'a>(&'a Curve);

impl fmt::Display for CurveData<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, component) in self.0.components().iter().enumerate() {
            let between = if i == 0 { "" } else { " " };
            let cubics: Vec<_> = component
                .segments()
                .iter()
                .map(|s| s.control_points())
                .collect();
            write!(f, "{between}{}", CubicData(&cubics, component.is_closed()))?;
        }
        Ok(())
    }
}

/// The path data of cubics end to end, and whether they are closed.
struct CubicData<'a>(&'a [[DVec2; 4]], bool);

impl fmt::Display for CubicData<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(cubics, closed) = self;
        for (i, [p0, p1, p2, p3]) in cubics.iter().enumerate() {
            if i == 0 {
                write!(f, "M {} {}", Number(p0.x), Number(p0.y))?;
            }
            let [x1, y1, x2, y2, x3, y3] = [p1.x, p1.y, p2.x, p2.y, p3.x, p3.y].map(Number);
            write!(f, " C {x1} {y1} {x2} {y2} {x3} {y3}")?;
        }
        f.write_str(if *closed { " Z" } else { "" })
    }
}

/// The radius of a point in pixels. Many points are small, so that they do not melt into each
/// other.
fn point_radius(count: usize) -> f64 {
    (720.0 / count as f64).clamp(1.0, 4.0)
}

/// The corners of a regular polygon, the first at the top.
fn mark(centre: DVec2, corners: u32, radius: f64) -> impl Iterator<Item = DVec2> + Clone {
    (0..corners).map(move |i| {
        let angle = std::f64::consts::TAU * (f64::from(i) / f64::from(corners) - 0.25);
        centre + DVec2::from_angle(angle) * radius
    })
}
