//! Connect-the-closest-dot puzzles: the rule by which coloured dots are joined.
//!
//! M. Löffler, M. Kaiser, T. van Kapel, G. Klappe, M. van Kreveld, F. Staals, *The
//! Connect-The-Dots Family of Puzzles: Design and Automatic Generation*, SIGGRAPH 2014.
//!
//! Each dot has one or more colours. For each of its colours, it is joined with the closest other
//! dot that has this colour too. This is no [`Reconstructor`](crate::Reconstructor), since those
//! see bare points: here the colours carry what a sampling condition would have to guarantee.
//! `curvecrust-sampling` makes dots of a curve such that the rule returns exactly their polygon.
//!
//! Cost: O(m log m) for m pairs of a dot and its colour, by one R-tree a colour. Only where many
//! dots are equally far from one, all of these are looked at.

use std::collections::BTreeMap;
use std::fmt;

use curvecrust_geometry::parallel::*;
use curvecrust_geometry::point_set::by_coordinates;
use curvecrust_geometry::{Edge, EdgeSet, Interrupt, PointId, PointSet};
use rstar::RTree;
use rstar::primitives::GeomWithData;

use crate::error::ReconstructError;

/// One of the colours of a puzzle: a number without a meaning.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Colour(u32);

impl From<u32> for Colour {
    fn from(number: u32) -> Self {
        Self(number)
    }
}

impl From<Colour> for u32 {
    fn from(colour: Colour) -> Self {
        colour.0
    }
}

impl fmt::Display for Colour {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// Dots: points, each with a set of colours.
///
/// # Guarantees
/// There is one set for each point, in the order of ids. It may be empty; its colours are ascending
/// and unique.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Dots {
    points: PointSet,
    colours: Vec<Vec<Colour>>,
}

impl Dots {
    /// Gives each point its colours, in any order, repeated or not.
    ///
    /// # Errors
    /// [`ColourCount`](ReconstructError::ColourCount) if there are more or fewer sets of colours
    /// than points.
    pub fn new(points: PointSet, mut colours: Vec<Vec<Colour>>) -> Result<Self, ReconstructError> {
        if colours.len() != points.len() {
            return Err(ReconstructError::ColourCount {
                sets: colours.len(),
                count: points.len(),
            });
        }
        for set in &mut colours {
            set.sort_unstable();
            set.dedup();
        }
        Ok(Self { points, colours })
    }

    /// Where the dots are.
    #[must_use]
    pub fn points(&self) -> &PointSet {
        &self.points
    }

    /// The colours of each dot, in the order of ids, ascending.
    #[must_use]
    pub fn colours(&self) -> &[Vec<Colour>] {
        &self.colours
    }

    /// How many colours there are.
    #[must_use]
    pub fn colour_count(&self) -> usize {
        self.of_colours().len()
    }

    /// The dots of each colour.
    fn of_colours(&self) -> BTreeMap<Colour, Vec<PointId>> {
        let mut dots: BTreeMap<Colour, Vec<PointId>> = BTreeMap::new();
        for (id, colours) in self.points.ids().zip(&self.colours) {
            for &colour in colours {
                dots.entry(colour).or_default().push(id);
            }
        }
        dots
    }
}

/// A dot and the one that it is joined with, for one of its colours.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Join {
    /// The dot.
    pub dot: PointId,
    /// One of its colours.
    pub colour: Colour,
    /// The closest other dot of this colour.
    pub closest: PointId,
    /// How far it is, in the unit of the coordinates.
    pub distance: f64,
    /// How far the second closest dot of this colour is; infinite if there is none.
    pub next: f64,
}

impl Join {
    /// By what share the second closest dot is farther than the closest: 0.1 if by 10 %, 0 where
    /// two are equally far.
    ///
    /// The smaller it is, the harder it is to see which dot is meant.
    #[must_use]
    pub fn margin(&self) -> f64 {
        self.next / self.distance - 1.0
    }
}

/// What each dot is joined with, in the order of dots, and of colours for each dot. A dot that is
/// the only one of a colour is joined with none for it.
///
/// Distances are compared as squares computed in f64 from differences of coordinates; ties go to
/// the smaller x, then the smaller y, as in [`neighbours`](crate::neighbours::neighbours).
#[must_use]
pub fn joins(dots: &Dots) -> Vec<Join> {
    let interrupt = Interrupt::current();
    let mut joins = Vec::new();
    for (colour, ids) in dots.of_colours() {
        let place = |&id: &PointId| GeomWithData::new(dots.points[id].to_array(), id.index());
        let tree = RTree::bulk_load(ids.iter().map(place).collect());
        let found: Vec<Option<Join>> = ids
            .par_iter()
            .map(|&dot| {
                interrupt.check();
                join(&dots.points, &tree, dot, colour)
            })
            .collect();
        joins.extend(found.into_iter().flatten());
    }
    joins.sort_unstable_by_key(|join| (join.dot, join.colour));
    joins
}

/// The closest other dot in a tree of dots of one colour.
fn join(
    points: &PointSet,
    tree: &RTree<GeomWithData<[f64; 2], usize>>,
    dot: PointId,
    colour: Colour,
) -> Option<Join> {
    let at = points[dot];
    let squared = |id: PointId| (points[id] - at).length_squared();
    let others = tree.nearest_neighbor_iter(at.to_array());
    let others = others.filter_map(|place| PointId::new(place.data));
    let mut others = others.filter(|&id| id != dot);
    let mut closest = others.next()?;
    let distance = squared(closest);
    // That of the second closest, even where it is as far as the closest.
    let mut next = None;
    for other in others {
        let other_distance = squared(other);
        next = next.or(Some(other_distance));
        if other_distance > distance {
            break;
        }
        if by_coordinates(points[other], points[closest]).is_lt() {
            closest = other;
        }
    }
    Some(Join {
        dot,
        colour,
        closest,
        distance: distance.sqrt(),
        next: next.map_or(f64::INFINITY, f64::sqrt),
    })
}

/// Solves a puzzle: the edges between dots that are [joined](joins).
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::closest_dot::{Colour, Dots, closest_dot};
///
/// // Along a line, steps that get shorter need one colour; longer ones again a second.
/// let points = [0.0, 4.0, 7.0, 9.0, 12.0].map(|x| DVec2::new(x, 0.0)).to_vec();
/// let [red, blue] = [0, 1].map(Colour::from);
/// let colours = [vec![red], vec![red], vec![red], vec![red, blue], vec![blue]];
/// let dots = Dots::new(PointSet::new(points)?, colours.to_vec())?;
/// let edges: Vec<String> = closest_dot(&dots).edges().iter().map(ToString::to_string).collect();
/// assert_eq!(edges, ["0-1", "1-2", "2-3", "3-4"]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn closest_dot(dots: &Dots) -> EdgeSet {
    let joins = joins(dots);
    let edges = joins.iter().filter_map(|j| Edge::new(j.dot, j.closest));
    EdgeSet::new(dots.points.len(), edges)
}

#[cfg(test)]
mod tests {
    use super::*;
    use curvecrust_geometry::DVec2;
    use proptest::prelude::*;

    /// Dots on a small grid, where many are equally far, each with up to three of three colours.
    fn dots() -> impl Strategy<Value = Dots> {
        let at = (-4i32..4, -4i32..4).prop_map(|(x, y)| DVec2::new(x.into(), y.into()));
        prop::collection::vec((at, prop::collection::vec(0u32..3, 0..4)), 0..50).prop_map(|all| {
            let (at, colours): (Vec<_>, Vec<_>) = all.into_iter().unzip();
            let points = PointSet::merging_duplicates(at).unwrap().points;
            let colours = colours.into_iter().take(points.len());
            let colours = colours.map(|set: Vec<u32>| set.into_iter().map(Colour).collect());
            Dots::new(points, colours.collect()).unwrap()
        })
    }

    /// The definition, word for word.
    fn brute_force(dots: &Dots) -> Vec<Join> {
        let points = &dots.points;
        let mut joins = Vec::new();
        for dot in points.ids() {
            for &colour in &dots.colours[dot.index()] {
                let of_colour = |id: &PointId| dots.colours[id.index()].contains(&colour);
                let mut others: Vec<PointId> = points
                    .ids()
                    .filter(of_colour)
                    .filter(|&id| id != dot)
                    .collect();
                let squared = |id: PointId| (points[id] - points[dot]).length_squared();
                others.sort_by(|&a, &b| {
                    let closer = squared(a).total_cmp(&squared(b));
                    closer.then(by_coordinates(points[a], points[b]))
                });
                joins.extend(others.first().map(|&closest| {
                    Join {
                        dot,
                        colour,
                        closest,
                        distance: squared(closest).sqrt(),
                        next: others
                            .get(1)
                            .map_or(f64::INFINITY, |&id| squared(id).sqrt()),
                    }
                }));
            }
        }
        joins
    }

    #[test]
    fn each_point_needs_its_colours() {
        let points = PointSet::new(vec![DVec2::ZERO, DVec2::X]).unwrap();
        let error = Dots::new(points, vec![vec![]]).unwrap_err();
        assert_eq!(error, ReconstructError::ColourCount { sets: 1, count: 2 });
    }

    #[test]
    fn a_dot_alone_in_its_colour_is_joined_with_none() {
        let points = PointSet::new(vec![DVec2::ZERO, DVec2::X]).unwrap();
        let dots = Dots::new(points, vec![vec![Colour(0)], vec![Colour(7)]]).unwrap();
        assert_eq!(dots.colour_count(), 2);
        assert!(closest_dot(&dots).is_empty());
        assert!(closest_dot(&Dots::default()).is_empty());
    }

    proptest! {
        #[test]
        fn equals_brute_force(dots in dots()) {
            prop_assert_eq!(joins(&dots), brute_force(&dots));
        }

        #[test]
        fn the_order_of_dots_does_not_matter(dots in dots()) {
            let count = u32::try_from(dots.points.len()).unwrap();
            let back = |id: PointId| PointId::from(count - 1 - u32::from(id));
            let points = dots.points.points().iter().rev().copied().collect();
            let colours = dots.colours.iter().rev().cloned().collect();
            let reversed = Dots::new(PointSet::new(points).unwrap(), colours).unwrap();
            let ends = closest_dot(&reversed);
            let ends = ends.edges().iter().filter_map(|e| Edge::new(back(e.a()), back(e.b())));
            prop_assert_eq!(EdgeSet::new(dots.points.len(), ends), closest_dot(&dots));
        }
    }
}
