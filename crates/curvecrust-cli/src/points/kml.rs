//! KML, of Google Earth and others: the coordinates of all points and tracks, in order, longitude
//! as x and latitude as y; the vertices of lines and polygons on request.

use super::gathered::Gathered;
use super::system::DEGREES;
use super::value::coordinate;
use super::xml::{line_of, with_root};
use super::{Flaw, Place, PointList, Problem, Wanted, quoted};
use roxmltree::Node;

pub(super) fn read(bytes: &[u8], wanted: &Wanted) -> Result<PointList, Flaw> {
    let document = with_root(bytes, "kml", || Problem::NotKml)?;
    let mut found = Gathered::new(wanted);
    found.note(format!("x is the longitude, y the latitude: {DEGREES}"));
    for node in document.root_element().descendants() {
        found.go_to(line_of(node));
        match node.tag_name().name() {
            "Point" => {
                for position in positions(node) {
                    let [x, y] = take(&mut found, &position)?;
                    found.point(x, y)?;
                }
            }
            // A track has an element for each of its points.
            "coord" => {
                let [x, y] = take(&mut found, &Position::of_track(node))?;
                found.point(x, y)?;
            }
            name @ ("LineString" | "LinearRing") => {
                found.wants_vertices(name)?;
                let vertices = positions(node).map(|position| take(&mut found, &position));
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
    fn of_track(node: Node<'a, '_>) -> Self {
        let whole = node.text().unwrap_or_default().trim();
        Self {
            words: whole.split_ascii_whitespace().collect(),
            whole,
            place: line_of(node),
        }
    }
}

/// The positions of a geometry: numbers with commas between, and white space between positions.
fn positions<'a>(geometry: Node<'a, 'a>) -> impl Iterator<Item = Position<'a>> {
    let lists = geometry.children();
    let lists = lists.filter(|child| child.tag_name().name() == "coordinates");
    lists.flat_map(|list| {
        let place = line_of(list);
        let text = list.text().unwrap_or_default();
        text.split_ascii_whitespace().map(move |whole| Position {
            words: whole.split(',').collect(),
            whole,
            place,
        })
    })
}

/// The longitude and the latitude of a position.
fn take(found: &mut Gathered, position: &Position<'_>) -> Result<[f64; 2], Flaw> {
    let [x, y, heights @ ..] = &position.words[..] else {
        let problem = Problem::Short(quoted(position.whole.as_bytes()));
        return Err(problem.at(position.place));
    };
    let value = |word: &str| {
        coordinate(word.as_bytes(), false).map_err(|problem| problem.at(position.place))
    };
    // Every position of Google Earth has a height, which is 0 on a map.
    let height = heights.first().and_then(|word| word.parse::<f64>().ok());
    found.height(height.is_some_and(|height| height.abs() > 0.0));
    Ok([value(x)?, value(y)?])
}
