//! Several tours from different starts, and the best of all of their edges.
//!
//! W. Cook, P. Seymour, "Tour Merging via Branch-Decomposition", INFORMS Journal on Computing
//! 15(3), 2003: good tours share most of their edges, and the few edges that they have in all hold
//! better tours than the best of them. Which clusters a tour passes in which order hardly changes
//! after its start, so one tour, however long it is improved, may have a wrong order. Here a search
//! among these edges alone takes the place of the decomposition.

use curvecrust_geometry::Random;

use super::ROUNDING;
use super::near::Near;
use super::search::Search;

/// Perturbations for each vertex and each tour, of one tour, and of all: 10,000 vertices and more
/// get one tour.
const PERTURBATIONS: usize = 4;
const MOST: usize = 14_000;
const MOST_OF_ALL: usize = 40_000;

/// So many tours at most, ...
const TOURS: usize = 5;
/// ... and none any more when so many exchanges were sought for each vertex, as on points whose
/// distances are of many orders of magnitude.
const MOST_SOUGHT: usize = 2_400;

/// So many vertices that follow each other stay together in a start.
const BLOCK: usize = 60;

/// So many of the shortest length are enough.
const ALIKE: usize = 3;

impl Search<'_> {
    /// Improves the tour and others by perturbations until so many of them are the shortest that no
    /// shorter one is likely; if there are not, one is sought among the edges of all.
    pub(super) fn merge_tours(&mut self) {
        let count = self.tour.len();
        let wanted = PERTURBATIONS * count;
        let rounds = wanted.min(MOST);
        let most = (MOST_OF_ALL / wanted.max(1)).clamp(1, TOURS);
        let mut tours: Vec<Vec<u32>> = Vec::new();
        let (mut shortest, mut least, mut alike) = (0, f64::INFINITY, 0);
        for seed in (1..).take(most) {
            if seed > 1 {
                if self.sought > MOST_SOUGHT * count {
                    break;
                }
                self.restart(shuffled(count, &mut Random::new(seed)));
            }
            self.perturb_often(rounds, seed);
            let length: f64 = self.lengths().sum();
            if length < least * (1.0 - ROUNDING) {
                (shortest, least, alike) = (tours.len(), length, 0);
            }
            alike += usize::from(length <= least * (1.0 + ROUNDING));
            if alike == ALIKE {
                return;
            }
            tours.push(self.tour.vertices().to_vec());
        }
        if tours.len() > 1 {
            self.near = Near::in_tours(&tours, self.cost.points());
            self.restart(tours.swap_remove(shortest));
            self.perturb_often(rounds, 1);
        }
    }
}

/// All vertices, whole blocks in random order. Vertices that follow each other are near each other.
fn shuffled(count: usize, random: &mut Random) -> Vec<u32> {
    let all: Vec<u32> = (0u32..).take(count).collect();
    let whole = all.chunks_exact(BLOCK);
    let rest = whole.remainder();
    let mut blocks: Vec<&[u32]> = whole.collect();
    random.shuffle(&mut blocks);
    blocks.push(rest);
    blocks.concat()
}
