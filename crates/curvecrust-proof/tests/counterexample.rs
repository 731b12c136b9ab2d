//! Where Theorem 2 is false, nothing is proven.

use curvecrust_proof::{Curves, Interval, Leaf, Reason, prove};

/// The counterexample of `docs/theorem-2.md` at rho = 0.8951: an arc of the unit circle before s1,
/// a line after it, z on the normal of the arc's midpoint.
fn unknowns() -> [Interval; 4] {
    // A little nearer to s1 than to s0.
    let angle = 38.2623_f64.to_radians() - 1e-5;
    let chord = 2.0 * (angle / 2.0).sin();
    // The reach of the arc is half of this; the quotient stays below 0.8951.
    let height = 2.0 * chord / 0.89506;
    [chord, 1.0, (angle / 2.0).tan(), height].map(Interval::point)
}

#[test]
fn the_counterexample_satisfies_all_conditions() {
    let (unknowns, rho) = (unknowns(), Interval::around(0.8951));
    let chord = unknowns[0].low();
    let angle = 38.2623_f64.to_radians() - 1e-5;
    let far = 1.0 + unknowns[3].low();
    let z = [-far * angle.sin(), far * angle.cos() - 1.0];
    let mut reasons = vec![
        Reason::Far,
        Reason::Nearest,
        Reason::Backwards,
        Reason::Reach,
        Reason::DiscAtS1,
        Reason::DiscAtQ,
        Reason::Sides,
        Reason::Ends,
        Reason::NoMidpoint,
    ];
    for i in -100..=20 {
        for j in -20..=100 {
            let center = [f64::from(i) / 80.0, f64::from(j) / 80.0];
            let radius = (center[0] - z[0]).hypot(center[1] - z[1]) * (1.0 + 1e-12);
            reasons.push(Reason::Ball { center, radius });
        }
    }
    for reason in reasons {
        for midpoint in [None, Some(0.5 * chord), Some(0.9999 * chord)] {
            let leaf = Leaf {
                midpoint,
                reason: reason.clone(),
            };
            for curves in [Curves::Smooth, Curves::Arcs] {
                assert!(!curves.refutes(&unknowns, rho, &leaf), "{leaf:?}");
            }
        }
    }
}

#[test]
fn a_box_resists_where_the_theorem_is_false() {
    assert!(prove(Curves::Smooth, 0.9, 2e-3).is_err());
}

/// There are no other failures on arcs: what resists is the counterexample.
#[test]
fn on_arcs_the_box_that_resists_is_the_counterexample() {
    let resisting = prove(Curves::Arcs, 0.8951, 1e-6).map(|_| ()).unwrap_err();
    for (i, [low, high]) in resisting.unknowns.into_iter().enumerate() {
        let around = Interval::new(low - 1e-3, high + 1e-3);
        assert!(around.holds(unknowns()[i]), "{resisting}");
    }
}
