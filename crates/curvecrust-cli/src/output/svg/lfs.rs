//! A curve in the colours of its local feature size, on a logarithmic scale, with a legend.

use super::frame::{Frame, LEGEND};
use super::{Data, open};
use crate::output::Number;
use curvecrust::DVec2;
use curvecrust::medial_axis::MeasuredCurve;
use std::io::{self, Write};

/// From small to large, darker to lighter.
const RAMP: [[f64; 3]; 5] = [
    [68.0, 1.0, 84.0],
    [59.0, 82.0, 139.0],
    [33.0, 145.0, 140.0],
    [94.0, 201.0, 98.0],
    [222.0, 217.0, 25.0],
];
/// Shades from one colour of the ramp to the next; a stretch of one shade is one path.
const STEPS: u8 = 8;
/// The lightest shade.
const LIGHTEST: u8 = 4 * STEPS;

/// Writes an open group.
pub(super) fn write(
    out: &mut dyn Write,
    measured: &MeasuredCurve,
    frame: &Frame,
) -> io::Result<()> {
    let dense = measured.dense();
    let finite = || {
        measured
            .lfs()
            .values()
            .iter()
            .copied()
            .filter(|v| v.is_finite())
    };
    let low = finite().fold(f64::INFINITY, f64::min);
    let high = finite().fold(0.0, f64::max);
    let shade = |i: usize| {
        let share = (measured.lfs().at(i) / low).ln() / (high / low).ln();
        // Constant and infinite ones have no place on the scale.
        let share = if share.is_nan() { 0.5 } else { share };
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "clamped to the shades"
        )]
        let shade = (share * f64::from(LIGHTEST))
            .round()
            .clamp(0.0, f64::from(LIGHTEST)) as u8;
        shade
    };
    open(out, "lfs", "none", 6.0 * frame.pixel)?;
    for component in dense.components() {
        let mut start = component.range.start;
        let mut stretch: Vec<DVec2> = Vec::new();
        for i in component.range.clone() {
            stretch.push(dense.points()[i]);
            let next = dense.next(i);
            let goes_on = next.is_some_and(|next| next > i && shade(next) == shade(start));
            if !goes_on {
                // Up to the next point, so that there is no gap.
                stretch.extend(next.map(|next| dense.points()[next]));
                let colour = colour(shade(start));
                writeln!(
                    out,
                    r#"<path stroke="{colour}" d="{}"/>"#,
                    Data(stretch.iter().copied(), false)
                )?;
                stretch.clear();
                start = i + 1;
            }
        }
    }
    writeln!(out, "</g>")?;
    legend(out, frame, low, high)
}

/// A bar of colours at the bottom, with the least and the largest value.
fn legend(out: &mut dyn Write, frame: &Frame, low: f64, high: f64) -> io::Result<()> {
    let Frame { extent, pixel, .. } = *frame;
    let width = (0.4 * extent.x).min(300.0 * pixel);
    let left = frame.low.x + 0.5 * (extent.x - width);
    let top = frame.low.y + extent.y - LEGEND * pixel;
    writeln!(out, r#"<defs><linearGradient id="ramp">"#)?;
    for shade in (0..=LIGHTEST).step_by(STEPS.into()) {
        let share = f64::from(shade) / f64::from(LIGHTEST);
        writeln!(
            out,
            r#"<stop offset="{share}" stop-color="{}"/>"#,
            colour(shade)
        )?;
    }
    writeln!(out, "</linearGradient></defs>")?;
    writeln!(
        out,
        r##"<g id="legend" font-family="sans-serif" font-size="{}" fill="#222">"##,
        Number(16.0 * pixel)
    )?;
    writeln!(
        out,
        r#"<rect x="{}" y="{}" width="{}" height="{}" fill="url(#ramp)"/>"#,
        Number(left),
        Number(top),
        Number(width),
        Number(12.0 * pixel)
    )?;
    let ends = [(left, "start", low), (left + width, "end", high)];
    for (x, anchor, value) in ends {
        writeln!(
            out,
            r#"<text x="{}" y="{}" text-anchor="{anchor}">lfs {}</text>"#,
            Number(x),
            Number(top + 30.0 * pixel),
            rounded(value)
        )?;
    }
    Ok(())
}

/// Three digits of a number.
fn rounded(value: f64) -> Number {
    Number(format!("{value:.2e}").parse().unwrap_or(value))
}

fn colour(shade: u8) -> String {
    let below = usize::from(shade / STEPS).min(RAMP.len() - 2);
    let part = f64::from(shade) / f64::from(STEPS) - below as f64;
    let [r, g, b] = std::array::from_fn(|channel| {
        let (from, to) = (RAMP[below][channel], RAMP[below + 1][channel]);
        (from + (to - from) * part).round()
    });
    format!("rgb({r},{g},{b})")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shades_go_along_the_ramp() {
        let rgb = |[r, g, b]: [f64; 3]| format!("rgb({r},{g},{b})");
        for (i, at) in (0..=LIGHTEST).step_by(STEPS.into()).enumerate() {
            assert_eq!(colour(at), rgb(RAMP[i]));
        }
        // Half way: (68 + 59) / 2 and so on.
        assert_eq!(colour(STEPS / 2), "rgb(64,42,112)");
    }
}
