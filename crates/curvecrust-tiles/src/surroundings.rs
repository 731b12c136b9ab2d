//! Which rings lie around a place, from sides in any order.

use std::iter;
use std::ops::Range;

use curvecrust_geometry::{DVec2, orient2d};

use crate::area::Area;

/// Places that sides of rings are held against: a ring lies around a place if it passes below it an
/// odd number of times (the even-odd rule).
#[derive(Clone, Debug)]
pub struct Crossings {
    /// The places and their positions among those given, sorted by x.
    places: Vec<(DVec2, usize)>,
    /// The place and the ring of each side that passes below; pairs cancel out.
    found: Vec<(usize, usize)>,
    /// The length of `found` when it was shortened last.
    shortened: usize,
    /// More than this are too many.
    most: usize,
}

/// Hands the rings around each of some places to `visit`: the position of the place and the rings,
/// ascending. A ring around which lie the rings is asked for by its
/// [`leftmost`](crate::Curve::leftmost) sample, which is never inside of the ring itself.
///
/// `sides` gives every side of every ring to [`Crossings::pass`], in any order. If more than `most`
/// pairs of a place and a ring have to be known at once, the places are halved, and it is called
/// again for each half. So memory is bounded however deeply rings are nested.
///
/// ```
/// use curvecrust_geometry::DVec2;
/// use curvecrust_tiles::{Area, TilesError, surrounding};
///
/// let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)].map(DVec2::from);
/// let places = [(1.0, 1.0), (5.0, 1.0), (0.0, 0.0)].map(DVec2::from);
/// let mut around = vec![];
/// let all = |crossings: &mut curvecrust_tiles::Crossings| {
///     for i in 0..4 {
///         crossings.pass(70, Area::of(corners), [corners[i], corners[(i + 1) % 4]]);
///     }
///     Ok::<_, TilesError>(())
/// };
/// surrounding(&places, 10, all, |place, rings| around.push((place, rings.to_vec())))?;
/// assert_eq!(around, [(0, vec![70])]);
/// # Ok::<(), TilesError>(())
/// ```
///
/// # Errors
/// Those of `sides`.
pub fn surrounding<E>(
    places: &[DVec2],
    most: usize,
    mut sides: impl FnMut(&mut Crossings) -> Result<(), E>,
    mut visit: impl FnMut(usize, &[usize]),
) -> Result<(), E> {
    let mut parts: Vec<Range<usize>> = iter::once(0..places.len()).collect();
    while let Some(part) = parts.pop() {
        if part.is_empty() {
            continue;
        }
        let numbered = part.clone().zip(&places[part.clone()]);
        let most = if part.len() == 1 { usize::MAX } else { most };
        let mut crossings = Crossings::new(numbered.map(|(at, &p)| (p, at)).collect(), most);
        sides(&mut crossings)?;
        crossings.shorten();
        if crossings.is_too_long() {
            let middle = part.start + part.len() / 2;
            parts.extend([middle..part.end, part.start..middle]);
            continue;
        }
        let by_place = crossings.found.chunk_by(|a, b| a.0 == b.0);
        for found in by_place {
            let rings: Vec<usize> = found.iter().map(|&(_, ring)| ring).collect();
            visit(found[0].0, &rings);
        }
    }
    Ok(())
}

impl Crossings {
    fn new(mut places: Vec<(DVec2, usize)>, most: usize) -> Self {
        places.sort_unstable_by(|a, b| a.0.x.total_cmp(&b.0.x).then(a.1.cmp(&b.1)));
        Self {
            places,
            found: Vec::new(),
            shortened: 0,
            most,
        }
    }

    /// Notes the places above a side of a ring, given where all of the ring lies.
    pub fn pass(&mut self, ring: usize, area: Area, [a, b]: [DVec2; 2]) {
        if self.is_too_long() {
            return;
        }
        // Of its ends only the right one belongs to a side, so that a vertex counts once.
        let (left, right) = if a.x <= b.x { (a, b) } else { (b, a) };
        let first = self.places.partition_point(|(place, _)| place.x <= left.x);
        let reached = self.places[first..].iter();
        for &(place, at) in reached.take_while(|(place, _)| place.x <= right.x) {
            if area.contains(place) && orient2d(left, right, place) > 0.0 {
                self.found.push((at, ring));
            }
        }
        // Each time there is room for as many as were kept, so that sorting is worth it.
        let room = (2 * self.shortened).max(1 << 16);
        if self.found.len() > room.min(self.most.saturating_mul(2)) {
            self.shorten();
        }
    }

    /// Whether a ring that lies in some area may lie around any of the places. If not, its sides
    /// need not be given.
    #[must_use]
    pub fn may_have(&self, area: Area) -> bool {
        // No side lies to the left of a place on the left border.
        let first = self.places.partition_point(|(p, _)| p.x <= area.low.x);
        let reached = self.places[first..].iter();
        let mut reached = reached.take_while(|(p, _)| p.x <= area.high.x);
        reached.any(|&(place, _)| area.contains(place))
    }

    /// Leaves of equal pairs one, or none if there are evenly many.
    fn shorten(&mut self) {
        self.found.sort_unstable();
        let mut kept = 0;
        for at in 0..self.found.len() {
            let pair = self.found[at];
            if kept > 0 && self.found[kept - 1] == pair {
                kept -= 1;
            } else {
                self.found[kept] = pair;
                kept += 1;
            }
        }
        self.found.truncate(kept);
        self.shortened = kept;
    }

    fn is_too_long(&self) -> bool {
        self.shortened > self.most
    }
}
