//! Edges in colours that show the reasons for them.

use super::frame::{Frame, LEGEND};
use super::{Data, Number};
use curvecrust::DVec2;
use curvecrust::geometry::{PointId, PointSet};
use curvecrust::reconstruct::{Explanation, Reason};
use std::io::{self, Write};

/// Reasons by colour and by width, none of them the colour of the axis.
const STYLES: [(Reason, &str, f64); 4] = [
    (Reason::Certified, "#b3150d", 2.0),
    (Reason::Completed, "#7b3fa6", 3.5),
    (Reason::Exchanged, "#e07b00", 5.0),
    (Reason::Required, "#2c8a3d", 5.0),
];

/// Reasons by colour and by width, with a legend; what was rejected at open ends is dotted.
///
/// The group of the legend stays open for the layer to close.
pub(super) fn write(
    out: &mut dyn Write,
    points: &PointSet,
    explanation: &Explanation,
    frame: &Frame,
) -> io::Result<()> {
    let pixel = frame.pixel;
    let mut shown = Vec::new();
    let pair = |ends: [PointId; 2]| ends.map(|id| points[id]);
    writeln!(
        out,
        r#"<g id="why" fill="none" stroke-linejoin="round" stroke-linecap="round">"#
    )?;
    for (reason, colour, width) in STYLES {
        let edges = explanation.edges.iter().filter(|e| e.reason == reason);
        let style = format!(
            r#"stroke="{colour}" stroke-width="{}""#,
            Number(width * pixel)
        );
        let edges = edges.map(|e| pair(e.edge.ends()));
        if lines(out, reason.name(), &style, edges)? {
            shown.push((reason.name(), style));
        }
    }
    let rejected = explanation.free_ends.iter().filter_map(|end| {
        let rejected = end.rejected?;
        Some(pair([end.point, rejected.partner]))
    });
    let style = format!(
        r##"stroke="#777" stroke-width="{}" stroke-dasharray="0 {}""##,
        Number(2.0 * pixel),
        Number(5.0 * pixel),
    );
    if lines(out, "rejected", &style, rejected)? {
        shown.push(("rejected", style));
    }
    writeln!(out, "</g>")?;
    legend(out, frame, &shown)
}

/// A line and a word for each reason that there is, side by side under the data.
fn legend(out: &mut dyn Write, frame: &Frame, shown: &[(&str, String)]) -> io::Result<()> {
    let Frame {
        low, extent, pixel, ..
    } = *frame;
    writeln!(
        out,
        r##"<g id="reasons" font-family="sans-serif" font-size="{}" fill="#222">"##,
        Number(14.0 * pixel)
    )?;
    let y = low.y + extent.y - (f64::from(frame.legends) * LEGEND - 16.0) * pixel;
    let step = extent.x / (shown.len() as f64 + 0.5);
    let mut x = low.x + 0.25 * step;
    for (name, style) in shown {
        let line = [DVec2::new(x, y), DVec2::new(x + 24.0 * pixel, y)];
        // Of the class of the edges, which has their colour on a dark page.
        let line = Data(line.into_iter(), false);
        writeln!(out, r#"<path class="{name}" {style} d="{line}"/>"#)?;
        writeln!(
            out,
            r#"<text x="{}" y="{}">{name}</text>"#,
            Number(x + 30.0 * pixel),
            Number(y + 5.0 * pixel)
        )?;
        x += step;
    }
    Ok(())
}

/// Segments as one path, if there are any; whether there are.
fn lines(
    out: &mut dyn Write,
    id: &str,
    style: &str,
    segments: impl Iterator<Item = [DVec2; 2]>,
) -> io::Result<bool> {
    let data: Vec<String> = segments
        .map(|ends| Data(ends.into_iter(), false).to_string())
        .collect();
    if data.is_empty() {
        return Ok(false);
    }
    let data = data.join(" ");
    writeln!(out, r#"<path id="{id}" class="{id}" {style} d="{data}"/>"#)?;
    Ok(true)
}
