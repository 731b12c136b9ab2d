//! The checker: accepts a certificate if each of its leaves is refuted by a named condition.
//!
//! It knows the interval type, the statement and the conditions, each a lemma of
//! `docs/theorem-2.md`; it uses nothing of the prover.

use super::ball::Ball;
use super::geometry::{B, F, T, V, frame, pt, radii, up};
use super::interval::Interval as I;
use super::statement::{Node, root};

/// lower bound of |x| over possible s0; None: there is no s0.
fn midpoint(f: &F, t: &T, s: I, k: I, depth: u32, best: f64) -> Option<f64> {
    if s.is_below(f.d) || (f.rho * f.tau).is_below(s) {
        return None;
    }
    let so = pt(0.5) * (k * s);
    let co = (pt(1.0) - so.square()).sqrt();
    let v = V { x: -co, y: -so };
    if s.is_below(pt(2.0) * f.z.dot(v)) {
        return None;
    }
    let e = pt(0.25) * (s.square() * (pt(2.0) * k - pt(1.0)));
    let h = (e / (co + (co.square() + e).sqrt())).max(pt(0.0));
    let x = (pt(0.25) * s.square() + h.square()).sqrt();
    if (pt(0.5) * (f.rho * f.tau)).is_below(x) {
        return None;
    }
    let lx = (x / f.rho).lower();
    let w = v.scale(s).minus(f.q);
    let (ww, wn) = (w.sq(), w.dot(f.n));
    if ww.is_below(pt(2.0) * (t.up.max(lx) * wn)) || ww.is_below(-(pt(2.0) * (t.down.max(lx) * wn)))
    {
        return None;
    }
    if x.lo() >= best {
        return Some(best);
    }
    if depth == 0 {
        return Some(x.lo());
    }
    let pair = if s.width() > 0.5 * k.width() {
        s.halves().map(|s| (s, k))
    } else {
        k.halves().map(|k| (s, k))
    };
    let mut out = None;
    let mut best = best;
    for (s, k) in pair {
        if let Some(r) = midpoint(f, t, s, k, depth - 1, best) {
            best = best.min(r);
            out = Some(best);
        }
    }
    out
}
fn simple(f: &F) -> bool {
    let two_rho = pt(2.0) * f.rho;
    two_rho.square().is_below(f.zz)
        || (f.d + pt(2.0) * (f.tau * f.slope)).is_below(pt(0.0))
        || (f.rho * f.tau).is_below(f.d)
        || (-f.t.dot(f.q)).is_below(pt(0.0))
        || f.z.minus(up()).sq().is_below(pt(1.0))
}
fn discs(f: &F, t: &T) -> bool {
    let ds = f.d * f.slope;
    let c = pt(1.0) - f.n.y;
    f.tau.is_below(pt(2.0) * t.up)
        || (f.d.square() * (pt(1.0) - f.ka)).is_below(pt(2.0) * (t.up * (c - ds)))
        || (f.d.square() * (pt(1.0) + f.ka)).is_below(pt(2.0) * (t.down * (c + ds)))
        || f.d.is_below(pt(2.0) * (t.up * f.slope))
        || f.d.is_below(-(pt(2.0) * (t.down * f.slope)))
}
fn bound(f: &F) -> I {
    (pt(0.5) * (f.d / f.rho)).max(pt(1.0) - f.d).lower()
}

/// The conditions that need no ball; otherwise what the balls need.
enum Elementary {
    Refuted,
    Open(F, T, I),
}

fn elementary(b: &B, rho: I) -> Elementary {
    let f = frame(b, rho);
    if simple(&f) {
        return Elementary::Refuted;
    }
    let l = bound(&f);
    let t = radii(&f, l);
    let s = I::new(f.d.lo(), (rho * f.tau).hi());
    if discs(&f, &t) {
        return Elementary::Refuted;
    }
    let Some(x) = midpoint(&f, &t, s, I::new(-1.0, 1.0), 16, 2.0) else {
        return Elementary::Refuted;
    };
    let l = l.max(pt(x) / rho).lower();
    let t = radii(&f, l);
    if discs(&f, &t) {
        return Elementary::Refuted;
    }
    Elementary::Open(f, t, l)
}

/// Whether one leaf is refuted.
pub(super) fn refutes(b: &B, rho: I, node: &Node) -> bool {
    // The sine is a monotone function of the half tangent only between -1 and 1, or beyond.
    if b[2].straddles_one() {
        return false;
    }
    match (elementary(b, rho), node) {
        (Elementary::Refuted, Node::Refuted) => true,
        (Elementary::Open(f, t, l), Node::Ball { center, radius }) => {
            let uppers = [(up(), pt(1.0)), (f.q.plus(f.n.scale(t.up)), t.up)];
            let c = V {
                x: pt(center[0]),
                y: pt(center[1]),
            };
            let r = pt(*radius);
            // The ball holds z.
            pt(0.0).is_below(r)
                && f.z.minus(c).sq().is_below(r.square())
                && Ball::new(&f, l, &uppers, c).is_some_and(|ball| ball.with(r).refuted(8))
        }
        _ => false,
    }
}

/// The radius that a ball about `center` needs, to hold z for all of the box; none if the box
/// needs no ball.
pub(super) fn needed_radius(b: &B, rho: I, center: [f64; 2]) -> f64 {
    let c = V {
        x: pt(center[0]),
        y: pt(center[1]),
    };
    (pt(1.0 + 1e-12) * frame(b, rho).z.minus(c).sq().sqrt()).hi()
}

/// The end of the normal at q, where candidates of centres are.
pub(super) fn foot(b: &B, rho: I) -> [f64; 2] {
    let q = frame(b, rho).q;
    [q.x.mid(), q.y.mid()]
}

/// Whether the certificate proves the statement for `rho`.
pub fn accepts(rho: f64, certificate: &[Node]) -> bool {
    let rho_interval = pt(rho);
    let mut open = vec![root(rho_interval)];
    for node in certificate {
        let Some(b) = open.pop() else { return false };
        match node {
            Node::Split(axis) => {
                let Some(side) = b.get(*axis) else {
                    return false;
                };
                for half in side.halves() {
                    let mut part = b;
                    part[*axis] = half;
                    open.push(part);
                }
            }
            leaf => {
                if !refutes(&b, rho_interval, leaf) {
                    return false;
                }
            }
        }
    }
    open.is_empty()
}
