//! The list of algorithms.

use crate::algorithm::Reconstructor;
use crate::alpha_shape::AlphaShape;
use crate::beta_skeleton::BetaSkeleton;
use crate::connect2d::Connect2d;
use crate::conservative_crust::ConservativeCrust;
use crate::crawl::Crawl;
use crate::crust::Crust;
use crate::discur::Discur;
use crate::gathan::Gathan;
use crate::gathan_g::GathanG;
use crate::hnn_crust::HnnCrust;
use crate::least_detour::LeastDetour;
use crate::lenz::Lenz;
use crate::nn_crust::NnCrust;
use crate::normalised_mesh::NormalisedMesh;
use crate::one_step_crust::OneStepCrust;
use crate::peel::Peel;
use crate::shortest_tour::ShortestTour;
use crate::sig_connect2d::SigConnect2d;
use crate::spanning_tree::SpanningTree;
use crate::sphere_of_influence::SphereOfInfluence;
use crate::vicur::Vicur;

/// Every algorithm of this crate, the recommended one first.
///
/// Programs, documents, benches and tests iterate this list, so that none of them forgets one.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::ALGORITHMS;
///
/// let on_a_line = [0.0, 1.0, 2.0, 3.0].map(|x| DVec2::new(x, 2.0 * x));
/// let points = PointSet::new(on_a_line.to_vec())?;
/// for algorithm in ALGORITHMS {
///     assert_eq!(algorithm.reconstruct(&points).len(), 3, "{}", algorithm.info().name);
/// }
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
pub const ALGORITHMS: &[&dyn Reconstructor] = &[
    &LeastDetour,
    &HnnCrust::MUTUAL,
    &HnnCrust::UNION,
    &NnCrust,
    &Crust,
    &OneStepCrust,
    &BetaSkeleton::CRUST,
    &BetaSkeleton::GABRIEL,
    &NormalisedMesh,
    &AlphaShape::OWN,
    &SphereOfInfluence,
    &SpanningTree,
    &ConservativeCrust::LEAST,
    &Gathan,
    &GathanG,
    &Lenz,
    &Discur,
    &Vicur,
    &Crawl,
    &Peel,
    &Connect2d,
    &SigConnect2d,
    &ShortestTour,
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algorithm::{AlgorithmInfo, Basis, Guarantee};

    #[test]
    fn the_crate_doc_lists_every_algorithm() {
        let row = |info: AlgorithmInfo| {
            let guarantees: Vec<_> = info.guarantees.iter().map(Guarantee::to_string).collect();
            let guarantees = match &guarantees[..] {
                [] => "none known".to_owned(),
                some => some.join(", "),
            };
            let basis = match info.basis {
                Basis::Published => "",
                Basis::Argued => " (argued)",
            };
            let known = match (info.honours_known, info.honours_termini) {
                (true, true) => "shape, number, termini",
                (true, false) => "shape, number",
                (false, true) => "termini",
                (false, false) => "nothing",
            };
            format!(
                "//! | [`{}`] | {}{basis} | {guarantees} | {} | {} | {known} |\n",
                info.name, info.citation, info.scope, info.cost,
            )
        };
        let rows: String = ALGORITHMS.iter().map(|a| row(a.info())).collect();
        let rule = "//! |---|---|---|---|---|---|\n";
        let doc = include_str!("lib.rs");
        let table = doc
            .split_once(rule)
            .unwrap()
            .1
            .split_once("//!\n")
            .unwrap()
            .0;
        assert_eq!(table, rows, "paste into lib.rs:\n{rows}");
    }

    #[test]
    fn names_are_unique() {
        let mut names: Vec<_> = ALGORITHMS.iter().map(|a| a.info().name).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), ALGORITHMS.len());
    }
}
