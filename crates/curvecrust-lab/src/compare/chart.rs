//! Line charts: one line per algorithm with a band of confidence, each with a colour,
//! dashes and a marker of its own, and named at its end.

use crate::compare::axis::{Axis, Scale};
use crate::drawing::{Within, document, path, polyline, rounded, text, text_width};
use curvecrust::DVec2;
use svg::node::element::path::Data;
use svg::node::element::{Path, Text};
use svg::{Document, Node};

/// Lines over an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// What it shows.
    pub title: String,
    /// Below.
    pub x: Axis,
    /// At the left.
    pub y: Axis,
    /// The lines, the most important first: it is drawn on top.
    pub lines: Vec<Line>,
}

/// One line of a chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Its name.
    pub name: String,
    /// Its look: the same for the same algorithm in all charts.
    pub look: usize,
    /// Its points, ascending in x.
    pub marks: Vec<Mark>,
}

/// A point of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mark {
    /// Along the x axis.
    pub x: f64,
    /// Along the y axis.
    pub y: f64,
    /// The band around y.
    pub band: [f64; 2],
}

/// How wide a plot is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Width {
    /// For a page: names stand beside the ends of the lines.
    Wide,
    /// For a telephone: names stand below.
    Narrow,
}

/// Where the values are drawn: the corners in pixels, and the ranges between them.
struct Frame {
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
    x: [f64; 2],
    y: [f64; 2],
}

/// The number of looks of lines.
const LINES: usize = 8;
const TOP: f64 = 62.0;
const LEGEND_LINE: f64 = 20.0;
const HEAD_LINE: f64 = 20.0;
/// Below an axis: lines at its zero are moved and marked this far down.
const TICK_LABEL: f64 = 27.0;
/// Equal lines are moved apart by this many pixels each, so that all of them can be seen.
const APART: f64 = 2.2;
/// All of them together are moved by no more than this, so that none is taken for another value.
const ALL_APART: f64 = 11.0;

impl Chart {
    /// The chart as SVG.
    #[must_use]
    pub fn to_svg(&self, width: Width, within: Within) -> String {
        let names = self.lines.iter().map(|line| text_width(&line.name));
        let named = names.fold(0.0, f64::max);
        let (total, beside, plot) = match width {
            Width::Wide => (760.0, named + 34.0, 330.0),
            Width::Narrow => (360.0, 14.0, 240.0),
        };
        let columns = (((total - 20.0) / (named + 44.0)).floor()).max(1.0);
        let rows = match width {
            Width::Wide => 0.0,
            Width::Narrow => (self.lines.len() as f64 / columns).ceil(),
        };
        let heading = wrapped(&self.title, (total - 24.0) / 8.6);
        let top = TOP + HEAD_LINE * (heading.len() as f64 - 1.0);
        let bottom = top + plot;
        let frame = Frame {
            left: 58.0,
            right: total - beside,
            top,
            bottom,
            x: self.x.range(self.marks().map(|m| [m.x, m.x])),
            y: self.y.range(self.marks().map(|m| m.band)),
        };
        let size = DVec2::new(total, bottom + 58.0 + rows * LEGEND_LINE);
        let mut svg = document(&self.title, size, within).set("class", "plot");
        for (i, line) in heading.iter().enumerate() {
            let at = DVec2::new(12.0, 22.0 + HEAD_LINE * i as f64);
            svg.append(text("head", at, line));
        }
        self.draw_axes(&mut svg, &frame);
        let middle = (self.lines.len() as f64 - 1.0) / 2.0;
        for (i, line) in self.lines.iter().enumerate().rev() {
            // On log axes equal values are rare, and a pixel is worth more.
            let equal = self.y.scale == Scale::Linear;
            let apart = if equal {
                (i as f64 - middle) * APART.min(0.5 * ALL_APART / middle)
            } else {
                0.0
            };
            self.draw_line(&mut svg, &frame, line, apart);
        }
        match width {
            Width::Wide => self.name_ends(&mut svg, &frame),
            Width::Narrow => self.name_below(&mut svg, bottom + 64.0, named + 44.0, columns),
        }
        svg.to_string() + "\n"
    }

    fn marks(&self) -> impl Iterator<Item = &Mark> {
        self.lines.iter().flat_map(|line| &line.marks)
    }

    fn draw_axes(&self, svg: &mut Document, frame: &Frame) {
        let Frame {
            left,
            right,
            top,
            bottom,
            ..
        } = *frame;
        let anchored = |anchor: &str, class: &str, x: f64, y: f64, words: &str| -> Text {
            text(class, DVec2::new(x, y), words).set("text-anchor", anchor)
        };
        svg.append(text("faint", DVec2::new(12.0, top - 18.0), &self.y.label));
        for value in self.y.ticks(frame.y, 6.0) {
            let y = rounded(self.y.place(value, frame.y, [bottom, top]));
            svg.append(path("grid", format!("M{left} {y}H{right}")));
            let written = self.y.written(value);
            svg.append(anchored("end", "tick", left - 8.0, y + 4.5, &written));
        }
        let wanted = (right - left) / 55.0;
        for value in self.x.ticks(frame.x, wanted) {
            let x = rounded(self.x.place(value, frame.x, [left, right]));
            svg.append(path("axis", format!("M{x} {bottom}v5")));
            let written = self.x.written(value);
            svg.append(anchored("middle", "tick", x, bottom + TICK_LABEL, &written));
        }
        svg.append(path("axis", format!("M{left} {bottom}H{right}")));
        let (x, y) = (f64::midpoint(left, right), bottom + TICK_LABEL + 21.0);
        svg.append(anchored("middle", "faint", x, y, &self.x.label));
    }

    fn place(&self, frame: &Frame, x: f64, y: f64) -> DVec2 {
        let x = self.x.place(x, frame.x, [frame.left, frame.right]);
        let y = self.y.place(y, frame.y, [frame.bottom, frame.top]);
        DVec2::new(rounded(x), rounded(y))
    }

    fn draw_line(&self, svg: &mut Document, frame: &Frame, line: &Line, apart: f64) {
        // Across the line where it is steep too: to the left of one that falls, to the right of one
        // that rises.
        let falls = match (line.marks.first(), line.marks.last()) {
            (Some(first), Some(last)) => first.y > last.y,
            _ => false,
        };
        let aside = DVec2::new(if falls { -apart } else { apart }, apart);
        let place = |(x, y): (f64, f64)| self.place(frame, x, y) + aside;
        let look = line.look % LINES;
        let upper = line.marks.iter().map(|m| (m.x, m.band[1]));
        let lower = line.marks.iter().rev().map(|m| (m.x, m.band[0]));
        let band = polyline(Data::new(), upper.chain(lower).map(place), true);
        svg.append(path(&format!("band fill{look}"), band));
        let means = line.marks.iter().map(|m| place((m.x, m.y)));
        let through = polyline(Data::new(), means.clone(), false);
        svg.append(path(&format!("line line{look}"), through));
        means.for_each(|at| svg.append(marker(look, at)));
    }

    /// Names at the ends of the lines, moved apart where these are close.
    fn name_ends(&self, svg: &mut Document, frame: &Frame) {
        let last = |line: &Line| line.marks.last().map(|m| self.place(frame, m.x, m.y));
        let mut ends: Vec<(&Line, DVec2)> = self
            .lines
            .iter()
            .filter_map(|l| Some((l, last(l)?)))
            .collect();
        ends.sort_by(|a, b| a.1.y.total_cmp(&b.1.y));
        let wanted: Vec<f64> = ends.iter().map(|end| end.1.y).collect();
        let placed = spread(&wanted, 17.0, frame.top, frame.bottom);
        for ((line, end), at) in ends.iter().zip(placed) {
            let from = DVec2::new(end.x + 6.0, end.y);
            let to = DVec2::new(frame.right + 16.0, at);
            svg.append(path("leader", polyline(Data::new(), [from, to], false)));
            let class = format!("fill{}", line.look % LINES);
            svg.append(text(&class, to + DVec2::new(4.0, 4.5), &line.name));
        }
    }

    fn name_below(&self, svg: &mut Document, top: f64, step: f64, columns: f64) {
        for (i, line) in self.lines.iter().enumerate() {
            let (column, row) = (i as f64 % columns, (i as f64 / columns).floor());
            let (x, y) = (
                rounded(12.0 + column * step),
                rounded(top + row * LEGEND_LINE),
            );
            let look = line.look % LINES;
            let class = format!("line line{look}");
            svg.append(path(&class, format!("M{x} {y}h28")));
            svg.append(marker(look, DVec2::new(x + 14.0, y)));
            svg.append(text("name", DVec2::new(x + 34.0, y + 4.5), &line.name));
        }
    }
}

/// A marker around a point; each look has its own.
fn marker(look: usize, at: DVec2) -> Path {
    let (aside, shape) = match look {
        0 => ((-4.2, 0.0), "a4.2 4.2 0 1 0 8.4 0a4.2 4.2 0 1 0 -8.4 0Z"),
        1 => ((-3.5, -3.5), "h7v7h-7Z"),
        2 => ((0.0, -4.8), "l4.6 8h-9.2Z"),
        3 => ((0.0, -5.0), "l5 5l-5 5l-5 -5Z"),
        4 => ((0.0, 4.8), "l4.6 -8h-9.2Z"),
        5 => ((-1.5, -4.5), "h3v3h3v3h-3v3h-3v-3h-3v-3h3Z"),
        6 => ((-5.0, -2.0), "h10v4h-10Z"),
        _ => ((-2.0, -5.0), "h4v10h-4Z"),
    };
    let start = at + DVec2::from(aside);
    let data = format!("M{} {}{shape}", rounded(start.x), rounded(start.y));
    path(&format!("marker fill{look}"), data)
}

/// Ascending places at least `gap` apart within the ends, near to the wanted ones.
fn spread(wanted: &[f64], gap: f64, low: f64, high: f64) -> Vec<f64> {
    let mut placed: Vec<f64> = Vec::with_capacity(wanted.len());
    for &at in wanted {
        let least = placed.last().map_or(low, |last| last + gap);
        placed.push(at.max(least));
    }
    let mut most = high;
    for at in placed.iter_mut().rev() {
        *at = at.min(most);
        most = *at - gap;
    }
    placed
}

/// The words of a text in lines of about `most` characters.
fn wrapped(text: &str, most: f64) -> Vec<String> {
    let mut lines: Vec<String> = vec![String::new()];
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if line.is_empty() => line.push_str(word),
            Some(line) if ((line.chars().count() + 1 + word.chars().count()) as f64) < most => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_moved_apart() {
        let placed = spread(&[10.0, 10.0, 11.0, 99.0, 100.0], 17.0, 0.0, 100.0);
        assert!(
            placed.windows(2).all(|p| p[1] - p[0] >= 17.0 - 1e-9),
            "{placed:?}"
        );
        assert!(placed[4] <= 100.0);
    }
}
