//! Samples in the formats of tables and features.

use crate::output::{Attribute, Attributes, Feature, Kind, Number, Places, Shape};
use curvecrust::DVec2;
use curvecrust::sampling::SampledCurve;
use serde::Serialize;
use std::io::{self, Write};

/// The properties of the samples of a component in GeoJSON.
#[derive(Serialize)]
pub(super) struct Properties {
    curve: u32,
}

impl Attributes for Properties {
    const COLUMNS: &'static [(&'static str, Kind)] = &[("curve", Kind::Whole)];

    fn values(&self) -> Vec<Attribute> {
        vec![Attribute::Whole(Some(self.curve))]
    }
}

/// The samples of every component, in order along it.
fn parts(samples: &SampledCurve) -> impl Iterator<Item = &[DVec2]> {
    let components = samples.components().iter();
    components.map(|component| &samples.points()[component.range.clone()])
}

pub(super) fn write_csv(out: &mut dyn Write, samples: &SampledCurve) -> io::Result<()> {
    writeln!(out, "curve,x,y")?;
    for (curve, part) in parts(samples).enumerate() {
        for p in part {
            writeln!(out, "{curve},{},{}", Number(p.x), Number(p.y))?;
        }
    }
    Ok(())
}

pub(super) fn write_text(out: &mut dyn Write, samples: &SampledCurve) -> io::Result<()> {
    let mut points = samples.points().iter();
    points.try_for_each(|p| writeln!(out, "{} {}", Number(p.x), Number(p.y)))
}

pub(super) fn features(samples: &SampledCurve) -> impl Iterator<Item = Feature<'_, Properties>> {
    (0..).zip(parts(samples)).map(|(curve, part)| Feature {
        shape: Shape::Points(Places::all(part)),
        properties: Properties { curve },
    })
}
