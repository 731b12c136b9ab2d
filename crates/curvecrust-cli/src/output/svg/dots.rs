//! Dots of a puzzle in their colours, how to solve it, and the lines of its solution.

use super::frame::{Frame, LEGEND};
use super::{Data, Number};
use curvecrust::DVec2;
use curvecrust::reconstruct::closest_dot::{Colour, Dots, joins};
use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::io::{self, Write};

/// The first colours, on a light page and on a dark one. They differ for those who see few colours,
/// and in lightness.
const COLOURS: [[&str; 2]; 8] = [
    ["#0068b8", "#4aa8f0"],
    ["#d55e00", "#ff9248"],
    ["#00946b", "#35d6a4"],
    ["#333333", "#e4e4e4"],
    ["#c05c98", "#f2a8d2"],
    ["#4db2ec", "#a9e0ff"],
    ["#b39a00", "#f2e55a"],
    ["#7a451c", "#c08a5c"],
];

/// How to solve the puzzle.
const RULES: [&str; 2] = [
    "Join each dot with the closest other dot of its colour.",
    "A dot of several colours is joined once for each of them.",
];

/// Writes an open group: the dots, and the rules below them.
pub(super) fn write(out: &mut dyn Write, dots: &Dots, frame: &Frame) -> io::Result<()> {
    colours(out, dots)?;
    writeln!(out, r#"<g id="dots">"#)?;
    let radius = (360.0 / dots.points().len() as f64).clamp(3.0, 7.0) * frame.pixel;
    for (&p, colours) in dots.points().points().iter().zip(dots.colours()) {
        dot(out, p, colours, radius)?;
    }
    writeln!(out, "</g>")?;
    rules(out, frame)
}

/// Writes an open group: a line for each choice, in the colour of it.
pub(super) fn lines(out: &mut dyn Write, dots: &Dots, pixel: f64) -> io::Result<()> {
    let width = Number(2.0 * pixel);
    writeln!(
        out,
        r#"<g id="joins" fill="none" stroke-width="{width}" stroke-linecap="round">"#
    )?;
    let points = dots.points();
    let mut joins = joins(dots);
    let ends = |join: &curvecrust::reconstruct::closest_dot::Join| {
        [join.dot.min(join.closest), join.dot.max(join.closest)]
    };
    joins.sort_unstable_by_key(|join| (ends(join), join.colour));
    // Two dots that choose each other have one line.
    joins.dedup_by_key(|join| (ends(join), join.colour));
    for join in joins {
        let line = Data(ends(&join).map(|id| points[id]).into_iter(), false);
        let number = join.colour;
        let colour = light(join.colour);
        writeln!(
            out,
            r#"<path class="line-{number}" stroke="{colour}" d="{line}"/>"#
        )?;
    }
    Ok(())
}

/// What the colours are on a dark page.
fn colours(out: &mut dyn Write, dots: &Dots) -> io::Result<()> {
    let mut rules = String::from("#rules { fill: #eee }");
    for (number, [_, dark]) in COLOURS.iter().enumerate().take(dots.colour_count()) {
        // Writing to a string does not fail.
        let _ = write!(
            rules,
            " .dot-{number} {{ fill: {dark} }} .line-{number} {{ stroke: {dark} }}"
        );
    }
    writeln!(
        out,
        "<style>@media (prefers-color-scheme: dark) {{ {rules} }}</style>"
    )
}

/// A disc of one colour, or as many sectors as a dot has colours.
fn dot(out: &mut dyn Write, at: DVec2, colours: &[Colour], radius: f64) -> io::Result<()> {
    let r = Number(radius);
    if let [colour] = colours {
        let (x, y, fill) = (Number(at.x), Number(at.y), light(*colour));
        return writeln!(
            out,
            r#"<circle class="dot-{colour}" cx="{x}" cy="{y}" r="{r}" fill="{fill}"/>"#
        );
    }
    // They are larger, since each colour has a part of them alone.
    let radius = 1.25 * radius;
    let r = Number(radius);
    let turn = |i: usize| {
        let angle = TAU * (i as f64 / colours.len() as f64 - 0.25);
        at + radius * DVec2::from_angle(angle)
    };
    for (i, &colour) in colours.iter().enumerate() {
        let [from, to] = [turn(i), turn(i + 1)];
        let [x, y, x0, y0, x1, y1] = [at.x, at.y, from.x, from.y, to.x, to.y].map(Number);
        let fill = light(colour);
        writeln!(
            out,
            r#"<path class="dot-{colour}" fill="{fill}" d="M {x} {y} L {x0} {y0} A {r} {r} 0 0 1 {x1} {y1} Z"/>"#
        )?;
    }
    Ok(())
}

/// The colour on a light page; those past the list have hues between the others.
fn light(colour: Colour) -> String {
    let number = u32::from(colour);
    let listed = COLOURS.get(number as usize);
    listed.map_or_else(
        || {
            let hue = (f64::from(number) * 137.5 % 360.0).round();
            format!("hsl({hue}, 60%, 45%)")
        },
        |[light, _]| (*light).to_owned(),
    )
}

/// The rules below the dots, smaller where the picture is narrow.
fn rules(out: &mut dyn Write, frame: &Frame) -> io::Result<()> {
    let Frame {
        low, extent, pixel, ..
    } = *frame;
    // A letter is about half as wide as it is high.
    let most = extent.x / pixel / (0.55 * RULES[1].len() as f64);
    let size = most.min(14.0);
    writeln!(
        out,
        r##"<g id="rules" font-family="sans-serif" font-size="{}" fill="#222">"##,
        Number(size * pixel)
    )?;
    let top = low.y + extent.y - (f64::from(frame.legends) * LEGEND - 10.0) * pixel;
    for (i, rule) in RULES.iter().enumerate() {
        let x = Number(low.x + 12.0 * pixel);
        let y = Number(top + 18.0 * i as f64 * pixel);
        writeln!(out, r#"<text x="{x}" y="{y}">{rule}</text>"#)?;
    }
    Ok(())
}
