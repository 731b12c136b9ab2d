//! The axes of charts: ranges, ticks and how values are written.

/// One axis of a chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// What it measures, with its unit.
    pub label: String,
    /// Equal steps or equal factors.
    pub scale: Scale,
    /// From and to; `None` for what the lines need.
    pub range: Option<[f64; 2]>,
    /// Whether values are shares, to be shown in per cent.
    pub format: Format,
}

/// How values are placed along an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// In proportion to their difference.
    Linear,
    /// In proportion to their ratio.
    Log,
}

/// How values at an axis are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// As numbers.
    Plain,
    /// As hundredths.
    Percent,
}

impl Axis {
    /// What the lines need, or what was asked for; never empty.
    pub(crate) fn range(&self, values: impl Iterator<Item = [f64; 2]>) -> [f64; 2] {
        if let Some(range) = self.range {
            return range;
        }
        let values = values.flatten().filter(|v| self.shows(*v));
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| {
            (l.min(v), h.max(v))
        });
        match self.scale {
            _ if low > high => [1.0, 10.0],
            Scale::Log => [low / 1.15, high * 1.15],
            Scale::Linear if low >= high => [low - 0.5, high + 0.5],
            Scale::Linear => {
                // From zero, unless that would waste half of the chart.
                let low = if low > 0.0 && low < 0.5 * high {
                    0.0
                } else {
                    low
                };
                [low, high]
            }
        }
    }

    pub(crate) fn shows(&self, value: f64) -> bool {
        value.is_finite() && (self.scale == Scale::Linear || value > 0.0)
    }

    /// The place of a value of the range between two pixels.
    pub(crate) fn place(&self, value: f64, [low, high]: [f64; 2], [from, to]: [f64; 2]) -> f64 {
        let share = match self.scale {
            Scale::Linear => (value - low) / (high - low),
            Scale::Log => (value.max(low) / low).ln() / (high / low).ln(),
        };
        from + (to - from) * share.clamp(0.0, 1.0)
    }

    /// Round values in a range, about as many as wanted.
    pub(crate) fn ticks(&self, [low, high]: [f64; 2], wanted: f64) -> Vec<f64> {
        let in_range = |v: &f64| *v >= low * (1.0 - 1e-9) && *v <= high + (high - low) * 1e-9;
        if self.scale == Scale::Log {
            let decades = |digits: &'static [f64], every: i32| {
                (-30..30)
                    .filter(move |e| e % every == 0)
                    .flat_map(move |e| digits.iter().map(move |d| d * 10f64.powi(e)))
                    .filter(in_range)
                    .collect::<Vec<_>>()
            };
            let choices = [
                decades(&[1.0, 2.0, 5.0], 1),
                decades(&[1.0], 1),
                decades(&[1.0], 2),
                decades(&[1.0], 3),
            ];
            let fits = |ticks: &&Vec<f64>| ticks.len() as f64 <= wanted.max(2.0) + 1.0;
            return choices.iter().find(fits).unwrap_or(&choices[3]).clone();
        }
        let rough = (high - low) / wanted.max(1.0);
        let power = 10f64.powf(rough.log10().floor());
        let steps = [1.0, 2.0, 5.0, 10.0].map(|s| s * power);
        let step = steps
            .into_iter()
            .find(|s| *s >= rough * 0.999)
            .unwrap_or(steps[3]);
        let first = (low / step - 1e-9).ceil();
        (0..100)
            .map(|i| (first + f64::from(i)) * step)
            .take_while(|v| *v <= high + step * 1e-9)
            .collect()
    }

    pub(crate) fn written(&self, value: f64) -> String {
        let rounded = |v: f64| format!("{v:.5e}").parse::<f64>().unwrap_or(v) + 0.0;
        match self.format {
            Format::Percent => format!("{} %", rounded(100.0 * value)),
            Format::Plain if value.abs() >= 1e4 || (value != 0.0 && value.abs() < 1e-3) => {
                // As a power of ten.
                let text = format!("{value:.0e}");
                match text.split_once('e') {
                    Some(("1", exponent)) => format!("10{}", superscript(exponent)),
                    Some((digit, exponent)) => format!("{digit}·10{}", superscript(exponent)),
                    None => text,
                }
            }
            Format::Plain => rounded(value).to_string(),
        }
    }
}

fn superscript(exponent: &str) -> String {
    let digits: Vec<char> = "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().collect();
    let digit = |c: char| digits.get(c.to_digit(10)? as usize).copied();
    let small = |c: char| digit(c).unwrap_or('⁻');
    exponent.chars().map(small).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round() {
        let axis = |scale| Axis {
            label: String::new(),
            scale,
            range: None,
            format: Format::Plain,
        };
        let linear = axis(Scale::Linear);
        let written = |axis: &Axis, range, n| {
            let ticks = axis.ticks(range, n);
            ticks
                .iter()
                .map(|&v| axis.written(v))
                .collect::<Vec<_>>()
                .join(" ")
        };
        assert_eq!(written(&linear, [0.1, 1.0], 5.0), "0.2 0.4 0.6 0.8 1");
        assert_eq!(written(&linear, [15.0, 120.0], 6.0), "20 40 60 80 100 120");
        let log = axis(Scale::Log);
        assert_eq!(written(&log, [900.0, 1.1e7], 8.0), "1000 10⁴ 10⁵ 10⁶ 10⁷");
        assert_eq!(written(&log, [0.9, 12.0], 5.0), "1 2 5 10");
        assert_eq!(written(&log, [1e-6, 10.0], 4.0), "10⁻⁶ 10⁻⁴ 0.01 1");
    }
}
