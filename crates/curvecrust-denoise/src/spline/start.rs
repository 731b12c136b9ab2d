//! The spline that a fit starts from: near the polyline of a guide.

use glam::DVec2;

use super::basis::Spline;
use super::guide::Guide;
use super::knots::Knots;
use super::penalty::{Penalty, Rough};
use super::system::{RIDGE, System};

/// Samples of the polyline an interval.
const DENSITY: usize = 8;
/// The fewest intervals between creases.
const LEAST: usize = 2;

/// A polyline with a parameter at each vertex, which grows by 1 an interval.
struct Polyline {
    places: Vec<DVec2>,
    tau: Vec<f64>,
}

impl Polyline {
    fn of(guide: &Guide) -> Option<Self> {
        let mut places = guide.vertices.clone();
        let mut spacing = guide.spacing.clone();
        if guide.closed {
            places.push(*places.first()?);
            spacing.push(*spacing.first()?);
        }
        let mut tau = vec![0.0];
        for i in 1..places.len() {
            let step = places[i].distance(places[i - 1]) / (0.5 * (spacing[i] + spacing[i - 1]));
            tau.push(tau[i - 1] + step);
        }
        let length = *tau.last()?;
        (length > 0.0 && length.is_finite()).then_some(Self { places, tau })
    }

    /// The same with its lengths as parameters.
    fn by_length(mut self) -> Self {
        let mut length = 0.0;
        for (i, t) in self.tau.iter_mut().enumerate() {
            length += self.places[i].distance(self.places[i.saturating_sub(1)]);
            *t = length;
        }
        self
    }

    fn at(&self, share: f64) -> DVec2 {
        let after = self.tau.partition_point(|&t| t < share);
        let edge = after.clamp(1, self.tau.len() - 1) - 1;
        let gap = self.tau[edge + 1] - self.tau[edge];
        let part = if gap > 0.0 {
            (share - self.tau[edge]) / gap
        } else {
            0.0
        };
        self.places[edge].lerp(self.places[edge + 1], part.clamp(0.0, 1.0))
    }
}

/// A part of the polyline between creases, from vertex to vertex, and how many intervals it gets.
struct Section {
    from: usize,
    to: usize,
    intervals: usize,
}

/// The sections between the creases of a guide; one of a guide without.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a number of intervals, of which there are as many as vertices allow"
)]
fn sections(guide: &Guide, line: &Polyline) -> Vec<Section> {
    // More than a few intervals a vertex serve nobody.
    let most = 4.0 * guide.vertices.len() as f64;
    let inner = guide.creases.iter().filter(|&&v| v > 0);
    let ends: Vec<usize> = std::iter::once(0)
        .chain(inner.copied())
        .chain(line.tau.len().checked_sub(1))
        .collect();
    let least = if guide.closed && guide.creases.len() < 2 {
        4
    } else {
        LEAST
    };
    ends.windows(2)
        .map(|pair| {
            let length = line.tau[pair[1]] - line.tau[pair[0]];
            Section {
                from: pair[0],
                to: pair[1],
                intervals: (length.ceil().min(most) as usize).max(least),
            }
        })
        .collect()
}

/// A spline near the polyline of the guide, with its creases.
pub(super) fn start(guide: &Guide) -> Option<Spline> {
    let line = Polyline::of(guide)?;
    let sections = sections(guide, &line);
    let line = if guide.even { line.by_length() } else { line };
    let (mut creases, mut intervals) = (Vec::new(), 0);
    creases.extend((guide.creases.first() == Some(&0)).then_some(0));
    let mut along = Vec::new();
    for section in &sections {
        let samples = DENSITY * section.intervals;
        for i in 0..samples {
            let [from, to] = [section.from, section.to].map(|v| line.tau[v]);
            along.push(line.at(from + i as f64 / samples as f64 * (to - from)));
        }
        intervals += section.intervals;
        creases.push(intervals);
    }
    creases.pop();
    if !guide.closed {
        along.extend(line.places.last());
    }
    let knots = Knots {
        intervals,
        closed: guide.closed,
        creases,
    };
    let rows: Vec<_> = (0..along.len())
        .map(|i| knots.row(i as f64 / DENSITY as f64))
        .collect();
    let weights = vec![1.0; rows.len()];
    let system = System::new(&rows, &along, &weights, &knots);
    let penalty = Penalty::new(&knots, Rough::Changes).matrix();
    let controls = system
        .normal
        .plus(1e-2, &penalty, RIDGE)
        .factor()
        .solve(system.right);
    Some(Spline { controls, knots })
}
