//! Whitespace text (`.xy`, `.txt`, `.p2d`): `x y` a line; empty lines and what follows a `#` do not
//! count.

use super::{Flaw, Place, Problem, coordinate, flaw::shown};
use curvecrust::DVec2;
use std::io::BufRead;

pub(super) fn read(mut reader: impl BufRead) -> Result<Vec<DVec2>, Flaw> {
    let mut points = Vec::new();
    let mut line = Vec::new();
    for number in 1.. {
        line.clear();
        if reader.read_until(b'\n', &mut line)? == 0 {
            break;
        }
        if let Some(point) = point(&line, number)? {
            points.push(point);
        }
    }
    Ok(points)
}

/// The point of a line; `None` for one that holds nothing.
fn point(line: &[u8], number: u64) -> Result<Option<DVec2>, Flaw> {
    let mut tokens = tokens(line);
    let Some(x) = tokens.next() else {
        return Ok(None);
    };
    let place = |start| Place::Column(number, column(line, start));
    let value = |(start, token)| coordinate(token).map_err(|problem| problem.at(place(start)));
    let Some(y) = tokens.next() else {
        return Err(Problem::Short(shown(x.1)).at(Place::Line(number)));
    };
    let point = DVec2::new(value(x)?, value(y)?);
    match tokens.next() {
        Some((start, third)) => Err(Problem::Long(shown(third)).at(place(start))),
        None => Ok(Some(point)),
    }
}

/// The words of a line, each with the index of its first byte.
fn tokens(line: &[u8]) -> impl Iterator<Item = (usize, &[u8])> {
    let line = line.split(|&byte| byte == b'#').next().unwrap_or_default();
    let mut start = 0;
    std::iter::from_fn(move || {
        start += line[start..]
            .iter()
            .position(|b| !b.is_ascii_whitespace())?;
        let rest = &line[start..];
        let length = rest.iter().position(u8::is_ascii_whitespace);
        let token = (start, &rest[..length.unwrap_or(rest.len())]);
        start += token.1.len();
        Some(token)
    })
}

/// The number of the character that starts at a byte, from 1.
fn column(line: &[u8], start: usize) -> usize {
    String::from_utf8_lossy(&line[..start]).chars().count() + 1
}
