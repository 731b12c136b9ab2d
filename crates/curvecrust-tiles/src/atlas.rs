//! Where the samples of all tiles are, and which place to ask first.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::area::Area;
use crate::query::Query;

/// Areas under a node.
const WIDTH: usize = 16;

/// The areas of groups of samples, such as the runs of all tiles.
///
/// Every sample of every tile lies in the area of its group. It is fastest if areas that follow
/// each other are close to each other, as the runs of [`Samples`](crate::Samples) are.
#[derive(Clone, Debug)]
pub struct Atlas {
    /// The areas, and above them those of each 16.
    levels: Vec<Vec<Area>>,
}

impl Atlas {
    /// The atlas of some areas, which are known by their positions.
    #[must_use]
    pub fn new(areas: Vec<Area>) -> Self {
        let mut levels = vec![areas];
        while let Some(below) = levels.last().filter(|level| level.len() > 1) {
            let above = below.chunks(WIDTH).map(|areas| {
                let areas = areas.iter().copied();
                areas.fold(Area::NOTHING, Area::union)
            });
            let above = above.collect();
            levels.push(above);
        }
        Self { levels }
    }

    /// The number of areas.
    #[must_use]
    pub fn len(&self) -> usize {
        self.levels.first().map_or(0, Vec::len)
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Makes an area empty. Those behind it keep their positions.
    pub(crate) fn clear(&mut self, index: usize) {
        if let Some(area) = self.levels[0].get_mut(index) {
            *area = Area::NOTHING;
        }
        let mut place = index / WIDTH;
        for level in 1..self.levels.len() {
            let below = &self.levels[level - 1];
            let areas = below.chunks(WIDTH).nth(place).into_iter().flatten();
            let all = areas.copied().fold(Area::NOTHING, Area::union);
            if let Some(area) = self.levels[level].get_mut(place) {
                *area = all;
            }
            place /= WIDTH;
        }
    }

    /// The area to ask first: the nearest one that may hold something better than what is known,
    /// and was not asked yet.
    pub(crate) fn first(&self, query: &Query, asked: &[usize]) -> Option<usize> {
        let is_wanted = |index| !asked.contains(&index);
        let found = self.nearest(|area| query.reach(area), is_wanted);
        found.map(|(index, _)| index)
    }

    /// The nearest of the areas that are wanted, and the square of its distance, which `reach`
    /// tells: `None` if an area holds nothing of interest, and neither do those that it covers.
    pub(crate) fn nearest(
        &self,
        reach: impl Fn(Area) -> Option<f64>,
        is_wanted: impl Fn(usize) -> bool,
    ) -> Option<(usize, f64)> {
        let mut heap = BinaryHeap::new();
        let push = |heap: &mut BinaryHeap<_>, level: usize, index: usize| {
            let area = self.levels.get(level).and_then(|level| level.get(index));
            if let Some(squared) = area.and_then(|&area| reach(area)) {
                // Bits of numbers from 0 on are in the order of the numbers.
                heap.push(Reverse((squared.to_bits(), level, index)));
            }
        };
        push(&mut heap, self.levels.len() - 1, 0);
        while let Some(Reverse((squared, level, index))) = heap.pop() {
            if level > 0 {
                for child in WIDTH * index..WIDTH * (index + 1) {
                    push(&mut heap, level - 1, child);
                }
            } else if is_wanted(index) {
                return Some((index, f64::from_bits(squared)));
            }
        }
        None
    }
}
