//! A reconstruction as tables, objects and shapes.

use super::BarePoints;
use super::polygons::{Polygon, polygons};
use crate::output::{Feature, Number, Path, Shape};
use curvecrust::DVec2;
use curvecrust::geometry::{Chain, PointId};
use curvecrust::reconstruct::Reconstruction;
use serde::Serialize;
use serde_json::{Map, Value, json};
use std::io::{self, Write};

/// What was found, in terms of the rows of the input.
pub(super) struct Found<'a> {
    pub(super) bare: &'a BarePoints,
    pub(super) curves: Reconstruction,
}

/// What `--json` prints; the schema is stable, and in `docs/formats.md`. Points are known by their
/// position in `points`.
#[derive(Debug, Serialize)]
pub(super) struct Object<'a> {
    algorithm: &'a str,
    points: Vec<[f64; 2]>,
    edges: Vec<[u32; 2]>,
    rings: Vec<Ring>,
    open_chains: Vec<Vec<u32>>,
    leaves: Vec<u32>,
    isolated: Vec<u32>,
    junctions: Vec<u32>,
    duplicates: Vec<Duplicate>,
}

#[derive(Debug, Serialize)]
struct Ring {
    points: Vec<u32>,
    nesting: u32,
}

#[derive(Debug, Serialize)]
struct Duplicate {
    point: u32,
    same_as: u32,
}

impl Found<'_> {
    pub(super) fn object<'a>(&self, algorithm: &'a str) -> Object<'a> {
        let edges = self.curves.edges().edges().iter();
        let chains = self.curves.chains().iter();
        let rings = chains.clone().filter_map(|chain| {
            Some(Ring {
                points: self.rows(chain.chain.vertices()),
                nesting: chain.nesting?,
            })
        });
        let open = chains.filter(|chain| chain.nesting.is_none());
        let duplicates = self.bare.duplicates();
        Object {
            algorithm,
            points: self.bare.rows().map(|p| p.to_array()).collect(),
            edges: edges.map(|e| e.ends().map(|v| self.bare.row(v))).collect(),
            rings: rings.collect(),
            open_chains: open.map(|c| self.rows(c.chain.vertices())).collect(),
            leaves: self.rows(&self.curves.leaves()),
            isolated: self.rows(&self.curves.isolated()),
            junctions: self.rows(&self.curves.junctions()),
            duplicates: duplicates
                .map(|[point, same_as]| Duplicate { point, same_as })
                .collect(),
        }
    }

    /// One line a point, chain by chain in order; a point where chains meet has one in each. Points
    /// without an edge come last, without a chain.
    pub(super) fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        writeln!(out, "chain,kind,nesting,point,x,y")?;
        for (number, chain) in self.curves.chains().iter().enumerate() {
            let start = match chain.nesting {
                Some(nesting) => format!("{number},ring,{nesting}"),
                None => format!("{number},open,"),
            };
            for &vertex in chain.chain.vertices() {
                self.write_row(out, &start, vertex)?;
            }
        }
        for vertex in self.curves.isolated() {
            self.write_row(out, ",isolated,", vertex)?;
        }
        Ok(())
    }

    fn write_row(&self, out: &mut dyn Write, start: &str, vertex: PointId) -> io::Result<()> {
        let (row, p) = (self.bare.row(vertex), self.bare.points[vertex]);
        writeln!(out, "{start},{row},{},{}", Number(p.x), Number(p.y))
    }

    /// Rings as polygons with holes, then open chains, then points without an edge.
    pub(super) fn features(&self) -> Vec<Feature> {
        let chains = self.curves.chains();
        let polygons = polygons(&self.bare.points, &self.curves);
        let rings = polygons.iter().map(|polygon| self.polygon(polygon));
        let open = chains.iter().filter(|chain| chain.nesting.is_none());
        let lines = open.map(|chain| Feature {
            shape: Shape::Line(self.places(chain.chain.vertices())),
            properties: properties("open", json!(self.rows(chain.chain.vertices()))),
        });
        let isolated = self.curves.isolated();
        let points = (!isolated.is_empty()).then(|| Feature {
            shape: Shape::Points(self.places(&isolated)),
            properties: properties("isolated", json!(self.rows(&isolated))),
        });
        rings.chain(lines).chain(points).collect()
    }

    fn polygon(&self, polygon: &Polygon) -> Feature {
        let chains = self.curves.chains();
        let outside = chains[polygon.outside].chain.clone();
        // Rings run counter-clockwise, holes have to run clockwise.
        let holes = polygon
            .holes
            .iter()
            .map(|&i| chains[i].chain.clone().reversed());
        let rings: Vec<Chain> = std::iter::once(outside).chain(holes).collect();
        let rows: Vec<_> = rings
            .iter()
            .map(|ring| self.rows(ring.vertices()))
            .collect();
        let nesting = chains[polygon.outside].nesting;
        let mut properties = properties("ring", json!(rows));
        properties.insert(String::from("nesting"), json!(nesting));
        let rings = rings.iter().map(|ring| self.places(ring.vertices()));
        Feature {
            shape: Shape::Polygon(rings.collect()),
            properties,
        }
    }

    fn rows(&self, vertices: &[PointId]) -> Vec<u32> {
        vertices.iter().map(|&v| self.bare.row(v)).collect()
    }

    fn places(&self, vertices: &[PointId]) -> Vec<DVec2> {
        vertices.iter().map(|&v| self.bare.points[v]).collect()
    }
}

fn properties(kind: &str, points: Value) -> Map<String, Value> {
    let mut properties = Map::new();
    properties.insert(String::from("kind"), json!(kind));
    properties.insert(String::from("points"), points);
    properties
}

/// Every chain as a polyline.
pub(crate) fn paths(bare: &BarePoints, curves: &Reconstruction) -> Vec<Path> {
    let place = |&v: &PointId| bare.points[v];
    let path = |chain: &Chain| {
        (
            chain.vertices().iter().map(place).collect(),
            chain.is_closed(),
        )
    };
    let chains = curves.chains().iter();
    chains.map(|chain| path(&chain.chain)).collect()
}
