//! Pictures (SVG) in the coordinates of the data, `y` downwards, so that they lie exactly over the
//! drawing that the data came from.
//!
//! Colours differ in lightness too, and lines from marks in shape, so that a picture can be read in
//! grey.

use super::Number;
use curvecrust::DVec2;
use std::fmt::Write as _;
use std::io::{self, Write};

/// A polyline, and whether it is closed.
pub(crate) type Path = (Vec<DVec2>, bool);

/// What is drawn.
#[derive(Debug)]
pub(crate) enum Layer {
    /// Found edges.
    Edges(Vec<Path>),
    /// Sample points.
    Points(Vec<DVec2>),
}

/// Layers, the first one at the back.
#[derive(Debug, Default)]
pub(crate) struct Picture {
    pub(crate) layers: Vec<Layer>,
}

/// The larger side on a page, in pixels.
const SIZE: f64 = 800.0;
/// Around the data, in pixels.
const MARGIN: f64 = 20.0;

impl Picture {
    pub(crate) fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let frame = Frame::around(self);
        frame.open(out)?;
        for layer in &self.layers {
            layer.write(out, frame.pixel)?;
        }
        writeln!(out, "</svg>")
    }
}

/// The part of the plane that is shown.
struct Frame {
    low: DVec2,
    extent: DVec2,
    /// The length of a pixel.
    pixel: f64,
}

impl Frame {
    fn around(picture: &Picture) -> Self {
        let (low, high) = picture
            .layers
            .iter()
            .flat_map(Layer::framed)
            .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), p| {
                (low.min(p), high.max(p))
            });
        let extent = high - low;
        // Points without extent, and no points, still make a picture.
        let (low, extent) = if extent.max_element() > 0.0 {
            (low, extent)
        } else if low.is_finite() {
            (low - 0.5, DVec2::ONE)
        } else {
            (DVec2::ZERO, DVec2::ONE)
        };
        let pixel = extent.max_element() / SIZE;
        Self {
            low: low - MARGIN * pixel,
            extent: extent + 2.0 * MARGIN * pixel,
            pixel,
        }
    }

    fn open(&self, out: &mut dyn Write) -> io::Result<()> {
        let Self { low, extent, pixel } = *self;
        let size = (extent / pixel).round();
        writeln!(
            out,
            r#"<svg xmlns="http://www.w3.org/2000/svg" width="{}" height="{}" viewBox="{} {} {} {}">"#,
            size.x,
            size.y,
            Number(low.x),
            Number(low.y),
            Number(extent.x),
            Number(extent.y)
        )?;
        writeln!(
            out,
            r##"<rect x="{}" y="{}" width="{}" height="{}" fill="#fff"/>"##,
            Number(low.x),
            Number(low.y),
            Number(extent.x),
            Number(extent.y)
        )
    }
}

impl Layer {
    /// The points that have to be in the picture.
    fn framed(&self) -> Box<dyn Iterator<Item = DVec2> + '_> {
        match self {
            Self::Edges(paths) => Box::new(paths.iter().flat_map(|path| &path.0).copied()),
            Self::Points(points) => Box::new(points.iter().copied()),
        }
    }

    fn write(&self, out: &mut dyn Write, pixel: f64) -> io::Result<()> {
        match self {
            Self::Edges(paths) => {
                stroked(out, "edges", "#c0261c", 2.0 * pixel)?;
                for path in paths {
                    writeln!(out, r#"<path d="{}"/>"#, data(path))?;
                }
            }
            Self::Points(points) => {
                writeln!(out, r##"<g id="points" fill="#111">"##)?;
                for p in points {
                    let (x, y, r) = (Number(p.x), Number(p.y), Number(4.0 * pixel));
                    writeln!(out, r#"<circle cx="{x}" cy="{y}" r="{r}"/>"#)?;
                }
            }
        }
        writeln!(out, "</g>")
    }
}

/// Opens a group of lines.
fn stroked(out: &mut dyn Write, id: &str, colour: &str, width: f64) -> io::Result<()> {
    writeln!(
        out,
        r#"<g id="{id}" fill="none" stroke="{colour}" stroke-width="{}" stroke-linejoin="round" stroke-linecap="round">"#,
        Number(width)
    )
}

/// The path data of a polyline.
fn data((points, closed): &Path) -> String {
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
    if *closed {
        data += " Z";
    }
    data
}
