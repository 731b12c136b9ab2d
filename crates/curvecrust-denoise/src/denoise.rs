//! From points to curves: the steps in order.

use curvecrust_geometry::point_set::by_coordinates;
use curvecrust_geometry::{Edge, EdgeSet, PointId, PointSet, Similarity};
use curvecrust_reconstruct::{Known, LeastDetour, Reconstructor};

use crate::band::{Rule, Windows};
use crate::candidates::best;
use crate::chain::as_set;
use crate::clean;
use crate::convert;
use crate::corners::cornered;
use crate::error::DenoiseError;
use crate::fitted::Fitted;
use crate::options::Options;

/// Fewer points than this are taken as clean: scatter looks like a curve that bends.
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

/// [`denoise`], with what is known about the curves.
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
    let sorted = Sorted::new(points);
    let even = may_be_clean
        .then(|| clean::edges_if_clean(&sorted.points))
        .flatten();
    let is_clean = even.is_some();
    if let Some(edges) = even
        && !clean::has_outliers(&sorted.points, &edges)
    {
        let known = options.known();
        let edges = match known == Known::default() {
            true => sorted.original(&edges),
            false => LeastDetour.reconstruct_known(points, &known)?,
        };
        return Ok(convert::clean(points, &all, edges));
    }
    let frame = Frame::new(sorted);
    let scale = 1.0 / frame.to_unit.invert_length(1.0);
    let sigma = options.sigma.map(|sigma| sigma * scale);
    let found = best(&frame.all, sigma, options);
    let stays = match &found {
        Some((model, band)) => (is_clean || may_be_clean && frame.is_clean(band))
            .then(|| clean::on_curves(&frame.all.points, band, model)),
        None => is_clean.then(|| clean::without_spikes_at_all(&frame.all.points)),
    };
    if let Some(stays) = stays.flatten() {
        return frame.clean(points, &stays, options);
    }
    let model = found.map(|(model, _)| cornered(&frame.all.points, model, sigma));
    let count = points.len();
    Ok(convert::noisy(
        count,
        &frame.order,
        frame.to_unit,
        model.as_ref(),
    ))
}

/// Points by coordinates: what is computed from them does not depend on the order of the input, not
/// by the rounding of a sum either.
struct Sorted {
    /// The index that each point had.
    order: Vec<usize>,
    points: PointSet,
}

impl Sorted {
    fn new(points: &PointSet) -> Self {
        let mut order: Vec<usize> = (0..points.len()).collect();
        let at = |i: usize| points.points()[i];
        order.sort_unstable_by(|&i, &j| by_coordinates(at(i), at(j)));
        let sorted = order.iter().map(|&i| at(i)).collect();
        Self {
            order,
            // The points of a set are one.
            points: PointSet::new(sorted).unwrap_or_default(),
        }
    }

    /// Edges between the points as they were given.
    fn original(&self, edges: &EdgeSet) -> EdgeSet {
        let id = |sorted: PointId| PointId::new(self.order[sorted.index()]);
        let given = edges.edges().iter().filter_map(|edge| {
            let [a, b] = edge.ends().map(id);
            Edge::new(a?, b?)
        });
        EdgeSet::new(self.order.len(), given)
    }
}

/// The sorted points in the unit box.
struct Frame {
    to_unit: Similarity,
    /// The index of each point.
    order: Vec<usize>,
    all: Windows,
}

impl Frame {
    fn new(Sorted { order, points }: Sorted) -> Self {
        let to_unit = Similarity::to_unit_box(points.points().iter().copied());
        let points = points.points().iter().map(|&p| to_unit.apply(p)).collect();
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
