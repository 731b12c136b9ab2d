//! Coordinate reference systems, as far as files name them.

use super::quote::quoted;
use serde_json::Value;

/// What a note says about longitude and latitude.
pub(super) const DEGREES: &str = "lengths are in degrees";

/// Codes of EPSG whose coordinates are degrees: those that maps and receivers are in.
const GEOGRAPHIC: &[u32] = &[
    4019, 4148, 4152, 4167, 4171, 4189, 4202, 4203, 4230, 4258, 4267, 4269, 4277, 4283, 4289, 4312,
    4313, 4314, 4322, 4326, 4490, 4555, 4612, 4617, 4619, 4659, 4674, 4759, 4937, 4955, 4979, 5340,
    6318, 6319, 6668, 7843, 7844, 7912, 8999, 9000, 9057, 9754, 9755,
];

/// A coordinate reference system.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct System {
    name: String,
    is_geographic: bool,
    definition: Definition,
}

/// What a file says of a system.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Definition {
    /// A code of EPSG.
    Code(u32),
    /// Well-known text, of either version.
    Text(String),
    /// PROJJSON.
    Json(Value),
}

impl System {
    /// That of a number which PostGIS and its like put in front of a geometry.
    pub(super) fn of_srid(srid: u32) -> Self {
        Self {
            name: format!("SRID {srid}"),
            ..Self::of_epsg(srid)
        }
    }

    /// That of a code of EPSG.
    pub(super) fn of_epsg(code: u32) -> Self {
        Self {
            name: format!("EPSG:{code}"),
            is_geographic: GEOGRAPHIC.contains(&code),
            definition: Definition::Code(code),
        }
    }

    /// That of the text which describes it in `.prj` files and scans, of either version; `None` if
    /// the text is none of these.
    pub(super) fn of_wkt(text: &str) -> Option<Self> {
        let has = |keyword: &str| text.contains(&format!("{keyword}["));
        let any = |keywords: &[&str]| keywords.iter().any(|keyword| has(keyword));
        let is_projected = any(&["PROJCS", "PROJCRS", "PROJECTEDCRS"]);
        let is_geographic = any(&["GEOGCS", "GEOGCRS", "GEODCRS", "GEOGRAPHICCRS"]);
        if !is_projected && !is_geographic && !any(&["LOCAL_CS", "ENGCRS", "GEOCCS"]) {
            return None;
        }
        let name = text.split('"').nth(1)?;
        Some(Self {
            name: quoted(name.trim().as_bytes()),
            is_geographic: is_geographic && !is_projected,
            definition: Definition::Text(text.trim_end_matches('\0').to_owned()),
        })
    }

    /// That of longitudes and latitudes of GPS, under the name that a file has for it.
    pub(super) fn of_longitudes(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            ..Self::of_epsg(Self::WGS84)
        }
    }

    /// That of an object of PROJJSON; `None` if it has no name.
    pub(super) fn of_json(value: &Value) -> Option<Self> {
        let kind = |value: &Value| match value["type"].as_str() {
            // Of several axes, those of the plane come first.
            Some("CompoundCRS") => value["components"][0]["type"].as_str().map(str::to_owned),
            Some("BoundCRS") => value["source_crs"]["type"].as_str().map(str::to_owned),
            kind => kind.map(str::to_owned),
        };
        let name = match value["type"].as_str() {
            Some("BoundCRS") => value["source_crs"]["name"].as_str()?,
            _ => value["name"].as_str()?,
        };
        let kind = kind(value);
        Some(Self {
            name: quoted(name.as_bytes()),
            is_geographic: matches!(kind.as_deref(), Some("GeographicCRS" | "GeodeticCRS")),
            definition: Definition::Json(value.clone()),
        })
    }
}

impl System {
    /// The code of EPSG for longitudes and latitudes as GPS has them.
    pub(crate) const WGS84: u32 = 4326;

    /// What messages call it.
    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    /// Whether x and y are longitude and latitude.
    pub(super) fn is_geographic(&self) -> bool {
        self.is_geographic
    }

    /// Its code of EPSG, if the file tells one.
    pub(crate) fn epsg(&self) -> Option<u32> {
        match &self.definition {
            Definition::Code(code) => Some(*code),
            Definition::Text(text) => code_of_text(text),
            Definition::Json(value) => {
                let id = &value["id"];
                match (id["authority"].as_str()?, &id["code"]) {
                    ("EPSG", code) => u32::try_from(code.as_u64()?).ok(),
                    ("OGC", code) if code == "CRS84" => Some(Self::WGS84),
                    _ => None,
                }
            }
        }
    }

    /// Its well-known text, if that is what the file has.
    #[cfg(any(feature = "flatgeobuf", feature = "las"))]
    pub(crate) fn text(&self) -> Option<&str> {
        match &self.definition {
            Definition::Text(text) => Some(text),
            _ => None,
        }
    }

    /// Its PROJJSON, if that is what the file has.
    #[cfg(feature = "parquet")]
    pub(crate) fn json(&self) -> Option<&Value> {
        match &self.definition {
            Definition::Json(value) => Some(value),
            _ => None,
        }
    }
}

/// The code of EPSG that stands last in well-known text, right before the brackets that close the
/// whole: those before it are of parts.
fn code_of_text(text: &str) -> Option<u32> {
    let whole = text.trim().strip_suffix(']')?.trim_end();
    let (_, last) = whole.rsplit_once(['[', '('])?;
    let (_, keyword) = whole[..whole.len() - last.len() - 1].rsplit_once([',', '\n'])?;
    let is_code = matches!(keyword.trim(), "AUTHORITY" | "ID");
    let (authority, code) = last.strip_suffix(']')?.split_once(',')?;
    let word = |word: &str| word.trim().trim_matches('"').to_owned();
    let code = word(code).parse().ok()?;
    (is_code && word(authority) == "EPSG").then_some(code)
}
