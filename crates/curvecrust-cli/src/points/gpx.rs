//! GPX, the exchange format of GPS receivers: all way points and points of routes and tracks, in
//! order, longitude as x and latitude as y.

use super::gathered::Gathered;
use super::svg::document;
use super::system::DEGREES;
use super::{Flaw, Place, PointList, Problem, Wanted, coordinate};

pub(super) fn read(bytes: &[u8], wanted: &Wanted) -> Result<PointList, Flaw> {
    let text = str::from_utf8(bytes).map_err(|_| Problem::NotGpx)?;
    let document = document(text)?;
    let root = document.root_element();
    if root.tag_name().name() != "gpx" {
        return Err(Problem::NotGpx.into());
    }
    let mut found = Gathered::new(wanted);
    found.note(format!("x is the longitude, y the latitude: {DEGREES}"));
    for node in root.descendants() {
        if !matches!(node.tag_name().name(), "wpt" | "rtept" | "trkpt") {
            continue;
        }
        let at = node.document().text_pos_at(node.range().start);
        found.go_to(Place::Line(at.row.into()));
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
