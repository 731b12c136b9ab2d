//! Fitted curves as tables, objects and shapes.

use super::BarePoints;
use crate::commands::reconstruct::polygons::{Ring, first_columns, rings};
use crate::number::counted;
use crate::output::{Attribute, Attributes, Feature, Kind, Number, Places, Shape, Streamed};
use curvecrust::denoise::{Fitted, FittedCurve};
use curvecrust::geometry::{Edge, EdgeSet, MergedPoints, PointId, PointSet};
use curvecrust::reconstruct::{NestedChain, Reconstruction};
use serde::ser::{Serialize, SerializeMap, Serializer};
use std::fmt;
use std::io::{self, Write};

/// What was found, in terms of the rows of the input.
pub(super) struct Found<'a> {
    pub(super) bare: &'a BarePoints,
    pub(super) fitted: &'a Fitted,
}

#[derive(serde::Serialize)]
struct CurveObject {
    closed: bool,
    points: usize,
    cubics: Vec<[[f64; 2]; 4]>,
    corners: Vec<usize>,
    sigma: Vec<f64>,
    standard_error: Vec<f64>,
}

#[derive(serde::Serialize)]
struct PlaceObject {
    curve: usize,
    parameter: f64,
    distance: f64,
}

/// The object that `--json` prints; its schema is stable, and in `docs/formats.md`. Points are
/// known by their position in `points`.
impl Serialize for Found<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self { bare, fitted } = self;
        let places = || {
            bare.points_of_rows().map(|id| {
                let place = fitted.places[id.index()]?;
                Some(PlaceObject {
                    curve: place.curve,
                    parameter: place.parameter,
                    distance: place.distance,
                })
            })
        };
        let outliers = || {
            let pairs = (0u32..).zip(bare.points_of_rows());
            pairs.filter_map(|(row, id)| fitted.places[id.index()].is_none().then_some(row))
        };
        let mut object = serializer.serialize_map(None)?;
        object.serialize_entry("clean", &fitted.is_clean())?;
        object.serialize_entry("sigma", &fitted.sigma())?;
        object.serialize_entry("points", &Streamed(|| bare.rows().map(|p| p.to_array())))?;
        object.serialize_entry(
            "curves",
            &Streamed(|| fitted.curves.iter().map(curve_object)),
        )?;
        object.serialize_entry("places", &Streamed(places))?;
        object.serialize_entry("outliers", &Streamed(outliers))?;
        let edges = fitted.edges.as_ref().map(|edges| {
            Streamed(move || edges.edges().iter().map(|e| e.ends().map(|v| bare.row(v))))
        });
        object.serialize_entry("edges", &edges)?;
        object.end()
    }
}

fn curve_object(curve: &FittedCurve) -> CurveObject {
    CurveObject {
        closed: curve.closed,
        points: curve.points,
        cubics: curve
            .cubics
            .iter()
            .map(|cubic| cubic.map(|p| p.to_array()))
            .collect(),
        corners: curve.corners.clone(),
        sigma: curve.sigma.clone(),
        standard_error: curve.standard_error.clone(),
    }
}

impl Found<'_> {
    /// The points that belong to a curve, a line each, in the order of the input.
    pub(super) fn write_inliers(&self, out: &mut dyn Write) -> io::Result<()> {
        writeln!(out, "point,curve,distance,x,y")?;
        let rows = self.bare.points_of_rows().zip(self.bare.rows()).enumerate();
        for (row, (id, p)) in rows {
            if let Some(place) = self.fitted.places[id.index()] {
                let [distance, x, y] = [place.distance, p.x, p.y].map(Number);
                writeln!(out, "{row},{},{distance},{x},{y}", place.curve)?;
            }
        }
        Ok(())
    }
}

/// What was found, in one line.
pub(super) struct Summary<'a>(pub(super) &'a Found<'a>);

impl fmt::Display for Summary<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let fitted = self.0.fitted;
        let outliers = fitted.outliers().len();
        let count = self.0.bare.points.len();
        if fitted.curves.is_empty() {
            return write!(f, "{count} points form no curve");
        }
        let closed = fitted.curves.iter().filter(|curve| curve.closed).count();
        let open = fitted.curves.len() - closed;
        let outside = counted(outliers, "outlier");
        write!(
            f,
            "{count} points, {outside}: {closed} closed and {open} open "
        )?;
        f.write_str(if fitted.curves.len() == 1 {
            "curve"
        } else {
            "curves"
        })?;
        if fitted.is_clean() {
            f.write_str(", on which the points lie")
        } else {
            write!(
                f,
                ", from which the points deviate by {:.3e}",
                fitted.sigma()
            )
        }
    }
}

/// Fitted curves as polylines, with what lies inside of what.
pub(super) struct Lines {
    vertices: PointSet,
    curves: Reconstruction,
    /// For each vertex the curve that it is on.
    curve_of: Vec<usize>,
    sigma: Vec<f64>,
}

/// The properties of a shape in GeoJSON.
#[derive(serde::Serialize)]
pub(super) struct Properties {
    kind: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    nesting: Option<u32>,
    /// The root mean square of the deviation of the points.
    sigma: f64,
}

impl Attributes for Properties {
    const COLUMNS: &'static [(&'static str, Kind)] = &[
        ("kind", Kind::Word),
        ("nesting", Kind::Whole),
        ("sigma", Kind::Real),
    ];

    fn values(&self) -> Vec<Attribute> {
        vec![
            Attribute::Word(self.kind),
            Attribute::Whole(self.nesting),
            Attribute::Real(self.sigma),
        ]
    }
}

impl Lines {
    pub(super) fn new(fitted: &Fitted, tolerance: f64) -> anyhow::Result<Self> {
        let (mut vertices, mut pairs, mut curve_of) = (Vec::new(), Vec::new(), Vec::new());
        for (k, curve) in fitted.curves.iter().enumerate() {
            let (start, line) = (vertices.len(), curve.polyline(tolerance));
            let end = start + line.len();
            pairs.extend((start..end).zip(start + 1..end));
            pairs.extend(curve.closed.then_some((end.saturating_sub(1), start)));
            curve_of.extend(line.iter().map(|_| k));
            vertices.extend(line);
        }
        let MergedPoints {
            points,
            representative,
            origin,
            ..
        } = PointSet::merging_duplicates(vertices)?;
        let edges = pairs
            .iter()
            .filter_map(|&(i, j)| Edge::new(representative[i], representative[j]));
        let edges = EdgeSet::new(points.len(), edges);
        Ok(Self {
            curves: Reconstruction::new(&points, edges)?,
            curve_of: origin.iter().map(|&i| curve_of[i]).collect(),
            sigma: fitted.curves.iter().map(FittedCurve::deviation).collect(),
            vertices: points,
        })
    }

    /// One line a vertex, curve by curve in order; as the table of `reconstruct`, but vertices are
    /// no points of the input.
    pub(super) fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        writeln!(out, "chain,kind,nesting,point,x,y")?;
        for (number, chain) in self.curves.chains().iter().enumerate() {
            let start = first_columns(number, chain);
            for &vertex in chain.chain.vertices() {
                let p = self.vertices[vertex];
                writeln!(out, "{start},,{},{}", Number(p.x), Number(p.y))?;
            }
        }
        Ok(())
    }

    pub(super) fn rings(&self) -> Vec<Ring> {
        rings(&self.curves)
    }

    /// Closed curves as polygons with holes, then open ones as lines.
    pub(super) fn features<'a>(
        &'a self,
        rings: &'a [Ring],
    ) -> impl Iterator<Item = Feature<'a, Properties>> {
        let polygons = rings.chunk_by(|a, b| a.outside == b.outside);
        let polygons = polygons.map(|rings| self.polygon(rings));
        let open = self.curves.chains().iter().filter(|c| c.nesting.is_none());
        let lines = open.map(|chain| Feature {
            shape: Shape::Line(Places::named(&self.vertices, chain.chain.vertices())),
            properties: self.properties("open", chain),
        });
        polygons.chain(lines)
    }

    fn polygon(&self, rings: &[Ring]) -> Feature<'_, Properties> {
        let chains = self.curves.chains();
        let ring = |ring: &Ring| Places::named(&self.vertices, ring.vertices(&self.curves));
        Feature {
            shape: Shape::Polygon(rings.iter().map(ring).collect()),
            properties: self.properties("ring", &chains[rings[0].outside]),
        }
    }

    fn properties(&self, kind: &'static str, chain: &NestedChain) -> Properties {
        let first: Option<&PointId> = chain.chain.vertices().first();
        let curve = first.map_or(0, |v| self.curve_of[v.index()]);
        Properties {
            kind,
            nesting: chain.nesting,
            sigma: self.sigma[curve],
        }
    }
}
