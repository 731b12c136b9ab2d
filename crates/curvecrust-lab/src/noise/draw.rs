//! A picture of a fit: points, outliers, the truth in grey, the curves in red.

use std::fmt::Write;

use curvecrust::denoise::Fitted;
use curvecrust::geometry::DVec2;

use super::curves::{Truth, bounds};
use super::sample::Sample;

pub(super) fn picture(truth: &[Truth], sample: &Sample, fitted: &Fitted) -> String {
    let (low, high) = bounds(&sample.points);
    let scale = 600.0 / (high - low).max_element();
    let to = |p: DVec2| {
        let q = (p - low) * scale + DVec2::splat(20.0);
        (q.x, 640.0 - q.y)
    };
    let mut svg = String::from(
        "<svg xmlns='http://www.w3.org/2000/svg' width='640' height='640'>\n<rect width='640' height='640' fill='white'/>\n",
    );
    let mut line = |points: &[DVec2], closed: bool, style: &str| {
        let mut d = String::new();
        for (i, &p) in points.iter().enumerate() {
            let (x, y) = to(p);
            let _ = write!(d, "{}{x:.1} {y:.1} ", if i == 0 { "M" } else { "L" });
        }
        let end = if closed { "Z" } else { "" };
        let _ = writeln!(svg, "<path d='{d}{end}' fill='none' {style}/>");
    };
    for t in truth {
        line(&t.points, t.closed, "stroke='#bbb' stroke-width='5'");
    }
    for c in &fitted.curves {
        line(
            &c.polyline(0.1 / scale),
            c.closed,
            "stroke='#d00' stroke-width='1.5'",
        );
    }
    for (&p, place) in sample.points.iter().zip(&fitted.places) {
        let (x, y) = to(p);
        let colour = if place.is_some() { "#000" } else { "#28f" };
        let _ = writeln!(
            svg,
            "<circle cx='{x:.1}' cy='{y:.1}' r='1.6' fill='{colour}'/>"
        );
    }
    svg.push_str("</svg>\n");
    svg
}
