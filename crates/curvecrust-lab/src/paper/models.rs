//! The four curves of the paper's tables: the authors', if they were fetched, or our own.

use super::rows::CurveOrigin;
use crate::digest::fnv1a;
use crate::repository::root;
use anyhow::{Context, ensure};
use curvecrust::curve::Curve;
use std::path::Path;

/// A curve and its name.
pub(crate) struct Model {
    pub(crate) name: &'static str,
    pub(crate) curve: Curve,
}

/// The models in the paper's order, as drawn for this project.
const REDRAWN: [(&str, &str); 4] = [
    (
        "parallel",
        include_str!("../../../../fixtures/curves/parallel.svg"),
    ),
    (
        "teaser",
        include_str!("../../../../fixtures/curves/teaser.svg"),
    ),
    (
        "bunny",
        include_str!("../../../../fixtures/curves/bunny.svg"),
    ),
    ("cat", include_str!("../../../../fixtures/curves/cat.svg")),
];

/// Digests of the control points of the authors' curves, by which a folder of them is recognised.
const AUTHORS: [u64; 4] = [
    0x9da8_3970_7505_067c,
    0xdd9f_dc35_b7ac_cac1,
    0x0574_1063_22ca_dc25,
    0xafe9_7784_9fff_4f49,
];

/// The curves in `folder`; without one, those in fixtures/paper, or the redrawn.
pub(crate) fn load(folder: Option<&Path>) -> anyhow::Result<(CurveOrigin, Vec<Model>)> {
    let fetched = root().join("fixtures").join("paper").join("curves");
    match folder {
        Some(folder) => {
            let models = read(folder)?;
            let digests = models.iter().map(|model| digest(&model.curve));
            let origin = if digests.eq(AUTHORS) {
                CurveOrigin::Authors
            } else {
                CurveOrigin::Given
            };
            Ok((origin, models))
        }
        None if fetched.is_dir() => Ok((CurveOrigin::Authors, read(&fetched)?)),
        None => Ok((CurveOrigin::Redrawn, redrawn()?)),
    }
}

/// The curves drawn for this project.
pub(crate) fn redrawn() -> anyhow::Result<Vec<Model>> {
    let parse = |(name, document)| {
        let curve =
            Curve::from_svg(document).with_context(|| format!("fixtures/curves/{name}.svg"))?;
        Ok(Model { name, curve })
    };
    REDRAWN.into_iter().map(parse).collect()
}

fn read(folder: &Path) -> anyhow::Result<Vec<Model>> {
    let missing: Vec<String> = REDRAWN
        .iter()
        .map(|(name, _)| format!("{name}.svg"))
        .filter(|file| !folder.join(file).is_file())
        .collect();
    ensure!(
        missing.is_empty(),
        "{} lacks {}: --curves takes a folder of parallel.svg, teaser.svg, bunny.svg and cat.svg",
        folder.display(),
        missing.join(", ")
    );
    let read = |(name, _)| {
        let path = folder.join(format!("{name}.svg"));
        let document = std::fs::read_to_string(&path)
            .with_context(|| format!("cannot read {}", path.display()))?;
        let curve = Curve::from_svg(&document).with_context(|| path.display().to_string())?;
        Ok(Model { name, curve })
    };
    REDRAWN.into_iter().map(read).collect()
}

/// FNV-1a over the start of every segment, to a hundredth of a unit.
fn digest(curve: &Curve) -> u64 {
    let segments = curve
        .components()
        .iter()
        .flat_map(|component| component.segments());
    let coordinates = segments.flat_map(|bezier| bezier.start().to_array());
    fnv1a(coordinates.flat_map(|coordinate| format!("{coordinate:.2} ").into_bytes()))
}
