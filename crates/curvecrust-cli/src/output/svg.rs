//! Pictures (SVG) in the coordinates of the data, `y` downwards, so that they lie exactly over the
//! drawing that the data came from.
//!
//! Colours differ in lightness too, and lines from marks in shape, so that a picture can be read in
//! grey.

mod frame;
mod lfs;

use super::Number;
use curvecrust::DVec2;
use curvecrust::curve::Curve;
use curvecrust::geometry::Segment;
use curvecrust::medial_axis::Measured;
use frame::Frame;
use std::fmt::Write as _;
use std::io::{self, Write};

/// A polyline, and whether it is closed.
pub(crate) type Path = (Vec<DVec2>, bool);

/// What is drawn.
#[derive(Debug)]
pub(crate) enum Layer {
    /// A smooth curve.
    Curve(Curve),
    /// A smooth curve, coloured by its local feature size.
    Lfs(Measured),
    /// The medial axis; what runs out of the picture is cut off.
    Axis(Vec<Segment>),
    /// Found edges.
    Edges(Vec<Path>),
    /// Sample points.
    Points(Vec<DVec2>),
    /// Where the sampling was too sparse.
    Marks {
        leaves: Vec<DVec2>,
        isolated: Vec<DVec2>,
        junctions: Vec<DVec2>,
    },
}

/// Layers, the first one at the back.
#[derive(Debug, Default)]
pub(crate) struct Picture {
    pub(crate) layers: Vec<Layer>,
}

impl Picture {
    pub(crate) fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let frame = Frame::around(self);
        frame.open(out)?;
        for layer in &self.layers {
            layer.write(out, &frame)?;
        }
        writeln!(out, "</svg>")
    }
}

impl Layer {
    fn write(&self, out: &mut dyn Write, frame: &Frame) -> io::Result<()> {
        let pixel = frame.pixel;
        match self {
            Self::Curve(curve) => {
                open(out, "curve", "#b4b4b4", 5.0 * pixel)?;
                writeln!(out, r#"<path d="{}"/>"#, curve_data(curve))?;
            }
            Self::Lfs(measured) => lfs::write(out, measured, frame)?,
            Self::Axis(segments) => {
                open(out, "medial-axis", "#3d85d0", 1.5 * pixel)?;
                let each = segments.iter().map(|s| data(&[s.a, s.b], false));
                let together = each.collect::<Vec<_>>().join(" ");
                writeln!(out, r#"<path d="{together}"/>"#)?;
            }
            Self::Edges(paths) => {
                open(out, "edges", "#b3150d", 2.0 * pixel)?;
                for (points, closed) in paths {
                    writeln!(out, r#"<path d="{}"/>"#, data(points, *closed))?;
                }
            }
            Self::Points(points) => {
                // Many points are small, so that they do not melt into each other.
                let radius = (720.0 / points.len() as f64).clamp(1.0, 4.0) * pixel;
                writeln!(out, r##"<g id="points" fill="#111">"##)?;
                for p in points {
                    let (x, y, r) = (Number(p.x), Number(p.y), Number(radius));
                    writeln!(out, r#"<circle cx="{x}" cy="{y}" r="{r}"/>"#)?;
                }
            }
            Self::Marks {
                leaves,
                isolated,
                junctions,
            } => {
                open(out, "violations", "#e07b00", 2.5 * pixel)?;
                for (places, corners) in [(leaves, 24), (isolated, 4), (junctions, 3)] {
                    for &p in places {
                        writeln!(out, r#"<path d="{}"/>"#, mark(p, corners, 10.0 * pixel))?;
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

/// The path data of a polyline.
fn data(points: &[DVec2], closed: bool) -> String {
    let mut data = String::new();
    for (i, p) in points.iter().enumerate() {
        let command = match i {
            0 => "M",
            1 => " L",
            _ => "",
        };
        // Writing to a string cannot fail.
        let _ = write!(data, "{command} {} {}", Number(p.x), Number(p.y));
    }
    if closed {
        data += " Z";
    }
    data
}

/// The path data of a smooth curve.
fn curve_data(curve: &Curve) -> String {
    let mut data = String::new();
    for component in curve.components() {
        for (i, segment) in component.segments().iter().enumerate() {
            let [p0, p1, p2, p3] = segment.control_points();
            if i == 0 {
                let _ = write!(data, "M {} {}", Number(p0.x), Number(p0.y));
            }
            let [x1, y1, x2, y2, x3, y3] = [p1.x, p1.y, p2.x, p2.y, p3.x, p3.y].map(Number);
            let _ = write!(data, " C {x1} {y1} {x2} {y2} {x3} {y3}");
        }
        data += if component.is_closed() { " Z " } else { " " };
    }
    data.truncate(data.trim_end().len());
    data
}

/// The path data of a regular polygon with a corner at the top.
fn mark(centre: DVec2, corners: u32, radius: f64) -> String {
    let corner = |i: u32| {
        let angle = std::f64::consts::TAU * (f64::from(i) / f64::from(corners) - 0.25);
        centre + DVec2::from_angle(angle) * radius
    };
    data(&(0..corners).map(corner).collect::<Vec<_>>(), true)
}
