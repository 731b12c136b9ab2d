//! SVG path strings, the `d` attribute, in double precision and by the strict grammar.

use glam::DVec2;
use kurbo::{Arc, Point, SvgArc, Vec2};
use svgtypes::{PathParser, PathSegment};

use crate::bezier::CubicBezier;
use crate::bezier_path::BezierPath;
use crate::error::CurveError;

/// How far the cubics of an arc may be from it, as a fraction of the larger radius; a quarter of a
/// circle gets 13 of them, whose curvature is right within 1e-6.
const ARC_TOLERANCE: f64 = 6e-11;

/// The subpaths of a path string that have a length.
pub(crate) fn drawn(d: &str) -> Result<Vec<BezierPath>, CurveError> {
    let mut subpaths = parse(d)?;
    subpaths.retain(|subpath| !subpath.segments().is_empty());
    Ok(subpaths)
}

/// The subpaths of a path string, not yet checked for smoothness; those of one point are empty.
pub(crate) fn parse(d: &str) -> Result<Vec<BezierPath>, CurveError> {
    let mut path = Pen::default();
    for command in PathParser::from(d) {
        path.draw(command.map_err(|error| malformed(d, &error))?);
    }
    Ok(path.finish())
}

/// An error of the parser, with the position that it may lack.
fn malformed(d: &str, error: &svgtypes::Error) -> CurveError {
    use svgtypes::Error;
    let end = d.chars().count() + 1;
    let expected = "give a command with all its numbers";
    let (position, message) = match *error {
        Error::UnexpectedEndOfStream => (end, format!("it ends too early; {expected}")),
        Error::InvalidNumber(position) if position >= end => {
            (end, format!("it ends too early; {expected}"))
        }
        Error::InvalidNumber(position) => {
            (position, "give a number that is finite here".to_owned())
        }
        Error::UnexpectedData(position) if position == 1 => {
            (position, "start with the command M or m".to_owned())
        }
        Error::UnexpectedData(position)
        | Error::InvalidChar(_, position)
        | Error::InvalidString(_, position) => (position, format!("unexpected; {expected}")),
        _ => (end, error.to_string()),
    };
    CurveError::PathData { position, message }
}

/// The handle that a following `S` or `T` reflects.
#[derive(Clone, Copy, Default)]
enum LastHandle {
    #[default]
    None,
    Cubic(DVec2),
    Quadratic(DVec2),
}

/// The state while drawing a path.
#[derive(Default)]
pub(crate) struct Pen {
    done: Vec<BezierPath>,
    segments: Vec<CubicBezier>,
    start: DVec2,
    at: DVec2,
    handle: LastHandle,
    /// Whether a move has begun a subpath.
    moved: bool,
    /// Whether a command has drawn since the last move or close.
    drawn: bool,
}

impl Pen {
    fn draw(&mut self, command: PathSegment) {
        let origin = if command.is_abs() {
            DVec2::ZERO
        } else {
            self.at
        };
        let point = |x, y| origin + DVec2::new(x, y);
        match command {
            PathSegment::MoveTo { x, y, .. } => self.move_to(point(x, y)),
            PathSegment::LineTo { x, y, .. } => self.line_to(point(x, y)),
            PathSegment::HorizontalLineTo { x, .. } => {
                self.line_to(DVec2::new(origin.x + x, self.at.y));
            }
            PathSegment::VerticalLineTo { y, .. } => {
                self.line_to(DVec2::new(self.at.x, origin.y + y));
            }
            PathSegment::CurveTo {
                x1,
                y1,
                x2,
                y2,
                x,
                y,
                ..
            } => self.cubic_to(point(x1, y1), point(x2, y2), point(x, y)),
            PathSegment::SmoothCurveTo { x2, y2, x, y, .. } => {
                let first = match self.handle {
                    LastHandle::Cubic(handle) => 2.0 * self.at - handle,
                    _ => self.at,
                };
                self.cubic_to(first, point(x2, y2), point(x, y));
            }
            PathSegment::Quadratic { x1, y1, x, y, .. } => {
                self.quadratic_to(point(x1, y1), point(x, y));
            }
            PathSegment::SmoothQuadratic { x, y, .. } => {
                let middle = match self.handle {
                    LastHandle::Quadratic(handle) => 2.0 * self.at - handle,
                    _ => self.at,
                };
                self.quadratic_to(middle, point(x, y));
            }
            PathSegment::EllipticalArc {
                rx,
                ry,
                x_axis_rotation,
                large_arc,
                sweep,
                x,
                y,
                ..
            } => {
                let to = point(x, y);
                self.arc_to(&SvgArc {
                    from: Point::new(self.at.x, self.at.y),
                    to: Point::new(to.x, to.y),
                    radii: Vec2::new(rx, ry),
                    x_rotation: (x_axis_rotation % 360.0).to_radians(),
                    large_arc,
                    sweep,
                });
            }
            PathSegment::ClosePath { .. } => self.close(),
        }
    }

    pub(crate) fn move_to(&mut self, to: DVec2) {
        if self.drawn {
            self.end_subpath(false);
        }
        (self.start, self.at) = (to, to);
        self.moved = true;
        self.handle = LastHandle::None;
    }

    pub(crate) fn line_to(&mut self, to: DVec2) {
        self.push(CubicBezier::line(self.at, to), LastHandle::None);
    }

    /// The arc in cubics, its end exactly; straight if a radius is 0, as SVG has it.
    fn arc_to(&mut self, arc: &SvgArc) {
        let (from, to) = (self.at, DVec2::new(arc.to.x, arc.to.y));
        // kurbo takes a radius below 1e-5 for 0, so the smaller one becomes 1.
        let unit = arc.radii.x.abs().min(arc.radii.y.abs());
        let half = (to - from) / (2.0 * unit);
        if unit == 0.0 || half.length_squared() < f64::MIN_POSITIVE {
            return self.line_to(to);
        }
        let placed = SvgArc {
            from: Point::new(-half.x, -half.y),
            to: Point::new(half.x, half.y),
            radii: arc.radii / unit,
            ..*arc
        };
        let Some(placed) = Arc::from_svg_arc(&placed) else {
            return self.line_to(to);
        };
        // Between ends that nearly coincide the angle is lost in rounding, but for a whole turn.
        let angle = placed.sweep_angle.abs();
        if angle < 1e-7 || !arc.large_arc && angle > 3.2 {
            return self.line_to(to);
        }
        let middle = from + (to - from) / 2.0;
        let on_plane = |p: Point| middle + DVec2::new(p.x, p.y) * unit;
        let tolerance = ARC_TOLERANCE * placed.radii.x.max(placed.radii.y);
        let mut pieces = Vec::new();
        placed.to_cubic_beziers(tolerance, |a, b, end| {
            pieces.push([a, b, end].map(on_plane));
        });
        match pieces.last_mut() {
            Some([.., end]) => *end = to,
            // Beyond what can be computed, which validation then reports.
            None => pieces.push([DVec2::NAN, DVec2::NAN, to]),
        }
        for [a, b, end] in pieces {
            self.push(CubicBezier::new([self.at, a, b, end]), LastHandle::None);
        }
    }

    /// A quarter of an ellipse with upright axes, in the direction from x to y.
    pub(crate) fn quarter_to(&mut self, radii: DVec2, to: DVec2) {
        self.arc_to(&SvgArc {
            from: Point::new(self.at.x, self.at.y),
            to: Point::new(to.x, to.y),
            radii: Vec2::new(radii.x, radii.y),
            x_rotation: 0.0,
            large_arc: false,
            sweep: true,
        });
    }

    /// Ends the subpath at its start; what follows without a move starts there again.
    pub(crate) fn close(&mut self) {
        // A second Z in a row closes nothing.
        if self.moved || self.drawn {
            self.end_subpath(true);
        }
        self.at = self.start;
        self.handle = LastHandle::None;
    }

    /// The subpaths that have been drawn.
    pub(crate) fn finish(mut self) -> Vec<BezierPath> {
        if self.drawn {
            self.end_subpath(false);
        }
        self.done
    }

    pub(crate) fn cubic_to(&mut self, first: DVec2, second: DVec2, to: DVec2) {
        let bezier = CubicBezier::new([self.at, first, second, to]);
        self.push(bezier, LastHandle::Cubic(second));
    }

    pub(crate) fn quadratic_to(&mut self, middle: DVec2, to: DVec2) {
        let bezier = CubicBezier::quadratic(self.at, middle, to);
        self.push(bezier, LastHandle::Quadratic(middle));
    }

    fn push(&mut self, bezier: CubicBezier, handle: LastHandle) {
        self.segments.push(bezier);
        self.at = bezier.end();
        self.handle = handle;
        self.drawn = true;
    }

    /// A subpath with commands but without length is kept, so that it can be reported.
    fn end_subpath(&mut self, z: bool) {
        let segments = std::mem::take(&mut self.segments);
        self.done.push(BezierPath::from_subpath(segments, z));
        (self.moved, self.drawn) = (false, false);
    }
}
