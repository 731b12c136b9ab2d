//! Line charts: one line per algorithm with a band of confidence, each told apart by colour, dashes
//! and marker, and named at its end.

use std::fmt::Write;

use crate::compare::axis::{Axis, Scale};
use crate::compare::style::{LINES, escaped, open, text_width};

pub use crate::compare::style::Paper;

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

/// Where the values are drawn.
struct Frame {
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
    x: [f64; 2],
    y: [f64; 2],
}

const TOP: f64 = 62.0;
const LEGEND_LINE: f64 = 20.0;
const HEAD_LINE: f64 = 20.0;
/// Below an axis: lines at its zero are moved and marked this far down.
const TICK_LABEL: f64 = 27.0;
/// Lines are moved so many pixels apart, so that equal ones can be told from each other, and all of
/// them over no more than so many, so that none is taken for another value.
const APART: f64 = 2.2;
const ALL_APART: f64 = 11.0;

impl Chart {
    /// The chart as SVG.
    #[must_use]
    pub fn to_svg(&self, width: Width, paper: Paper) -> String {
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
        let height = bottom + 58.0 + rows * LEGEND_LINE;
        let mut svg = open(&self.title, total, height, paper);
        for (i, line) in heading.iter().enumerate() {
            let (y, line) = (22.0 + HEAD_LINE * i as f64, escaped(line));
            let _ = writeln!(svg, "<text class=\"head\" x=\"12\" y=\"{y}\">{line}</text>");
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
        svg + "</svg>\n"
    }

    fn marks(&self) -> impl Iterator<Item = &Mark> {
        self.lines.iter().flat_map(|line| &line.marks)
    }

    fn draw_axes(&self, svg: &mut String, frame: &Frame) {
        let Frame {
            left,
            right,
            top,
            bottom,
            ..
        } = *frame;
        let label = escaped(&self.y.label);
        let _ = writeln!(
            svg,
            "<text class=\"faint\" x=\"12\" y=\"{}\">{label}</text>",
            top - 18.0
        );
        for value in self.y.ticks(frame.y, 6.0) {
            let y = px(self.y.place(value, frame.y, [bottom, top]));
            let _ = writeln!(
                svg,
                "<path class=\"grid\" d=\"M{left} {y}H{right}\"/>\
                 <text text-anchor=\"end\" x=\"{}\" y=\"{}\">{}</text>",
                left - 8.0,
                px(y + 4.5),
                self.y.written(value)
            );
        }
        let wanted = (right - left) / 55.0;
        for value in self.x.ticks(frame.x, wanted) {
            let x = px(self.x.place(value, frame.x, [left, right]));
            let _ = writeln!(
                svg,
                "<path class=\"axis\" d=\"M{x} {bottom}v5\"/>\
                 <text text-anchor=\"middle\" x=\"{x}\" y=\"{}\">{}</text>",
                bottom + TICK_LABEL,
                self.x.written(value)
            );
        }
        let _ = writeln!(
            svg,
            "<path class=\"axis\" d=\"M{left} {bottom}H{right}\"/>\
             <text class=\"faint\" text-anchor=\"middle\" x=\"{}\" y=\"{}\">{}</text>",
            px(f64::midpoint(left, right)),
            bottom + TICK_LABEL + 21.0,
            escaped(&self.x.label)
        );
    }

    fn place(&self, frame: &Frame, x: f64, y: f64) -> (f64, f64) {
        let x = self.x.place(x, frame.x, [frame.left, frame.right]);
        let y = self.y.place(y, frame.y, [frame.bottom, frame.top]);
        (px(x), px(y))
    }

    fn draw_line(&self, svg: &mut String, frame: &Frame, line: &Line, apart: f64) {
        // Across the line where it is steep too: to the left of one that falls, to the right of one that
        // rises.
        let falls = match (line.marks.first(), line.marks.last()) {
            (Some(first), Some(last)) => first.y > last.y,
            _ => false,
        };
        let aside = if falls { -apart } else { apart };
        let place = |x: f64, y: f64| {
            let (x, y) = self.place(frame, x, y);
            (px(x + aside), px(y + apart))
        };
        let look = line.look % LINES;
        let path = |ends: &mut dyn Iterator<Item = (f64, f64)>| {
            let mut d = String::new();
            for (i, (x, y)) in ends.enumerate() {
                let (x, y) = place(x, y);
                let _ = write!(d, "{}{x} {y}", if i == 0 { "M" } else { "L" });
            }
            d
        };
        let upper = line.marks.iter().map(|m| (m.x, m.band[1]));
        let lower = line.marks.iter().rev().map(|m| (m.x, m.band[0]));
        let band = path(&mut upper.chain(lower));
        let middle = path(&mut line.marks.iter().map(|m| (m.x, m.y)));
        let _ = writeln!(
            svg,
            "<path class=\"b{look}\" d=\"{band}Z\"/><path class=\"l{look}\" d=\"{middle}\"/>"
        );
        for mark in &line.marks {
            let (x, y) = place(mark.x, mark.y);
            svg.push_str(&marker(look, x, y));
        }
        svg.push('\n');
    }

    /// Names at the ends of the lines, moved apart where these are close.
    fn name_ends(&self, svg: &mut String, frame: &Frame) {
        let last = |line: &Line| line.marks.last().map(|m| self.place(frame, m.x, m.y));
        let mut ends: Vec<(&Line, (f64, f64))> = self
            .lines
            .iter()
            .filter_map(|l| Some((l, last(l)?)))
            .collect();
        ends.sort_by(|a, b| a.1.1.total_cmp(&b.1.1));
        let wanted: Vec<f64> = ends.iter().map(|end| end.1.1).collect();
        let placed = spread(&wanted, 17.0, frame.top, frame.bottom);
        for ((line, (x, y)), at) in ends.iter().zip(placed) {
            let (from, to) = (x + 6.0, frame.right + 16.0);
            let at = px(at);
            let _ = writeln!(
                svg,
                "<path class=\"leader\" d=\"M{} {y}L{} {at}\"/>\
                 <text class=\"t{}\" x=\"{}\" y=\"{}\">{}</text>",
                px(from),
                px(to),
                line.look % LINES,
                px(to + 4.0),
                px(at + 4.5),
                escaped(&line.name)
            );
        }
    }

    fn name_below(&self, svg: &mut String, top: f64, step: f64, columns: f64) {
        for (i, line) in self.lines.iter().enumerate() {
            let (column, row) = (i as f64 % columns, (i as f64 / columns).floor());
            let (x, y) = (px(12.0 + column * step), px(top + row * LEGEND_LINE));
            let look = line.look % LINES;
            let _ = writeln!(
                svg,
                "<path class=\"l{look}\" d=\"M{x} {y}h28\"/>{}<text x=\"{}\" y=\"{}\">{}</text>",
                marker(look, x + 14.0, y),
                x + 34.0,
                px(y + 4.5),
                escaped(&line.name)
            );
        }
    }
}

/// A marker around a point; each look has its own.
fn marker(look: usize, x: f64, y: f64) -> String {
    let d = match look {
        0 => format!(
            "M{} {y}a4.2 4.2 0 1 0 8.4 0a4.2 4.2 0 1 0 -8.4 0Z",
            px(x - 4.2)
        ),
        1 => format!("M{} {}h7v7h-7Z", px(x - 3.5), px(y - 3.5)),
        2 => format!("M{x} {}l4.6 8h-9.2Z", px(y - 4.8)),
        3 => format!("M{x} {}l5 5l-5 5l-5 -5Z", px(y - 5.0)),
        4 => format!("M{x} {}l4.6 -8h-9.2Z", px(y + 4.8)),
        5 => format!(
            "M{} {}h3v3h3v3h-3v3h-3v-3h-3v-3h3Z",
            px(x - 1.5),
            px(y - 4.5)
        ),
        6 => format!("M{} {}h10v4h-10Z", px(x - 5.0), px(y - 2.0)),
        _ => format!("M{} {}h4v10h-4Z", px(x - 2.0), px(y - 5.0)),
    };
    format!("<path class=\"m{look}\" d=\"{d}\"/>")
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

/// The words of a text in lines of about so many characters.
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

/// To a hundredth of a pixel.
fn px(value: f64) -> f64 {
    (value * 100.0).round() / 100.0 + 0.0
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
