//! Coordinate reference systems, as far as files name them.

use super::quote::quoted;

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
pub(super) struct System {
    /// What messages call it.
    pub(super) name: String,
    /// Whether x and y are longitude and latitude.
    pub(super) is_geographic: bool,
}

impl System {
    /// That of a number which PostGIS and its like put in front of a geometry.
    pub(super) fn of_srid(srid: u32) -> Self {
        Self {
            name: format!("SRID {srid}"),
            is_geographic: GEOGRAPHIC.contains(&srid),
        }
    }
}

impl System {
    /// That of a code of EPSG.
    pub(super) fn of_epsg(code: u32) -> Self {
        Self {
            name: format!("EPSG:{code}"),
            is_geographic: GEOGRAPHIC.contains(&code),
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
        })
    }
}

impl System {
    /// One of longitudes and latitudes.
    pub(super) fn of_longitudes(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            is_geographic: true,
        }
    }

    /// That of an object of PROJJSON; `None` if it has no name.
    pub(super) fn of_json(value: &serde_json::Value) -> Option<Self> {
        let kind = |value: &serde_json::Value| match value["type"].as_str() {
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
        })
    }
}
