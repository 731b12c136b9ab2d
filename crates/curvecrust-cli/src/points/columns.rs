//! Which columns of a table hold the coordinates.

use super::quote::{left_out, listed};
use super::records::Records;
use super::system::DEGREES;
use super::{Flaw, Place, Problem};

/// Names of columns that were asked for.
#[derive(Clone, Debug)]
pub(crate) struct ColumnNames {
    pub(crate) x: String,
    pub(crate) y: String,
}

/// Indices of the columns of x and y.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Columns {
    pub(super) x: usize,
    pub(super) y: usize,
    /// That of the heights, if there is one.
    pub(super) z: Option<usize>,
    /// That which marks ends of curves, if there is one.
    pub(super) terminus: Option<usize>,
}

/// Names of columns of x and of y that belong together, in small letters.
pub(super) const KNOWN: [[&[&str]; 2]; 3] = [
    [&["x"], &["y"]],
    [&["lon", "lng", "long", "longitude"], &["lat", "latitude"]],
    [&["easting"], &["northing"]],
];

/// Names of columns of heights, in small letters.
pub(super) const HEIGHTS: &[&str] = &["z", "h", "height", "alt", "altitude", "ele", "elevation"];

impl Columns {
    /// Of a table without names.
    pub(super) fn first(width: usize) -> Self {
        Self {
            x: 0,
            y: 1,
            z: (width == 3).then_some(2),
            terminus: None,
        }
    }

    /// The columns that have the names, or names that are known; `None` if there are none.
    pub(super) fn of_header(
        header: &impl Records,
        names: Option<&ColumnNames>,
    ) -> Result<Option<Self>, Flaw> {
        let pair = |x: Option<usize>, y: Option<usize>| {
            let (x, y) = (x?, y?);
            let is_height = |column: &usize| *column != x && *column != y;
            let z = heights(header).find(is_height);
            let is_mark = |column: &usize| is_one_of(header.field(*column), &["terminus"]);
            let terminus = (0..header.len()).find(is_mark);
            Some(Self { x, y, z, terminus })
        };
        if let Some(ColumnNames { x, y }) = names {
            return Ok(pair(asked(header, x)?, asked(header, y)?));
        }
        for [x, y] in KNOWN {
            let found = pair(known(header, x)?, known(header, y)?);
            if found.is_some() {
                return Ok(found);
            }
        }
        Ok(None)
    }

    /// What the user should know about the choice; `None` if it is as plain as x and y.
    pub(super) fn note(self, header: &impl Records, keeps_heights: bool) -> Option<String> {
        let Self { x, y, z, .. } = self;
        let [x_name, y_name] = [x, y].map(|column| header.field(column));
        let mut notes = Vec::new();
        if !(x_name.eq_ignore_ascii_case(b"x") && y_name.eq_ignore_ascii_case(b"y")) {
            let [x, y] = [x_name, y_name].map(|name| listed([name].into_iter()));
            let degrees = match is_longitude(x_name) {
                true => format!(": {DEGREES}"),
                false => String::new(),
            };
            notes.push(format!("x is the column {x}, y is {y}{degrees}"));
        }
        let kept = z.filter(|_| keeps_heights);
        let others =
            heights(header).filter(|&column| ![Some(x), Some(y), kept].contains(&Some(column)));
        let others: Vec<&[u8]> = others.map(|column| header.field(column)).collect();
        if !others.is_empty() {
            notes.push(left_out(others.into_iter()));
        }
        (!notes.is_empty()).then(|| notes.join("; "))
    }
}

/// The columns that have a name of heights.
fn heights(header: &impl Records) -> impl Iterator<Item = usize> {
    let is_height = |&column: &usize| is_one_of(without_unit(header.field(column)), HEIGHTS);
    (0..header.len()).filter(is_height)
}

/// Whether a column has a name of longitudes, which are degrees.
pub(super) fn is_longitude(name: &[u8]) -> bool {
    is_one_of(without_unit(name), KNOWN[1][0])
}

/// Why a header is none that is understood.
pub(super) fn not_found(header: &impl Records, names: Option<&ColumnNames>) -> Flaw {
    let found = listed((0..header.len()).map(|column| header.field(column)));
    let missing = match names {
        Some(ColumnNames { x, y }) => [x, y]
            .into_iter()
            .find(|name| !matches!(asked(header, name), Ok(Some(_)))),
        None => None,
    };
    let problem = match missing {
        Some(name) => Problem::NoColumn {
            missing: listed([name.as_bytes()].into_iter()),
            found,
        },
        None => Problem::NoColumns { found },
    };
    problem.at(Place::Line(header.line()))
}

/// The column of a name as it was typed, else in other letters.
fn asked(header: &impl Records, name: &str) -> Result<Option<usize>, Flaw> {
    let name = name.trim().as_bytes();
    let exact = (0..header.len()).find(|&column| header.field(column) == name);
    match exact {
        Some(column) => Ok(Some(column)),
        None => only(header, |field| field.eq_ignore_ascii_case(name)),
    }
}

/// The column that has one of the names, else one of them and a unit, as in `X (m)`.
fn known(header: &impl Records, names: &[&str]) -> Result<Option<usize>, Flaw> {
    match only(header, |field| is_one_of(field, names))? {
        Some(column) => Ok(Some(column)),
        None => only(header, |field| is_one_of(without_unit(field), names)),
    }
}

fn only(header: &impl Records, is_it: impl Fn(&[u8]) -> bool) -> Result<Option<usize>, Flaw> {
    let mut found = (0..header.len()).filter(|&column| is_it(header.field(column)));
    match (found.next(), found.next()) {
        (Some(first), Some(second)) => {
            let names = [first, second].map(|column| header.field(column));
            let problem = Problem::TwoColumns(listed(names.into_iter()));
            Err(problem.at(Place::Line(header.line())))
        }
        (column, _) => Ok(column),
    }
}

fn is_one_of(field: &[u8], names: &[&str]) -> bool {
    let mut names = names.iter();
    names.any(|name| field.eq_ignore_ascii_case(name.as_bytes()))
}

/// A name without what stands in brackets behind it.
fn without_unit(field: &[u8]) -> &[u8] {
    match field {
        [.., b')' | b']'] => {
            let name = field.split(|byte| b"([".contains(byte)).next();
            name.unwrap_or_default().trim_ascii()
        }
        _ => field,
    }
}
