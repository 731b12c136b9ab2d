//! Rings inside rings as polygons with holes.

use curvecrust::geometry::PointId;
use curvecrust::reconstruct::{NestedChain, Reconstruction};
use std::borrow::Cow;

/// A ring that belongs to a polygon; indices of chains.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(in super::super) struct Ring {
    /// The ring at the outside of the polygon.
    pub(in super::super) outside: usize,
    /// Another one right inside it; `None` for the outside itself.
    pub(in super::super) hole: Option<usize>,
}

impl Ring {
    /// Its vertices in the order that formats want: counter-clockwise outside, clockwise for holes.
    pub(in super::super) fn vertices<'a>(&self, curves: &'a Reconstruction) -> Cow<'a, [PointId]> {
        let chains = curves.chains();
        match self.hole {
            None => Cow::Borrowed(chains[self.outside].chain.vertices()),
            // All rings of a reconstruction run counter-clockwise.
            Some(hole) => {
                let mut ids = chains[hole].chain.vertices().to_vec();
                ids[1..].reverse();
                Cow::Owned(ids)
            }
        }
    }
}

/// The first columns of a chain in a table: its number, what it is, and the nesting of a ring.
pub(in super::super) fn first_columns(number: usize, chain: &NestedChain) -> String {
    match chain.nesting {
        Some(nesting) => format!("{number},ring,{nesting}"),
        None => format!("{number},open,"),
    }
}

/// Every ring once, polygon by polygon in the order of their outsides, each outside before its
/// holes.
///
/// Rings at odd nesting are holes of the ring right around them. A hole around which there is none,
/// as may be where rings cross, is the outside of a polygon of its own.
pub(in super::super) fn rings(curves: &Reconstruction) -> Vec<Ring> {
    let ring = |(index, chain): (usize, &NestedChain)| {
        let is_odd = chain.nesting? % 2 == 1;
        let around = chain.parent.filter(|_| is_odd);
        Some(Ring {
            outside: around.unwrap_or(index),
            hole: around.map(|_| index),
        })
    };
    let chains = curves.chains().iter().enumerate();
    let mut rings: Vec<Ring> = chains.filter_map(ring).collect();
    rings.sort_unstable();
    rings
}
