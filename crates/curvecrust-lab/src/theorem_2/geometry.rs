//! What the unknowns of a box determine: q, its tangent and normal, z, and radii of discs that
//! are free of the curve.

use super::interval::Interval as I;

pub(super) type B = [I; 4];
#[derive(Clone, Copy)]
pub(super) struct V {
    pub(super) x: I,
    pub(super) y: I,
}
impl V {
    pub(super) fn dot(self, o: V) -> I {
        self.x * o.x + self.y * o.y
    }
    pub(super) fn sq(self) -> I {
        self.x.square() + self.y.square()
    }
    pub(super) fn scale(self, k: I) -> V {
        V {
            x: k * self.x,
            y: k * self.y,
        }
    }
    pub(super) fn plus(self, o: V) -> V {
        V {
            x: self.x + o.x,
            y: self.y + o.y,
        }
    }
    pub(super) fn minus(self, o: V) -> V {
        V {
            x: self.x - o.x,
            y: self.y - o.y,
        }
    }
}
pub(super) fn pt(x: f64) -> I {
    I::point(x)
}
pub(super) fn up() -> V {
    V {
        x: pt(0.0),
        y: pt(1.0),
    }
}
/// What the four unknowns of a box determine.
pub(super) struct F {
    pub(super) rho: I,
    pub(super) d: I,
    pub(super) q: V,
    pub(super) n: V,
    pub(super) t: V,
    pub(super) z: V,
    pub(super) tau: I,
    pub(super) slope: I,
    pub(super) ka: I,
    pub(super) zz: I,
}
pub(super) fn frame(b: &B, rho: I) -> F {
    let [d, ka, m, tau] = *b;
    let s = pt(0.5) * (ka * d);
    let c = (pt(1.0) - s.square()).sqrt();
    let q = V {
        x: -(d * c),
        y: -(d * s),
    };
    let cos = pt(2.0) / (pt(1.0) + m.square()) - pt(1.0);
    let f = |a: f64| {
        let a = pt(a);
        pt(2.0) * a / (pt(1.0) + a.square())
    };
    let sin = f(m.lo()).hull(f(m.hi())); // dyadic: no +-1 inside
    let n = V { x: -sin, y: cos };
    let t = V { x: cos, y: sin };
    let slope = sin * c - cos * s;
    let z = q.plus(n.scale(tau));
    let zz = d.square() + tau * (pt(2.0) * (d * slope) + tau);
    F {
        rho,
        d,
        q,
        n,
        t,
        z,
        tau,
        slope,
        ka,
        zz,
    }
}
pub(super) struct T {
    pub(super) up: I,
    pub(super) down: I,
}
pub(super) fn radii(f: &F, l: I) -> T {
    let ds = f.d * f.slope;
    if f.d.is_below(pt(1.0)) {
        let root = (ds.square() + pt(1.0) - f.d.square()).sqrt();
        T {
            up: (root - ds).max(l).lower(),
            down: (root + ds).max(l).lower(),
        }
    } else {
        // the ray may enter O(s1,1) before L
        let disc = ds.square() + pt(1.0) - f.d.square();
        let mut r = T { up: l, down: l };
        if pt(0.0).is_below(disc) {
            let root = disc.sqrt();
            if (-ds - root).is_below(l) {
                r.up = (root - ds).max(l).lower();
            }
            if (ds - root).is_below(l) {
                r.down = (root + ds).max(l).lower();
            }
        }
        r
    }
}
