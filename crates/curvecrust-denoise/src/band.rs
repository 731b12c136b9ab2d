//! The band: points that lie along curves, each with its place on a local parabola.

use std::sync::atomic::{AtomicU32, Ordering};

use glam::DVec2;
use rayon::prelude::*;

use curvecrust_geometry::Interrupt;

use crate::area::hull_area;
use crate::evidence;
use crate::scale::{Scales, scales};
use crate::tree::Tree;
use crate::window::{Parabola, parabola};

/// The radius of a window, in scales.
const WINDOW: f64 = 1.3;
/// A point goes that fewer than this share of the windows that see it support.
const SUPPORT: f64 = 0.34;
/// How often points without support are taken away.
const SIEVES: usize = 2;
/// They stay if they are no more than this share: nothing else would change.
const STRAY: f64 = 0.005;
/// The fewest points that are left.
const FEWEST: usize = 5;
/// How many times log n the evidence against the background must be.
const EVIDENCE: f64 = 3.0;

/// How a band is looked for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Search {
    /// By how much windows are larger than their scale asks for.
    pub(crate) factor: f64,
    /// Whether points without support and those of the background are taken away.
    pub(crate) sieve: bool,
}

/// What the scale of a point is.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Rule {
    /// The smallest neighbourhood that is not round, with this many false alarms allowed, as in
    /// [`scales`].
    Stroke { alarms: f64 },
    /// The window holds this many of the nearest points.
    Nearest(usize),
}

/// A point of the band.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Member {
    /// The position of the point.
    pub(crate) index: usize,
    /// Where it lies on the local parabola.
    pub(crate) place: DVec2,
    /// The radius of its scale.
    pub(crate) radius: f64,
    /// The deviation of the points of its window.
    pub(crate) sigma: f64,
    count: usize,
    /// The number of points that this one stands for.
    stands_for: usize,
}

/// Finds the band of points whose scales are known, and whether each point is in it; no member if
/// the points form none.
pub(crate) fn band(all: &Windows, search: &Search) -> (Vec<Member>, Vec<bool>) {
    let mut alive: Vec<usize> = (0..all.points.len()).collect();
    let mut sieved: Option<Windows> = None;
    if search.sieve {
        for _ in 0..SIEVES {
            let windows = sieved.as_ref().unwrap_or(all);
            let stays = windows.supported(search.factor);
            let left: Vec<usize> = (0..alive.len()).filter(|&i| stays[i]).collect();
            let removed = alive.len() - left.len();
            if removed as f64 <= STRAY * alive.len() as f64 || left.len() < 2 * FEWEST {
                break;
            }
            alive = left.iter().map(|&i| alive[i]).collect();
            let points = alive.iter().map(|&i| all.points[i]).collect();
            sieved = Some(Windows::new(points, all.rule));
        }
    }
    let windows = sieved.as_ref().unwrap_or(all);
    let mut members = windows.members(search.factor);
    if search.sieve {
        members = above_background(&all.points, members);
    }
    if members.len() < FEWEST {
        members.clear();
    }
    let mut is_member = vec![false; alive.len()];
    for member in &mut members {
        is_member[member.index] = true;
        member.index = alive[member.index];
    }
    let mut in_band = vec![false; all.points.len()];
    for (&i, &centre) in alive.iter().zip(&windows.scales.centres) {
        in_band[i] = is_member[centre];
    }
    (members, in_band)
}

/// Points, and the scale of each, as wide as the window about it has to be.
pub(crate) struct Windows {
    pub(crate) points: Vec<DVec2>,
    pub(crate) tree: Tree,
    scales: Scales,
    rule: Rule,
}

impl Windows {
    pub(crate) fn new(points: Vec<DVec2>, rule: Rule) -> Self {
        let tree = Tree::new(&points);
        let scales = match rule {
            Rule::Stroke { alarms } => scales(&points, &tree, alarms),
            Rule::Nearest(count) => {
                let reach = |p: &DVec2| {
                    let last = tree.nearest(*p).nth(count);
                    last.map(|(_, squared)| squared.sqrt() / WINDOW)
                };
                Scales {
                    radii: points.par_iter().map(reach).collect(),
                    centres: (0..points.len()).collect(),
                }
            }
        };
        Self {
            points,
            tree,
            scales,
            rule,
        }
    }

    /// The radius of a point for windows that are larger by a factor.
    fn radius(&self, i: usize, factor: f64) -> Option<f64> {
        self.scales.radii[i]
            .map(|r| r * factor)
            .filter(|&r| r > 0.0)
    }

    /// The window about a point that stands for some.
    fn at(&self, i: usize, factor: f64) -> Option<(Vec<usize>, Parabola)> {
        if self.scales.centres[i] != i {
            return None;
        }
        let radius = WINDOW * self.radius(i, factor)?;
        let members = self.tree.within(self.points[i], radius);
        let found = parabola(&self.points, &members, self.points[i], radius)?;
        Some((members, found))
    }

    /// Whether each point has a scale and enough of the windows that see it support it.
    fn supported(&self, factor: f64) -> Vec<bool> {
        let count = self.points.len();
        let zeros = || (0..count).map(|_| AtomicU32::new(0)).collect::<Vec<_>>();
        let (seen, for_it) = (zeros(), zeros());
        let interrupt = Interrupt::current();
        (0..count).into_par_iter().for_each(|i| {
            interrupt.check();
            let Some((members, found)) = self.at(i, factor) else {
                return;
            };
            // Sums of integers: the order of threads does not matter.
            for (&j, supported) in members.iter().zip(found.supported) {
                if j != i {
                    seen[j].fetch_add(1, Ordering::Relaxed);
                    for_it[j].fetch_add(u32::from(supported), Ordering::Relaxed);
                }
            }
        });
        let load = |a: &AtomicU32| f64::from(a.load(Ordering::Relaxed));
        (0..count)
            .map(|i| {
                let seen = load(&seen[i]);
                self.radius(i, factor).is_some() && seen > 0.0 && load(&for_it[i]) >= SUPPORT * seen
            })
            .collect()
    }

    fn members(&self, factor: f64) -> Vec<Member> {
        let interrupt = Interrupt::current();
        let mut stand_for = vec![0; self.points.len()];
        for &centre in &self.scales.centres {
            stand_for[centre] += 1;
        }
        let member = |i: usize| {
            interrupt.check();
            let radius = self.radius(i, factor)?;
            let (members, found) = self.at(i, factor)?;
            Some(Member {
                index: i,
                place: found.place,
                radius,
                sigma: found.sigma,
                count: members.len(),
                stands_for: stand_for[i],
            })
        };
        let all: Vec<Option<Member>> = (0..self.points.len()).into_par_iter().map(member).collect();
        all.into_iter().flatten().collect()
    }
}

/// The members whose windows hold more points along them than the background explains. What is
/// no member is background; to a fixpoint.
fn above_background(points: &[DVec2], members: Vec<Member>) -> Vec<Member> {
    let area = hull_area(points);
    let log_n = (points.len() as f64).ln();
    let mut kept: usize = members.iter().map(|m| m.stands_for).sum();
    let mut stays = vec![true; members.len()];
    for _ in 0..6 {
        let left = points.len() - kept;
        let density = (left + 1) as f64 / area;
        let is_dense = |m: &Member| {
            let (count, length) = (m.count as f64, 2.0 * WINDOW * m.radius);
            evidence::of_band(count, length, m.sigma, density) > EVIDENCE * log_n
        };
        let next: Vec<bool> = members.iter().map(is_dense).collect();
        if next == stays {
            break;
        }
        let staying = members.iter().zip(&next).filter(|(_, stays)| **stays);
        kept = staying.map(|(m, _)| m.stands_for).sum();
        stays = next;
    }
    let pairs = members.into_iter().zip(stays);
    pairs.filter_map(|(m, stays)| stays.then_some(m)).collect()
}
