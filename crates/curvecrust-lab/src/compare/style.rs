//! How plots look: one sheet for all of them, so that a page holds it once.

/// The colours of lines by their index, told apart by hue, lightness, marker and dashes.
pub(crate) const LINES: usize = 8;

/// Which paper a plot is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Paper {
    /// A file of its own: light, whatever the reader prefers.
    Light,
    /// A page, which brings the style itself, for light and dark.
    Page,
}

/// After Okabe and Ito's colours for all kinds of colour vision, darkened to stand out on white.
const LIGHT: [&str; LINES] = [
    "#c0392b", "#0b6fb3", "#127a52", "#8a5a00", "#8e44ad", "#3d4852", "#b0367a", "#007a87",
];
const DARK: [&str; LINES] = [
    "#ff8a75", "#6cb8f0", "#5fd3a0", "#e6b450", "#d3a0f0", "#c3ccd5", "#ff93c8", "#5cd6e3",
];
const DASHES: [&str; LINES] = ["", "7 3", "2 3", "9 3 2 3", "5 2", "1 2", "12 4", "3 2 1 2"];

/// The rules of plots in light colours.
pub(crate) fn light() -> String {
    rules("#ffffff", "#1c2126", "#59636e", "#e3e6ea", LIGHT)
}

/// The rules of plots in dark colours.
pub(crate) fn dark() -> String {
    rules("#14181c", "#e8ebee", "#a4aeb8", "#2d343b", DARK)
}

fn rules(paper: &str, ink: &str, faint: &str, grid: &str, lines: [&str; LINES]) -> String {
    let mut text = format!(
        ".plot text {{ font: 13px system-ui, 'DejaVu Sans', sans-serif; fill: {ink} }}\n\
         .plot .faint {{ fill: {faint} }}\n\
         .plot .head {{ font-size: 15px; font-weight: 600 }}\n\
         .plot .paper {{ fill: {paper} }}\n\
         .plot .grid {{ stroke: {grid}; stroke-width: 1; fill: none }}\n\
         .plot .axis {{ stroke: {faint}; stroke-width: 1; fill: none }}\n\
         .plot .leader {{ stroke: {faint}; stroke-width: .7; fill: none }}\n"
    );
    for (i, (colour, dashes)) in lines.iter().zip(DASHES).enumerate() {
        text += &format!(
            ".plot .l{i} {{ stroke: {colour}; stroke-width: 2; fill: none; stroke-dasharray: {} }}\n\
             .plot .m{i} {{ fill: {colour}; stroke: {paper}; stroke-width: .8 }}\n\
             .plot .b{i} {{ fill: {colour}; fill-opacity: .12; stroke: none }}\n\
             .plot .t{i} {{ fill: {colour} }}\n",
            if dashes.is_empty() { "none" } else { dashes }
        );
    }
    text
}

/// The start of a plot: the size, what it shows for those who cannot see it, and its style if it
/// stands alone.
pub(crate) fn open(title: &str, width: f64, height: f64, paper: Paper) -> String {
    let title = escaped(title);
    let style = match paper {
        Paper::Light => format!("<style>\n{}</style>\n", light()),
        Paper::Page => String::new(),
    };
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" role=\"img\" \
         viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\">\n\
         <title>{title}</title>\n{style}\
         <rect class=\"paper\" width=\"{width}\" height=\"{height}\"/>\n"
    )
}

/// A text as content of XML.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

/// About how wide a text of 13 px is.
pub(crate) fn text_width(text: &str) -> f64 {
    7.4 * text.chars().count() as f64
}
