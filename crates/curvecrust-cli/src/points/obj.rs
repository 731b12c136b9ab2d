//! Wavefront OBJ: the x and y of all vertices, which are lines of a `v` and numbers.

use super::heights::Heights;
use super::{Flaw, Place, PointList, Problem, ReadOptions, coordinate, quoted};
use curvecrust::DVec2;

pub(super) fn read(bytes: &[u8], options: &ReadOptions) -> Result<PointList, Flaw> {
    let mut points = Vec::new();
    let mut heights = Heights::new(options);
    for (line, text) in (1..).zip(bytes.split(|&byte| byte == b'\n')) {
        let mut words = text
            .split(u8::is_ascii_whitespace)
            .filter(|word| !word.is_empty());
        if words.next() != Some(b"v") {
            continue;
        }
        let place = Place::Line(line);
        let mut next = || {
            let word = words
                .next()
                .ok_or_else(|| Problem::Short(quoted(text)).at(place))?;
            coordinate(word, false).map_err(|problem| problem.at(place))
        };
        points.push(DVec2::new(next()?, next()?));
        let height = heights.of_word(words.next(), false);
        let taken = height.and_then(|height| heights.take(height));
        taken.map_err(|problem| problem.at(place))?;
    }
    Ok(PointList::new(points, heights))
}
