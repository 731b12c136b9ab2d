//! What a result says about the points: a line each, where something would help.

use super::BarePoints;
use curvecrust::geometry::{EdgeSet, PointId, PointSet};

/// Points this much nearer than the usual spacing are one point, most likely.
const NEARLY_EQUAL: f64 = 1e-6;

/// Of points on curves that are sampled well, smaller shares are ends, stay alone, or turn sharply.
const LOOSE_SHARE: f64 = 0.15;
const SHARP_SHARE: f64 = 0.08;

/// So few of them are no sign of anything.
const FEW: usize = 8;

/// The cosine of a sharp turn: 100 degrees. Consecutive edges of a rho-sample with rho < 0.9 turn
/// by at most 107 (SGP 2016, Lemma 8), and hardly ever by as much.
const SHARP_COSINE: f64 = -0.17364817766693033;

/// The hints for some edges, none for most.
pub(super) fn hints(bare: &BarePoints, edges: &EdgeSet) -> Vec<String> {
    let partners = Partners::new(edges);
    let loose = partners.loose();
    let near = (loose > 0).then(|| nearly_equal(bare, edges)).flatten();
    let shape = shape(&bare.points, &partners, loose);
    near.into_iter().chain(shape).collect()
}

/// Points that are nearly equal tear the curve through them, so this asks where it is torn.
fn nearly_equal(bare: &BarePoints, edges: &EdgeSet) -> Option<String> {
    let points = &bare.points;
    let length = |[v, w]: [PointId; 2]| points[v].distance(points[w]);
    let edges = edges.edges().iter();
    let mut lengths: Vec<f64> = edges.map(|edge| length(edge.ends())).collect();
    let middle = lengths.len() / 2;
    if lengths.is_empty() {
        return None;
    }
    let (_, &mut spacing, _) = lengths.select_nth_unstable_by(middle, f64::total_cmp);
    let within = NEARLY_EQUAL * spacing;
    let merged = PointSet::merging_within(points.points().to_vec(), within).ok()?;
    let standing =
        |v: PointId| PointId::new(merged.origin[merged.representative[v.index()].index()]);
    let (v, w) = points
        .ids()
        .find_map(|v| standing(v).filter(|&w| w != v).map(|w| (v, w)))?;
    let more = match merged.duplicates() - 1 {
        0 => String::new(),
        1 => String::from(", and 1 more such pair"),
        count => format!(", and {count} more such pairs"),
    };
    let (v, w) = (v.min(w), v.max(w));
    Some(format!(
        "points {} and {} are only {:.1e} apart, less than a millionth of the spacing{more}: \
         --merge-within takes such points for one",
        bare.row(v),
        bare.row(w),
        length([v, w]),
    ))
}

/// Many ends, points that stay alone, and sharp turns: these are not points of well sampled curves.
fn shape(points: &PointSet, partners: &Partners, loose: usize) -> Option<String> {
    let count = points.len();
    let sharp = partners.sharp(points);
    let much = |some: usize, share: f64| some > FEW && some as f64 > share * count as f64;
    let what = if much(loose, LOOSE_SHARE) {
        format!("{loose} of {count} points are ends or stay alone")
    } else if much(sharp, SHARP_SHARE) {
        format!("the curves turn by more than 100 degrees at {sharp} of {count} points")
    } else {
        return None;
    };
    Some(format!(
        "{what}: the points may scatter about their curves, which `curvecrust fit` is for, be too \
         sparse for them, or lie on lines that meet; more points help, and --closed, --open and \
         --curves for what is known"
    ))
}

/// The first two partners of every point, and how many it has.
struct Partners {
    partners: Vec<[Option<PointId>; 2]>,
    degrees: Vec<u32>,
}

impl Partners {
    fn new(edges: &EdgeSet) -> Self {
        let mut partners = vec![[None; 2]; edges.vertex_count()];
        for edge in edges.edges() {
            for (v, w) in [(edge.a(), edge.b()), (edge.b(), edge.a())] {
                if let Some(free) = partners[v.index()].iter_mut().find(|p| p.is_none()) {
                    *free = Some(w);
                }
            }
        }
        Self {
            partners,
            degrees: edges.degrees(),
        }
    }

    /// The number of points that are ends or alone.
    fn loose(&self) -> usize {
        self.degrees.iter().filter(|&&degree| degree < 2).count()
    }

    /// The number of points with two edges that turn sharply.
    fn sharp(&self, points: &PointSet) -> usize {
        let at = points.ids().zip(&self.partners).zip(&self.degrees);
        let turns = at.filter(|&((v, partners), &degree)| {
            let [Some(p), Some(q)] = *partners else {
                return false;
            };
            let (a, b) = (points[v] - points[p], points[q] - points[v]);
            degree == 2 && a.dot(b) < SHARP_COSINE * a.length() * b.length()
        });
        turns.count()
    }
}
