//! Points from the text of a file: csv, text, GeoJSON and SVG, recognised by their content.
//!
//! The program reads more formats and more of each. These are the common cases of them, small
//! enough for a page; whatever is none of them is an error in words.

mod geojson;
mod svg;
mod table;

use crate::error::Error;
use curvecrust::DVec2;

/// The most points of one request: beyond, the memory of a browser's tab is in danger.
pub(crate) const MOST_POINTS: usize = 2_000_000;

/// Points, and the format they were in.
#[derive(Debug)]
pub(crate) struct Found {
    pub(crate) format: &'static str,
    pub(crate) points: Vec<DVec2>,
}

/// Reads the points of a file.
pub(crate) fn read(name: &str, text: &str) -> Result<Found, Error> {
    let text = text.trim_start_matches('\u{feff}');
    let (format, points) = match text.trim_start().chars().next() {
        Some('<') => ("SVG", svg::read(text)),
        Some('{' | '[') => ("GeoJSON", geojson::read(text)),
        _ => ("table", table::read(text)),
    };
    let refused = |why: String| Error::File(format!("{name}: {why}"));
    let points = points.map_err(refused)?;
    if points.is_empty() {
        return Err(refused("there is no point in this file".to_owned()));
    }
    if points.len() > MOST_POINTS {
        return Err(Error::TooMany(points.len(), MOST_POINTS));
    }
    Ok(Found { format, points })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(text: &str) -> Result<Vec<[f64; 2]>, String> {
        let found = read("file", text).map_err(|error| error.to_string())?;
        Ok(found.points.iter().map(DVec2::to_array).collect())
    }

    #[test]
    fn every_format_gives_the_same_points() {
        let wanted = Ok(vec![[1.0, 2.0], [3.0, -4.5]]);
        for text in [
            "1 2\n3 -4.5\n",
            "# two\n1\t2 # first\n\n3\t-4.5",
            "x,y\r\n1,2\r\n3,-4.5\r\n",
            "id;y;x\na;2;1\nb;-4.5;3\n",
            "\u{feff}[[1,2],[3,-4.5]]",
            r#"{"type":"MultiPoint","coordinates":[[1,2],[3,-4.5,7]]}"#,
            r#"{"type":"FeatureCollection","features":[
                {"type":"Feature","geometry":{"type":"Point","coordinates":[1,2]}},
                {"type":"Feature","geometry":{"type":"Point","coordinates":[3,-4.5]}}]}"#,
            r#"<svg xmlns="http://www.w3.org/2000/svg"><g><circle cx="1" cy="2" r="1"/>
                <circle cx="3" cy="-4.5"/></g></svg>"#,
            r#"<svg xmlns="http://www.w3.org/2000/svg"><polyline points="1,2 3,-4.5"/></svg>"#,
        ] {
            assert_eq!(points(text), wanted, "{text}");
        }
    }

    #[test]
    fn what_is_no_file_of_points_is_named() {
        for (text, why) in [
            ("", "no point"),
            ("hello", "line 1"),
            ("1 2\n3 x", "line 2"),
            ("1 2\n3", "line 2"),
            ("{", "not JSON"),
            ("{\"type\":\"Polygon\"}", "Polygon"),
            ("<svg", "not XML"),
            ("<html/>", "not an SVG"),
            ("<svg xmlns=\"http://www.w3.org/2000/svg\"/>", "no point"),
            ("\u{0}\u{1}PNG\u{fffd}", "line 1"),
        ] {
            let error = points(text).unwrap_err();
            assert!(error.contains(why), "{text}: {error}");
        }
    }
}
