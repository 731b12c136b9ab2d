//! FlatGeobuf, by the crate of that name: the points of all features; the vertices of lines and
//! polygons on request.
//!
//! The crate verifies headers and features. It would reserve what a feature says it has, and its
//! tree fails where the header is wrong: the tree is passed over, and features are read, here.

use super::gathered::{Gathered, Vertex};
use super::system::System;
use super::{Flaw, Place, PointList, Problem, ReadOptions};
use flatgeobuf::{FgbReader, Geometry, GeometryType, Header, size_prefixed_root_as_feature};
use std::io::{self, BufRead, ErrorKind, Read};

/// Geometries in geometries.
const DEEPEST: usize = 64;

/// Bytes of a node of the tree.
const NODE: u64 = 40;

/// What the header says.
struct Layer {
    kind: GeometryType,
    features: u64,
    tree: u64,
    has_measures: bool,
}

pub(super) fn read(mut input: impl BufRead, options: &ReadOptions) -> Result<PointList, Flaw> {
    let mut found = Gathered::new(options);
    let layer = {
        let reader = FgbReader::open(&mut input);
        let reader =
            reader.map_err(|error| problem(&format!("its header cannot be read: {error}")))?;
        let header = reader.header();
        if let Some(system) = system(&header) {
            found.system(system);
        }
        Layer::of(&header)?
    };
    let tree = io::copy(&mut input.by_ref().take(layer.tree), &mut io::sink())?;
    if tree < layer.tree {
        return Err(problem("it is cut off in its tree").into());
    }
    let mut buffer = Vec::new();
    for number in 0.. {
        found.go_to(Place::Item("feature", number + 1));
        if !next(&mut input, &mut buffer).map_err(|error| broken(&found, error))? {
            if number < layer.features {
                let (what, promised) = ("features", layer.features);
                return Err(Problem::CutOff {
                    what,
                    promised,
                    found: number,
                }
                .into());
            }
            break;
        }
        let feature = size_prefixed_root_as_feature(&buffer);
        let feature = feature.map_err(|error| found.flaw(problem(&error.to_string())))?;
        // A feature without a geometry is no place.
        if let Some(geometry) = feature.geometry() {
            found.go_to(Place::Position(usize::try_from(number + 1).ok(), 0));
            collect(&mut found, &layer, geometry, layer.kind, DEEPEST)?;
        }
    }
    Ok(found.finish())
}

fn problem(what: &str) -> Problem {
    Problem::Flatgeobuf(what.to_owned())
}

fn broken(found: &Gathered, error: io::Error) -> Flaw {
    found.flaw(match error.kind() {
        ErrorKind::UnexpectedEof => problem("the file is cut off"),
        _ => Problem::Io(error),
    })
}

/// Reads the bytes of the next feature, its length in front; false if there is none.
fn next(input: &mut impl BufRead, buffer: &mut Vec<u8>) -> io::Result<bool> {
    if input.fill_buf()?.is_empty() {
        return Ok(false);
    }
    let mut length = [0; 4];
    input.read_exact(&mut length)?;
    buffer.clear();
    buffer.extend(length);
    let length = u64::from(u32::from_le_bytes(length));
    // No more is reserved than is read.
    match input.take(length).read_to_end(buffer)? as u64 {
        read if read < length => Err(ErrorKind::UnexpectedEof.into()),
        _ => Ok(true),
    }
}

impl Layer {
    fn of(header: &Header<'_>) -> Result<Self, Flaw> {
        let features = header.features_count();
        Ok(Self {
            kind: header.geometry_type(),
            features,
            tree: tree(features, header.index_node_size())
                .ok_or_else(|| problem("its tree has a size that cannot be"))?,
            has_measures: header.has_m(),
        })
    }
}

/// Bytes of the tree over the features, whose nodes have `node` children each.
fn tree(features: u64, node: u16) -> Option<u64> {
    let (mut level, mut nodes) = (features, features);
    if node == 0 || features == 0 {
        return Some(0);
    }
    if node == 1 {
        return None;
    }
    loop {
        level = level.div_ceil(node.into());
        nodes = nodes.checked_add(level)?;
        if level == 1 {
            return nodes.checked_mul(NODE);
        }
    }
}

fn system(header: &Header<'_>) -> Option<System> {
    let crs = header.crs()?;
    let code = u32::try_from(crs.code()).ok().filter(|&code| code > 0);
    let org = crs.org().unwrap_or("EPSG");
    match code {
        Some(code) if org.eq_ignore_ascii_case("EPSG") => Some(System::of_epsg(code)),
        _ => System::of_wkt(crs.wkt()?),
    }
}

/// Takes a geometry that holds at most `levels` of others in each other.
fn collect(
    found: &mut Gathered,
    layer: &Layer,
    geometry: Geometry<'_>,
    kind: GeometryType,
    levels: usize,
) -> Result<(), Flaw> {
    let kind = match kind {
        GeometryType::Unknown => geometry.type_(),
        kind => kind,
    };
    let parts = geometry.parts().into_iter().flatten();
    match kind {
        GeometryType::Point | GeometryType::MultiPoint => {
            found.measure(layer.has_measures || geometry.m().is_some());
            let mut vertices = vertices(&geometry);
            vertices.try_for_each(|vertex| found.point(vertex))
        }
        GeometryType::LineString | GeometryType::MultiLineString | GeometryType::Polygon => {
            found.wants_vertices(kind.variant_name().unwrap_or_default())?;
            found.measure(layer.has_measures || geometry.m().is_some());
            lines(found, &geometry)
        }
        GeometryType::MultiPolygon | GeometryType::GeometryCollection => {
            if levels == 0 {
                return Err(found.flaw(problem("geometries in geometries")));
            }
            let of = match kind {
                GeometryType::MultiPolygon => GeometryType::Polygon,
                _ => GeometryType::Unknown,
            };
            for part in parts {
                collect(found, layer, part, of, levels - 1)?;
            }
            Ok(())
        }
        other => {
            let name = other
                .variant_name()
                .unwrap_or("of a type that is not known");
            Err(found.flaw(problem(&format!("geometries are not read that are {name}"))))
        }
    }
}

fn vertices<'a>(geometry: &Geometry<'a>) -> impl Iterator<Item = Vertex> + 'a {
    let xy = geometry.xy();
    let count = xy.map_or(0, |xy| xy.len() / 2);
    let xy = xy.into_iter().flatten();
    let mut numbers = xy.take(2 * count);
    let mut heights = geometry.z().into_iter().flatten();
    std::iter::from_fn(move || Some(([numbers.next()?, numbers.next()?], heights.next())))
}

/// The vertices of the lines of a geometry, which ends where the next begins.
fn lines(found: &mut Gathered, geometry: &Geometry<'_>) -> Result<(), Flaw> {
    let vertices: Vec<Vertex> = vertices(geometry).collect();
    let all = u32::try_from(vertices.len()).unwrap_or(u32::MAX);
    let ends: Vec<u32> = match geometry.ends() {
        Some(ends) if !ends.is_empty() => ends.iter().collect(),
        _ => vec![all],
    };
    let mut start = 0;
    for end in ends {
        let line = vertices.get(start as usize..end as usize);
        let line = line.ok_or_else(|| found.flaw(problem("its lines are not in order")))?;
        found.line(line.iter().copied().map(Ok))?;
        start = end;
    }
    Ok(())
}
