//! Connect-the-closest-dot puzzles: dots of a curve, in colours by which they are joined.
//!
//! M. Löffler, M. Kaiser, T. van Kapel, G. Klappe, M. van Kreveld, F. Staals, *The
//! Connect-The-Dots Family of Puzzles: Design and Automatic Generation*, SIGGRAPH 2014.
//!
//! The solver joins each dot, for each of its colours, with the closest other dot of this colour
//! ([`mod@curvecrust_reconstruct::closest_dot`]). The encoder walks along each curve. The next dot
//! is as far as the curve allows and the solver would still join it in some colour, with a margin;
//! a new colour comes where none fits. In one colour, steps may get shorter and then longer again.
//! So a dot has one colour along such a run, and two where the next run begins.
//!
//! Each edge is added only if the solver joins all dots so far as before, and a new colour joins
//! any two dots: so the encoder gets to the end of every curve. The solver is run at last.
//!
//! A sampling condition asks for no colours, but for more dots: `docs/results/puzzles.md` of this
//! project counts both.
//!
//! Cost: for n dense points and c colours about c n questions to an R-tree.

mod colours;

use curvecrust_geometry::{DVec2, Progress};
use curvecrust_medial_axis::MeasuredCurve;
use curvecrust_reconstruct::closest_dot::{Colour, Dots, closest_dot, joins};

use crate::arcs::{Arcs, farthest};
use crate::condition::DeviationLimit;
use crate::error::SamplingError;
use crate::sampled_curve::SampledCurve;
use crate::sampling::Sampling;

use colours::{Colours, Dot};

/// How [`sample_puzzle`] chooses dots.
#[derive(Clone, Copy, Debug)]
pub struct PuzzleOptions<'a> {
    /// By what share the second closest dot of a colour is to be farther than the closest: 0.1 by
    /// default, above 0 and at most 1.
    pub margin: f64,
    /// No point of the curve is farther than this from the line through its two dots; by default
    /// nothing but that it is nearer than lfs, which holds in any case.
    pub max_distance: Option<f64>,
    /// A new colour comes where all others would make the step shorter than this share of what the
    /// curve allows: 0.5 by default, above 0 and at most 1. The larger, the more colours and the
    /// fewer dots.
    pub least_step: f64,
    /// Places that are dots, such as corners; none by default.
    pub fixed: &'a [DVec2],
    /// Hears how many dense points are done, of how many.
    pub progress: Progress<'a>,
}

impl Default for PuzzleOptions<'_> {
    fn default() -> Self {
        Self {
            margin: 0.1,
            max_distance: None,
            least_step: 0.5,
            fixed: &[],
            progress: Progress::default(),
        }
    }
}

/// Dots that the solver joins to exactly the manifold boundary of the samples.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Puzzle {
    /// The dots as samples, in the order of the curve.
    pub sampling: Sampling,
    /// The dots with their colours, in the same order; colours are numbered from 0.
    pub dots: Dots,
}

impl Puzzle {
    /// The least [margin](curvecrust_reconstruct::closest_dot::Join::margin) of all choices;
    /// infinite where every dot has but one to choose.
    #[must_use]
    pub fn margin(&self) -> f64 {
        let margins = joins(&self.dots).into_iter().map(|join| join.margin());
        margins.fold(f64::INFINITY, f64::min)
    }
}

/// Makes a connect-the-closest-dot puzzle of a curve.
///
/// Closed components have three dots or more, open ones a dot at either end. The result is the same
/// on every run. Between two dots, the curve is nearer to the chord than lfs, so that the solved
/// puzzle can be deformed into the curve without touching the medial axis.
///
/// # Errors
/// [`Parameter`](SamplingError::Parameter) if an option is out of its range,
/// [`TooCoarse`](SamplingError::TooCoarse) if the limit is smaller than dense points can show,
/// [`Points`](SamplingError::Points) if two dots are at one place,
/// [`NotSolved`](SamplingError::NotSolved) if the margin is so small that rounding decides.
///
/// ```
/// use curvecrust_curve::Curve;
/// use curvecrust_medial_axis::measure;
/// use curvecrust_reconstruct::closest_dot;
/// use curvecrust_sampling::{PuzzleOptions, sample_puzzle};
///
/// let d = "M 0 0 C 30 -20 50 20 80 0 S 120 40 80 60 S 30 30 0 60 S -30 20 0 0 Z";
/// let measured = measure(&Curve::from_path_data(d)?)?;
/// let puzzle = sample_puzzle(&measured, &PuzzleOptions::default())?;
/// assert!(puzzle.margin() >= 0.1);
/// assert_eq!(closest_dot(&puzzle.dots), puzzle.sampling.samples.manifold_boundary());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn sample_puzzle(
    measured: &MeasuredCurve,
    options: &PuzzleOptions<'_>,
) -> Result<Puzzle, SamplingError> {
    check(options)?;
    let arcs = Arcs::of(measured);
    let mut encoder = Encoder::new(measured, options);
    for arcs in &arcs {
        encoder.walk(arcs)?;
    }
    let Encoder { sets, samples, .. } = encoder;
    // There are as many sets as points.
    let dots = Dots::new(samples.point_set()?, sets).unwrap_or_default();
    let truth = samples.manifold_boundary();
    let found = closest_dot(&dots);
    let mut wrong = truth.difference(&found).chain(found.difference(&truth));
    if let Some(edge) = wrong.next() {
        return Err(SamplingError::NotSolved {
            at: samples.points()[edge.a().index()],
            margin: options.margin,
        });
    }
    Ok(Puzzle {
        sampling: Sampling::new(measured, &arcs, samples, None),
        dots,
    })
}

fn check(options: &PuzzleOptions<'_>) -> Result<(), SamplingError> {
    let share = "above 0 and at most 1";
    for (name, value) in [
        ("the margin", options.margin),
        ("the least step", options.least_step),
    ] {
        if !(value > 0.0 && value <= 1.0) {
            let range = share;
            return Err(SamplingError::Parameter { name, value, range });
        }
    }
    match options.max_distance {
        Some(value) if !(value > 0.0 && value.is_finite()) => Err(SamplingError::Parameter {
            name: "the largest distance",
            value,
            range: "a length above 0",
        }),
        _ => Ok(()),
    }
}

/// Dots and colours so far.
struct Encoder<'a> {
    measured: &'a MeasuredCurve,
    options: &'a PuzzleOptions<'a>,
    /// Dense points that are dots, ascending.
    fixed: Vec<usize>,
    colours: Colours,
    /// The colours of each dot.
    sets: Vec<Vec<Colour>>,
    samples: SampledCurve,
}

/// Where the walk along a component is.
struct Step {
    /// The position of the last dot, and that dot.
    from: usize,
    dot: Dot,
    /// The colour of the edge to it.
    colour: Option<usize>,
    /// How far the next dot may be.
    far: usize,
    /// The dot that is there already, where a closed component ends.
    closing: Option<Dot>,
}

impl<'a> Encoder<'a> {
    fn new(measured: &'a MeasuredCurve, options: &'a PuzzleOptions<'a>) -> Self {
        let points = measured.dense().points();
        let is_fixed = |&i: &usize| options.fixed.contains(&points[i]);
        Self {
            fixed: (0..points.len()).filter(is_fixed).collect(),
            measured,
            options,
            colours: Colours::new(options.margin),
            sets: Vec::new(),
            samples: SampledCurve::default(),
        }
    }

    /// Makes the dots of one component.
    fn walk(&mut self, arcs: &Arcs<'_>) -> Result<(), SamplingError> {
        let component = &arcs.component;
        if component.is_empty() {
            return Ok(());
        }
        let stops = self.stops(arcs);
        let (start, end) = (stops[0], stops[0] + arcs.len());
        let first = self.dot(arcs.point(start));
        let mut positions = vec![start];
        let mut step = Step {
            from: start,
            dot: first,
            colour: None,
            far: start,
            closing: None,
        };
        while step.from < end {
            let next = stops.partition_point(|&stop| stop <= step.from);
            let stop = stops.get(next).map_or(end, |&stop| stop.min(end));
            step.far = self.farthest(arcs, step.from, stop)?;
            step.closing = (component.closed && step.far == end).then_some(first);
            let (to, colour) = self.choose(arcs, &step, step.far == stop);
            let dot = match step.closing {
                Some(dot) => dot,
                None => {
                    positions.push(to);
                    self.dot(arcs.point(to))
                }
            };
            self.join(colour, [step.dot, dot]);
            step = Step {
                from: to,
                dot,
                colour: Some(colour),
                ..step
            };
            let done = component.range.start + to.min(end) - start;
            self.options
                .progress
                .report(done, self.measured.dense().points().len());
        }
        let indices = positions
            .into_iter()
            .map(|at| component.after(component.range.start, at));
        let dense = self.measured.dense();
        self.samples
            .push_component(dense, indices, component.closed);
        Ok(())
    }

    /// The positions that are dots in any case, ascending, the first of which is where to start.
    fn stops(&self, arcs: &Arcs<'_>) -> Vec<usize> {
        let range = &arcs.component.range;
        let fixed = self.fixed.iter().filter(|i| range.contains(i));
        let mut stops: Vec<usize> = fixed.map(|i| i - range.start).collect();
        if !arcs.component.closed || stops.is_empty() {
            stops.insert(0, 0);
            stops.dedup();
        }
        stops
    }

    /// A new dot.
    fn dot(&mut self, at: DVec2) -> Dot {
        self.sets.push(Vec::new());
        Dot {
            index: self.sets.len() - 1,
            at,
        }
    }

    /// The farthest position, at most `stop`, at which the next dot may be for the curve's sake.
    fn farthest(&self, arcs: &Arcs<'_>, from: usize, stop: usize) -> Result<usize, SamplingError> {
        // Three dots at least.
        let most = match arcs.component.closed {
            true => stop.min(from + arcs.len().div_ceil(3)),
            false => stop,
        };
        let keeps = |to| self.keeps(arcs, from, to);
        let far = farthest(from + 1, from + 1, most, keeps);
        let far = far.ok_or_else(|| SamplingError::TooCoarse {
            index: arcs.component.after(arcs.component.range.start, from),
            at: arcs.point(from),
            gap: arcs.point(from).distance(arcs.point(from + 1)),
            lfs: arcs.lfs(from).min(arcs.lfs(from + 1)),
        })?;
        // What is left for the last step is no sliver.
        let (step, left) = (far - from, stop - far);
        let shared = from + (3 * (step + left)).div_ceil(5);
        let is_sliver = 0 < left && 2 * left < step;
        Ok(if is_sliver && self.keeps(arcs, from, shared) {
            shared
        } else {
            far
        })
    }

    /// Whether the curve between two positions is near enough to its chord.
    fn keeps(&self, arcs: &Arcs<'_>, from: usize, to: usize) -> bool {
        let length = self.options.max_distance.map(DeviationLimit::Length);
        arcs.keeps(DeviationLimit::OfLfs(1.0), from, to)
            && length.is_none_or(|limit| arcs.keeps(limit, from, to))
    }

    /// The next position, and the colour of the edge to it, which fits. With `all`, no other
    /// position will do than the farthest.
    fn choose(&mut self, arcs: &Arcs<'_>, step: &Step, all: bool) -> (usize, usize) {
        let share = if all { 1.0 } else { self.options.least_step };
        let least = share * (step.far - step.from) as f64;
        let others = (0..self.colours.len()).filter(|&colour| Some(colour) != step.colour);
        let mut best = None;
        for colour in step.colour.into_iter().chain(others) {
            let nearest = best.map_or(step.from, |(to, _)| to) + 1;
            let fits = |to: &usize| {
                let next = step.closing.unwrap_or(Dot {
                    index: usize::MAX,
                    at: arcs.point(*to),
                });
                // A shorter interval may be farther from its chord.
                self.colours.fits(colour, [step.dot, next]) && self.keeps(arcs, step.from, *to)
            };
            let ahead = (nearest..=step.far).rev();
            let mut ahead = ahead.take_while(|to| (to - step.from) as f64 >= least);
            if let Some(to) = ahead.find(fits) {
                best = Some((to, colour));
            }
        }
        best.unwrap_or_else(|| (step.far, self.colours.add()))
    }

    /// Joins two dots in a colour in which they fit.
    fn join(&mut self, colour: usize, ends: [Dot; 2]) {
        self.colours.join(colour, ends);
        let Ok(number) = u32::try_from(colour) else {
            return;
        };
        for end in ends {
            self.sets[end.index].push(Colour::from(number));
        }
    }
}
