//! Archives of NumPy arrays (`.npz`), by the crate `zip`: one array of points, or one of all x and
//! one of all y.

mod bounded;

use super::columns::{ColumnNames, HEIGHTS, KNOWN};
use super::quote::{left_out, listed};
use super::{Flaw, PointList, Problem, ReadOptions, npy, quoted};
use crate::input::Seekable;
use bounded::Bounded;
use curvecrust::DVec2;
use std::io::{BufReader, Read};
use zip::ZipArchive;
use zip::result::ZipError;

/// Names of arrays that hold points, if there are several.
const POINTS: &[&str] = &["points", "samples", "xy"];

type Archive = ZipArchive<BufReader<Seekable>>;

/// Where in the archive the coordinates are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Choice {
    /// An array of rows of x and y.
    Rows(usize),
    /// Two arrays.
    Columns(usize, usize),
}

pub(super) fn read(source: Seekable, options: &ReadOptions) -> Result<PointList, Flaw> {
    let size = source.size()?;
    let mut archive = ZipArchive::new(BufReader::new(source)).map_err(flaw)?;
    let names_of = (0..archive.len()).filter_map(|index| archive.name_for_index(index));
    let arrays = names_of.map(|name| name.map(|name| stem(&name)).map_err(flaw));
    let arrays: Vec<String> = arrays.collect::<Result<_, _>>()?;
    let choice = choose(&arrays, options.columns.as_ref())?;
    let (mut list, taken) = match choice {
        Choice::Rows(index) => {
            let list = within(&mut archive, index, &arrays, size, |array| {
                npy::read(array, options)
            })?;
            (list, vec![index])
        }
        Choice::Columns(x, y) => columns(&mut archive, [x, y], &arrays, size, options)?,
    };
    list.notes.extend(note(&arrays, choice, &taken));
    Ok(list)
}

/// Reads two arrays of coordinates and, if heights are wanted, a third; and says which these are.
fn columns(
    archive: &mut Archive,
    [x, y]: [usize; 2],
    arrays: &[String],
    size: u64,
    options: &ReadOptions,
) -> Result<(PointList, Vec<usize>), Flaw> {
    let mut read = |index: usize| {
        let read = |array: &mut dyn Read| npy::read_column(array);
        within(archive, index, arrays, size, read)
    };
    let xs = read(x)?;
    let of_length = |index: usize, values: Vec<f64>| match values.len() == xs.len() {
        true => Ok(values),
        false => Err(Problem::Rows {
            first: name(arrays, x),
            second: name(arrays, index),
            first_rows: xs.len(),
            second_rows: values.len(),
        }),
    };
    let ys = of_length(y, read(y)?)?;
    let mut taken = vec![x, y];
    let mut heights = None;
    if options.heights {
        let is_height = |name: &str| {
            HEIGHTS
                .iter()
                .any(|height| name.eq_ignore_ascii_case(height))
        };
        let z =
            (0..arrays.len()).find(|&index| !taken.contains(&index) && is_height(&arrays[index]));
        let z = z.ok_or(Problem::NoHeight)?;
        heights = Some(of_length(z, read(z)?)?);
        taken.push(z);
    }
    let points = xs.iter().zip(ys).map(|(&x, y)| DVec2::new(x, y));
    let list = PointList {
        points: points.collect(),
        heights,
        ..PointList::default()
    };
    Ok((list, taken))
}

/// Reads one array, which may unpack to no more than its packed size allows.
fn within<T>(
    archive: &mut Archive,
    index: usize,
    arrays: &[String],
    size: u64,
    read: impl Fn(&mut dyn Read) -> Result<T, Flaw>,
) -> Result<T, Flaw> {
    let result = archive.by_index(index).map_err(flaw).and_then(|file| {
        // What the archive says may be more than it has.
        let packed = file.compressed_size().min(size);
        read(&mut Bounded::new(file, packed))
    });
    result.map_err(|flaw| {
        let (name, flaw) = (quoted(arrays[index].as_bytes()), Box::new(flaw));
        Problem::InArray { name, flaw }.into()
    })
}

fn choose(arrays: &[String], names: Option<&ColumnNames>) -> Result<Choice, Problem> {
    let place = |name: &str| arrays.iter().position(|array| array == name);
    let any = |names: &[&str]| {
        let mut arrays = arrays.iter();
        arrays.position(|array| names.iter().any(|name| array.eq_ignore_ascii_case(name)))
    };
    if let Some(ColumnNames { x, y }) = names {
        let find = |name: &str| {
            place(name).ok_or_else(|| Problem::NoArrayNamed {
                missing: listed([name.as_bytes()].into_iter()),
                found: all(arrays),
            })
        };
        return Ok(Choice::Columns(find(x)?, find(y)?));
    }
    for [x, y] in KNOWN {
        if let (Some(x), Some(y)) = (any(x), any(y)) {
            return Ok(Choice::Columns(x, y));
        }
    }
    match (any(POINTS), arrays) {
        (Some(index), _) => Ok(Choice::Rows(index)),
        (None, []) => Err(Problem::NoPoints),
        (None, [_]) => Ok(Choice::Rows(0)),
        (None, _) => Err(Problem::Arrays(all(arrays))),
    }
}

/// What the user should know about the choice.
fn note(arrays: &[String], choice: Choice, taken: &[usize]) -> Option<String> {
    let mut notes = Vec::new();
    if let Choice::Columns(x, y) = choice {
        let [x, y] = [x, y].map(|index| name(arrays, index));
        if [&*x, &*y] != ["`x`", "`y`"] {
            notes.push(format!("x is the array {x}, y is {y}"));
        }
    }
    let others = (0..arrays.len()).filter(|index| !taken.contains(index));
    let others: Vec<&[u8]> = others.map(|index| arrays[index].as_bytes()).collect();
    if !others.is_empty() {
        notes.push(left_out(others.into_iter()));
    }
    (!notes.is_empty()).then(|| notes.join("; "))
}

/// The name of an array is that of its file without the ending.
fn stem(name: &str) -> String {
    name.strip_suffix(".npy").unwrap_or(name).to_owned()
}

fn name(arrays: &[String], index: usize) -> String {
    listed([arrays[index].as_bytes()].into_iter())
}

fn all(arrays: &[String]) -> String {
    listed(arrays.iter().map(String::as_bytes))
}

fn flaw(error: ZipError) -> Flaw {
    match error {
        ZipError::Io(error) => error.into(),
        other => Problem::Archive(other.to_string()).into(),
    }
}
