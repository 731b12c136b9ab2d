//! GeoJSON points, and bare arrays of pairs. Heights are left out.

use curvecrust::DVec2;
use serde_json::Value;

/// Reads all positions of points, in order.
pub(super) fn read(text: &str) -> Result<Vec<DVec2>, String> {
    let value: Value = serde_json::from_str(text).map_err(|why| format!("not JSON: {why}"))?;
    let mut points = Vec::new();
    match &value {
        Value::Array(pairs) => take_all(pairs, &mut points)?,
        object => collect(object, &mut points)?,
    }
    Ok(points)
}

/// The parser refuses values that are nested deeply, so this ends.
fn collect(object: &Value, points: &mut Vec<DVec2>) -> Result<(), String> {
    let list = |name: &str| {
        let found = object.get(name).and_then(Value::as_array);
        found.ok_or_else(|| format!("a GeoJSON object has no list of {name}"))
    };
    match object.get("type").and_then(Value::as_str) {
        Some("Point") => points.push(position(object.get("coordinates"))?),
        Some("MultiPoint" | "LineString") => take_all(list("coordinates")?, points)?,
        Some("GeometryCollection") => {
            for geometry in list("geometries")? {
                collect(geometry, points)?;
            }
        }
        Some("Feature") => match object.get("geometry") {
            None | Some(Value::Null) => {}
            Some(geometry) => collect(geometry, points)?,
        },
        Some("FeatureCollection") => {
            for feature in list("features")? {
                collect(feature, points)?;
            }
        }
        Some(other) => return Err(format!("GeoJSON of type {other:.20} holds no points")),
        None => return Err("this is JSON, but neither GeoJSON nor pairs of numbers".to_owned()),
    }
    Ok(())
}

fn take_all(pairs: &[Value], points: &mut Vec<DVec2>) -> Result<(), String> {
    for pair in pairs {
        points.push(position(Some(pair))?);
    }
    Ok(())
}

fn position(value: Option<&Value>) -> Result<DVec2, String> {
    let numbers = value.and_then(Value::as_array).map(Vec::as_slice);
    let found = match numbers {
        Some([x, y, ..]) => x.as_f64().zip(y.as_f64()),
        _ => None,
    };
    let (x, y) = found.ok_or("a position is not a pair of numbers")?;
    Ok(DVec2::new(x, y))
}
