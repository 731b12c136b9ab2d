//! What every algorithm promises, whatever the points.

#![allow(
    clippy::panic,
    clippy::unwrap_used,
    reason = "a test that fails panics"
)]

mod chains;
mod exact;
mod family;
mod least_detour;
mod least_detour_search;
mod oracles;
mod regions;
mod tours;

use curvecrust_geometry::{DVec2, Edge, EdgeSet, PointId, PointSet, PointSetError};
use curvecrust_reconstruct::{
    ALGORITHMS, Beta, HnnCrust, OneStepCrust, ReconstructError, Reconstruction, Reconstructor,
    ViolationReport, one_step_crust, spanning_tree,
};
use curvecrust_testing::hard_points::HARD_POINTS;
use curvecrust_testing::moves::{distances_differ, mapped, permuted, relabelled, shifted};
use curvecrust_testing::strategies::{any_points, rounded};
use curvecrust_voronoi::Delaunay;
use proptest::prelude::*;

/// The edges from the definition; `None` where floating point cannot tell them.
fn oracle(name: &str, points: &PointSet) -> Option<EdgeSet> {
    Some(match name {
        "hnn-crust" => oracles::hnn_crust(points),
        "hnn-crust-union" => oracles::hnn_crust_union(points),
        "nn-crust" => oracles::nn_crust(points),
        "crust" => oracles::crust(points),
        "one-step-crust" => oracles::one_step_crust(points),
        "beta-skeleton" => oracles::beta_skeleton(points, 1.7),
        "gabriel" => oracles::beta_skeleton(points, 1.0),
        "normalised-mesh" => oracles::normalised_mesh(points),
        "sphere-of-influence" => oracles::sphere_of_influence(points),
        "spanning-tree" => family::spanning_tree(points),
        "conservative-crust" => family::conservative_crust(points, 1.0),
        "gathan-like" => return chains::gathan(points),
        "gathan-g-like" => chains::gathan_g(points),
        "lenz-like" => chains::lenz(points),
        "discur" => return chains::discur(points),
        "vicur-like" => return chains::vicur(points),
        "crawl" => family::crawl(points),
        "peel" => family::peel(points),
        "connect2d" => regions::connect2d(points),
        "sig-connect2d" => regions::sig_connect2d(points),
        other => panic!("write an oracle for {other}"),
    })
}

/// What is wrong with the edges that an algorithm has found, if anything.
fn fault(name: &str, points: &PointSet, edges: &EdgeSet) -> Option<String> {
    match name {
        "least-detour" => return least_detour::fault(points, edges),
        "alpha-shape" => return family::alpha_shape_fault(points, edges),
        "shortest-tour" => return tours::fault(points, edges),
        _ => {}
    }
    let expected = oracle(name, points)?;
    (*edges != expected).then(|| format!("{edges:?} instead of {expected:?}"))
}

/// All algorithms; the search of the shortest tour, which takes longer than all others together,
/// for small sets alone.
fn algorithms(points: &PointSet) -> impl Iterator<Item = &'static dyn Reconstructor> + use<> {
    let is_small = points.len() <= 16;
    let all = ALGORITHMS.iter().copied();
    all.filter(move |algorithm| is_small || algorithm.info().name != "shortest-tour")
}

/// The same for `moved` as for `points`, for all algorithms; tours may differ that are equally
/// long to rounding.
fn same_edges(points: &PointSet, moved: Option<&PointSet>) -> Result<(), TestCaseError> {
    let Some(moved) = moved else { return Ok(()) };
    for algorithm in algorithms(points) {
        let name = algorithm.info().name;
        let [found, expected] = [moved, points].map(|set| algorithm.reconstruct(set));
        let is_as_long = || {
            let [found, expected] = [&found, &expected].map(|tour| tours::length(points, tour));
            (found - expected).abs() <= 1e-14 * expected
        };
        let is_tie =
            name == "shortest-tour" && tours::fault(points, &found).is_none() && is_as_long();
        if !is_tie {
            prop_assert_eq!(found, expected, "{}", name);
        }
    }
    Ok(())
}

#[test]
fn hard_points_are_joined_as_defined() {
    for hard in HARD_POINTS {
        for count in [12, 23] {
            // The oracles compute with multiples of 2^-100.
            let given = (hard.points)(count).into_iter().map(|p| rounded(p, 100));
            let points = PointSet::merging_duplicates(given.collect()).unwrap();
            for algorithm in algorithms(&points.points) {
                let name = algorithm.info().name;
                let found = algorithm.reconstruct(&points.points);
                let fault = fault(name, &points.points, &found);
                assert_eq!(fault, None, "{name}: {}", hard.name);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn edges_are_valid_and_become_chains(points in any_points()) {
        for algorithm in algorithms(&points) {
            let edges = algorithm.reconstruct(&points);
            prop_assert_eq!(edges.vertex_count(), points.len());
            prop_assert!(edges.edges().is_sorted_by(|e, f| e < f));
            let found = Reconstruction::new(&points, edges.clone()).unwrap();
            let chains = found.chains().iter();
            let mut covered: Vec<Edge> = chains.flat_map(|c| c.chain.edges()).collect();
            covered.sort_unstable();
            prop_assert_eq!(covered, edges.edges());
            prop_assert!(ViolationReport::new(&points, &edges).is_ok());
        }
    }

    #[test]
    fn permuted_points_have_permuted_edges(
        (points, order) in any_points().prop_flat_map(|points| {
            let ids: Vec<PointId> = points.ids().collect();
            (Just(points), Just(ids).prop_shuffle())
        }),
    ) {
        let shuffled = permuted(&points, &order);
        for algorithm in algorithms(&points) {
            let edges = relabelled(&algorithm.reconstruct(&shuffled), &order);
            prop_assert_eq!(edges, algorithm.reconstruct(&points), "{}", algorithm.info().name);
        }
    }

    #[test]
    fn exact_shifts_and_scales_change_nothing(
        points in any_points(),
        shift in prop::sample::select(vec![1.0, 1000.0, 1048576.0]),
        exponent in -80..80i32,
    ) {
        same_edges(&points, shifted(&points, DVec2::new(shift, -0.75 * shift)).as_ref())?;
        same_edges(&points, mapped(&points, |p| p * 2f64.powi(exponent)).as_ref())?;
    }

    #[test]
    fn right_angles_and_mirrors_change_nothing(points in any_points()) {
        if distances_differ(&points) {
            same_edges(&points, mapped(&points, DVec2::perp).as_ref())?;
            same_edges(&points, mapped(&points, |p| DVec2::new(-p.x, p.y)).as_ref())?;
            same_edges(&points, mapped(&points, |p| DVec2::new(p.y, p.x)).as_ref())?;
        }
    }

    #[test]
    fn one_thread_and_many_agree(points in any_points()) {
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| algorithms(&points).map(|a| a.reconstruct(&points)).collect::<Vec<_>>())
        };
        prop_assert_eq!(on(1), on(4));
    }

    #[test]
    fn an_edge_is_in_the_crust_or_its_dual_in_the_skeleton(points in any_points()) {
        let found = one_step_crust(&points);
        prop_assert_eq!(&found.crust, &OneStepCrust.reconstruct(&points));
        let duals = found.skeleton.edges().iter().filter_map(|e| Edge::new(e.sites[0], e.sites[1]));
        let anti_crust = EdgeSet::new(points.len(), duals);
        prop_assert_eq!(found.skeleton.edges().len(), anti_crust.len());
        let both = found.crust.edges().iter().chain(anti_crust.edges());
        let delaunay = Delaunay::new(&points);
        let all = delaunay.edges().filter_map(|dual| Edge::new(dual.ends[0], dual.ends[1]));
        let all = EdgeSet::new(points.len(), all);
        prop_assert_eq!(all.len(), found.crust.len() + anti_crust.len());
        prop_assert_eq!(EdgeSet::new(points.len(), both.copied()), all);

        let lfs = found.skeleton.lfs(&points);
        prop_assert_eq!(lfs.len(), points.len());
        prop_assert!(lfs.iter().all(|&d| d >= 0.0 && (d.is_finite() || anti_crust.is_empty())));
    }

    #[test]
    fn the_whole_range_of_coordinates_is_carried(
        places in prop::collection::vec((-1.0..1.0, -1.0..1.0, 0..4usize), 0..12),
    ) {
        let sizes = [PointSet::MIN_MAGNITUDE * 1e20, 1e-20, 1.0, PointSet::MAX_MAGNITUDE];
        let points = places.iter().map(|&(x, y, size)| DVec2::new(x, y) * sizes[size]);
        let Ok(points) = PointSet::new(points.collect()) else { return Ok(()) };
        for algorithm in algorithms(&points) {
            let found = Reconstruction::by(algorithm, &points);
            prop_assert_eq!(found.degrees().len(), points.len());
        }
        let lfs = one_step_crust(&points).skeleton.lfs(&points);
        prop_assert!(lfs.iter().all(|&d| d >= 0.0));
    }

    #[test]
    fn termini_are_honoured_or_refused(
        points in any_points(),
        picks in prop::collection::vec(0..60usize, 0..4),
    ) {
        let inside = picks.iter().filter(|&&i| i < points.len());
        let termini: Vec<PointId> = inside.filter_map(|&i| PointId::new(i)).collect();
        for algorithm in algorithms(&points) {
            let info = algorithm.info();
            let open = algorithm.reconstruct_open(&points, &termini);
            if termini.is_empty() {
                prop_assert_eq!(open, Ok(algorithm.reconstruct(&points)));
            } else if info.honours_termini {
                let (open, all) = (open.unwrap(), algorithm.reconstruct(&points));
                if info.name.starts_with("hnn-crust") {
                    prop_assert_eq!(open.difference(&all).count(), 0);
                }
                if info.name != "hnn-crust-union" {
                    let degrees = open.degrees();
                    prop_assert!(termini.iter().all(|t| degrees[t.index()] <= 1));
                }
            } else {
                let refused = ReconstructError::TerminiNotHonoured { algorithm: info.name };
                prop_assert_eq!(open, Err(refused));
            }
        }
    }

    #[test]
    fn no_spanning_tree_is_shorter(points in any_points()) {
        let found = tours::length(&points, &spanning_tree(&points));
        let least = family::least_tree(&points);
        prop_assert!((found - least).abs() <= 1e-12 * least);
    }

    #[test]
    fn crusts_contain_each_other(points in any_points()) {
        let by = |name: &str| {
            let found = ALGORITHMS.iter().find(|a| a.info().name == name);
            found.unwrap().reconstruct(&points)
        };
        let inside = |small: &str, large: &str| by(small).difference(&by(large)).count() == 0;
        prop_assert!(inside("hnn-crust", "hnn-crust-union"));
        prop_assert!(inside("crust", "one-step-crust"));
        prop_assert!(inside("beta-skeleton", "gabriel"));
        prop_assert!(inside("one-step-crust", "gabriel"));
        prop_assert!(inside("normalised-mesh", "one-step-crust"));
        prop_assert!(inside("conservative-crust", "gabriel"));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn edges_are_those_of_the_definition(points in any_points()) {
        for algorithm in algorithms(&points) {
            let name = algorithm.info().name;
            let edges = algorithm.reconstruct(&points);
            prop_assert_eq!(fault(name, &points, &edges), None, "{}", name);
        }
    }
}

#[test]
fn errors_name_index_and_value() {
    let points = PointSet::new(vec![DVec2::ZERO, DVec2::X]).unwrap();
    let termini = [PointId::from(1), PointId::from(7)];
    let message = |error: &dyn std::error::Error| error.to_string();
    let error = HnnCrust::MUTUAL
        .reconstruct_open(&points, &termini)
        .unwrap_err();
    assert!(
        message(&error).starts_with("terminus 1 is point 7"),
        "{error}"
    );

    for beta in [0.999, -1.7, 0.0, f64::NAN, f64::INFINITY] {
        let error = Beta::new(beta).unwrap_err();
        assert!(
            message(&error).starts_with(&format!("beta is {beta}")),
            "{error}"
        );
    }

    let error = PointSet::new(vec![DVec2::X, DVec2::ZERO, DVec2::X]).unwrap_err();
    assert!(matches!(
        error,
        PointSetError::Duplicate {
            first: 0,
            second: 2,
            ..
        }
    ));
    let error = PointSet::new(vec![DVec2::X, DVec2::new(0.0, 1e300)]).unwrap_err();
    assert_eq!(
        error,
        PointSetError::Magnitude {
            index: 1,
            value: 1e300
        }
    );

    let too_few = EdgeSet::new(1, []);
    let error = Reconstruction::new(&points, too_few).unwrap_err();
    assert_eq!(
        error,
        ReconstructError::VertexCount {
            vertices: 1,
            count: 2
        }
    );
}
