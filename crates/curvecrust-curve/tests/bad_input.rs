//! Every kind of bad input, and the message that it earns.
#![allow(clippy::panic, reason = "a test, its helpers included")]

use curvecrust_curve::{BezierPath, CubicBezier, Curve, CurveError};
use glam::DVec2;

fn svg_error(content: &str) -> CurveError {
    let svg = format!("<svg xmlns='http://www.w3.org/2000/svg'>\n{content}</svg>");
    match Curve::from_svg(&svg) {
        Ok(curve) => panic!("{content}: {curve:?}"),
        Err(error) => error,
    }
}

#[test]
fn path_data() {
    for &(d, message) in PATHS {
        let error = Curve::from_path_data(d).expect_err(d);
        assert_eq!(error.to_string(), message, "{d}");
    }
}

#[test]
fn contents_of_documents() {
    for &(content, message) in CONTENTS {
        assert_eq!(svg_error(content).to_string(), message, "{content}");
    }
}

#[test]
fn whole_documents() {
    for &(document, message) in DOCUMENTS {
        let error = Curve::from_svg(document).expect_err(document);
        assert_eq!(error.to_string(), message, "{document}");
    }
}

#[test]
fn components() {
    let line = |x0, x1| CubicBezier::line(DVec2::new(x0, 0.0), DVec2::new(x1, 0.0));
    for (segments, closed, message) in [
        (vec![], false, "component 0 has no length: remove it"),
        (
            vec![line(1.0, 1.0)],
            true,
            "component 0 has no length: remove it",
        ),
        (
            vec![line(0.0, 1.0), line(1.0, f64::NAN)],
            false,
            "component 0, segment 1 has the control point (NaN, 0): coordinates must be finite",
        ),
        (
            vec![line(0.0, 1.0), line(1.5, 2.0)],
            false,
            "component 0, segment 1 starts at (1.5, 0), but the one before it ends at (1, 0): \
             join them, or make two components",
        ),
        (
            vec![line(0.0, 1.0), line(1.0, 2.0)],
            true,
            "component 0, segment 0 starts at (0, 0), but the one before it ends at (2, 0): \
             join them, or make two components",
        ),
    ] {
        let error = Curve::new(vec![BezierPath::new(segments, closed)]).unwrap_err();
        assert_eq!(error.to_string(), message);
    }
    assert_eq!(Curve::new(vec![]), Err(CurveError::Empty));
}

#[test]
fn many_references_to_many_references_end() {
    let mut svg = "<path id='u0' d='M0 0h1'/>".to_owned();
    for k in 0..20 {
        let uses = format!("<use href='#u{k}'/>").repeat(10);
        svg += &format!("<g id='u{}'>{uses}</g>", k + 1);
    }
    assert!(svg_error(&svg).to_string().contains("1000000 elements"));
}

#[test]
fn many_references_to_a_long_path_end() {
    let long = format!("<path id='a' d='M0 0{}'/>", "h1".repeat(100_000));
    let error = svg_error(&(long + &"<use href='#a'/>".repeat(200)));
    assert!(error.to_string().contains("10000000 segments"), "{error}");
}

#[test]
fn deep_nesting_ends() {
    let deep = format!(
        "{}<path d='M0 0h1'/>{}",
        "<g>".repeat(400),
        "</g>".repeat(400)
    );
    assert!(svg_error(&deep).to_string().contains("128 levels"));
    let deeper = format!("{}{}", "<g>".repeat(200_000), "</g>".repeat(200_000));
    assert!(svg_error(&deeper).to_string().contains("128 levels"));
    let mut chain = "<path id='u0' d='M0 0h1'/>".to_owned();
    for k in 0..200_000 {
        chain += &format!("<svg id='u{}'><use href='#u{k}'/></svg>", k + 1);
    }
    assert!(svg_error(&chain).to_string().contains("128 levels"));
}

const PATHS: &[(&str, &str)] = &[
    ("", "there is no curve: draw at least one path or shape"),
    (
        "M 1 2",
        "there is no curve: draw at least one path or shape",
    ),
    (
        "L 1 2",
        "path data is malformed at character 1: start with the command M or m",
    ),
    (
        "M 0 0 L 1",
        "path data is malformed at character 10: it ends too early; give a command with all its numbers",
    ),
    (
        "M 0 0 L 1 x",
        "path data is malformed at character 11: give a number that is finite here",
    ),
    (
        "M 0 0 L 1 2 3",
        "path data is malformed at character 14: it ends too early; give a command with all its numbers",
    ),
    (
        "M 0 0 X 1 1",
        "path data is malformed at character 7: unexpected; give a command with all its numbers",
    ),
    (
        "M0 0 A 1 1 0 2 0 1 1",
        "path data is malformed at character 14: unexpected; give a command with all its numbers",
    ),
    (
        "M 0 0 L 1e999 0",
        "path data is malformed at character 9: give a number that is finite here",
    ),
    (
        "M 0 0 L NaN 0",
        "path data is malformed at character 9: give a number that is finite here",
    ),
    (
        "é",
        "path data is malformed at character 1: start with the command M or m",
    ),
    (
        "M0 0h1Z 1",
        "path data is malformed at character 9: unexpected; give a command with all its numbers",
    ),
    (
        "M 1e308 0 l 1e308 0",
        "component 0, segment 0 has the coordinate 1e308: scale the curve so that no coordinate exceeds 3.2138760885179806e60",
    ),
    (
        "M 0 0 H 1e100",
        "component 0, segment 0 has the coordinate 1e100: scale the curve so that no coordinate exceeds 3.2138760885179806e60",
    ),
    (
        "M 0 0 L 0 0",
        "there is no curve: draw at least one path or shape",
    ),
    (
        "M 0 0 Z",
        "there is no curve: draw at least one path or shape",
    ),
    (
        "M 0 0 H 1 V 1",
        "component 0 has a corner of 90.000 degrees at the start of segment 1, at (1, 0): curves must be smooth, so round it off, or split the curve there",
    ),
    (
        "M 0 0 H 1 V 1 H 0 Z",
        "component 0 has a corner of 90.000 degrees at the start of segment 0, at (0, 0), one of 90.000 degrees at the start of segment 1, at (1, 0), one of 90.000 degrees at the start of segment 2, at (1, 1), one of 90.000 degrees at the start of segment 3, at (0, 1): curves must be smooth, so round them off, or split the curve there",
    ),
    (
        "M0 0 C 1 1 0 1 1 0",
        "component 0, segment 0 has a cusp at t = 0.500000, at (0.5, 0.75): curves must be smooth, so move its handles",
    ),
    (
        "M0 0 H1 H0",
        "component 0 has a corner of 180.000 degrees at the start of segment 0, at (0, 0), one of 180.000 degrees at the start of segment 1, at (1, 0): curves must be smooth, so round them off, or split the curve there",
    ),
    (
        "M-3 0C-2 .1 0 0 0 0 0 0 2-.11 3 0",
        "component 0 has a corner of 2.856908734510114e-1 degrees at the start of segment 1, at (0, 0), where two segments meet that have a handle of length zero: draw these handles out",
    ),
];

const CONTENTS: &[(&str, &str)] = &[
    ("", "there is no curve: draw at least one path or shape"),
    ("<g/>", "there is no curve: draw at least one path or shape"),
    (
        "<path id='p' d='M 0 0 L'/>",
        r#"<path id="p"> in line 2: path data is malformed at character 8: it ends too early; give a command with all its numbers"#,
    ),
    (
        "<path d='M0 0L1e999 0'/>",
        "<path> in line 2: path data is malformed at character 6: give a number that is finite here",
    ),
    (
        "<g>\n<path id='q' d='M0 0 H1 V1'/></g>",
        r#"<path id="q"> in line 3: component 0 has a corner of 90.000 degrees at the start of segment 1, at (1, 0): curves must be smooth, so round it off, or split the curve there"#,
    ),
    (
        "<rect id='r' width='3' height='2'/>",
        r#"<rect id="r"> in line 2: component 0 has a corner of 90.000 degrees at the start of segment 0, at (0, 0), one of 90.000 degrees at the start of segment 1, at (3, 0), one of 90.000 degrees at the start of segment 2, at (3, 2), one of 90.000 degrees at the start of segment 3, at (0, 2): curves must be smooth, so round them off, or split the curve there"#,
    ),
    (
        "<path d='M0 0h1'/><rect width='3' height='2'/>",
        "<rect> in line 2: component 1 has a corner of 90.000 degrees at the start of segment 0, at (0, 0), one of 90.000 degrees at the start of segment 1, at (3, 0), one of 90.000 degrees at the start of segment 2, at (3, 2), one of 90.000 degrees at the start of segment 3, at (0, 2): curves must be smooth, so round them off, or split the curve there",
    ),
    (
        "<rect width='3'/>",
        "<rect> in line 2: it has no size: give width and height",
    ),
    (
        "<circle r='-1'/>",
        r#"<circle> in line 2: r="-1" must be positive: correct it, or remove the element"#,
    ),
    ("<circle/>", "<circle> in line 2: it has no size: give r"),
    (
        "<circle r='1 em'/>",
        r#"<circle> in line 2: r="1 em" is not a length: give a number below 1e38"#,
    ),
    (
        "<circle r='1e39'/>",
        r#"<circle> in line 2: r="1e39" is not a length: give a number below 1e38"#,
    ),
    (
        "<circle r='1e999'/>",
        r#"<circle> in line 2: r="1e999" is not a length: give a number below 1e38"#,
    ),
    (
        "<circle r='1' cx='5%'/>",
        r#"<circle> in line 2: cx="5%" is a part of a size that the root does not have: give it a viewBox"#,
    ),
    (
        "<ellipse/>",
        "<ellipse> in line 2: it has no size: give rx and ry",
    ),
    (
        "<ellipse rx='-1'/>",
        r#"<ellipse> in line 2: rx="-1" must be positive: correct it, or remove the element"#,
    ),
    (
        "<ellipse rx='0' ry='1'/>",
        r#"<ellipse> in line 2: rx="0" must be positive: correct it, or remove the element"#,
    ),
    (
        "<line id='l'/>",
        "there is no curve: draw at least one path or shape",
    ),
    (
        "<polyline points='0,0 1'/>",
        r#"<polyline> in line 2: points="0,0 1" has an odd number of coordinates: give pairs"#,
    ),
    (
        "<polygon points='0,0 1,x'/>",
        r#"<polygon> in line 2: points="0,0 1,x" is no list of numbers: invalid number at position 7"#,
    ),
    (
        "<path d='M0 0h1' transform='spin(3)'/>",
        r#"<path> in line 2: transform="spin(3)" is no list of transforms: unexpected data at position 1"#,
    ),
    (
        "<polyline points='0,0 1e39,1'/>",
        r#"<polyline> in line 2: points="0,0 1e39,1" has the number 1e39: keep below 1e38"#,
    ),
    (
        "<g transform='scale(0)'><path d='M0 0h1'/></g>",
        r#"<g> in line 2: transform="scale(0)" scales to nothing, or beyond 1e38: correct it"#,
    ),
    (
        "<g transform='scale(1e39)'><path d='M0 0h1'/></g>",
        r#"<g> in line 2: transform="scale(1e39)" scales to nothing, or beyond 1e38: correct it"#,
    ),
    (
        "<path d='M0 0h1' display='none'/>",
        "there is no curve: draw at least one path or shape",
    ),
    (
        "<g style='display:none'><path d='M0 0h1'/></g>",
        "there is no curve: draw at least one path or shape",
    ),
    (
        "<g visibility='hidden'><path d='M0 0h1'/></g>",
        "there is no curve: draw at least one path or shape",
    ),
    (
        "<text>abc</text>",
        "there is no curve: draw at least one path or shape",
    ),
    (
        "<image/>",
        "there is no curve: draw at least one path or shape",
    ),
    (
        "<use href=''/>",
        r#"<use> in line 2: href="" is no element of the document: correct or remove it"#,
    ),
    (
        "<use href='#no'/>",
        r##"<use> in line 2: href="#no" is no element of the document: correct or remove it"##,
    ),
    (
        "<use href='other.svg#a'/>",
        r#"<use> in line 2: href="other.svg#a" is no element of the document: correct or remove it"#,
    ),
    (
        "<g id='a'><use href='#a'/></g>",
        r##"<use> in line 2: href="#a" contains this element itself: correct or remove it"##,
    ),
    (
        "<g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g>",
        r##"<use> in line 2: href="#a" contains this element itself: correct or remove it"##,
    ),
    (
        "<g id='g'><use id='u' href='#g'/></g><use href='#u'/>",
        r##"<use id="u"> in line 2: href="#g" contains this element itself: correct or remove it"##,
    ),
    (
        "<clipPath><path id='p' d='M0 0 h'/></clipPath><use href='#p'/>",
        r#"<path id="p"> in line 2: path data is malformed at character 7: it ends too early; give a command with all its numbers"#,
    ),
    (
        "<style>.a { r: 4 }</style>",
        "<style> in line 2: it sets r, which is read from attributes only: make it an attribute",
    ),
    (
        "<path style='transform: scale(2)' d='M0 0h1'/>",
        r#"<path> in line 2: style="transform: scale(2)" sets transform, which is read from attributes only: make it an attribute"#,
    ),
    (
        "<svg width='1' height='1' viewBox='0 0 0 1'/>",
        r#"<svg> in line 2: viewBox="0 0 0 1" must be four numbers, the last two positive: correct it"#,
    ),
    (
        "<svg width='0'/>",
        r#"<svg> in line 2: width="0" must be positive: correct it, or remove the element"#,
    ),
    (
        "<svg width='1' height='1' viewBox='0 0 1 1' preserveAspectRatio='top'/>",
        r#"<svg> in line 2: preserveAspectRatio="top" is not an alignment of SVG: correct it"#,
    ),
    (
        "<path d='M0 0'/>",
        "there is no curve: draw at least one path or shape",
    ),
];

const DOCUMENTS: &[(&str, &str)] = &[
    (
        "",
        "malformed XML at line 1, column 1: the document does not have a root node",
    ),
    ("abc", "malformed XML at line 1, column 1: unknown token"),
    (
        "<svg",
        "malformed XML at line 1, column 1: the document does not have a root node",
    ),
    (
        "<svg xmlns='http://www.w3.org/2000/svg'><path></svg>",
        "malformed XML at line 1, column 47: expected 'path' tag, not 'svg'",
    ),
    (
        "<svg/>",
        r#"the root element is <svg>: it must be <svg> with xmlns="http://www.w3.org/2000/svg""#,
    ),
    (
        "<html xmlns='http://www.w3.org/1999/xhtml'/>",
        r#"the root element is <html>: it must be <svg> with xmlns="http://www.w3.org/2000/svg""#,
    ),
    (
        "<svg xmlns='http://www.w3.org/2000/svg' width='0'/>",
        r#"<svg> in line 1: width="0" must be positive: correct it, or remove the element"#,
    ),
];
