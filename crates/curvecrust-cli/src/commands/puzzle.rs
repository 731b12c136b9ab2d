//! `curvecrust puzzle`: connect-the-closest-dot puzzles of curves.

use super::Outcome;
use super::curve_source::CurveSource;
use crate::args::{self, Distance};
use crate::console::Console;
use crate::format::Format;
use crate::number::counted;
use crate::output::{Layer, Number, Picture, Results};
use curvecrust::DVec2;
use curvecrust::geometry::point_set::by_coordinates;
use curvecrust::geometry::{PointSet, Progress};
use curvecrust::reconstruct::closest_dot::{Dots, closest_dot};
use curvecrust::sampling::{PuzzleOptions, sample_puzzle};
use serde::Serialize;
use std::io::{self, Write};

/// The formats of a puzzle, the one of stdout first.
const FORMATS: &[Format] = &[Format::Svg, Format::Csv, Format::Json];

/// What `--json` prints; the schema is stable, and in `docs/formats.md`.
#[derive(Serialize)]
struct Object {
    count: usize,
    colours: usize,
    /// How many dots have more than one colour.
    several: usize,
    /// `null` where every dot has but one to choose.
    margin: Option<f64>,
    max_distance: f64,
    dots: Vec<DotObject>,
    /// The solution, by indices of dots.
    edges: Vec<[u32; 2]>,
}

#[derive(Serialize)]
struct DotObject {
    at: [f64; 2],
    colours: Vec<u32>,
}

/// Which curves become a puzzle and how, and where it goes.
#[derive(Debug)]
pub(crate) struct Job {
    curve: CurveSource,
    solved: bool,
    max_distance: Distance,
    margin: f64,
    least_step: f64,
    results: Results,
}

impl Job {
    pub(crate) fn new(args: args::Puzzle) -> anyhow::Result<Self> {
        Ok(Self {
            results: Results::new(args.output, args.json, FORMATS)?,
            curve: args.curve.into(),
            solved: args.solved,
            max_distance: args.max_distance,
            margin: args.margin,
            least_step: args.least_step,
        })
    }

    pub(crate) fn run(self, console: &Console) -> anyhow::Result<Outcome> {
        let split = self.curve.read(console)?;
        let strokes = self.curve.measure_strokes(split, |_| Ok(None), console)?;
        let corners = strokes.split.corners().iter().map(|corner| corner.at);
        let corners: Vec<DVec2> = corners.collect();
        let extent = strokes.split.pieces().extent();
        let max_distance = self.max_distance.of_extent(extent);
        let puzzle = console.during("choosing dots", |progress| {
            let options = PuzzleOptions {
                margin: self.margin,
                max_distance: Some(max_distance),
                least_step: self.least_step,
                fixed: &corners,
                progress: Progress::new(progress),
            };
            sample_puzzle(&strokes.measured, &options)
        });
        let puzzle = puzzle.map_err(|error| self.curve.named(error))?;
        let dots = shuffled(&puzzle.dots)?;
        let object = object(&dots, puzzle.margin(), max_distance);
        if let Some(output) = &self.results.output {
            match output.format {
                Format::Csv => output.write(|out| write_csv(out, &dots))?,
                Format::Json => output.write_json(&object)?,
                _ => output.write(|out| self.picture(&dots).write(out))?,
            }
        }
        self.results.print_json(|| Ok(&object))?;
        tell(&object, console);
        Ok(Outcome::Fine)
    }

    fn picture<'a>(&self, dots: &'a Dots) -> Picture<'a> {
        let lines = self.solved.then_some(Layer::Joins(dots));
        let layers = lines.into_iter().chain([Layer::Dots(dots)]);
        Picture {
            layers: layers.collect(),
        }
    }
}

/// The dots by coordinates, so that their order does not tell the curve.
fn shuffled(dots: &Dots) -> anyhow::Result<Dots> {
    let points = dots.points();
    let mut ids: Vec<_> = points.ids().collect();
    ids.sort_unstable_by(|&a, &b| by_coordinates(points[a], points[b]));
    let colours = ids.iter().map(|id| dots.colours()[id.index()].clone());
    let colours = colours.collect();
    let points = PointSet::new(ids.into_iter().map(|id| points[id]).collect())?;
    Ok(Dots::new(points, colours)?)
}

fn tell(object: &Object, console: &Console) {
    let dots = counted(object.count, "dot");
    let colours = counted(object.colours, "colour");
    let several = match object.several {
        0 => "",
        1 => ", 1 of them with two colours",
        several => &format!(", {several} of them with two colours"),
    };
    let margin = object.margin.map_or(String::new(), |margin| {
        let percent = (1000.0 * margin).floor() / 10.0;
        let percent = Number(percent);
        format!("; the second closest of a colour is at least {percent} % farther than the closest")
    });
    console.note(format_args!("{dots} in {colours}{several}{margin}"));
}

fn write_csv(out: &mut dyn Write, dots: &Dots) -> io::Result<()> {
    writeln!(out, "x,y,colours")?;
    for (p, colours) in dots.points().points().iter().zip(dots.colours()) {
        let colours: Vec<String> = colours.iter().map(ToString::to_string).collect();
        writeln!(out, "{},{},{}", Number(p.x), Number(p.y), colours.join(" "))?;
    }
    Ok(())
}

fn object(dots: &Dots, margin: f64, max_distance: f64) -> Object {
    let places = dots.points().points().iter().zip(dots.colours());
    let dot = |(p, colours): (&DVec2, &Vec<_>)| DotObject {
        at: p.to_array(),
        colours: colours.iter().map(|&colour| u32::from(colour)).collect(),
    };
    let edges = closest_dot(dots);
    let several = dots.colours().iter().filter(|colours| colours.len() > 1);
    Object {
        count: dots.points().len(),
        colours: dots.colour_count(),
        several: several.count(),
        margin: margin.is_finite().then_some(margin),
        max_distance,
        dots: places.map(dot).collect(),
        edges: edges
            .edges()
            .iter()
            .map(|edge| edge.ends().map(u32::from))
            .collect(),
    }
}
