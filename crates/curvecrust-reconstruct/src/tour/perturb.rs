//! Perturbations: the tour is changed at random and improved again, many times.
//!
//! O. Martin, S. W. Otto, E. W. Felten, "Large-Step Markov Chains for the Traveling Salesman
//! Problem", Complex Systems 5, 1991; D. Applegate, W. Cook, A. Rohe, "Chained Lin-Kernighan for
//! Large Traveling Salesman Problems", INFORMS Journal on Computing 15(1), 2003. The change is a
//! double bridge, which no sequential exchange undoes, of edges at the ends of random walks from a
//! random vertex.

use curvecrust_geometry::Random;

use super::cost::Change;
use super::order::{Mark, Order, Segment};
use super::search::Search;

/// A walk has at most so many steps.
const LONGEST_WALK: usize = 100;

/// A perturbation that would move more vertices takes paths of at most so many instead.
const MOST_MOVED: usize = 2_000;
const LONGEST_PATH: usize = 50;

/// A tour that is longer by up to this share of the second shortest edge that the perturbation took
/// away may replace the present one: edges in clusters are much shorter than those between them.
/// The share falls to 0.
const ACCEPTED: f64 = 0.3;

/// On most points 50 to 180 exchanges are sought after a perturbation; where distances are of many
/// orders of magnitude, thousands. Perturbations end when there were so many for each on average.
const MOST_SOUGHT: usize = 200;

impl Search<'_> {
    /// Perturbs the tour and improves it, so many times; the best one remains.
    pub(super) fn perturb_often(&mut self, rounds: usize, seed: u64) {
        let count = self.tour.len();
        // A double bridge takes five vertices at least. Of the three tours through four, exchanges
        // find the shortest.
        if count < 5 {
            return;
        }
        self.keeps = false;
        self.tour.keep();
        let most = self.sought + MOST_SOUGHT * rounds;
        let mut random = Random::new(seed);
        let mut above = Change::default();
        let mut best = None;
        for round in 0..rounds {
            if self.sought > most {
                break;
            }
            let share = ACCEPTED * (1.0 - round as f64 / rounds as f64);
            let (perturbed, edge) = self.perturb(&mut random);
            let change = perturbed + self.improve();
            let risk = share * edge * random.unit();
            if (above + change).is_gain() {
                (above, best) = (Change::default(), None);
            } else if change.is_gain() || change.cost < risk {
                best = best.or_else(|| Some(self.tour.kept()));
                above = above + change;
            } else {
                self.tour.undo(Mark::default());
            }
            self.tour.keep();
        }
        if let Some(best) = best {
            self.tour = Order::new(best);
        }
    }

    /// A double bridge: from a, b..c, d..e, f..g, h to a, f..g, d..e, b..c, h. What it changes, and
    /// the second shortest of the edges that it takes away.
    fn perturb(&mut self, random: &mut Random) -> (Change, f64) {
        let [a, c, e, g] = self.four(random);
        let [b, d, f, h] = [a, c, e, g].map(|v| self.tour.next(v));
        let vertices = [a, b, c, d, e, f, g, h];
        let mut change = Change::default();
        let mut removed = [[a, b], [c, d], [e, f], [g, h]].map(|[v, w]| self.cost.edge(v, w));
        removed.iter().for_each(|&edge| change.remove(edge));
        removed.sort_unstable_by(f64::total_cmp);
        for [v, w] in [[a, f], [g, d], [e, b], [c, h]] {
            change.add(self.cost.edge(v, w));
        }
        change.cost -= self.vertices_cost(&vertices);
        let paths = [[h, a], [f, g], [d, e], [b, c]];
        self.tour.join(&mut paths.map(|path| {
            let [from, to] = path.map(|v| self.tour.place(v));
            let is_on = true;
            Segment { from, to, is_on }
        }));
        change.cost += self.vertices_cost(&vertices);
        for v in vertices {
            self.enqueue(v);
        }
        (change, removed[1])
    }

    fn vertices_cost(&self, vertices: &[u32]) -> f64 {
        let first = |&i: &usize| !vertices[..i].contains(&vertices[i]);
        let each = (0..vertices.len()).filter(first);
        each.map(|i| self.vertex(vertices[i])).sum()
    }

    /// Four vertices in the order of the tour, of which the first comes farthest after the last.
    fn four(&self, random: &mut Random) -> [u32; 4] {
        let count = self.tour.len();
        let start = self.tour.vertices()[random.below(count)];
        let mut four = [start; 4];
        for v in &mut four[1..] {
            for _ in 0..=random.below(LONGEST_WALK) {
                let near = self.near.of(*v);
                *v = near.get(random.below(near.len())).copied().unwrap_or(*v);
            }
        }
        four.sort_unstable_by_key(|&v| self.tour.place(v));
        let places = four.map(|v| self.tour.place(v) as usize);
        let after = |i: usize| (places[(i + 1) % 4] + count - places[i]) % count;
        let widest = (0..4).max_by_key(|&i| after(i)).unwrap_or(3);
        let is_distinct = (0..4).all(|i| after(i) > 0);
        if is_distinct && count - after(widest) <= MOST_MOVED {
            four.rotate_left((widest + 1) % 4);
            return four;
        }
        let most = LONGEST_PATH.min((count - 2) / 3);
        let mut steps = 0;
        [0, 1, 1, 1].map(|is_further| {
            steps += is_further * (1 + random.below(most));
            self.tour.after(start, steps)
        })
    }
}
