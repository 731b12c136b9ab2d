//! `curvecrust fit`: smooth curves of points that scatter about them.

mod result;

use super::bare_points::{BarePoints, PointSource};
use super::{Outcome, reconstruct};
use crate::args;
use crate::console::Console;
use crate::format::Format;
use crate::output::{GEOMETRIES, Layer, Output, Picture, Results};
use anyhow::ensure;
use curvecrust::denoise::{Fitted, Options, denoise_with};
use result::{Found, Lines, Summary};

/// By default lines are within this share of the deviation of the points from their curve.
const TOLERANCE: f64 = 0.05;

/// Which points curves are fitted to, what is known about these, and where they go.
#[derive(Debug)]
pub(crate) struct Job {
    points: PointSource,
    options: Options,
    /// How far lines may be from the curves.
    tolerance: Option<f64>,
    inliers: Option<Output>,
    results: Results,
}

impl Job {
    pub(crate) fn new(args: args::Fit) -> anyhow::Result<Self> {
        if let Some(tolerance) = args.tolerance {
            ensure!(
                tolerance > 0.0 && tolerance.is_finite(),
                "--tolerance is {tolerance}: give a finite length above 0"
            );
        }
        let force = args.output.force;
        let inliers = args
            .inliers
            .map(|path| Output::new(Some(path), Some(Format::Csv), force, &[Format::Csv]));
        Ok(Self {
            results: Results::new(args.output, args.json, GEOMETRIES)?,
            points: args.points.into(),
            options: args.known.into(),
            tolerance: args.tolerance,
            inliers: inliers.transpose()?,
        })
    }

    pub(crate) fn run(self, console: &Console) -> anyhow::Result<Outcome> {
        let bare = self.points.read(console)?;
        let fitted = console.during("fitting", |_| denoise_with(&bare.points, &self.options))?;
        let found = Found {
            bare: &bare,
            fitted: &fitted,
        };
        console.during("writing", |_| self.write(&found))?;
        if let Some(note) = self.results.leaves_out(bare.system.as_ref()) {
            console.note(note);
        }
        console.note(Summary(&found));
        Ok(Outcome::Fine)
    }

    fn write(&self, found: &Found<'_>) -> anyhow::Result<()> {
        if let Some(output) = &self.results.output {
            self.write_curves(output, found)?;
        }
        if let Some(inliers) = &self.inliers {
            inliers.write(|out| found.write_inliers(out))?;
        }
        self.results.print_json(|| Ok(found))
    }

    fn write_curves(&self, output: &Output, found: &Found<'_>) -> anyhow::Result<()> {
        match (output.format, &found.fitted.edges) {
            (Format::Json, _) => output.write_json(found),
            // Points that lie on their curves are what `reconstruct` is for.
            (_, Some(edges)) => reconstruct::write_edges(output, found.bare, edges.clone()),
            (Format::Svg, None) => {
                let layers = layers(found.bare, found.fitted);
                output.write(|out| Picture { layers }.write(out))
            }
            (format, None) => {
                let usual = TOLERANCE * found.fitted.sigma();
                let lines = Lines::new(found.fitted, self.tolerance.unwrap_or(usual))?;
                if format == Format::Csv {
                    output.write(|out| lines.write_csv(out))
                } else {
                    let system = found.bare.system.as_ref();
                    output.write_features(lines.features(&lines.rings()), system)
                }
            }
        }
    }
}

/// The curves with their band, over the points.
pub(crate) fn layers<'a>(bare: &'a BarePoints, fitted: &'a Fitted) -> Vec<Layer<'a>> {
    vec![
        Layer::FittedPoints(&bare.points, fitted),
        Layer::Fitted(fitted),
    ]
}
