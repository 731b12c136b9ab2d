//! The fewest samples: certified greedy sampling from the best of all starts.
//!
//! Whether greedy is optimal. Write J(a) for the last dense point up to which the condition holds
//! from a.
//!
//! *Epsilon below 1, and rho up to 1, without a limit: yes.* Parts of an interval that holds hold.
//! For a curve point p, the open disc of radius lfs(p) meets the curve in one arc, along which the
//! distance to p grows from p to either side; otherwise a smaller disc about p would meet the curve
//! in two pieces and contain a point of the medial axis (Amenta, Bern, Eppstein 1998). If p has an
//! end of its interval nearer than epsilon lfs(p), or than rho reach, which are at most lfs(p),
//! then an end that is moved towards p is nearer still, and the reach is no smaller. So J(a) never
//! decreases with a, and by induction the i-th sample of greedy from a is at least as far along as
//! that of any other sampling that has a sample at a: on an open component, which has one at its
//! start, none has fewer samples. A closed component has some sample somewhere, so the best of all
//! starts is optimal; any other start needs one more at most. All this is among samplings at dense
//! points, and as far as lfs is right.
//!
//! *With a Hausdorff limit: no.* The chord from crest to trough of a gentle wave may pass near
//! enough to all of it where the chord from crest to crest does not: parts of what holds need not
//! hold, the farthest next sample may be a bad one, and greedy may take more samples than need be
//! (6 for 4 in the test `greedy_is_not_optimal_with_a_limit`). The result is the best greedy
//! sampling over all starts.
//!
//! Closed components without a limit: every sampling has a sample behind the first and up to the
//! second of two consecutive greedy ones, or its interval across them would hold on beyond J.
//! Greedy starts from all dense points there, at the two samples with the fewest between them;
//! walks that meet go on as one, since the start that is farthest back needs no more steps than the
//! others. Cost: O(n log n) at most, seldom a tenth of n steps. With a limit: J for every dense
//! point, then jumps of 2^i steps by doubling, and the smallest number of steps that goes round
//! from any start. Cost: O(n log n).

use curvecrust_geometry::Interrupt;
use curvecrust_geometry::parallel::*;
use curvecrust_medial_axis::MeasuredCurve;

use crate::arcs::Arcs;
use crate::certified::{certified, walk};
use crate::condition::Condition;
use crate::error::SamplingError;
use crate::sampling::{SampleOptions, Sampling};

/// Starts in a row, each of which helps the next; one item of progress.
const CHUNK: usize = 2048;

/// Samples every component of a curve with the fewest samples of all starts of certified
/// [greedy sampling](crate::sample).
///
/// Without a Hausdorff limit no certified sampling at these dense points has fewer samples; with
/// one, there are no more than from any one dense point. Of equally good starts always the same is
/// taken, the first dense point if it is one; the samples of each component are in the order of its
/// dense points.
///
/// # Errors
/// Those of [`sample`](crate::sample).
///
/// ```
/// use curvecrust_curve::Curve;
/// use curvecrust_medial_axis::measure;
/// use curvecrust_sampling::{Condition, sample, sample_fewest};
///
/// let d = "M 0 0 C 30 -20 50 20 80 0 S 120 40 80 60 S 30 30 0 60 S -30 20 0 0 Z";
/// let curve = Curve::from_path_data(d)?;
/// let measured = measure(&curve)?;
/// let rho = Condition::rho(0.9)?;
/// let fewest = sample_fewest(&measured, rho)?;
/// assert!(fewest.samples.len() <= sample(&measured, rho)?.samples.len());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn sample_fewest(
    measured: &MeasuredCurve,
    condition: Condition,
) -> Result<Sampling, SamplingError> {
    sample_fewest_with(measured, condition, &SampleOptions::default())
}

/// [`sample_fewest`] by the given [options](SampleOptions).
///
/// # Errors
/// Those of [`sample_fewest`].
pub fn sample_fewest_with(
    measured: &MeasuredCurve,
    condition: Condition,
    options: &SampleOptions<'_>,
) -> Result<Sampling, SamplingError> {
    let (progress, total) = (options.progress, measured.dense().len());
    progress.report(0, total);
    certified(measured, condition, |arcs| {
        let on_component = |done: usize| progress.report(arcs.component.range.start + done, total);
        let positions = positions(arcs, condition, &on_component)?;
        progress.report(arcs.component.range.end, total);
        Ok(positions)
    })
}

/// The positions of the fewest samples of a component, or a gap that is too long.
pub(crate) fn positions(
    arcs: &Arcs,
    condition: Condition,
    progress: &(dyn Fn(usize) + Sync),
) -> Result<Vec<usize>, usize> {
    let mut positions = walk(arcs, condition, 0)?;
    if arcs.component.closed {
        let start = if condition.hausdorff_limit().is_some() {
            best_start(&jumps(arcs, condition, progress)?)
        } else {
            better_start(arcs, condition, &positions, progress).unwrap_or(0)
        };
        let other = walk(arcs, condition, start)?;
        if other.len() < positions.len() {
            positions = other.into_iter().map(|at| at % arcs.len()).collect();
            positions.sort_unstable();
        }
    }
    Ok(positions)
}

/// A start from which greedy takes one sample fewer than the given ones, those from 0; `None` if
/// none does. Only without a Hausdorff limit.
fn better_start(
    arcs: &Arcs,
    condition: Condition,
    positions: &[usize],
    progress: &dyn Fn(usize),
) -> Option<usize> {
    let round = arcs.len();
    let pairs = positions.windows(2).map(|pair| (pair[0], pair[1]));
    let (from, to) = pairs.min_by_key(|(from, to)| to - from)?;
    // Where each walk starts, and where it is.
    let mut walks: Vec<[usize; 2]> = (from + 1..=to).map(|start| [start; 2]).collect();
    let interrupt = Interrupt::current();
    for step in 1..positions.len() {
        interrupt.check();
        let mut guess = 0;
        for [_, at] in &mut walks {
            let before = *at / round * round;
            let from = *at - before;
            let found = arcs.farthest(condition, from, guess.max(before) - before, from + round);
            *at = before + found.unwrap_or(from + 1);
            // Any guess gives the same; this one saves a fifth of the time.
            guess = *at + 1;
        }
        walks.dedup_by_key(|walk| walk[1]);
        progress(round / positions.len() * step);
    }
    let goes_round = |walk: &&[usize; 2]| walk[1] >= walk[0] + round;
    walks.iter().find(goes_round).map(|walk| walk[0])
}

/// How far greedy jumps from every position of a closed component, in gaps; or a gap that is too
/// long.
fn jumps(
    arcs: &Arcs,
    condition: Condition,
    progress: &(dyn Fn(usize) + Sync),
) -> Result<Vec<usize>, usize> {
    let round = arcs.len();
    let too_long = |&gap: &usize| !arcs.holds(condition, gap, gap + 1);
    if let Some(gap) = (0..round).into_par_iter().find_first(too_long) {
        return Err(gap);
    }
    let mut jumps = vec![0; round];
    let interrupt = Interrupt::current();
    // A batch of chunks at a time, so that progress is reported in order.
    let batch = 16 * CHUNK;
    for (index, part) in jumps.chunks_mut(batch).enumerate() {
        let chunks = part.par_chunks_mut(CHUNK).enumerate();
        chunks.for_each(|(chunk, jumps)| {
            interrupt.check();
            let first = index * batch + chunk * CHUNK;
            let mut to = first;
            for (from, jump) in (first..).zip(jumps) {
                // Most often one farther than from the position before.
                let found = arcs.farthest(condition, from, to + 1, from + round);
                to = found.unwrap_or(from + 1);
                *jump = to - from;
            }
        });
        progress((index * batch + part.len()).min(round));
    }
    Ok(jumps)
}

/// The first position from which the fewest jumps go round.
fn best_start(jumps: &[usize]) -> usize {
    let round = jumps.len();
    // Jumps in a row, no longer than a round.
    let then = |first: &[usize], second: &[usize]| -> Vec<usize> {
        let both = |(from, &jump): (usize, &usize)| {
            let at = from + jump;
            let at = if at >= round { at - round } else { at };
            (jump + second[at]).min(round)
        };
        first
            .par_iter()
            .enumerate()
            .map(|(from, jump)| both((from, jump)))
            .collect()
    };
    let goes_round = |jump: &[usize]| jump.par_iter().any(|&j| j >= round);
    let mut powers = vec![jumps.to_vec()];
    while let Some(last) = powers.last().filter(|last| !goes_round(last)) {
        powers.push(then(last, last));
    }
    // As many jumps as do not go round from anywhere; one more does from somewhere.
    let mut some = vec![0; round];
    for power in powers.iter().rev() {
        let more = then(&some, power);
        if !goes_round(&more) {
            some = more;
        }
    }
    let one_more = then(&some, jumps);
    one_more.iter().position(|&j| j >= round).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may panic")]

    use super::*;
    use curvecrust_curve::Curve;
    use curvecrust_medial_axis::{Discretisation, MeasureOptions, measure_with};

    #[test]
    fn no_start_needs_fewer() {
        let mut differ = 0;
        for d in [
            "M 0 0 C 30 -20 50 20 80 0 S 120 40 80 60 S 30 30 0 60 S -30 20 0 0 Z",
            "M 0 0 C 20 20 40 -20 60 0 S 90 30 60 40 S 20 30 0 40 S -20 -20 0 0 Z",
        ] {
            let curve = Curve::from_path_data(d).unwrap();
            let options = MeasureOptions {
                discretisation: Discretisation::Adaptive { gap_to_lfs: 0.05 },
                ..MeasureOptions::default()
            };
            let measured = measure_with(&curve, &options).unwrap();
            let arcs = &Arcs::of(&measured)[0];
            for b in [0.9, 0.7, 0.5, 0.4, 0.3, 0.25] {
                let limit = 0.002 * curve.extent();
                for condition in [Condition::rho(b).unwrap(), Condition::epsilon(b).unwrap()] {
                    for condition in [condition, condition.with_hausdorff_limit(limit).unwrap()] {
                        let from = |start| walk(arcs, condition, start).unwrap().len();
                        let counts = (0..arcs.len()).map(from);
                        let (least, most) = counts.fold((usize::MAX, 0), |(least, most), n| {
                            (least.min(n), most.max(n))
                        });
                        let found = positions(arcs, condition, &|_| ()).unwrap();
                        assert_eq!(found.len(), least, "{condition:?}");
                        differ += usize::from(least < most);
                    }
                }
            }
        }
        assert!(differ > 10, "{differ}");
    }

    /// In more than one batch: a jump that is longer by one does not hold.
    #[test]
    fn jumps_are_as_long_as_they_can_be() {
        let d = "M 0 0 C 30 -20 50 20 80 0 S 120 40 80 60 S 30 30 0 60 S -30 20 0 0 Z";
        let options = MeasureOptions {
            discretisation: Discretisation::PerSegment(9_000),
            ..MeasureOptions::default()
        };
        let measured = measure_with(&Curve::from_path_data(d).unwrap(), &options).unwrap();
        let arcs = &Arcs::of(&measured)[0];
        let round = arcs.len();
        assert!(round > 17 * CHUNK);
        let condition = Condition::rho(0.5).unwrap().with_hausdorff_limit(0.2);
        let condition = condition.unwrap();
        let heard = std::sync::Mutex::new(Vec::new());
        let jumps = jumps(arcs, condition, &|done| heard.lock().unwrap().push(done)).unwrap();
        assert_eq!(heard.into_inner().unwrap(), [16 * CHUNK, round]);
        for (from, &jump) in jumps.iter().enumerate().step_by(101) {
            assert!(arcs.holds(condition, from, from + jump));
            assert!(!arcs.holds(condition, from, from + jump + 1));
        }
    }

    /// By definition: the first of the starts from which the fewest jumps go round.
    #[test]
    fn the_best_start_is_the_first_with_the_fewest_jumps() {
        let mut random = curvecrust_geometry::Random::new(3);
        for round in (1..40).chain([200]) {
            for longest in [1.0, 3.0, 9.0, 60.0] {
                let jump = |_| {
                    (1..=round)
                        .filter(|_| random.fine_between(0.0, longest) < 1.0)
                        .count()
                        .max(1)
                };
                let jumps: Vec<usize> = (0..round).map(jump).collect();
                let count = |&start: &usize| {
                    let (mut far, mut count) = (0, 0);
                    while far < round {
                        far += jumps[(start + far) % round];
                        count += 1;
                    }
                    count
                };
                assert_eq!(
                    Some(best_start(&jumps)),
                    (0..round).min_by_key(count),
                    "{jumps:?}"
                );
            }
        }
    }
}
