//! From points to edges, with their reasons.

use crate::error::Error;
use crate::message::Answer;
use crate::points::MOST_POINTS;
use curvecrust::DVec2;
use curvecrust::geometry::{EdgeSet, PointId, PointSet};
use curvecrust::reconstruct::{
    ALGORITHMS, Explanation, Known, Reconstruction, Reconstructor, Shape,
};
use serde::Deserialize;
use std::num::NonZeroU32;

/// What is asked for.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Request {
    algorithm: String,
    shape: Option<KnownShape>,
    curves: Option<NonZeroU32>,
    /// Whether edges come with their reasons, which take longer to find than the edges.
    #[serde(default)]
    reasons: bool,
}

/// The shape of all curves.
#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum KnownShape {
    Closed,
    Open,
}

impl Request {
    /// Reconstructs points, of which equal ones count as one.
    pub(super) fn perform(self, points: Vec<DVec2>) -> Result<Answer, Error> {
        if points.len() > MOST_POINTS {
            return Err(Error::TooMany(points.len(), MOST_POINTS));
        }
        let algorithm = ALGORITHMS.iter().find(|a| a.info().name == self.algorithm);
        let algorithm = *algorithm.ok_or(Error::Algorithm(self.algorithm))?;
        let known = Known {
            shape: self.shape.map(|shape| match shape {
                KnownShape::Closed => Shape::Closed,
                KnownShape::Open => Shape::Open,
            }),
            curves: self.curves,
            termini: Vec::new(),
        };
        let merged = PointSet::merging_duplicates(points)?;
        let duplicates = merged.duplicates();
        let (edges, why) = found(algorithm, &merged.points, &known, self.reasons)?;
        let curves = Reconstruction::new(&merged.points, edges)?;
        let index = |id: PointId| merged.origin.get(id.index()).copied().unwrap_or(id.index());
        let mut answer = describe(&curves, index);
        answer.value("duplicates", duplicates);
        if let Some(why) = why {
            explain(&mut answer, &why, index);
        }
        Ok(answer)
    }
}

/// The edges, with reasons if they are wanted and the algorithm gives some.
fn found(
    algorithm: &dyn Reconstructor,
    points: &PointSet,
    known: &Known,
    reasons: bool,
) -> Result<(EdgeSet, Option<Explanation>), Error> {
    if reasons && let Some(why) = algorithm.explain_known(points, known)? {
        return Ok((why.edge_set(points.len()), Some(why)));
    }
    Ok((algorithm.reconstruct_known(points, known)?, None))
}

/// Edges, curves in order, and points that are not within a curve, all by index.
fn describe(curves: &Reconstruction, index: impl Fn(PointId) -> usize + Copy) -> Answer {
    let mut answer = Answer::default();
    let edges = curves.edges().edges().iter();
    answer.pairs(
        "edges",
        edges.map(|edge| [index(edge.a()), index(edge.b())]),
    );
    let chains = curves.chains();
    let mut vertices = Vec::with_capacity(curves.degrees().len());
    for nested in chains {
        vertices.extend(nested.chain.vertices().iter().copied().map(index));
    }
    answer.indices("vertices", vertices);
    answer.indices(
        "lengths",
        chains.iter().map(|nested| nested.chain.vertices().len()),
    );
    let closed = chains
        .iter()
        .map(|nested| usize::from(nested.chain.is_closed()));
    answer.indices("closed", closed);
    answer.indices("leaves", curves.leaves().into_iter().map(index));
    answer.indices("isolated", curves.isolated().into_iter().map(index));
    answer.indices("junctions", curves.junctions().into_iter().map(index));
    answer
}

/// The reasons of the edges, in their order, and what the free ends have rejected.
fn explain(answer: &mut Answer, why: &Explanation, index: impl Fn(PointId) -> usize + Copy) {
    let reasons: Vec<&str> = why.edges.iter().map(|edge| edge.reason.name()).collect();
    answer.value("reasons", reasons);
    // NaN where there is no margin.
    let margins = why
        .edges
        .iter()
        .map(|edge| edge.margin_at_most.unwrap_or(f64::NAN));
    answer.array("margins", margins);
    let ends = why.free_ends.iter();
    answer.indices("ends", ends.clone().map(|end| index(end.point)));
    answer.array("penalties", ends.clone().map(|end| end.penalty));
    let rejected = |end: &curvecrust::reconstruct::FreeEnd| match end.rejected {
        Some(other) => [index(other.partner) as f64, other.cost_at_most],
        None => [f64::NAN; 2],
    };
    answer.array("rejected", ends.flat_map(rejected));
}
