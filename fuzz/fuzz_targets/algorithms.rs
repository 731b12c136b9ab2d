//! `PointSet` and every algorithm: total, and the same edges whatever the order of the points,
//! their place and their scale.

#![no_main]

use curvecrust::DVec2;
use curvecrust::geometry::{Edge, EdgeSet, PointId, PointSet};
use curvecrust::reconstruct::{
    ALGORITHMS, HnnCrust, Reconstruction, Reconstructor, ViolationReport, crust, hnn_crust,
    one_step_crust,
};
use curvecrust_fuzz::NearlyDegenerate;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|points: NearlyDegenerate| {
    let given = points.0;
    let merged = match PointSet::merging_duplicates(given.clone()) {
        Ok(merged) => merged,
        Err(error) => {
            // As text: the error may hold a NaN.
            let other = PointSet::new(given).unwrap_err();
            assert_eq!(other.to_string(), error.to_string());
            return;
        }
    };
    assert_eq!(PointSet::new(given).is_ok(), merged.duplicates() == 0);
    let points = merged.points;
    let reversed = PointSet::new(points.points().iter().rev().copied().collect()).unwrap();
    let halved = PointSet::new(points.points().iter().map(|&p| p / 2.0).collect()).ok();
    let back = |id: PointId| PointId::new(points.len() - 1 - id.index()).unwrap();
    for algorithm in ALGORITHMS {
        let edges = algorithm.reconstruct(&points);
        assert_eq!(edges.vertex_count(), points.len());
        let from_reversed = algorithm.reconstruct(&reversed);
        let renamed = from_reversed
            .edges()
            .iter()
            .filter_map(|e| Edge::new(back(e.a()), back(e.b())));
        assert_eq!(EdgeSet::new(points.len(), renamed), edges, "{algorithm:?}");
        if let Some(halved) = &halved
            && exactly_halved(&points, halved)
        {
            assert_eq!(algorithm.reconstruct(halved), edges, "{algorithm:?}");
        }
        let found = Reconstruction::new(&points, edges.clone()).unwrap();
        let covered: usize = found.chains().iter().map(|c| c.chain.edge_count()).sum();
        assert_eq!(covered, edges.len());
        ViolationReport::new(&points, &edges).unwrap();
    }
    let mutual = hnn_crust(&points);
    assert!(mutual.degrees().iter().all(|&degree| degree <= 2));
    assert_eq!(
        mutual
            .difference(&HnnCrust::UNION.reconstruct(&points))
            .count(),
        0
    );
    let termini: Vec<PointId> = points.ids().step_by(3).collect();
    let open = HnnCrust::MUTUAL
        .reconstruct_open(&points, &termini)
        .unwrap();
    let degrees = open.degrees();
    assert!(termini.iter().all(|t| degrees[t.index()] <= 1));

    let one_step = one_step_crust(&points);
    assert_eq!(crust(&points).difference(&one_step.crust).count(), 0);
    for lfs in one_step.skeleton.lfs(&points) {
        assert!(lfs >= 0.0);
    }
});

/// Whether no bit was lost.
fn exactly_halved(points: &PointSet, halved: &PointSet) -> bool {
    let doubled = halved.points().iter().map(|&p: &DVec2| p * 2.0);
    doubled.zip(points.points()).all(|(p, &q)| p == q)
}
