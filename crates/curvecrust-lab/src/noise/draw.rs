//! A picture of a fit: the known curves in grey, the fitted ones over them, points, and outliers as
//! rings.

use curvecrust::denoise::Fitted;
use curvecrust::geometry::DVec2;
use svg::node::element::path::Data;

use super::curves::Truth;
use super::sample::Sample;
use crate::drawing::{Within, circle, document, path, polyline};
use crate::figure::bounds;

/// The larger side of the data, and what is around them, in pixels.
const SIZE: f64 = 600.0;
const MARGIN: f64 = 20.0;

pub(super) fn picture(truth: &[Truth], sample: &Sample, fitted: &Fitted) -> String {
    let (low, high) = bounds(&sample.points);
    let scale = SIZE / (high - low).max_element();
    let to = |p: DVec2| {
        // Pages have y downwards.
        let q = DVec2::new(p.x - low.x, high.y - p.y) * scale;
        q + DVec2::splat(MARGIN)
    };
    let lines = truth.iter().map(|t| ("curve", t.points.clone(), t.closed));
    let curves = fitted.curves.iter();
    let curves = curves.map(|c| ("edges", c.polyline(0.1 / scale), c.closed));
    let size = (high - low) * scale + DVec2::splat(2.0 * MARGIN);
    let mut picture = document("A fit", size, Within::File);
    for (class, points, closed) in lines.chain(curves) {
        let data = polyline(Data::new(), points.into_iter().map(to), closed);
        picture = picture.add(path(class, data));
    }
    for (&p, place) in sample.points.iter().zip(&fitted.places) {
        let (class, radius) = if place.is_some() {
            ("point", 1.6)
        } else {
            ("leaf", 2.4)
        };
        picture = picture.add(circle(class, to(p), radius));
    }
    format!("{picture}\n")
}
