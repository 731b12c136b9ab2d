//! Fitted curves, how sure they are, and the points they were fitted to.

use super::{CubicData, Data, Number, open, point_radius};
use curvecrust::DVec2;
use curvecrust::denoise::{Fitted, FittedCurve};
use curvecrust::geometry::PointSet;
use std::io::{self, Write};

/// How many standard errors the band is wide on each side: 19 of 20 places of the curve that the
/// points come from lie in it.
const WIDTH: f64 = 2.0;

/// The curves over their bands.
///
/// The last group stays open for the layer to close.
pub(super) fn curves(out: &mut dyn Write, fitted: &Fitted, pixel: f64) -> io::Result<()> {
    writeln!(
        out,
        r##"<g id="band" fill="#b3150d" fill-opacity="0.2" fill-rule="evenodd">"##
    )?;
    for curve in fitted.curves.iter().filter(|_| !fitted.is_clean()) {
        let [left, right] = sides(curve);
        if curve.closed {
            let (left, right) = (Data(left.into_iter(), true), Data(right.into_iter(), true));
            writeln!(out, r#"<path d="{left} {right}"/>"#)?;
        } else {
            let around = left.iter().chain(right.iter().rev()).copied();
            writeln!(out, r#"<path d="{}"/>"#, Data(around, true))?;
        }
    }
    writeln!(out, "</g>")?;
    open(out, "fitted", "#b3150d", 2.0 * pixel)?;
    for curve in &fitted.curves {
        writeln!(
            out,
            r#"<path d="{}"/>"#,
            CubicData(&curve.cubics, curve.closed)
        )?;
    }
    Ok(())
}

/// The sides of the band at the joints of a curve.
fn sides(curve: &FittedCurve) -> [Vec<DVec2>; 2] {
    [1.0, -1.0].map(|side| {
        let cubics = curve.cubics.iter().zip(&curve.standard_error);
        let mut places: Vec<DVec2> = cubics
            .map(|(&[p, q, ..], error)| p + across(p, q) * (side * WIDTH * error))
            .collect();
        if let (false, Some(&[.., p, q]), Some(error)) = (
            curve.closed,
            curve.cubics.last(),
            curve.standard_error.last(),
        ) {
            places.push(q + across(p, q) * (side * WIDTH * error));
        }
        places
    })
}

fn across(p: DVec2, q: DVec2) -> DVec2 {
    (q - p).normalize_or_zero().perp()
}

/// The points; outliers are rings instead of discs.
///
/// The last group stays open for the layer to close.
pub(super) fn points(
    out: &mut dyn Write,
    points: &PointSet,
    fitted: &Fitted,
    pixel: f64,
) -> io::Result<()> {
    let radius = Number(point_radius(points.len()) * pixel);
    let width = Number(pixel);
    for (id, style, inliers) in [
        (
            "outliers",
            format!(r##"fill="none" stroke="#3d85d0" stroke-width="{width}""##),
            false,
        ),
        ("points", r##"fill="#111""##.to_owned(), true),
    ] {
        writeln!(out, r#"<g id="{id}" {style}>"#)?;
        let all = points.points().iter().zip(&fitted.places);
        for (p, _) in all.filter(|(_, place)| place.is_some() == inliers) {
            writeln!(
                out,
                r#"<circle cx="{}" cy="{}" r="{radius}"/>"#,
                Number(p.x),
                Number(p.y)
            )?;
        }
        if !inliers {
            writeln!(out, "</g>")?;
        }
    }
    Ok(())
}
