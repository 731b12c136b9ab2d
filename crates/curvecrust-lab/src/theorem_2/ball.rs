//! Balls about centres off the medial axis (docs/theorem-2.md, Lemma 5).

use super::geometry::{F, V, pt};
use super::interval::Interval as I;

#[derive(Clone, Copy)]
pub(super) struct Ball<'a> {
    f: &'a F,
    l: I,
    c: V,
    r: I,
    uppers: &'a [(V, I)],
    holds: u32,
    in_one: bool,
    in_q: bool,
    right: bool,
}
impl Ball<'_> {
    pub(super) fn new<'a>(f: &'a F, l: I, uppers: &'a [(V, I)], c: V) -> Option<Ball<'a>> {
        let w = c.minus(f.q);
        let left = c.x.is_below(pt(0.0));
        let in_one = c.sq().is_below(pt(1.0));
        let in_q = w.sq().is_below(l.square());
        let right =
            left && pt(0.0).is_below(w.dot(f.t)) && (in_q || pt(0.0).is_below(-f.t.dot(f.q)));
        let mut holds = 0;
        for (i, (p, r)) in uppers.iter().enumerate() {
            if c.minus(*p).sq().is_below(r.square()) {
                holds |= 1 << i;
            }
        }
        if !(in_one || in_q) || holds == 0 {
            return None;
        }
        Some(Ball {
            f,
            l,
            c,
            r: pt(0.0),
            uppers,
            holds,
            in_one,
            in_q,
            right,
        })
    }
    pub(super) fn with(mut self, r: I) -> Self {
        self.r = r;
        self
    }
    pub(super) fn refuted(&self, depth: u32) -> bool {
        [1.0, -1.0]
            .into_iter()
            .all(|sign| self.slices(sign, I::new(-1.0, 1.0), depth))
    }
    fn slices(&self, sign: f64, k: I, depth: u32) -> bool {
        if self.slice(sign, k) {
            return true;
        }
        depth > 0
            && k.halves()
                .into_iter()
                .all(|k| self.slices(sign, k, depth - 1))
    }
    fn exit(&self, u: V, center: V, r: I) -> I {
        let w = self.c.minus(center);
        let b = w.dot(u);
        ((b.square() + r.square() - w.sq()).sqrt() - b).lower()
    }
    fn slice(&self, sign: f64, k: I) -> bool {
        let g = |a: f64| {
            let a = pt(a);
            pt(2.0) * a / (pt(1.0) + a.square())
        };
        let u = V {
            x: g(k.lo()).hull(g(k.hi())),
            y: pt(sign) * (pt(1.0) - pt(2.0) / (pt(1.0) + k.square())),
        };
        let mut e = pt(0.0);
        for (i, (p, r)) in self.uppers.iter().enumerate() {
            if self.holds >> i & 1 == 1 {
                e = e.max(self.exit(u, *p, *r));
            }
        }
        if self.r.is_below(e) {
            return true;
        }
        if self.right {
            let p = self.c.plus(u.scale(e.hull(self.r)));
            if self.f.d.square().is_below(p.sq()) || pt(0.0).is_below(p.x) {
                return true;
            }
        }
        let exit1 = || {
            let b = self.c.dot(u);
            ((b.square() + pt(1.0) - self.c.sq()).sqrt() - b).lower()
        };
        let mut l = pt(0.0);
        if self.in_one {
            l = exit1();
        }
        if self.in_q {
            let w = self.c.minus(self.f.q);
            let b = w.dot(u);
            let e = ((b.square() + self.l.square() - w.sq()).sqrt() - b).lower();
            l = l.max(e);
            if !self.in_one && self.c.plus(u.scale(e)).sq().is_below(pt(1.0)) {
                l = l.max(exit1());
            }
        }
        let m = (l - self.r).lower();
        if !pt(0.0).is_below(m) {
            return false;
        }
        let c2 = self.c.plus(u.scale(l));
        let m2 = m.square();
        c2.sq().is_below(m2)
            || c2.minus(self.f.q).sq().is_below(m2)
            || self
                .uppers
                .iter()
                .any(|(p, r)| c2.minus(*p).sq().is_below((*r + m).square()))
    }
}
