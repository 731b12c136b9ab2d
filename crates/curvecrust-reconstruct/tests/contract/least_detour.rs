//! What least detour promises of its edges, from its definition.

use curvecrust_geometry::point_set::by_coordinates;
use curvecrust_geometry::{DVec2, Edge, EdgeSet, PointId, PointSet};
use curvecrust_reconstruct::{LeastDetour, Reason, Reconstructor};
use curvecrust_testing::strategies::{any_points, even_runs, point_set, uniform};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

use self::constants::{
    AHEAD_COSINE, CERTIFIED_COSINE, CONTINUATION_NEIGHBOURS, EVEN_RATIO, PENALTY, RUN_EDGES,
    RUN_PENALTY, SPACING_NEIGHBOURS, STRAIGHT_COSINE, TRUSTED_DETOUR, UNEVEN_RATIO,
};
use super::oracles;

/// The constants of the method, not a copy of them.
#[path = "../../src/least_detour/constants.rs"]
#[allow(
    dead_code,
    reason = "those of the search are no part of the definition"
)]
mod constants;

/// `docs/method.md` lists every constant with its value. It is not there in the published crate.
#[test]
fn the_method_lists_every_constant() {
    let here = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let Ok(method) = std::fs::read_to_string(here.join("../../docs/method.md")) else {
        return;
    };
    let code = include_str!("../../src/least_detour/constants.rs");
    let constants = code.lines().filter_map(|line| {
        let (name, rest) = line.strip_prefix("pub(super) const ")?.split_once(": ")?;
        let (_, value) = rest.split_once(" = ")?;
        Some((name, value.trim_end_matches(';')))
    });
    let constants: Vec<_> = constants.collect();
    assert_eq!(constants.len(), code.matches("const ").count());
    for (name, value) in constants {
        let row = format!("| `{name}` | `{value}` |");
        assert_eq!(
            method.matches(&row).count(),
            1,
            "docs/method.md lacks {row}"
        );
    }
}

/// The cost of edges as the module's doc defines it, with brute force for what it depends on.
pub(crate) struct Definition<'a> {
    points: &'a PointSet,
    /// Delaunay edges whose dual is longer than a point.
    pub(crate) candidates: EdgeSet,
    hnn: EdgeSet,
    crust: EdgeSet,
    /// Of one free end of each point, and of both.
    penalties: Vec<[f64; 2]>,
}

pub(crate) fn partners(edges: &EdgeSet, v: PointId) -> Vec<PointId> {
    let at = edges.edges().iter().filter(|e| e.ends().contains(&v));
    at.map(|e| if e.a() == v { e.b() } else { e.a() }).collect()
}

/// |vp| + |vq| - |pq|, where p is the nearer: |vq| - |pq| is nothing but rounding when vp is tiny.
fn detour(v: DVec2, p: DVec2, q: DVec2) -> f64 {
    let (a, b) = (p - v, q - v);
    let [a, b] = if a.length() <= b.length() {
        [a, b]
    } else {
        [b, a]
    };
    let difference = a.dot(2.0 * b - a) / (b.length() + p.distance(q));
    a.length() + difference
}

/// Whether the path p, v, q is possible in a rho-sample.
fn may_be_consecutive(v: DVec2, p: DVec2, q: DVec2) -> bool {
    detour(v, p, q) <= TRUSTED_DETOUR * v.distance(p).min(v.distance(q))
}

impl<'a> Definition<'a> {
    pub(crate) fn new(points: &'a PointSet) -> Self {
        let pairs = points.ids().flat_map(|p| points.ids().map(move |q| (p, q)));
        let candidates =
            pairs.filter(|&(p, q)| p < q && oracles::voronoi_edge(points, p, q).is_some());
        let candidates = candidates.filter_map(|(p, q)| Edge::new(p, q));
        let mut definition = Self {
            points,
            candidates: EdgeSet::new(points.len(), candidates),
            hnn: oracles::hnn_crust(points),
            crust: oracles::one_step_crust(points),
            penalties: Vec::new(),
        };
        definition.penalties = points.ids().map(|v| definition.penalty(v)).collect();
        definition
    }

    fn closest(&self, v: PointId) -> Vec<PointId> {
        let mut closest = partners(&self.candidates, v);
        closest.sort_by(|&p, &q| {
            let distance = |p: PointId| self.points[v].distance_squared(self.points[p]);
            distance(p)
                .total_cmp(&distance(q))
                .then(by_coordinates(self.points[p], self.points[q]))
        });
        closest
    }

    fn to_nearest(&self, v: PointId) -> f64 {
        let nearest = self.closest(v).first().copied();
        nearest.map_or(0.0, |p| self.points[v].distance(self.points[p]))
    }

    fn is_saturated(&self, v: PointId) -> bool {
        let certified = partners(&self.hnn, v).into_iter();
        certified.filter(|&w| self.is_certified(v, w)).count() == 2
    }

    fn longest_trusted(&self, v: PointId) -> f64 {
        let longest = |graph: &EdgeSet, may_be: &dyn Fn(PointId) -> bool| {
            let trusted = partners(graph, v).into_iter().filter(|&w| {
                may_be(v)
                    && may_be(w)
                    && Self::continues(self.points, graph, [v, w], may_be_consecutive)
            });
            let lengths = trusted.map(|w| self.points[v].distance(self.points[w]));
            lengths.fold(0.0, f64::max)
        };
        longest(&self.hnn, &|_| true).max(longest(&self.crust, &|v| !self.is_saturated(v)))
    }

    /// Of one free end of a point that certified edges do not saturate, and of both.
    fn penalty(&self, v: PointId) -> [f64; 2] {
        let closest = self.closest(v).into_iter().take(SPACING_NEIGHBOURS);
        let around = closest.map(|w| self.to_nearest(w).max(self.longest_trusted(w)));
        let expected = around.fold(self.longest_trusted(v), f64::max);
        let usual = PENALTY * expected.max(self.to_nearest(v));
        let both = if self.continues_a_neighbour(v) {
            usual.max(2.0 * PENALTY * expected)
        } else {
            usual
        };
        let run = self.run_ending_at(v);
        let one = usual.min(run.map_or(f64::INFINITY, |spacing| RUN_PENALTY * spacing));
        [one, both.min(2.0 * one)]
    }

    /// Whether the path p, v, q turns by no more than the angle with this cosine.
    fn turns_less(&self, cosine: f64, [p, v, q]: [PointId; 3]) -> bool {
        let [p, v, q] = [p, v, q].map(|id| self.points[id]);
        (v - p).angle_to(q - v).abs() <= cosine.acos()
    }

    /// The spacing of the even run that ends at a point.
    pub(crate) fn run_ending_at(&self, v: PointId) -> Option<f64> {
        let mut runs = partners(&self.hnn, v);
        runs.retain(|&w| self.spacing_of_run(v, w).is_some());
        let [previous] = runs[..] else { return None };
        let ahead = self.closest(v).into_iter().filter(|&w| {
            w != previous
                && !self.is_saturated(w)
                && self.turns_less(AHEAD_COSINE, [previous, v, w])
        });
        let is_uneven = |spacing: &f64| self.longest_trusted(v) > UNEVEN_RATIO * spacing;
        let spacing = self.spacing_of_run(v, previous);
        spacing.filter(|spacing| ahead.count() == 0 && !is_uneven(spacing))
    }

    fn spacing_of_run(&self, v: PointId, previous: PointId) -> Option<f64> {
        let mut run = vec![v, previous];
        while run.len() <= RUN_EDGES {
            let [to, at] = [run[run.len() - 2], run[run.len() - 1]];
            let next = partners(&self.hnn, at).into_iter().find(|&w| w != to)?;
            if !self.turns_less(AHEAD_COSINE, [to, at, next]) {
                return None;
            }
            run.push(next);
        }
        let lengths = run
            .windows(2)
            .map(|w| self.points[w[0]].distance(self.points[w[1]]));
        let lengths: Vec<f64> = lengths.collect();
        let longest = lengths.iter().copied().fold(0.0, f64::max);
        let is_even = lengths.iter().all(|length| EVEN_RATIO * length >= longest);
        is_even.then(|| lengths[0].max(lengths.iter().sum::<f64>() / RUN_EDGES as f64))
    }

    /// Whether the curve through a candidate that is not saturated may continue to the point.
    fn continues_a_neighbour(&self, v: PointId) -> bool {
        self.closest(v).into_iter().any(|w| {
            let mut others = self.closest(w);
            others.retain(|&u| u != v);
            others.truncate(CONTINUATION_NEIGHBOURS);
            let pairs = || {
                others
                    .iter()
                    .flat_map(|&p| others.iter().map(move |&q| (p, q)))
            };
            let mut straight_on =
                pairs().filter(|&(p, q)| self.turns_less(STRAIGHT_COSINE, [p, w, q]));
            !self.is_saturated(w)
                && straight_on.next().is_none()
                && (others.is_empty()
                    || others.iter().any(|&u| {
                        may_be_consecutive(self.points[w], self.points[u], self.points[v])
                    }))
        })
    }

    /// Whether an edge of a graph continues at both ends by an edge that `is_continuation` accepts.
    fn continues(
        points: &PointSet,
        graph: &EdgeSet,
        [v, w]: [PointId; 2],
        is_continuation: impl Fn(DVec2, DVec2, DVec2) -> bool,
    ) -> bool {
        [(v, w), (w, v)].into_iter().all(|(at, to)| {
            let others = partners(graph, at).into_iter().filter(|&p| p != to);
            let mut others = others.map(|p| points[p]);
            others.any(|p| is_continuation(points[at], points[to], p))
        })
    }

    fn is_certified(&self, v: PointId, w: PointId) -> bool {
        let is_straight = |v: DVec2, p: DVec2, q: DVec2| {
            let (a, b) = (p - v, q - v);
            -a.dot(b) >= CERTIFIED_COSINE * a.length() * b.length()
        };
        Edge::new(v, w).is_some_and(|e| self.hnn.contains(e) && self.crust.contains(e))
            && Self::continues(self.points, &self.hnn, [v, w], is_straight)
    }

    pub(crate) fn certified(&self) -> impl Iterator<Item = Edge> + '_ {
        let edges = self.hnn.edges().iter().copied();
        edges.filter(|e| self.is_certified(e.a(), e.b()))
    }

    pub(crate) fn cost(&self, edges: &EdgeSet) -> f64 {
        let lengths = edges.edges().iter().map(|e| {
            let [p, q] = e.ends().map(|id| self.points[id]);
            p.distance(q)
        });
        let at = |v: PointId| self.cost_at(v, &partners(edges, v));
        lengths.sum::<f64>() + self.points.ids().map(at).sum::<f64>()
    }

    /// What a point with these partners costs: its detour, or its free ends.
    fn cost_at(&self, v: PointId, partners: &[PointId]) -> f64 {
        match *partners {
            [p, q] => detour(self.points[v], self.points[p], self.points[q]),
            [_] => self.penalties[v.index()][0],
            _ => self.penalties[v.index()][1],
        }
    }

    pub(crate) fn has_triangle(edges: &EdgeSet) -> bool {
        let rings = edges.chains();
        rings
            .iter()
            .any(|c| c.is_closed() && c.vertices().len() == 3)
    }
}

/// What is wrong with the edges, if anything.
pub(crate) fn fault(points: &PointSet, edges: &EdgeSet) -> Option<String> {
    let definition = Definition::new(points);
    let candidates = &definition.candidates;
    if let Some(edge) = edges.difference(candidates).next() {
        return Some(format!("{edge:?} is not a candidate"));
    }
    if !edges.junctions().is_empty() || Definition::has_triangle(edges) {
        return Some("a junction or a triangle".to_owned());
    }
    let certified: Vec<Edge> = definition.certified().collect();
    if let Some(edge) = certified.iter().find(|&&e| !edges.contains(e)) {
        return Some(format!("{edge:?} is certified and missing"));
    }
    let cost = definition.cost(edges);
    let is_better = |others: &EdgeSet| definition.cost(others) < cost * (1.0 - 1e-9);
    let changed = |edge: Edge| {
        let others = edges.edges().iter().copied().filter(|&e| e != edge);
        let added = Some(edge).filter(|&e| !edges.contains(e));
        EdgeSet::new(points.len(), others.chain(added))
    };
    let toggled = candidates.edges().iter().filter(|e| !certified.contains(e));
    for &edge in toggled {
        let others = changed(edge);
        let is_valid = others.junctions().is_empty() && !Definition::has_triangle(&others);
        if is_valid && is_better(&others) {
            return Some(format!("without or with {edge:?} the cost is less"));
        }
    }
    None
}

/// The least cost of all triangle-free 2-matchings with the certified edges, by trying all.
pub(crate) struct Exhaustive<'a> {
    definition: &'a Definition<'a>,
    partners: Vec<Vec<PointId>>,
    least: f64,
}

impl<'a> Exhaustive<'a> {
    /// Given the cost of one of them.
    fn least_cost(definition: &'a Definition<'a>, known: f64) -> f64 {
        Self::least_cost_of(definition, known, |_| true)
    }

    /// That of those which `may_be`, where it is below a `known` one: else the known one.
    pub(crate) fn least_cost_of(
        definition: &'a Definition<'a>,
        known: f64,
        may_be: impl Fn(&[Vec<PointId>]) -> bool,
    ) -> f64 {
        let mut search = Self {
            definition,
            partners: vec![Vec::new(); definition.points.len()],
            least: known,
        };
        let certified: Vec<Edge> = definition.certified().collect();
        let certified_cost = certified.iter().map(|&e| search.add(e)).sum();
        let candidates = definition.candidates.edges().iter().copied();
        let rest: Vec<Edge> = candidates.filter(|e| !certified.contains(e)).collect();
        search.with_or_without(&rest, certified_cost, &may_be);
        search.least
    }

    /// Adds an edge, and returns its length and the detours at ends that have two edges now.
    fn add(&mut self, edge: Edge) -> f64 {
        let points = self.definition.points;
        let mut cost = points[edge.a()].distance(points[edge.b()]);
        for (v, w) in [(edge.a(), edge.b()), (edge.b(), edge.a())] {
            self.partners[v.index()].push(w);
            let partners = &self.partners[v.index()];
            if partners.len() == 2 {
                cost += self.definition.cost_at(v, partners);
            }
        }
        cost
    }

    fn with_or_without(
        &mut self,
        rest: &[Edge],
        cost: f64,
        may_be: &impl Fn(&[Vec<PointId>]) -> bool,
    ) {
        // What the edges cost so far, they cost whatever follows.
        if cost >= self.least {
            return;
        }
        let Some((&edge, rest)) = rest.split_first() else {
            if !may_be(&self.partners) {
                return;
            }
            let all = self.definition.points.ids().zip(&self.partners);
            let free = all.filter(|(_, partners)| partners.len() < 2);
            let penalties = free.map(|(v, partners)| self.definition.cost_at(v, partners));
            self.least = self.least.min(cost + penalties.sum::<f64>());
            return;
        };
        let [a, b] = edge.ends().map(|v| &self.partners[v.index()]);
        if a.len() < 2 && b.len() < 2 && !a.iter().any(|v| b.contains(v)) {
            let added = self.add(edge);
            self.with_or_without(rest, cost + added, may_be);
            for v in edge.ends() {
                self.partners[v.index()].pop();
            }
        }
        self.with_or_without(rest, cost, may_be);
    }
}

/// Nearly all small sets of scattered points, with hardly a certified edge, get the cheapest
/// 2-matching.
#[test]
fn exchanges_find_the_cheapest_edges_of_nearly_all_small_sets() {
    let mut runner = TestRunner::deterministic();
    let (mut sets, mut cheapest, mut excess) = (0_u32, 0_u32, 0.0);
    while sets < 500 {
        let points = point_set(uniform(13).new_tree(&mut runner).unwrap().current());
        if points.len() < 7 {
            continue;
        }
        let definition = Definition::new(&points);
        let cost = definition.cost(&LeastDetour.reconstruct(&points));
        let least = Exhaustive::least_cost(&definition, cost);
        sets += 1;
        cheapest += u32::from(cost <= least * (1.0 + 1e-9));
        excess += cost / least - 1.0;
    }
    // 497, and 0.01 % in the mean.
    assert!(cheapest >= 490, "{cheapest} of {sets}");
    assert!(excess / f64::from(sets) < 0.0005, "{excess}");
}

/// A cluster as wide as a few roundings, where penalties are 10^12 times as large as lengths: their
/// rounding errors once looked like a gain, and exchanges went on for ever.
#[test]
fn penalties_much_larger_than_lengths_feign_no_gain() {
    let steps = [
        (0, 0),
        (1, 6),
        (3, 4),
        (5, 6),
        (6, 4),
        (5, 4),
        (4, 0),
        (5, 0),
        (2, 6),
        (1, 0),
        (6, 1),
        (2, 1),
        (6, 0),
        (2, 4),
        (0, 6),
    ];
    let cluster = steps.map(|(x, y)| {
        let step = |n: i32| 1.0 + f64::from(n) * f64::EPSILON;
        DVec2::new(step(x), step(y))
    });
    let around = [(0.0, 1.0), (1.0, 2.0), (0.0, 2.0)].map(DVec2::from);
    let points = PointSet::new([&cluster[..], &around[..]].concat()).unwrap();
    for v in points.ids() {
        let edges = LeastDetour.reconstruct_open(&points, &[v]).unwrap();
        assert!(edges.degrees()[v.index()] <= 1);
    }
}

/// Two points are joined, and more in a row one after another, whatever the turn of the last edge.
#[test]
fn a_few_points_in_a_row_are_joined() {
    for n in 2..9 {
        for degrees in [0.0, 30.0, 60.0, 90.0] {
            let turn = DVec2::from_angle(f64::to_radians(degrees));
            let mut row: Vec<DVec2> = (1..n).map(|i| f64::from(i) * DVec2::X).collect();
            row.push(f64::from(n - 1) * DVec2::X + turn);
            let points = PointSet::new(row).unwrap();
            let edges =
                (1..points.len()).filter_map(|i| Edge::new(PointId::new(i - 1)?, PointId::new(i)?));
            let edges = EdgeSet::new(points.len(), edges);
            assert_eq!(LeastDetour.reconstruct(&points), edges, "{n}, {degrees}");
        }
    }
}

/// Half circles with ends beside each other: lengths and detours alone would bridge the gap, but
/// the penalty at the end of an even run is small.
#[test]
fn even_runs_end_and_uneven_ones_continue() {
    let arc = |x: f64, even: bool| {
        (0..=10).map(move |i| {
            // Uneven: every other sample is moved by half a step.
            let shift = if even || i % 2 == 0 || i == 10 {
                0.0
            } else {
                0.5
            };
            let angle = (f64::from(i) + shift) * std::f64::consts::PI / 10.0;
            DVec2::new(x, 0.0) + DVec2::from_angle(angle)
        })
    };
    let leaves = |even: bool| {
        // Steps of 0.31, and 0.6 from one arc to the other.
        let points = arc(0.0, even).chain(arc(2.6, even)).collect();
        let points = PointSet::new(points).unwrap();
        LeastDetour.reconstruct(&points).leaves().len()
    };
    assert_eq!(leaves(true), 4);
    assert!(leaves(false) < 4);
}

/// An outlier beside a straight row is left alone, at every distance of a spacing or more; the tip
/// of a corner that is as far from both legs is not.
#[test]
fn an_outlier_is_left_alone() {
    let row = |y: f64| (0..12).map(move |i| DVec2::new(f64::from(i), y * f64::from(i)));
    for height in [1.0, 1.5, 2.0, 3.0] {
        let points = row(0.0).chain([DVec2::new(5.4, height)]).collect();
        let points = PointSet::new(points).unwrap();
        let edges = LeastDetour.reconstruct(&points);
        assert_eq!((edges.len(), edges.isolated().len()), (11, 1), "{height}");
    }
    let tip = row(0.15).chain(row(-0.15).skip(1)).collect();
    let edges = LeastDetour.reconstruct(&PointSet::new(tip).unwrap());
    assert!(edges.isolated().is_empty());
}

/// Each edge and each free end is explained as the definition has it.
fn explained_as_defined(points: &PointSet) -> Result<(), TestCaseError> {
    let definition = Definition::new(points);
    let edges = LeastDetour.reconstruct(points);
    let why = LeastDetour.explain(points, &[]).unwrap().unwrap();
    let explained: Vec<Edge> = why.edges.iter().map(|e| e.edge).collect();
    prop_assert_eq!(&explained[..], edges.edges());
    let certified: Vec<Edge> = definition.certified().collect();
    for explained in &why.edges {
        let is_certified = certified.contains(&explained.edge);
        prop_assert_eq!(explained.reason == Reason::Certified, is_certified);
        prop_assert!(!is_certified || explained.margin.is_none());
        prop_assert!(explained.margin.is_none_or(|margin| margin >= 0.0));
    }
    let free: Vec<_> = why
        .free_ends
        .iter()
        .map(|end| (end.point, usize::from(end.count)))
        .collect();
    let expected = points.ids().map(|v| (v, 2 - partners(&edges, v).len()));
    prop_assert_eq!(free, expected.filter(|s| s.1 > 0).collect::<Vec<_>>());
    for end in &why.free_ends {
        let penalty = definition.penalties[end.point.index()][usize::from(end.count) - 1];
        prop_assert!((end.penalty - penalty).abs() <= 1e-9 * penalty);
        let Some(rejected) = end.rejected else {
            continue;
        };
        let joined = Edge::new(end.point, rejected.partner).unwrap();
        prop_assert!(definition.candidates.contains(joined) && !edges.contains(joined));
        prop_assert!(rejected.cost >= 0.0);
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn what_is_explained_is_what_is_returned(points in any_points()) {
        explained_as_defined(&points)?;
    }

    #[test]
    fn ends_of_even_runs_are_explained_as_defined(points in even_runs().prop_map(point_set)) {
        explained_as_defined(&points)?;
    }
}
