//! Rows of numbers: x and y by the names of their columns, or the first two.

use curvecrust::DVec2;

/// Reads one point a row. What follows a `#` is a comment.
pub(super) fn read(text: &str) -> Result<Vec<DVec2>, String> {
    let mut columns = None;
    let mut points = Vec::new();
    for (number, line) in (1..).zip(text.lines()) {
        let line = line.split('#').next().unwrap_or_default().trim();
        if line.is_empty() {
            continue;
        }
        let fields = fields(line);
        let Some(columns) = columns else {
            let (found, is_header) = columns_of(&fields);
            columns = Some(found);
            if !is_header {
                points.push(point(&fields, found).map_err(|why| at(number, &why))?);
            }
            continue;
        };
        points.push(point(&fields, columns).map_err(|why| at(number, &why))?);
    }
    Ok(points)
}

fn at(number: usize, why: &str) -> String {
    format!("line {number}: {why}")
}

/// The fields of a row, by the first separator that it has.
fn fields(line: &str) -> Vec<&str> {
    let by = [';', '\t', ','].into_iter().find(|&c| line.contains(c));
    match by {
        Some(by) => line
            .split(by)
            .map(|field| field.trim().trim_matches('"'))
            .collect(),
        None => line.split_whitespace().collect(),
    }
}

/// Where x and y stand, and whether the row names them.
fn columns_of(fields: &[&str]) -> ([usize; 2], bool) {
    let place = |names: &[&str]| {
        let mut lower = fields.iter().map(|field| field.to_lowercase());
        lower.position(|field| names.contains(&field.as_str()))
    };
    let x = place(&["x", "lon", "lng", "longitude", "east"]);
    let y = place(&["y", "lat", "latitude", "north"]);
    match (x, y) {
        (Some(x), Some(y)) => ([x, y], true),
        _ => ([0, 1], false),
    }
}

fn point(fields: &[&str], columns: [usize; 2]) -> Result<DVec2, String> {
    let [x, y] = columns.map(|column| {
        let Some(field) = fields.get(column) else {
            return Err("this is not a row with two numbers".to_owned());
        };
        let short: String = field.chars().take(20).collect();
        let number = field
            .parse::<f64>()
            .ok()
            .filter(|number| number.is_finite());
        number.ok_or_else(|| format!("{short:?} is not a number"))
    });
    Ok(DVec2::new(x?, y?))
}
