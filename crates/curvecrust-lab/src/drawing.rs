//! What plots and drawings are written with: documents, words and lines, on the crate `svg`.
//!
//! How they look is in one sheet, `STYLE`, by the classes of their elements. A file brings it;
//! pages have it too, beside that of their own text.

use curvecrust::DVec2;
use svg::Document;
use svg::node::element::path::Data;
use svg::node::element::{Circle, Path, Rectangle, Style, Text, Title};

/// The sheet of plots and drawings, for readers of light and of dark pages.
pub(crate) const STYLE: &str = include_str!("style/drawings.css");

/// Where a document is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Within {
    /// In a file of its own: it brings the sheet and its paper.
    File,
    /// On a page, which has both.
    Page,
}

/// A document of this size in pixels. Screen readers skip it if it has no title.
pub(crate) fn document(title: &str, size: DVec2, within: Within) -> Document {
    let (width, height) = (rounded(size.x), rounded(size.y));
    let document = Document::new()
        .set("viewBox", (0, 0, width, height))
        .set("width", width)
        .set("height", height);
    let document = if title.is_empty() {
        document.set("aria-hidden", "true")
    } else {
        document.set("role", "img").add(Title::new(title))
    };
    match within {
        Within::Page => document,
        Within::File => document
            .add(Style::new(STYLE))
            .add(rectangle("paper", DVec2::ZERO, size)),
    }
}

/// Words from a point on, on their base line.
pub(crate) fn text(class: &str, at: DVec2, words: &str) -> Text {
    let text = Text::new(words).set("class", class);
    text.set("x", rounded(at.x)).set("y", rounded(at.y))
}

pub(crate) fn path(class: &str, data: impl Into<svg::node::Value>) -> Path {
    Path::new().set("class", class).set("d", data)
}

pub(crate) fn circle(class: &str, centre: DVec2, radius: f64) -> Circle {
    let circle = Circle::new().set("class", class).set("r", rounded(radius));
    circle
        .set("cx", rounded(centre.x))
        .set("cy", rounded(centre.y))
}

pub(crate) fn rectangle(class: &str, corner: DVec2, size: DVec2) -> Rectangle {
    let rectangle = Rectangle::new().set("class", class);
    let rectangle = rectangle
        .set("x", rounded(corner.x))
        .set("y", rounded(corner.y));
    rectangle
        .set("width", rounded(size.x))
        .set("height", rounded(size.y))
}

/// Data that go on with points joined in order.
pub(crate) fn polyline(data: Data, points: impl IntoIterator<Item = DVec2>, closed: bool) -> Data {
    let at = |p: DVec2| (rounded(p.x), rounded(p.y));
    let mut points = points.into_iter();
    let Some(first) = points.next() else {
        return data;
    };
    let data = points.fold(data.move_to(at(first)), |data, p| data.line_to(at(p)));
    if closed { data.close() } else { data }
}

/// To a hundredth of a pixel, so that the same data give the same bytes everywhere.
pub(crate) fn rounded(value: f64) -> f64 {
    (value * 100.0).round() / 100.0 + 0.0
}

/// About how wide words of 13 px are.
pub(crate) fn text_width(words: &str) -> f64 {
    7.4 * words.chars().count() as f64
}
