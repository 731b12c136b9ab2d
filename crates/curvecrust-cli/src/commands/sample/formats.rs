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

/// With a column that marks the ends of open curves, if there are any.
pub(super) fn write_csv(out: &mut dyn Write, samples: &SampledCurve) -> io::Result<()> {
    let components = samples.components();
    let has_ends = components.iter().any(|component| !component.closed);
    let header = if has_ends { ",terminus" } else { "" };
    writeln!(out, "curve,x,y{header}")?;
    for (curve, component) in components.iter().enumerate() {
        for i in component.range.clone() {
            let p = samples.points()[i];
            write!(out, "{curve},{},{}", Number(p.x), Number(p.y))?;
            if has_ends {
                write!(out, ",{}", u8::from(component.is_end(i)))?;
            }
            writeln!(out)?;
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
