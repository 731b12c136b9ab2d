//! Sampled splines as text: a line `spline` for each, then its control points and samples.

use crate::certificate::FormatError;
use crate::sampling::SampledSplines;
use crate::spline::ClosedSpline;
use std::fmt;
use std::str::FromStr;

/// What a line may be.
const EXPECTED: &str = "`spline`, `control X Y` or `sample SEGMENT PARAMETER`";

impl fmt::Display for SampledSplines {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (spline, samples) in self.splines.iter().zip(&self.samples) {
            writeln!(f, "spline")?;
            for [x, y] in &spline.control {
                writeln!(f, "control {x} {y}")?;
            }
            for (segment, parameter) in samples {
                writeln!(f, "sample {segment} {parameter}")?;
            }
        }
        Ok(())
    }
}

/// Each spline needs three control points and samples in order; numbers are finite.
impl FromStr for SampledSplines {
    type Err = FormatError;

    fn from_str(text: &str) -> Result<Self, FormatError> {
        let mut read = Self {
            splines: Vec::new(),
            samples: Vec::new(),
        };
        let mut end = 0;
        for (i, line) in text.lines().enumerate() {
            end = i + 1;
            let expected = EXPECTED;
            read.take(line).ok_or(FormatError {
                line: end,
                expected,
            })?;
        }
        let whole = read.splines.iter().zip(&read.samples).all(is_whole);
        let expected = "three control points of each spline, and samples in order";
        whole.then_some(read).ok_or(FormatError {
            line: end,
            expected,
        })
    }
}

impl SampledSplines {
    /// Takes in a line.
    fn take(&mut self, line: &str) -> Option<()> {
        let mut words = line.split(' ');
        let word = words.next()?;
        match word {
            "spline" => {
                self.samples.push(Vec::new());
                let control = Vec::new();
                self.splines.push(ClosedSpline { control });
            }
            "control" => {
                let mut number = || words.next()?.parse().ok().filter(|x: &f64| x.is_finite());
                let point = [number()?, number()?];
                self.splines.last_mut()?.control.push(point);
            }
            "sample" => {
                let sample = (words.next()?.parse().ok()?, words.next()?.parse().ok()?);
                self.samples.last_mut()?.push(sample);
            }
            _ => return None,
        }
        words.next().is_none().then_some(())
    }
}

fn is_whole((spline, samples): (&ClosedSpline, &Vec<(usize, f64)>)) -> bool {
    let inside = |(segment, at): &(usize, f64)| *segment < spline.len() && (0.0..1.0).contains(at);
    spline.len() >= 3
        && !samples.is_empty()
        && samples.iter().all(inside)
        && samples.is_sorted_by(|a, b| a < b)
}
