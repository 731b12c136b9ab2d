//! Samples of any origin, by their places on a dense curve.

use std::collections::HashMap;
use std::ops::Range;

use curvecrust_curve::DenseCurve;
use curvecrust_geometry::{Component, DVec2, Edge, EdgeSet, PointId, Segment, SegmentTree};
use curvecrust_medial_axis::MeasuredCurve;

use crate::error::SamplingError;
use crate::sampled_curve::SampledCurve;

/// A sample, and where it is on a dense curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// The sample.
    pub point: DVec2,
    /// Index of the dense point at it or before it.
    pub dense: usize,
    /// How far along the gap after that point, in [0, 1): its fraction of the chord. 0 at an open
    /// end.
    pub t: f64,
}

/// Samples in the order of a dense curve.
///
/// # Guarantees
/// The samples of each component follow each other along it, each once, and come before those of
/// the next component. On a closed component the first of them may be anywhere.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedSamples {
    placements: Vec<Placement>,
    components: Vec<Range<usize>>,
}

/// Bare points that were projected to a curve.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Projected {
    /// The samples, in the order of the curve.
    pub samples: PlacedSamples,
    /// For each sample the index of the point that it was.
    pub indices: Vec<usize>,
    /// For each sample its distance to the polygon of the dense points, of which the curve is
    /// within about an eighth of (gap / lfs)^2 lfs.
    pub distances: Vec<f64>,
}

impl Projected {
    /// The manifold boundary: the edges between consecutive samples of each component, by the
    /// indices of the points. `measured` is the curve that the points were projected to.
    #[must_use]
    pub fn manifold_boundary(&self, measured: &MeasuredCurve) -> EdgeSet {
        let dense = measured.dense().components().iter();
        let edges = self.samples.components().iter().zip(dense);
        let edges = edges.flat_map(|(range, &Component { closed, .. })| {
            let range = range.clone();
            let id = |sample: usize| PointId::new(self.indices[sample]);
            let pairs = Component { range, closed }.pairs();
            pairs.filter_map(move |(i, j)| Edge::new(id(i)?, id(j)?))
        });
        EdgeSet::new(self.indices.len(), edges)
    }
}

impl PlacedSamples {
    /// Takes samples that are in the order of the curve already.
    ///
    /// # Errors
    /// [`NoSuchPlace`](SamplingError::NoSuchPlace) and [`OutOfOrder`](SamplingError::OutOfOrder),
    /// for the first sample at fault.
    pub fn new(
        measured: &MeasuredCurve,
        placements: Vec<Placement>,
    ) -> Result<Self, SamplingError> {
        let dense = measured.dense();
        for (index, place) in placements.iter().enumerate() {
            let Placement { dense: at, t, .. } = *place;
            let in_gap = at < dense.len()
                && place.point.is_finite()
                && (0.0..1.0).contains(&t)
                && (t <= 0.0 || dense.next(at).is_some());
            if !in_gap {
                return Err(SamplingError::NoSuchPlace {
                    index,
                    dense: at,
                    t,
                });
            }
        }
        let mut components = Vec::with_capacity(dense.components().len());
        let mut start = 0;
        for (component, Component { range, closed }) in each_component(dense) {
            let here = placements[start..].iter();
            let end = start + here.take_while(|p| range.contains(&p.dense)).count();
            let samples = &placements[start..end];
            let mut rounds_left = usize::from(closed);
            for (i, pair) in samples.windows(2).enumerate() {
                let ascends = key(&pair[0]) < key(&pair[1]);
                // Over the seam once, and not on to the first sample again.
                let seam = !ascends && rounds_left > 0;
                rounds_left -= usize::from(seam);
                let wrapped = rounds_left < usize::from(closed);
                let overlaps = closed && wrapped && key(&pair[1]) >= key(&samples[0]);
                if !(ascends || seam) || overlaps {
                    let index = start + i + 1;
                    return Err(SamplingError::OutOfOrder { index, component });
                }
            }
            components.push(start..end);
            start = end;
        }
        if let Some(place) = placements.get(start) {
            let component = dense.component_of(place.dense);
            return Err(SamplingError::OutOfOrder {
                index: start,
                component,
            });
        }
        Ok(Self {
            placements,
            components,
        })
    }

    /// Takes the samples of a sampler, on the dense curve that it was given.
    ///
    /// # Errors
    /// [`NoSuchPlace`](SamplingError::NoSuchPlace) or [`OffCurve`](SamplingError::OffCurve) if they
    /// are of another dense curve.
    pub fn of(measured: &MeasuredCurve, sampled: &SampledCurve) -> Result<Self, SamplingError> {
        let points = measured.dense().points();
        let placements = Self::at_dense_points(sampled).placements;
        let elsewhere = |p: &Placement| points.get(p.dense).is_some_and(|&q| q != p.point);
        if let Some(index) = placements.iter().position(elsewhere) {
            let Placement { point, dense, .. } = placements[index];
            return Err(SamplingError::OffCurve {
                index,
                at: point,
                distance: point.distance(points[dense]),
                tolerance: 0.0,
            });
        }
        Self::new(measured, placements)
    }

    /// Samples that are dense points, as samplers return them.
    pub(crate) fn at_dense_points(sampled: &SampledCurve) -> Self {
        let places = sampled.points().iter().zip(sampled.dense_indices());
        let place = |(&point, &dense): (&DVec2, &usize)| Placement {
            point,
            dense,
            t: 0.0,
        };
        let components = sampled.components().iter();
        Self {
            placements: places.map(place).collect(),
            components: components.map(|c| c.range.clone()).collect(),
        }
    }

    /// Projects bare points, in any order, to the nearest places of the dense polygon.
    ///
    /// # Errors
    /// [`Parameter`](SamplingError::Parameter) for a tolerance that is no length,
    /// [`OffCurve`](SamplingError::OffCurve) for the first point that is farther than the
    /// tolerance, and [`SamePlace`](SamplingError::SamePlace) for points that have the same
    /// projection.
    pub fn project(
        measured: &MeasuredCurve,
        points: &[DVec2],
        tolerance: f64,
    ) -> Result<Projected, SamplingError> {
        if !(tolerance >= 0.0 && tolerance.is_finite()) {
            return Err(SamplingError::Parameter {
                name: "tolerance",
                value: tolerance,
                range: "a length, not below 0",
            });
        }
        let polygon = Polygon::new(measured.dense());
        let mut found = Vec::with_capacity(points.len());
        for (index, &p) in points.iter().enumerate() {
            let near = if p.is_finite() {
                polygon.nearest(p)
            } else {
                None
            };
            let distance = near.map_or(f64::NAN, |(_, distance)| distance);
            match near {
                Some((place, distance)) if distance <= tolerance => {
                    found.push((place, index, distance));
                }
                _ => {
                    return Err(SamplingError::OffCurve {
                        index,
                        at: p,
                        distance,
                        tolerance,
                    });
                }
            }
        }
        found.sort_by(|(p, i, _), (q, j, _)| {
            let along = p.dense.cmp(&q.dense).then(p.t.total_cmp(&q.t));
            along.then(i.cmp(j))
        });
        if let Some(pair) = found.windows(2).find(|f| key(&f[0].0) == key(&f[1].0)) {
            return Err(SamplingError::SamePlace {
                samples: [pair[0].1, pair[1].1],
                at: pair[0].0.point,
            });
        }
        let samples = Self::new(measured, found.iter().map(|f| f.0).collect())?;
        Ok(Projected {
            samples,
            indices: found.iter().map(|f| f.1).collect(),
            distances: found.iter().map(|f| f.2).collect(),
        })
    }

    /// The samples.
    #[must_use]
    pub fn placements(&self) -> &[Placement] {
        &self.placements
    }

    /// The indices of the samples of each component of the dense curve; empty where there are none.
    #[must_use]
    pub fn components(&self) -> &[Range<usize>] {
        &self.components
    }
}

fn each_component(dense: &DenseCurve) -> impl Iterator<Item = (usize, Component)> + '_ {
    dense.components().iter().cloned().enumerate()
}

fn key(place: &Placement) -> (usize, f64) {
    (place.dense, place.t)
}

/// The chords of a dense curve, to be found by their ends.
struct Polygon<'a> {
    dense: &'a DenseCurve,
    tree: SegmentTree,
    starts: HashMap<[u64; 4], usize>,
}

impl<'a> Polygon<'a> {
    fn new(dense: &'a DenseCurve) -> Self {
        // A component of one point is a segment without length.
        let end = |i: usize| match dense.next(i) {
            Some(next) => Some(next),
            None => dense.previous(i).is_none().then_some(i),
        };
        let chord = |i: usize| {
            let points = dense.points();
            Some((i, Segment::new(points[i], points[end(i)?])))
        };
        let chords: Vec<_> = (0..dense.len()).filter_map(chord).collect();
        Self {
            dense,
            tree: SegmentTree::new(chords.iter().map(|&(_, chord)| chord)),
            // Of equal chords the first.
            starts: chords.iter().rev().map(|&(i, s)| (bits(s), i)).collect(),
        }
    }

    fn nearest(&self, p: DVec2) -> Option<(Placement, f64)> {
        let (chord, distance) = self.tree.nearest(p)?;
        let start = *self.starts.get(&bits(chord))?;
        let foot = chord.closest_point(p);
        let t = foot.distance(chord.a) / chord.length();
        // The end of a gap is the start of the next.
        let (dense, t) = if t >= 1.0 {
            (self.dense.next(start).unwrap_or(start), 0.0)
        } else if t > 0.0 {
            (start, t)
        } else {
            (start, 0.0)
        };
        let place = Placement { point: p, dense, t };
        Some((place, distance))
    }
}

fn bits(s: Segment) -> [u64; 4] {
    [s.a.x, s.a.y, s.b.x, s.b.y].map(f64::to_bits)
}
