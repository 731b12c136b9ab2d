//! Where GeoParquet has its geometries: <https://geoparquet.org/releases/v1.1.0/>

use super::super::quote::quoted;
use super::super::system::System;
use super::{Flaw, Problem};
use parquet::file::metadata::FileMetaData;
use serde_json::Value;

pub(super) struct Geo {
    /// The column of the geometries.
    pub(super) column: String,
    pub(super) encoding: Encoding,
    pub(super) system: Option<System>,
}

pub(super) enum Encoding {
    Wkb,
    /// Columns of x and y.
    Point,
}

/// What the metadata say; `None` if they say nothing of geometries.
pub(super) fn of(metadata: &FileMetaData) -> Result<Option<Geo>, Flaw> {
    let mut pairs = metadata.key_value_metadata().into_iter().flatten();
    let Some(text) = pairs
        .find(|pair| pair.key == "geo")
        .and_then(|pair| pair.value.as_ref())
    else {
        return Ok(None);
    };
    let problem = |what: &str| Problem::Parquet(format!("its metadata `geo` {what}"));
    let geo: Value = serde_json::from_str(text).map_err(|_| problem("are no JSON"))?;
    let column = geo["primary_column"].as_str();
    let column = column.ok_or_else(|| problem("name no column"))?.to_owned();
    let about = &geo["columns"][&column];
    let encoding = match about["encoding"].as_str() {
        Some("WKB") => Encoding::Wkb,
        Some("point") => Encoding::Point,
        other => {
            let other = quoted(other.unwrap_or_default().as_bytes());
            return Err(Problem::Parquet(format!(
                "its geometries are in the encoding `{other}`: save them as WKB"
            ))
            .into());
        }
    };
    let system = match about.get("crs") {
        None => Some(System::of_longitudes("OGC:CRS84")),
        Some(crs) => System::of_json(crs),
    };
    Ok(Some(Geo {
        column,
        encoding,
        system,
    }))
}
