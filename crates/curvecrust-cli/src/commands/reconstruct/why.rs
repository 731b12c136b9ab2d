//! Why edges are there and ends stay open, as objects.

use super::BarePoints;
use curvecrust::reconstruct::Explanation;
use serde::Serialize;

/// Why an edge is there.
#[derive(Serialize)]
pub(super) struct ReasonObject {
    reason: &'static str,
    margin_at_most: Option<f64>,
}

/// Why an end stays open.
#[derive(Serialize)]
pub(super) struct OpenEndObject {
    point: u32,
    free_ends: u8,
    penalty: f64,
    partner: Option<u32>,
    cost_at_most: Option<f64>,
}

/// For every edge, in the order of the edges.
pub(super) fn reasons(why: &Explanation) -> impl Iterator<Item = ReasonObject> + '_ {
    why.edges.iter().map(|edge| ReasonObject {
        reason: edge.reason.name(),
        margin_at_most: edge.margin_at_most,
    })
}

/// For every open end.
pub(super) fn open_ends<'a>(
    why: &'a Explanation,
    bare: &'a BarePoints,
) -> impl Iterator<Item = OpenEndObject> + 'a {
    why.free_ends.iter().map(|end| OpenEndObject {
        point: bare.row(end.point),
        free_ends: end.count,
        penalty: end.penalty,
        partner: end.rejected.map(|rejected| bare.row(rejected.partner)),
        cost_at_most: end.rejected.map(|rejected| rejected.cost_at_most),
    })
}
