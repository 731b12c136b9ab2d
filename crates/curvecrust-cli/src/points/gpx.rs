//! GPX, the exchange format of GPS receivers: all way points and points of routes and tracks, in
//! order, longitude as x and latitude as y.

use super::gathered::Gathered;
use super::system::System;
use super::xml::{Lines, with_root};
use super::{Flaw, PointList, Problem, ReadOptions, coordinate};

pub(super) fn read(bytes: &[u8], options: &ReadOptions) -> Result<PointList, Flaw> {
    let document = with_root(bytes, "gpx", || Problem::NotGpx)?;
    let mut found = Gathered::new(options);
    found.note("x is the longitude, y the latitude");
    found.system(System::of_longitudes("WGS 84"));
    let lines = Lines::new(&document);
    for node in document.root_element().descendants() {
        if !matches!(node.tag_name().name(), "wpt" | "rtept" | "trkpt") {
            continue;
        }
        found.go_to(lines.of(node));
        let value = |name: &str| {
            let word = node.attribute(name).unwrap_or_default();
            coordinate(word.trim().as_bytes(), false).map_err(|problem| found.flaw(problem))
        };
        let place = [value("lon")?, value("lat")?];
        let mut children = node.children();
        let height = children.find(|child| child.tag_name().name() == "ele");
        let height = height.map(|node| node.text().unwrap_or_default().trim());
        found.point((place, found.height_of(height.map(str::as_bytes))?))?;
    }
    Ok(found.finish())
}
