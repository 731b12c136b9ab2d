//! KML, of Google Earth and others: the coordinates of all points and tracks, in order, longitude
//! as x and latitude as y; the vertices of lines and polygons on request.

use super::gathered::{Gathered, Vertex};
use super::system::System;
use super::value::coordinate;
use super::xml::{Lines, with_root};
use super::{Flaw, Place, PointList, Problem, ReadOptions, quoted};
use roxmltree::Node;

pub(super) fn read(bytes: &[u8], options: &ReadOptions) -> Result<PointList, Flaw> {
    let document = with_root(bytes, "kml", || Problem::NotKml)?;
    let mut found = Gathered::new(options);
    found.note("x is the longitude, y the latitude");
    found.system(System::of_longitudes("WGS 84"));
    let lines = Lines::new(&document);
    for node in document.root_element().descendants() {
        found.go_to(lines.of(node));
        match node.tag_name().name() {
            "Point" => {
                for position in positions(node, &lines) {
                    let vertex = take(&found, &position)?;
                    found.point(vertex)?;
                }
            }
            // A track has an element for each of its points.
            "coord" => {
                let vertex = take(&found, &Position::of_track(node, &lines))?;
                found.point(vertex)?;
            }
            name @ ("LineString" | "LinearRing") => {
                found.wants_vertices(name)?;
                let vertices = positions(node, &lines).map(|position| take(&found, &position));
                let vertices = vertices.collect::<Result<Vec<_>, _>>()?;
                found.line(vertices.into_iter().map(Ok))?;
            }
            _ => {}
        }
    }
    Ok(found.finish())
}

/// The words of a position, and where it stands.
struct Position<'a> {
    words: Vec<&'a str>,
    whole: &'a str,
    place: Place,
}

impl<'a> Position<'a> {
    fn of_track(node: Node<'a, '_>, lines: &Lines) -> Self {
        let whole = node.text().unwrap_or_default().trim();
        Self {
            words: whole.split_ascii_whitespace().collect(),
            whole,
            place: lines.of(node),
        }
    }
}

/// The positions of a geometry: numbers with commas between, and white space between positions.
fn positions<'a>(geometry: Node<'a, 'a>, lines: &Lines) -> impl Iterator<Item = Position<'a>> {
    let lists = geometry.children();
    let lists = lists.filter(|child| child.tag_name().name() == "coordinates");
    lists.flat_map(|list| {
        let place = lines.of(list);
        let text = list.text().unwrap_or_default();
        text.split_ascii_whitespace().map(move |whole| Position {
            words: whole.split(',').collect(),
            whole,
            place,
        })
    })
}

/// The longitude, the latitude and the height of a position.
fn take(found: &Gathered, position: &Position<'_>) -> Result<Vertex, Flaw> {
    let [x, y, rest @ ..] = &position.words[..] else {
        let problem = Problem::Short(quoted(position.whole.as_bytes()));
        return Err(problem.at(position.place));
    };
    let value = |word: &str| {
        coordinate(word.as_bytes(), false).map_err(|problem| problem.at(position.place))
    };
    let height = found.height_of(rest.first().map(|word| word.as_bytes()));
    let height = height.map_err(|flaw| flaw.problem.at(position.place))?;
    Ok(([value(x)?, value(y)?], height))
}
