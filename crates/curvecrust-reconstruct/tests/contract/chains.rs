//! Algorithms that join chains at their ends, from their definitions, step by step and with nothing
//! kept between steps.

use std::f64::consts::PI;

use curvecrust_geometry::point_set::by_coordinates;
use curvecrust_geometry::{DVec2, Edge, EdgeSet, PointId, PointSet};
use num_bigint::BigInt;

use super::exact::{Exact, Ratio2, integer};
use super::family::{
    CLOSE, Pair, around, by_length, component, degree, delaunay_pairs, edge_set, touches,
};
use super::oracles::{joined, voronoi_edge, voronoi_vertices};

/// The edges that both ends take.
fn mutual(points: &PointSet, takes: impl FnMut(PointId) -> Vec<Option<PointId>>) -> Vec<Pair> {
    let taken: Vec<Vec<Option<PointId>>> = points.ids().map(takes).collect();
    let takes = |p: PointId, q: PointId| taken[p.index()].contains(&Some(q));
    let both = joined(points, |p, q| takes(p, q) && takes(q, p));
    let mut pairs: Vec<Pair> = both.edges().iter().map(|edge| edge.ends()).collect();
    pairs.sort_by(|&e, &f| by_length(points, e, f));
    pairs
}

/// `None` if some edge is about as long as the way to the pole, or as steep as it may be.
pub(crate) fn gathan(points: &PointSet) -> Option<EdgeSet> {
    let pairs = delaunay_pairs(points);
    let exact = Exact::new(points);
    let vertices: Vec<Ratio2> = voronoi_vertices(points, &exact);
    let on_hull = |[p, q]: Pair| {
        let dual = voronoi_edge(points, p, q).unwrap();
        let across = (points[q] - points[p]).perp().normalize();
        match [dual.left, dual.right] {
            // All points lie on one line, and both rays count alike.
            [None, None] if by_coordinates(points[p], points[q]).is_gt() => Some(-across),
            [None, _] => Some(across),
            [_, None] => Some(-across),
            _ => None,
        }
    };
    let mut is_close = false;
    let normals: Vec<(DVec2, f64)> = points
        .ids()
        .map(|v| {
            let rays = pairs.iter().filter(|pair| pair.contains(&v));
            let ray: DVec2 = rays.filter_map(|&pair| on_hull(pair)).sum();
            is_close |= ray.length() > 0.0 && ray.length() < CLOSE;
            if ray.length() > CLOSE {
                return (ray.normalize(), f64::INFINITY);
            }
            let of_cell = vertices
                .iter()
                .filter(|vertex| touches(&exact, points, vertex, v));
            let ways: Vec<DVec2> = of_cell.map(|vertex| way(&exact, vertex, v)).collect();
            let farthest = ways.iter().map(|way| way.length()).fold(0.0, f64::max);
            let mut poles = ways
                .iter()
                .filter(|way| way.length() > farthest * (1.0 - CLOSE));
            let Some(&pole) = poles.next() else {
                return (DVec2::ZERO, 0.0);
            };
            is_close |= poles.any(|other| other.distance(pole) > CLOSE * farthest);
            (pole.normalize(), farthest)
        })
        .collect();
    let mut kept = mutual(points, |v| {
        let (normal, distance) = normals[v.index()];
        [1.0, -1.0]
            .map(|side| {
                around(&pairs, v).find(|&w| {
                    let edge = points[w] - points[v];
                    let slope = normal.dot(edge).abs() / edge.length();
                    let steepest = 40f64.to_radians().sin();
                    is_close |= (edge.length() / distance - 1.0).abs() < CLOSE;
                    is_close |= (slope - steepest).abs() < CLOSE;
                    edge.length() <= distance
                        && slope <= steepest
                        && side * normal.perp_dot(edge) > 0.0
                })
            })
            .to_vec()
    });
    let longest = |kept: &[Pair], v: PointId| {
        let lengths = around(kept, v).map(|w| points[v].distance(points[w]));
        lengths.fold(0.0, f64::max)
    };
    let smooth = kept.clone();
    for &[p, q] in &pairs {
        let length = points[p].distance(points[q]);
        let most = 2.0 * longest(&smooth, p).max(longest(&smooth, q));
        let lacks = degree(&kept, p) < 2 && degree(&kept, q) < 2;
        if lacks && !kept.contains(&[p, q]) && length <= most {
            kept.push([p, q]);
        }
    }
    (!is_close).then(|| edge_set(points, &kept))
}

/// From a point to a Voronoi vertex.
pub(crate) fn way(exact: &Exact, vertex: &Ratio2, v: PointId) -> DVec2 {
    let unit = integer(1.0);
    let float = |n: &BigInt| {
        // To some 90 bits, of which a double takes what it can.
        let scaled: BigInt = (n << 90) / (&vertex.w * &unit);
        scaled.to_string().parse::<f64>().unwrap() / 2f64.powi(90)
    };
    let [x, y] = vertex.from(exact.at(v));
    DVec2::new(float(&x), float(&y))
}

pub(crate) fn gathan_g(points: &PointSet) -> EdgeSet {
    let pairs = delaunay_pairs(points);
    let mut kept = mutual(points, |v| {
        let nearest = around(&pairs, v).next();
        let opposite = nearest.and_then(|nearest| {
            let back = points[nearest] - points[v];
            around(&pairs, v).find(|&w| {
                let on = points[w] - points[v];
                w != nearest && back.dot(on) <= -(3f64.sqrt()) / 2.0 * back.length() * on.length()
            })
        });
        vec![nearest, opposite]
    });
    let smooth = kept.clone();
    let is_end = |kept: &[Pair], v: PointId| degree(kept, v) == 1;
    let is_free = |kept: &[Pair], v: PointId| degree(kept, v) == 0;
    let mut ways: Vec<(f64, Vec<usize>, Vec<PointId>)> = Vec::new();
    for end in points.ids().filter(|&v| is_end(&smooth, v)) {
        let mut unfinished = vec![vec![end]];
        while let Some(stops) = unfinished.pop() {
            let at = *stops.last().unwrap();
            for to in around(&pairs, at).take(12) {
                let joins = |pair: &&Pair| pair.contains(&at) && pair.contains(&to);
                if stops.contains(&to) || smooth.iter().any(|pair| joins(&pair)) {
                    continue;
                }
                let mut stops = stops.clone();
                stops.push(to);
                if is_free(&smooth, to) && stops.len() < 4 {
                    unfinished.push(stops);
                } else if is_end(&smooth, to) {
                    let steps = || stops.windows(2).map(|step| [step[0], step[1]]);
                    let number = |step: Pair| {
                        let is_same = |pair: &Pair| step.iter().all(|v| pair.contains(v));
                        pairs.iter().position(is_same).unwrap()
                    };
                    let mut numbers: Vec<usize> = steps().map(number).collect();
                    numbers.sort_unstable();
                    let lengths = numbers.iter().map(|&number| {
                        let [p, q] = pairs[number];
                        points[p].distance(points[q])
                    });
                    ways.push((lengths.sum(), numbers.clone(), stops));
                }
            }
        }
    }
    ways.sort_by(|a, b| a.0.total_cmp(&b.0).then_with(|| a.1.cmp(&b.1)));
    for (_, _, stops) in ways {
        let [first, inner @ .., last] = &stops[..] else {
            continue;
        };
        let is_open = is_end(&kept, *first)
            && is_end(&kept, *last)
            && inner.iter().all(|&v| is_free(&kept, v));
        if is_open {
            kept.extend(stops.windows(2).map(|step| [step[0], step[1]]));
        }
    }
    edge_set(points, &kept)
}

pub(crate) fn lenz(points: &PointSet) -> EdgeSet {
    let nearest_of = |v: PointId, wanted: &dyn Fn(PointId) -> bool| {
        let others = points.ids().filter(|&w| w != v && wanted(w));
        others.min_by(|&p, &q| {
            let distances = [p, q].map(|w| points[v].distance_squared(points[w]));
            let by_distance = distances[0].total_cmp(&distances[1]);
            by_distance.then(by_coordinates(points[p], points[q]))
        })
    };
    let seeds = mutual(points, |v| vec![nearest_of(v, &|_| true)]);
    let mut edges = EdgeSet::new(points.len(), []);
    let further = |[from, at]: Pair| {
        let last = points[at] - points[from];
        let next = nearest_of(at, &|w| {
            let step = points[w] - points[at];
            step.length_squared() <= 2.4 * 2.4 * last.length_squared()
                && last.dot(step) >= 0.5 * last.length() * step.length()
        })?;
        Some([at, next])
    };
    for [p, q] in seeds {
        let mut ends = vec![[p, q], [q, p]];
        while !ends.is_empty() {
            ends.retain(|&[p, q]| !edges.contains(Edge::new(p, q).unwrap()));
            let added = ends.iter().map(|&[p, q]| Edge::new(p, q).unwrap());
            edges = EdgeSet::new(points.len(), edges.edges().iter().copied().chain(added));
            ends = ends.into_iter().filter_map(further).collect();
        }
    }
    edges
}

/// The lengths of the edges of the curve that a point belongs to.
fn lengths(points: &PointSet, kept: &[Pair], v: PointId) -> Vec<f64> {
    let members = component(kept, v);
    let own = kept.iter().filter(|pair| members.contains(&pair[0]));
    own.map(|&[p, q]| points[p].distance(points[q])).collect()
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

fn deviation(values: &[f64]) -> f64 {
    let mean = mean(values);
    let squares = values.iter().map(|x| (x - mean) * (x - mean));
    (squares.sum::<f64>() / values.len() as f64).sqrt()
}

/// The shortest edge that both of its ends accept, until there is none; `None` if one is hardly
/// accepted, or hardly not.
pub(crate) fn discur(points: &PointSet) -> Option<EdgeSet> {
    let pairs = delaunay_pairs(points);
    let mut kept: Vec<Pair> = Vec::new();
    let mut is_close = false;
    loop {
        let mut accepts = |v: PointId, length: f64| {
            let Some(before) = around(&kept, v).next() else {
                return true;
            };
            let lengths = lengths(points, &kept, v);
            let (h, s) = (mean(&lengths), deviation(&lengths));
            let last = points[before].distance(points[v]);
            let uneven = (length - last).abs() / 2f64.sqrt();
            let spread = if s > 0.0 {
                (1.0 + h / s).powf(s / h)
            } else {
                1.0
            };
            let accepted = h * (length + last) / 2.0 / uneven * spread;
            // Near 0 the spread is steep.
            is_close |= (length / accepted - 1.0).abs() < 1e-5;
            length < accepted
        };
        let next = pairs.iter().find(|&&[p, q]| {
            let length = points[p].distance(points[q]);
            !kept.contains(&[p, q])
                && degree(&kept, p) < 2
                && degree(&kept, q) < 2
                && accepts(p, length)
                && accepts(q, length)
        });
        match next {
            Some(&pair) => kept.push(pair),
            None => return (!is_close).then(|| edge_set(points, &kept)),
        }
    }
}

/// The angle at a point.
fn angle(points: &PointSet, p: PointId, at: PointId, q: PointId) -> f64 {
    let (u, v) = (points[p] - points[at], points[q] - points[at]);
    u.perp_dot(v).abs().atan2(u.dot(v))
}

/// The shortest edge that both ends agree to, until there is none; `None` if a choice is close.
pub(crate) fn vicur(points: &PointSet) -> Option<EdgeSet> {
    let pairs = delaunay_pairs(points);
    let mut kept: Vec<Pair> = Vec::new();
    let mut is_close = false;
    loop {
        let choices: Vec<Option<PointId>> = points
            .ids()
            .map(|v| {
                let (choice, close) = vicur_choice(points, &pairs, &kept, v);
                is_close |= close;
                choice
            })
            .collect();
        let wants = |p: PointId, q: PointId| choices[p.index()] == Some(q);
        let is_free = |v: PointId| degree(&kept, v) == 0;
        let agreed = |&&[p, q]: &&Pair| {
            wants(p, q) && wants(q, p)
                || wants(p, q) && !is_free(p) && is_free(q)
                || wants(q, p) && !is_free(q) && is_free(p)
        };
        match pairs.iter().find(agreed) {
            Some(&pair) => kept.push(pair),
            None => return (!is_close).then(|| edge_set(points, &kept)),
        }
    }
}

/// Whom an end wants, and whether that is close.
fn vicur_choice(
    points: &PointSet,
    pairs: &[Pair],
    kept: &[Pair],
    v: PointId,
) -> (Option<PointId>, bool) {
    let is_end = |w: PointId| degree(kept, w) < 2;
    let is_joined = |w: PointId| around(kept, v).any(|u| u == w);
    let ends = || around(pairs, v).filter(|&w| is_end(v) && is_end(w) && !is_joined(w));
    let Some(before) = around(kept, v).next() else {
        return (ends().next(), false);
    };
    let lengths = lengths(points, kept, v);
    let (h, s) = (mean(&lengths), deviation(&lengths));
    let inner = component(kept, v)
        .into_iter()
        .filter(|&w| degree(kept, w) == 2);
    let angles: Vec<f64> = inner
        .map(|w| {
            let ends: Vec<PointId> = around(kept, w).collect();
            angle(points, ends[0], w, ends[1])
        })
        .collect();
    let usual = if angles.is_empty() { PI } else { mean(&angles) };
    let mut is_close = false;
    let mut rated: Vec<(f64, PointId)> = ends()
        .filter_map(|w| {
            let (distance, turned) = (points[v].distance(points[w]), angle(points, before, v, w));
            is_close |= (distance / (1.849 * h) - 1.0).abs() < CLOSE;
            is_close |= (turned / (PI / 4.0) - 1.0).abs() < CLOSE;
            let smooth = turned / usual - 1.0;
            let near = distance / (h + s);
            let rating = 1.0 / (1.0 + 0.7 * smooth * smooth + 0.3 / 4.0 * near * near);
            (distance <= 1.849 * h && turned >= PI / 4.0).then_some((rating, w))
        })
        .collect();
    rated.sort_by(|a, b| b.0.total_cmp(&a.0));
    if let [first, second, ..] = rated[..] {
        // The deviation of even edges is rounding, the square root of which is larger.
        is_close |= second.0 > first.0 * (1.0 - 1e-6);
    }
    (rated.first().map(|&(_, w)| w), is_close)
}
