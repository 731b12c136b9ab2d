//! A reconstruction as tables, objects and shapes.

use super::BarePoints;
use super::polygons::{Ring, first_columns, rings};
use super::why;
use crate::output::{Attribute, Attributes, Feature, Kind, Number, Path, Places, Shape, Streamed};
use curvecrust::geometry::{Chain, PointId, PointSet};
use curvecrust::reconstruct::{
    Explanation, Known, NestedChain, Reconstruction, Shape as KnownShape,
};
use serde::ser::{Serialize, SerializeMap, Serializer};
use std::borrow::Cow;
use std::io::{self, Write};
use std::num::NonZeroU32;

/// What was found, in terms of the rows of the input.
pub(super) struct Found<'a> {
    pub(super) algorithm: &'a str,
    pub(super) bare: &'a BarePoints,
    pub(super) known: &'a Known,
    pub(super) curves: Reconstruction,
    /// Where it is asked for.
    pub(super) why: Option<Explanation>,
}

/// The rows of some points.
struct Rows<'a> {
    bare: &'a BarePoints,
    ids: Cow<'a, [PointId]>,
}

/// The properties of a shape in GeoJSON.
#[derive(serde::Serialize)]
pub(super) struct Properties<'a> {
    kind: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    nesting: Option<u32>,
    points: Numbers<'a>,
}

/// The rows of the places of a shape, in their order.
#[derive(serde::Serialize)]
#[serde(untagged)]
enum Numbers<'a> {
    Of(Rows<'a>),
    OfRings(Vec<Rows<'a>>),
}

#[derive(serde::Serialize)]
struct RingObject<'a> {
    points: Rows<'a>,
    nesting: u32,
}

/// What the user knows.
#[derive(serde::Serialize)]
struct KnownObject<'a> {
    shape: Option<&'static str>,
    curves: Option<NonZeroU32>,
    termini: Rows<'a>,
}

#[derive(serde::Serialize)]
struct Duplicate {
    point: u32,
    same_as: u32,
}

/// The object that `--json` prints; its schema is stable, and in `docs/formats.md`. Points are
/// known by their position in `points`.
impl Serialize for Found<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let edges = || {
            let edges = self.curves.edges().edges().iter();
            edges.map(|edge| edge.ends().map(|v| self.bare.row(v)))
        };
        let rings = || {
            self.curves.chains().iter().filter_map(|chain| {
                Some(RingObject {
                    points: self.rows(chain.chain.vertices()),
                    nesting: chain.nesting?,
                })
            })
        };
        let open = || self.open().map(|chain| self.rows(chain.chain.vertices()));
        let duplicates = || {
            let pairs = self.bare.duplicates();
            pairs.map(|[point, same_as]| Duplicate { point, same_as })
        };
        let mut object = serializer.serialize_map(None)?;
        object.serialize_entry("algorithm", self.algorithm)?;
        if *self.known != Known::default() {
            let known = KnownObject {
                shape: self.known.shape.map(|shape| match shape {
                    KnownShape::Closed => "closed",
                    KnownShape::Open => "open",
                }),
                curves: self.known.curves,
                termini: self.rows(&self.known.termini),
            };
            object.serialize_entry("known", &known)?;
        }
        let points = Streamed(|| self.bare.rows().map(|p| p.to_array()));
        object.serialize_entry("points", &points)?;
        if let Some(heights) = self.bare.heights() {
            object.serialize_entry("z", heights)?;
        }
        object.serialize_entry("edges", &Streamed(edges))?;
        object.serialize_entry("rings", &Streamed(rings))?;
        object.serialize_entry("open_chains", &Streamed(open))?;
        object.serialize_entry("leaves", &self.rows(self.curves.leaves()))?;
        object.serialize_entry("isolated", &self.rows(self.curves.isolated()))?;
        object.serialize_entry("junctions", &self.rows(self.curves.junctions()))?;
        object.serialize_entry("duplicates", &Streamed(duplicates))?;
        if let Some(why) = &self.why {
            object.serialize_entry("reasons", &Streamed(|| why::reasons(why)))?;
            object.serialize_entry("open_ends", &Streamed(|| why::open_ends(why, self.bare)))?;
        }
        object.end()
    }
}

impl Attributes for Properties<'_> {
    const COLUMNS: &'static [(&'static str, Kind)] =
        &[("kind", Kind::Word), ("nesting", Kind::Whole)];

    fn values(&self) -> Vec<Attribute> {
        vec![Attribute::Word(self.kind), Attribute::Whole(self.nesting)]
    }
}

impl Found<'_> {
    /// One line a point, chain by chain in order; a point where chains meet has one in each. Points
    /// without an edge come last, without a chain.
    pub(super) fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        let z = self.bare.heights().map_or("", |_| ",z");
        writeln!(out, "chain,kind,nesting,point,x,y{z}")?;
        for (number, chain) in self.curves.chains().iter().enumerate() {
            let start = first_columns(number, chain);
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
        write!(out, "{start},{row},{},{}", Number(p.x), Number(p.y))?;
        match self.bare.height(vertex) {
            Some(z) => writeln!(out, ",{}", Number(z)),
            None => writeln!(out),
        }
    }

    /// Rings as polygons with holes, then open chains, then points without an edge; at the heights
    /// of all points, if those are kept.
    pub(super) fn features<'a>(
        &'a self,
        rings: &'a [Ring],
        heights: Option<&'a [f64]>,
    ) -> impl Iterator<Item = Feature<'a, Properties<'a>>> {
        let polygons = rings.chunk_by(|a, b| a.outside == b.outside);
        let polygons = polygons.map(move |rings| self.polygon(rings, heights));
        let lines = self.open().map(move |chain| {
            let ids = chain.chain.vertices();
            Feature {
                shape: Shape::Line(self.places(ids).at_heights(heights)),
                properties: Properties {
                    kind: "open",
                    nesting: None,
                    points: Numbers::Of(self.rows(ids)),
                },
            }
        });
        let isolated = self.curves.isolated();
        let points = (!isolated.is_empty()).then(|| Feature {
            shape: Shape::Points(self.places(isolated.clone()).at_heights(heights)),
            properties: Properties {
                kind: "isolated",
                nesting: None,
                points: Numbers::Of(self.rows(isolated)),
            },
        });
        polygons.chain(lines).chain(points)
    }

    /// The rings, as [`features`](Self::features) takes them.
    pub(super) fn rings(&self) -> Vec<Ring> {
        rings(&self.curves)
    }

    /// A polygon of its outside and its holes.
    fn polygon<'a>(
        &'a self,
        rings: &[Ring],
        heights: Option<&'a [f64]>,
    ) -> Feature<'a, Properties<'a>> {
        let chains = self.curves.chains();
        let nesting = rings.first().and_then(|ring| chains[ring.outside].nesting);
        let rings = || rings.iter().map(|ring| ring.vertices(&self.curves));
        Feature {
            shape: Shape::Polygon(
                rings()
                    .map(|ids| self.places(ids).at_heights(heights))
                    .collect(),
            ),
            properties: Properties {
                kind: "ring",
                nesting,
                points: Numbers::OfRings(rings().map(|ids| self.rows(ids)).collect()),
            },
        }
    }

    /// The chains that are no rings.
    fn open(&self) -> impl Iterator<Item = &NestedChain> {
        let chains = self.curves.chains().iter();
        chains.filter(|chain| chain.nesting.is_none())
    }

    fn rows<'a>(&'a self, ids: impl Into<Cow<'a, [PointId]>>) -> Rows<'a> {
        Rows {
            bare: self.bare,
            ids: ids.into(),
        }
    }

    fn places<'a>(&'a self, ids: impl Into<Cow<'a, [PointId]>>) -> Places<'a> {
        Places::named(&self.bare.points, ids)
    }
}

impl Serialize for Rows<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.ids.iter().map(|&id| self.bare.row(id)))
    }
}

/// Every chain as a polyline.
pub(crate) fn paths<'a>(points: &'a PointSet, curves: &'a Reconstruction) -> Vec<Path<'a>> {
    let path = |chain: &'a Chain| {
        let places = Places::named(points, chain.vertices());
        (places, chain.is_closed())
    };
    let chains = curves.chains().iter();
    chains.map(|chain| path(&chain.chain)).collect()
}
