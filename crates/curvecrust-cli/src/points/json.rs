//! JSON: an array of `[x, y]` or of objects with `x` and `y`, or an object with such an array as
//! `points` or `samples`, such as the program prints. An object with a `type` is GeoJSON. Where
//! every point is `[x, y, z]`, z is a height.

use super::columns::{HEIGHTS, KNOWN, is_longitude};
use super::heights::Heights;
use super::json_text::parse;
use super::system::DEGREES;
use super::{Flaw, Place, PointList, Problem, ReadOptions, geojson, in_double_range};
use curvecrust::DVec2;
use serde::Deserialize;
use serde::de::{DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde_json::Value;
use std::fmt;

/// The keys of an object that are read.
#[derive(Deserialize)]
struct Object {
    r#type: Option<IgnoredAny>,
    points: Option<Points>,
    samples: Option<Points>,
    termini: Option<Vec<usize>>,
}

/// An array of points.
#[derive(Default)]
struct Points {
    points: Vec<DVec2>,
    kind: Kind,
}

/// What the points of an array are.
#[derive(Default)]
struct Kind {
    /// How many numbers each has; `None` before the first.
    dimension: Option<Dimension>,
    /// The height of every point, up to the last that has one; no number where there is none.
    heights: Vec<f64>,
    /// Whether any is a longitude and a latitude.
    has_degrees: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Dimension {
    Two,
    Three,
}

pub(super) fn read(bytes: &[u8], options: &ReadOptions) -> Result<PointList, Flaw> {
    let mut termini = None;
    let found: Points = if bytes.trim_ascii_start().starts_with(b"[") {
        parse(bytes)?
    } else {
        let object: Object = parse(bytes)?;
        termini = object.termini.filter(|_| options.termini);
        match (object.r#type, object.points, object.samples) {
            (Some(_), ..) => return geojson::read(bytes, options),
            (None, Some(points), None) | (None, None, Some(points)) => points,
            (None, None, None) => return Err(Problem::NoArray.into()),
            (None, Some(_), Some(_)) => return Err(Problem::TwoArrays.into()),
        }
    };
    let Points { points, kind } = found;
    let mut heights = Heights::new(options);
    for index in 0..points.len() {
        let height = kind.heights.get(index).filter(|height| !height.is_nan());
        let taken = heights.take(height.copied());
        taken.map_err(|problem| problem.at(Place::Item("point", index as u64 + 1)))?;
    }
    let mut list = PointList::new(points, heights);
    if let Some(termini) = termini {
        let points = termini.iter().map(|&index| {
            let point = list.points.get(index).copied();
            point.ok_or(Problem::NoTerminus { index })
        });
        list.points = points.collect::<Result<_, _>>()?;
    }
    if kind.has_degrees {
        let note = format!("x is the longitude, y the latitude: {DEGREES}");
        list.notes.push(note);
    }
    Ok(list)
}

impl Kind {
    /// Takes the height of a point.
    fn height(&mut self, index: usize, height: f64) {
        self.heights.resize(index, f64::NAN);
        self.heights.push(height);
    }
}

impl<'de> Deserialize<'de> for Points {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_seq(PointsVisitor)
    }
}

struct PointsVisitor;

impl<'de> Visitor<'de> for PointsVisitor {
    type Value = Points;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an array of points [x, y]")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Points, A::Error> {
        let mut found = Points::default();
        loop {
            let index = found.points.len();
            let kind = &mut found.kind;
            match seq.next_element_seed(Point { index, kind })? {
                Some(point) => found.points.push(point),
                None => return Ok(found),
            }
        }
    }
}

/// One point, which has as many numbers as those before it.
struct Point<'a> {
    index: usize,
    kind: &'a mut Kind,
}

impl<'de> DeserializeSeed<'de> for Point<'_> {
    type Value = DVec2;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<DVec2, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Point<'_> {
    type Value = DVec2;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a point [x, y] or an object of x and y")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<DVec2, A::Error> {
        let less = || A::Error::custom("a point is [x, y], but here is less");
        let more = || A::Error::custom("a point is [x, y], but here is more");
        let mut next = || seq.next_element::<f64>();
        let [x, y] = [next()?.ok_or_else(less)?, next()?.ok_or_else(less)?];
        let value = |value| in_double_range(value).map_err(A::Error::custom);
        let point = DVec2::new(value(x)?, value(y)?);
        let dimension = match next()? {
            None => Dimension::Two,
            Some(height) => {
                self.kind.height(self.index, height);
                Dimension::Three
            }
        };
        match (*self.kind.dimension.get_or_insert(dimension), dimension) {
            (Dimension::Three, Dimension::Two) => return Err(less()),
            (Dimension::Two, Dimension::Three) => return Err(more()),
            _ => {}
        }
        match seq.next_element::<IgnoredAny>()? {
            Some(_) => Err(more()),
            None => Ok(point),
        }
    }

    /// Of the pairs of names that columns of tables have, the first that is there.
    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<DVec2, A::Error> {
        let mut values = [[None; 2]; KNOWN.len()];
        while let Some(key) = map.next_key::<String>()? {
            let key = key.to_ascii_lowercase();
            let pairs = KNOWN.iter().zip(&mut values);
            let mut places = pairs.flat_map(|(names, values)| names.iter().zip(values));
            match places.find(|(names, _)| names.contains(&&*key)) {
                Some((_, value)) => *value = Some(map.next_value::<f64>()?),
                None if HEIGHTS.contains(&&*key) => {
                    if let Value::Number(height) = map.next_value::<Value>()? {
                        self.kind
                            .height(self.index, height.as_f64().unwrap_or(f64::NAN));
                    }
                }
                None => {
                    map.next_value::<IgnoredAny>()?;
                }
            }
        }
        self.kind.dimension.get_or_insert(Dimension::Two);
        let pairs = KNOWN.iter().zip(&values);
        let found = pairs
            .into_iter()
            .find_map(|(names, &[x, y])| Some((names, x?, y?)));
        let (names, x, y) = found.ok_or_else(|| {
            A::Error::custom("an object of a point has x and y, or longitude and latitude")
        })?;
        self.kind.has_degrees |= is_longitude(names[0][0].as_bytes());
        let value = |value| in_double_range(value).map_err(A::Error::custom);
        Ok(DVec2::new(value(x)?, value(y)?))
    }
}
