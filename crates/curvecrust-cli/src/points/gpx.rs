//! GPX, the exchange format of GPS receivers: all way points and points of routes and tracks, in
//! order, longitude as x and latitude as y.

use super::svg::document;
use super::{Flaw, Place, PointList, Problem, coordinate};
use curvecrust::DVec2;
use roxmltree::Node;

pub(super) fn read(bytes: &[u8]) -> Result<PointList, Flaw> {
    let text = str::from_utf8(bytes).map_err(|_| Problem::NotGpx)?;
    let document = document(text)?;
    let root = document.root_element();
    if root.tag_name().name() != "gpx" {
        return Err(Problem::NotGpx.into());
    }
    let is_point =
        |node: &Node<'_, '_>| matches!(node.tag_name().name(), "wpt" | "rtept" | "trkpt");
    let nodes = root.descendants().filter(is_point);
    let points = nodes.map(|node| {
        let value = |name: &str| {
            let at = node.document().text_pos_at(node.range().start);
            let found = node.attribute(name).unwrap_or_default();
            let place = Place::Line(at.row.into());
            coordinate(found.trim().as_bytes(), false).map_err(|problem| problem.at(place))
        };
        Ok(DVec2::new(value("lon")?, value("lat")?))
    });
    Ok(PointList {
        points: points.collect::<Result<_, Flaw>>()?,
        notes: vec!["x is the longitude, y the latitude: lengths are in degrees".into()],
    })
}
