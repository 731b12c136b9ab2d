//! Edges told apart by why they are there.

use super::{Data, Number};
use curvecrust::DVec2;
use curvecrust::geometry::{PointId, PointSet};
use curvecrust::reconstruct::{Explanation, Reason};
use std::io::{self, Write};

/// Reasons by colour and by width; what was rejected at open ends is dotted.
///
/// The group of all edges stays open for the layer to close.
pub(super) fn write(
    out: &mut dyn Write,
    points: &PointSet,
    explanation: &Explanation,
    pixel: f64,
) -> io::Result<()> {
    let pair = |ends: [PointId; 2]| ends.map(|id| points[id]);
    writeln!(
        out,
        r#"<g id="why" fill="none" stroke-linejoin="round" stroke-linecap="round">"#
    )?;
    for (reason, colour, width) in [
        (Reason::Certified, "#b3150d", 2.0),
        (Reason::Completed, "#3d85d0", 3.5),
        (Reason::Exchanged, "#e07b00", 5.0),
        (Reason::Required, "#2c8a3d", 5.0),
    ] {
        let edges = explanation.edges.iter().filter(|e| e.reason == reason);
        let style = format!(
            r#"stroke="{colour}" stroke-width="{}""#,
            Number(width * pixel)
        );
        lines(
            out,
            reason.name(),
            &style,
            edges.map(|e| pair(e.edge.ends())),
        )?;
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
    lines(out, "rejected", &style, rejected)
}

/// Segments as one path, if there are any.
fn lines(
    out: &mut dyn Write,
    id: &str,
    style: &str,
    segments: impl Iterator<Item = [DVec2; 2]>,
) -> io::Result<()> {
    let data: Vec<String> = segments
        .map(|ends| Data(ends.into_iter(), false).to_string())
        .collect();
    if data.is_empty() {
        return Ok(());
    }
    writeln!(out, r#"<path id="{id}" {style} d="{}"/>"#, data.join(" "))
}
