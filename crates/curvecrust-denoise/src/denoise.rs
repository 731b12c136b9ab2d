//! From points to curves: the steps in order.

use curvecrust_geometry::{PointSet, Similarity, point_set::by_coordinates};
use curvecrust_reconstruct::{Known, LeastDetour, Reconstructor};

use crate::band::{Rule, Windows};
use crate::candidates::best;
use crate::chain::as_set;
use crate::clean;
use crate::convert;
use crate::error::DenoiseError;
use crate::fitted::Fitted;
use crate::options::Options;

/// Fewer points than this are taken as clean: scatter cannot be told from a curve that bends.
const FEWEST: usize = 16;
/// Fits curves to points that scatter about them, among others that belong to none.
///
/// Nothing has to be known. Points that are clean give the edges of
/// [`LeastDetour`](curvecrust_reconstruct::LeastDetour); points that form no curve give none. Equal
/// points in another order give the same curves, as do points scaled by a power of two.
///
/// ```
/// use curvecrust_denoise::denoise;
/// use curvecrust_geometry::{DVec2, PointSet, Random};
///
/// // A circle of radius 10, points that scatter about it by 0.5, and some that belong nowhere.
/// let mut random = Random::new(5);
/// let mut points = Vec::new();
/// for _ in 0..400 {
///     let angle = random.between(0.0, std::f64::consts::TAU);
///     let noise = 0.5 * DVec2::new(random.normal(), random.normal());
///     points.push(10.0 * DVec2::from_angle(angle) + noise);
/// }
/// for _ in 0..20 {
///     points.push(DVec2::new(random.between(-12.0, 12.0), random.between(-12.0, 12.0)));
/// }
/// let fitted = denoise(&PointSet::new(points)?);
/// let [circle] = &*fitted.curves else { panic!("one curve") };
/// assert!(circle.closed && (0.4..0.6).contains(&fitted.sigma()));
/// for place in circle.polyline(0.01) {
///     assert!((place.length() - 10.0).abs() < 0.5);
/// }
/// assert!(fitted.outliers().len() > 8);
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[must_use]
pub fn denoise(points: &PointSet) -> Fitted {
    // Without anything that is known nothing can contradict it.
    denoise_with(points, &Options::default()).unwrap_or_default()
}

/// [`denoise`], told what is known about the curves.
///
/// # Errors
/// [`DenoiseError::Sigma`] for a deviation that is no length; [`DenoiseError::Reconstruct`] if the
/// points are clean, or fewer than 16, and no curves through them are as they are known to be.
pub fn denoise_with(points: &PointSet, options: &Options) -> Result<Fitted, DenoiseError> {
    options.check()?;
    let all = vec![true; points.len()];
    let is_known_clean = options.sigma.is_some_and(|sigma| sigma <= 0.0);
    if points.len() < FEWEST || is_known_clean {
        let edges = LeastDetour.reconstruct_known(points, &options.known())?;
        return Ok(convert::clean(points, &all, edges));
    }
    let may_be_clean = options.sigma.is_none();
    let even = may_be_clean
        .then(|| clean::edges_if_clean(points))
        .flatten();
    let is_clean = even.is_some();
    if let Some(edges) = even
        && !clean::has_outliers(points, &edges)
    {
        let known = options.known();
        let edges = match known == Known::default() {
            true => edges,
            false => LeastDetour.reconstruct_known(points, &known)?,
        };
        return Ok(convert::clean(points, &all, edges));
    }
    let frame = Frame::new(points);
    let found = best(&frame.all, frame.to_unit, options);
    let stays = match &found {
        Some((model, band)) => (is_clean || may_be_clean && frame.is_clean(band))
            .then(|| clean::on_curves(&frame.all.points, band, model)),
        None => is_clean.then(|| clean::without_spikes_at_all(&frame.all.points)),
    };
    if let Some(stays) = stays.flatten() {
        return frame.clean(points, &stays, options);
    }
    let model = found.map(|(model, _)| model);
    let count = points.len();
    Ok(convert::noisy(
        count,
        &frame.order,
        frame.to_unit,
        model.as_ref(),
    ))
}

/// The points in the unit box, sorted by coordinates: what follows does not depend on their order.
struct Frame {
    to_unit: Similarity,
    /// The index of each point.
    order: Vec<usize>,
    all: Windows,
}

impl Frame {
    fn new(points: &PointSet) -> Self {
        let to_unit = Similarity::to_unit_box(points.points().iter().copied());
        let mut order: Vec<usize> = (0..points.len()).collect();
        let at = |i: usize| points.points()[i];
        order.sort_unstable_by(|&i, &j| by_coordinates(at(i), at(j)));
        let points = order.iter().map(|&i| to_unit.apply(at(i))).collect();
        Self {
            to_unit,
            order,
            all: Windows::new(points, Rule::Stroke { alarms: 1.0 }),
        }
    }

    /// Whether the points of a band lie on curves.
    fn is_clean(&self, band: &[bool]) -> bool {
        let points = self.all.points.iter().zip(band);
        let set = as_set(points.filter_map(|(&p, &b)| b.then_some(p)));
        set.is_some_and(|set| clean::edges_if_clean(&set.points).is_some())
    }

    /// The result for points of which some, in the order of this frame, lie on their curves.
    fn clean(
        &self,
        points: &PointSet,
        sorted: &[bool],
        options: &Options,
    ) -> Result<Fitted, DenoiseError> {
        let mut stays = vec![false; points.len()];
        for (&i, &s) in self.order.iter().zip(sorted) {
            stays[i] = s;
        }
        let left = points.points().iter().zip(&stays);
        let left = left.filter_map(|(&p, &s)| s.then_some(p)).collect();
        // A part of a set of points is one.
        let left = PointSet::new(left).unwrap_or_default();
        let edges = LeastDetour.reconstruct_known(&left, &options.known())?;
        Ok(convert::clean(points, &stays, edges))
    }
}
