//! GPX, the exchange format of GPS receivers: all way points and points of routes and tracks, in
//! order, longitude as x and latitude as y.

use super::gathered::Gathered;
use super::system::DEGREES;
use super::xml::{line_of, with_root};
use super::{Flaw, PointList, Problem, Wanted, coordinate};

pub(super) fn read(bytes: &[u8], wanted: &Wanted) -> Result<PointList, Flaw> {
    let document = with_root(bytes, "gpx", || Problem::NotGpx)?;
    let mut found = Gathered::new(wanted);
    found.note(format!("x is the longitude, y the latitude: {DEGREES}"));
    for node in document.root_element().descendants() {
        if !matches!(node.tag_name().name(), "wpt" | "rtept" | "trkpt") {
            continue;
        }
        found.go_to(line_of(node));
        let value = |name: &str| {
            let word = node.attribute(name).unwrap_or_default();
            coordinate(word.trim().as_bytes(), false).map_err(|problem| found.flaw(problem))
        };
        let [x, y] = [value("lon")?, value("lat")?];
        found.point(x, y)?;
        found.height(
            node.children()
                .any(|child| child.tag_name().name() == "ele"),
        );
    }
    Ok(found.finish())
}
