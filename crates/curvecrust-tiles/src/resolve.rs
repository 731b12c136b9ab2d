//! The choices of open samples, by asking where other samples are.

use curvecrust_geometry::{Interrupt, Progress};
use rayon::prelude::*;

use crate::atlas::Atlas;
use crate::claim::Claim;
use crate::error::TilesError;
use crate::query::{Outcome, Query};
use crate::sample::Sample;

/// Finds the choices of open samples: their claims, in no order.
///
/// Each question goes to the nearest area of `atlas` that may hold a better sample than is known,
/// then to the next, until none is left. The questions go on in rounds: in each, all that go to
/// one area are answered together. `read` returns the samples of an area by its position, and is
/// called for each area at most once a round, in their order.
///
/// `progress` hears how many questions are answered.
///
/// ```
/// use curvecrust_geometry::{DVec2, Progress};
/// use curvecrust_reconstruct::neighbours::HalfRule;
/// use curvecrust_tiles::*;
///
/// let sample = |id, x| Sample { id, point: DVec2::new(x, 0.0) };
/// let elsewhere = [vec![sample(7, 50.0), sample(8, 2.0)], vec![sample(9, -3.0)]];
/// let areas = elsewhere.iter().map(|all| Area::of(all.iter().map(|s| s.point)));
/// let alone = OpenSample {
///     sample: sample(0, 0.0),
///     lacks: Lack::Nearest,
///     nearest: None,
///     half: None,
/// };
/// let query = Query::new(alone, Area::NOTHING, HalfRule::Bisector);
/// let atlas = Atlas::new(areas.collect());
/// let read = |area: usize| Ok::<_, TilesError>(elsewhere[area].clone());
/// let claims = resolve(vec![query], &atlas, Progress::default(), read)?;
/// assert_eq!(claims, [Claim { from: 0, to: 8 }, Claim { from: 0, to: 9 }]);
/// # Ok::<(), TilesError>(())
/// ```
///
/// # Errors
/// Two samples at one place, and whatever `read` returns.
pub fn resolve<E: From<TilesError>>(
    queries: Vec<Query>,
    atlas: &Atlas,
    progress: Progress<'_>,
    mut read: impl FnMut(usize) -> Result<Vec<Sample>, E>,
) -> Result<Vec<Claim>, E> {
    let total = queries.len();
    let mut open: Vec<Asking> = queries.into_iter().map(Asking::new).collect();
    let mut claims = Vec::new();
    let interrupt = Interrupt::current();
    loop {
        open.par_iter_mut().for_each(|asking| {
            interrupt.check();
            asking.go_on(atlas);
        });
        claims.extend(open.iter_mut().flat_map(|asking| asking.claims.drain(..)));
        open.retain(|asking| asking.next.is_some());
        progress.report(total - open.len(), total);
        if open.is_empty() {
            return Ok(claims);
        }
        // Those that ask the same area follow each other; a stable sort keeps their order.
        open.sort_by_key(|asking| asking.next);
        for asking in open.chunk_by_mut(|a, b| a.next == b.next) {
            interrupt.check();
            let Some(area) = asking.first().and_then(|asking| asking.next) else {
                continue;
            };
            let samples = read(area)?;
            let answer = |asking: &mut Asking| asking.query.offer(&samples);
            asking.par_iter_mut().try_for_each(answer)?;
        }
    }
}

/// A question on its way.
struct Asking {
    query: Query,
    /// The areas that were asked for what is sought now.
    asked: Vec<usize>,
    /// The area to ask; `None` if the question is answered.
    next: Option<usize>,
    claims: Vec<Claim>,
}

impl Asking {
    fn new(query: Query) -> Self {
        Self {
            query,
            asked: Vec::new(),
            next: None,
            claims: Vec::new(),
        }
    }

    /// Finds the next area to ask, or ends.
    fn go_on(&mut self, atlas: &Atlas) {
        self.asked.extend(self.next.take());
        loop {
            self.next = atlas.first(&self.query, &self.asked);
            if self.next.is_some() {
                return;
            }
            match self.query.settle() {
                Outcome::On(claim) => {
                    self.claims.push(claim);
                    self.asked.clear();
                }
                Outcome::Done(claim) => {
                    self.claims.extend(claim);
                    return;
                }
            }
        }
    }
}
