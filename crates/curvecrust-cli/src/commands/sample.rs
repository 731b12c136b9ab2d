//! `curvecrust sample`: samples of curves, as sparse as a condition allows.

mod formats;
mod result;

use super::Outcome;
use super::condition::{Requirement, name_and_bound};
use super::curve_source::{CurveSource, touching};
use super::guarantee::{Guaranteed, open_curves};
use crate::args::{self, Algorithm, Count, Strokes};
use crate::console::Console;
use crate::format::Format;
use crate::output::{GEOMETRIES, Number, Results};
use anyhow::{Context, anyhow, bail};
use curvecrust::DVec2;
use curvecrust::curve::{Curve, SplitCurve};
use curvecrust::geometry::Progress;
use curvecrust::medial_axis::MeasuredCurve;
use curvecrust::reconstruct::{HnnCrust, LeastDetour, Reconstructor};
use curvecrust::sampling::{
    Condition, DecodeOptions, SampleOptions, Sampling, SamplingError, SplitOptions, VerifyOptions,
    decode, on_strokes, sample, sample_curve_with, sample_decoded_with, sample_fewest_with,
    sample_verified_with,
};

/// Which curves are sampled and how, and where the samples go.
#[derive(Debug)]
pub(crate) struct Job {
    curve: CurveSource,
    requirement: Requirement,
    strokes: Strokes,
    count: Count,
    decoder: Option<Algorithm>,
    results: Results,
}

impl Job {
    pub(crate) fn new(args: args::Sample) -> anyhow::Result<Self> {
        let formats = [GEOMETRIES, &[Format::Text, Format::Npy]].concat();
        let results = Results::new(args.output, args.json, &formats)?;
        let requirement = Requirement::new(&args.condition)?;
        let curve = CurveSource::from(args.curve);
        Ok(Self {
            curve,
            requirement: requirement.context("give either --rho or --epsilon")?,
            strokes: args.strokes,
            count: args.count,
            decoder: args.decoder,
            results,
        })
    }

    pub(crate) fn run(self, console: &Console) -> anyhow::Result<Outcome> {
        let split = self.curve.read(console)?;
        let (curve, sampled) = if self.curve.splits() {
            self.sample_strokes(split, console)?
        } else {
            self.sample_smooth(split.pieces().clone(), console)?
        };
        if let Some(output) = &self.results.output {
            result::write(output, &curve, &sampled)?;
        }
        self.results
            .print_json(|| result::object(&curve, &sampled))?;
        self.tell_of_ends(&sampled.sampling, console);
        let (name, bound) = name_and_bound(sampled.condition);
        let verified = if self.count == Count::Verified {
            ", fewer than the condition asks for: verified for this sample set only"
        } else {
            ""
        };
        console.note(format_args!(
            "{} samples for {name} < {bound}{verified}{}",
            sampled.sampling.samples.len(),
            sampled.ending
        ));
        Ok(Outcome::Fine)
    }

    /// Tells that ends of open curves are no matter of the theorems, and where they are written.
    fn tell_of_ends(&self, sampling: &Sampling, console: &Console) {
        let Some(curves) = open_curves(sampling.samples.components()) else {
            return;
        };
        let marks = [Format::Csv, Format::Json].map(|format| self.results.writes(format));
        let marked = if marks.contains(&true) || self.results.json {
            "; the ends are marked, for `reconstruct --termini-from`"
        } else {
            ""
        };
        console.note(format_args!("{}: {curves}{marked}", self.curve.name()));
    }

    /// Samples of all strokes together; where they touch, of what is left of them when they are cut
    /// there, or of each by itself.
    fn sample_strokes(
        &self,
        split: SplitCurve,
        console: &Console,
    ) -> anyhow::Result<(Curve, Sampled)> {
        let mut touch = None;
        if matches!(self.strokes, Strokes::Auto | Strokes::Together) {
            let together = self.sample_together(&split, console);
            touch = together.as_ref().err().and_then(touching);
            let may_part = self.strokes == Strokes::Auto && self.takes_pieces();
            if touch.is_none() || !may_part {
                return together;
            }
        }
        if self.strokes != Strokes::Apart {
            let cut = self.sample_cut(&split, console);
            if cut.is_ok() || self.strokes == Strokes::Cut {
                return cut;
            }
        }
        let apart = self.sample_pieces(&split.apart(), touch, console);
        apart.map_err(|error| match touching(&error) {
            Some(_) => anyhow!("{error:#}; a larger --snap leaves out spikes of drawing programs"),
            None => error,
        })
    }

    /// Samples of strokes that are cut where they touch.
    fn sample_cut(
        &self,
        split: &SplitCurve,
        console: &Console,
    ) -> anyhow::Result<(Curve, Sampled)> {
        let cut = self.curve.cut(split)?;
        let (curve, mut sampled) = self.sample_pieces(&cut.curve, None, console)?;
        if !cut.places.is_empty() {
            self.curve.tell_of_cuts(&cut, console);
            sampled.strokes = "cut";
            sampled.places = cut.places;
        }
        Ok((curve, sampled))
    }

    fn sample_together(
        &self,
        split: &SplitCurve,
        console: &Console,
    ) -> anyhow::Result<(Curve, Sampled)> {
        if split.corners().is_empty() {
            self.sample_smooth(split.pieces().clone(), console)
        } else {
            self.sample_pieces(split, None, console)
        }
    }

    /// Whether no option is given that pieces cannot be sampled with.
    fn takes_pieces(&self) -> bool {
        self.curve.discretisation().is_none()
    }

    /// Samples of every smooth piece, put together; what attains the bound is a piece. It tells
    /// where strokes touch that were to be together.
    fn sample_pieces(
        &self,
        split: &SplitCurve,
        touch: Option<DVec2>,
        console: &Console,
    ) -> anyhow::Result<(Curve, Sampled)> {
        let name = self.curve.name();
        if !self.takes_pieces() {
            bail!(
                "{name}: curves with corners, and strokes apart, cannot be sampled with --gap or \
                 --per-segment"
            );
        }
        if split.is_apart() && self.count == Count::Verified {
            bail!("{name}: strokes apart cannot be sampled with --count verified");
        }
        let condition = self.requirement.on(split.pieces())?;
        let decoder = self.decoder();
        let decoded = console.during("sampling", |progress| {
            let options = DecodeOptions {
                sampling: SplitOptions {
                    every_start: self.count != Count::Greedy,
                    progress: Progress::new(progress),
                },
                decoder,
            };
            sample_decoded_with(split, condition, &options)
        });
        let mut decoded = decoded.map_err(|error| self.curve.named(error))?;
        if self.count == Count::Verified {
            let start = on_strokes(split, &decoded.sampling).with_context(|| name.clone())?;
            let corners: Vec<DVec2> = split.corners().iter().map(|corner| corner.at).collect();
            let fewer = verified(&start, condition, decoder, &corners, console);
            decoded.sampling = fewer.with_context(|| name.clone())?;
            decoded.added = 0;
        }
        if let Some(DVec2 { x, y }) = touch {
            console.note(format_args!(
                "{}: strokes touch or cross near ({}, {}), so each is sampled as if it were alone; \
                 no reconstruction of all together is promised",
                name,
                Number(x),
                Number(y)
            ));
        }
        let corners = match split.corners().len() {
            0 => "",
            1 => "1 corner, which no theorem covers: ",
            count => &format!("{count} corners, which no theorem covers: "),
        };
        let polygon = match split.is_apart() {
            true => "the polygon of each stroke from its own samples",
            false => "the polygon of these samples",
        };
        let (decoder, added) = (decoder.info().name, decoded.added);
        let found = found(decoder, decoded.is_exact, added, polygon);
        console.note(format_args!("{corners}{found}"));
        let sampled = Sampled {
            condition,
            sampling: decoded.sampling,
            guaranteed: Guaranteed::of_run(decoded.is_exact),
            decoder,
            added,
            ending: String::new(),
            places: Vec::new(),
            strokes: if split.is_apart() {
                "apart"
            } else {
                "together"
            },
        };
        Ok((split.pieces().clone(), sampled))
    }

    /// Samples of smooth curves, at the dense points that were asked for or at as many as needed.
    fn sample_smooth(&self, curve: Curve, console: &Console) -> anyhow::Result<(Curve, Sampled)> {
        let condition = self.requirement.on(&curve)?;
        let measured = (self.curve.discretisation().is_some())
            .then(|| self.curve.measure(&curve, None, console))
            .transpose()?;
        let sampling = self.chosen(&curve, measured, condition, console);
        let sampling = sampling.map_err(|error| self.curve.named(error))?;
        let is_by_theorem = Guaranteed::is_by_theorem(&curve, condition);
        let sampled = if is_by_theorem && self.decoder.is_none() && self.count != Count::Verified {
            Sampled {
                condition,
                sampling,
                strokes: "together",
                places: Vec::new(),
                guaranteed: Guaranteed::Theorem,
                decoder: HnnCrust::MUTUAL.info().name,
                added: 0,
                ending: String::from("; HNN-Crust is proven to return exactly their polygon"),
            }
        } else {
            self.decoded(condition, sampling)
        };
        Ok((curve, sampled))
    }

    /// The samples that were asked for among all that satisfy the condition.
    fn chosen(
        &self,
        curve: &Curve,
        measured: Option<MeasuredCurve>,
        condition: Condition,
        console: &Console,
    ) -> anyhow::Result<Sampling> {
        let greedy = match measured {
            Some(measured) => sample(&measured, condition)?,
            None => console.during("sampling", |progress| {
                let progress = Progress::new(progress);
                sample_curve_with(curve, condition, &SampleOptions { progress })
            })?,
        };
        match self.count {
            Count::Greedy => Ok(greedy),
            Count::Fewest => Ok(console.during("sampling from every start", |progress| {
                let progress = Progress::new(progress);
                sample_fewest_with(&greedy.measured, condition, &SampleOptions { progress })
            })?),
            Count::Verified => {
                let fewer = verified(&greedy, condition, self.decoder(), &[], console);
                Ok(fewer?)
            }
        }
    }

    /// The algorithm that is run: the one asked for, else least detour, but HNN-Crust where it runs
    /// for every sample that may go.
    fn decoder(&self) -> Algorithm {
        self.decoder.unwrap_or(match self.count {
            Count::Verified => &HnnCrust::MUTUAL,
            Count::Fewest | Count::Greedy => &LeastDetour,
        })
    }

    /// Samples with more of them near the edges that an algorithm gets wrong; as they are, if they
    /// are to be as few as a verified sampling has.
    fn decoded(&self, condition: Condition, sampling: Sampling) -> Sampled {
        let decoder = self.decoder();
        let decoded = decode(sampling, decoder);
        let (decoder, added) = (decoder.info().name, decoded.added);
        let found = found(decoder, decoded.is_exact, added, "their polygon");
        Sampled {
            condition,
            sampling: decoded.sampling,
            strokes: "together",
            places: Vec::new(),
            guaranteed: Guaranteed::of_run(decoded.is_exact),
            decoder,
            added,
            ending: format!("; {found}"),
        }
    }
}

/// What a run of an algorithm has found, in words.
fn found(decoder: &str, is_exact: bool, added: usize, polygon: &str) -> String {
    let decoder = decoder.replace('-', " ");
    match (is_exact, added) {
        (true, 0) => format!("{decoder} returns exactly {polygon}"),
        (true, added) => {
            format!("{decoder} returns exactly {polygon}, {added} more than the condition asks for")
        }
        (false, _) => format!("{decoder} does not return {polygon}"),
    }
}

/// Samples, and the condition that they were taken for.
struct Sampled {
    condition: Condition,
    sampling: Sampling,
    /// `together`, `cut` or `apart`.
    strokes: &'static str,
    /// Where strokes touched that are cut.
    places: Vec<DVec2>,
    guaranteed: Guaranteed,
    decoder: &'static str,
    added: usize,
    /// How the last note ends; nothing where another one has said it.
    ending: String,
}

/// As few samples as an algorithm still returns, with those at some places.
fn verified(
    start: &Sampling,
    condition: Condition,
    algorithm: Algorithm,
    fixed: &[DVec2],
    console: &Console,
) -> Result<Sampling, SamplingError> {
    console.during("taking samples away", |progress| {
        let options = VerifyOptions {
            algorithm,
            fixed,
            progress: Progress::new(progress),
            ..VerifyOptions::of(condition)
        };
        sample_verified_with(start, &options)
    })
}
