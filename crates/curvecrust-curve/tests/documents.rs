//! Whole SVG documents: shapes against closed forms, placement, and what is read at all.
#![allow(
    clippy::panic,
    clippy::unwrap_used,
    reason = "clippy knows helpers of tests as tests in modules only"
)]
#![allow(
    clippy::float_cmp,
    reason = "coordinates that are written down come back bit by bit"
)]

use curvecrust_curve::{BezierPath, Curve};
use glam::DVec2;
use proptest::prelude::*;

fn v(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

fn document(content: &str) -> Curve {
    let svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' \
         viewBox='5 5 200 100'>{content}</svg>"
    );
    Curve::from_svg(&svg).unwrap_or_else(|error| panic!("{content}: {error}"))
}

fn near(p: DVec2, q: DVec2) {
    assert!(p.distance(q) < 1e-13 * (1.0 + q.length()), "{p} and {q}");
}

fn starts(curve: &Curve) -> Vec<DVec2> {
    let first = |c: &BezierPath| c.segments()[0].start();
    curve.components().iter().map(first).collect()
}

/// Points along all segments of a component.
fn along(component: &BezierPath) -> impl Iterator<Item = DVec2> + '_ {
    let at = |i| f64::from(i) / 8.0;
    component
        .segments()
        .iter()
        .flat_map(move |s| (0..8).map(move |i| s.point(at(i))))
}

/// Cubics of a quarter of a circle.
const ARC: usize = 13;

const LINE: &str = "<path d='M1 2 L3 5'/>";

/// Where the line from (1, 2) to (3, 5) has gone.
fn line_in(before: &str, after: &str) -> [DVec2; 2] {
    let curve = document(&format!("{before}{LINE}{after}"));
    assert_eq!(curve.components().len(), 1);
    let segment = curve.components()[0].segments()[0];
    [segment.start(), segment.end()]
}

#[test]
fn a_path_in_a_document_is_the_path_alone() {
    let d = "M 0.1 0.2 C 0 4.000000000000001 6 4 6 0.3";
    let alone = Curve::from_path_data(d).unwrap();
    assert_eq!(document(&format!("<path d='{d}'/>")), alone);
    let curves = ["<path d=''/>", "<path/>", "<path d='M1 1'/>"].concat();
    assert_eq!(document(&format!("{curves}<path d='{d}'/>")), alone);
}

#[test]
fn circles_and_ellipses_lie_on_their_equations() {
    for (shape, radii) in [
        ("<circle cx='10' cy='-3' r='4'/>", v(4.0, 4.0)),
        ("<ellipse cx='10' cy='-3' rx='4' ry='2'/>", v(4.0, 2.0)),
        ("<ellipse cx='10' cy='-3' rx='4'/>", v(4.0, 4.0)),
        ("<ellipse cx='10' cy='-3' rx='auto' ry='3'/>", v(3.0, 3.0)),
    ] {
        let curve = document(shape);
        let component = &curve.components()[0];
        assert!(component.is_closed());
        assert_eq!(component.segments().len(), 4 * ARC);
        for p in along(component) {
            let unit = (p - v(10.0, -3.0)) / radii;
            assert!((unit.length() - 1.0).abs() < 1e-10, "{shape}");
        }
        let (low, high) = curve.bounding_box();
        near(low, v(10.0, -3.0) - radii);
        near(high, v(10.0, -3.0) + radii);
        assert_eq!(starts(&curve), [v(10.0 + radii.x, -3.0)]);
    }
}

#[test]
fn rounded_rectangles_lie_at_their_radius_from_an_inner_one() {
    for (radii, inner, sides) in [
        ("rx='2'", v(3.0, 1.0), 4),
        ("rx='2' ry='2'", v(3.0, 1.0), 4),
        ("ry='2'", v(3.0, 1.0), 4),
        // Cut to half of each side: two sides are gone.
        ("rx='3' ry='3'", v(2.0, 0.0), 2),
    ] {
        let shape = format!("<rect x='1' y='2' width='10' height='6' {radii}/>");
        let curve = document(&shape);
        let component = &curve.components()[0];
        assert!(component.is_closed());
        assert_eq!(component.segments().len(), 4 * ARC + sides, "{shape}");
        let radius = 3.0 - inner.y;
        for p in along(component) {
            let from_centre = (p - v(6.0, 5.0)).abs();
            let outside = (from_centre - inner).max(DVec2::ZERO);
            assert!(
                (outside.length() - radius).abs() < 1e-10 * radius,
                "{shape}: {p}"
            );
        }
        let (low, high) = curve.bounding_box();
        near(low, v(1.0, 2.0));
        near(high, v(11.0, 8.0));
    }
}

#[test]
fn lines_and_polylines() {
    let ends = |shape: &str| {
        let curve = document(shape);
        let segments = curve.components()[0].segments();
        [segments[0].start(), segments[segments.len() - 1].end()]
    };
    let expected = [v(1.0, 2.0), v(3.0, 4.0)];
    assert_eq!(ends("<line x1='1' y1='2' x2='3' y2='4'/>"), expected);
    assert_eq!(ends("<polyline points='1,2 2,3 3,4'/>"), expected);
    let polygon: Vec<_> = (0..720)
        .map(|i| DVec2::from_angle(f64::from(i).to_radians() / 2.0))
        .map(|p| format!("{},{}", p.x, p.y))
        .collect();
    let polygon = document(&format!("<polygon points='{}'/>", polygon.join(" ")));
    assert!(polygon.components()[0].is_closed());
    assert_eq!(polygon.components()[0].segments().len(), 720);
}

#[test]
fn transforms_apply_from_the_inside_out() {
    for (transform, start, end) in [
        ("translate(10)", v(11.0, 2.0), v(13.0, 5.0)),
        ("scale(2, 3)", v(2.0, 6.0), v(6.0, 15.0)),
        ("rotate(90)", v(-2.0, 1.0), v(-5.0, 3.0)),
        ("rotate(90, 1, 2)", v(1.0, 2.0), v(-2.0, 4.0)),
        ("rotate(-180)", v(-1.0, -2.0), v(-3.0, -5.0)),
        ("rotate(-450)", v(2.0, -1.0), v(5.0, -3.0)),
        ("skewX(45)", v(3.0, 2.0), v(8.0, 5.0)),
        ("skewY(45)", v(1.0, 3.0), v(3.0, 8.0)),
        ("matrix(1 2 3 4 5 6)", v(12.0, 16.0), v(23.0, 32.0)),
        ("translate(10,20) scale(2)", v(12.0, 24.0), v(16.0, 30.0)),
        ("none", v(1.0, 2.0), v(3.0, 5.0)),
    ] {
        let [p, q] = line_in(&format!("<g transform='{transform}'>"), "</g>");
        near(p, start);
        near(q, end);
    }
    let outer = "<g transform='translate(10,20)'><a transform='scale(2)'>";
    assert_eq!(line_in(outer, "</a></g>"), [v(12.0, 24.0), v(16.0, 30.0)]);
}

#[test]
fn a_nested_svg_is_fitted_into_its_viewport() {
    // A view of 10 x 10 in a viewport of 40 x 20 at (100, 0).
    for (ratio, start, end) in [
        ("", v(112.0, 4.0), v(116.0, 10.0)),
        (
            "preserveAspectRatio='xMinYMin'",
            v(102.0, 4.0),
            v(106.0, 10.0),
        ),
        (
            "preserveAspectRatio='xMaxYMax meet'",
            v(122.0, 4.0),
            v(126.0, 10.0),
        ),
        (
            "preserveAspectRatio='xMidYMid slice'",
            v(104.0, -2.0),
            v(112.0, 10.0),
        ),
        ("preserveAspectRatio='none'", v(104.0, 4.0), v(112.0, 10.0)),
    ] {
        let frame = format!("x='100' width='40' height='20' viewBox='0 0 10 10' {ratio}");
        let [p, q] = line_in(&format!("<svg {frame}>"), "</svg>");
        near(p, start);
        near(q, end);
        let symbol = format!("<symbol id='s' viewBox='0 0 10 10' {ratio}>");
        let used = "</symbol><use href='#s' x='100' width='40' height='20'/>";
        let [p, q] = line_in(&symbol, used);
        near(p, start);
        near(q, end);
    }
}

#[test]
fn references_draw_their_target_where_they_stand() {
    for link in ["href", "xlink:href"] {
        let content = format!(
            "<use {link}='#later' x='10' transform='scale(2)'/>\
             <defs><g id='later' transform='translate(0, 1)'>{LINE}</g></defs>\
             <use {link}='#later'/>"
        );
        assert_eq!(starts(&document(&content)), [v(22.0, 6.0), v(1.0, 3.0)]);
    }
}

#[test]
fn lengths_with_units_and_percentages() {
    let x_of = |x: &str| starts(&document(&format!("<line x1='{x}' x2='1e3'/>")))[0].x;
    for (x, expected) in [
        ("2", 2.0),
        ("2px", 2.0),
        ("1in", 96.0),
        ("2.54cm", 96.0),
        ("25.4mm", 96.0),
        ("72pt", 96.0),
        ("6pc", 96.0),
        (" 10%", 20.0),
    ] {
        assert!((x_of(x) - expected).abs() < 1e-12, "{x}");
    }
    // Percentages of both: the diagonal, by its side of a square.
    let circle = document("<circle r='10%'/>");
    let radius = 0.1 * f64::sqrt((200.0 * 200.0 + 100.0 * 100.0) / 2.0);
    assert!((circle.extent() - 2.0 * radius).abs() < 1e-9);
}

/// The first coordinates of the paths, which say which of them are part of the curve.
fn drawn(content: &str) -> Vec<f64> {
    starts(&document(content)).iter().map(|p| p.x).collect()
}

#[test]
fn only_paint_of_none_matters_and_order_is_that_of_the_document() {
    let painted = "<style>.a{fill:none;stroke:none!important} #b{fill:none!important;opacity:0}\
                   path:hover{opacity:0}</style>\
         <path d='M1 0h1'/><path d='M2 0h1' fill='none'/><path d='M3 0h1' class='a'/>\
         <path id='b' d='M4 0h1'/><g opacity='0'><path d='M5 0h1' style='opacity:0!important'/></g>\
         <path d='M6 0h1' stroke='red' stroke-width='0' stroke-dasharray='1 2'/>\
         <path d='M7 0h1' style='fill:none;stroke:none;stroke-width:-1;stroke-dasharray:4'/>\
         <g fill='none' stroke='url(#nothing)'><path d='M8 0h1M9 0h1'/></g>";
    assert_eq!(drawn(painted), [1.0, 2.0, 4.0, 5.0, 6.0, 8.0, 9.0]);
    // All icons of one kind have a shape that nobody sees.
    let page = "<g fill='none'><path stroke='none' d='M90 0h9'/>";
    let seen = format!("{page}<g stroke='blue'><path d='M1 0h1'/></g></g>");
    assert_eq!(drawn(&seen), [1.0]);
    let lines_alone = format!("{page}</g><path style='fill:none;stroke:none' d='M1 0h1'/>");
    assert_eq!(drawn(&lines_alone), [90.0, 1.0]);
}

#[test]
fn clips_masks_filters_and_markers_neither_cut_nor_draw() {
    let content = "<clipPath id='c'><path d='M90 0h1v1'/></clipPath><mask id='m'><circle/></mask>\
         <marker id='k' orient='auto'><path d='M90 0h1v1'/></marker><filter id='f'/>\
         <pattern id='p'><path d='M90 0h1v1'/></pattern>\
         <path d='M1 0h1' clip-path='url(#c)'/><path d='M2 0h1' style='mask:url(#m)!important'/>\
         <path d='M3 0h1' marker-start='url(#k)' marker-end='url(#k)' paint-order='stroke markers'/>\
         <path d='M4 0h1' style='marker:url(#k)'/><path d='M5 0h1' fill='url(#p)'/>\
         <path d='M6 0h1' filter='url(#f)'/><path d='M7 0h1' clip-path='url(#nothing)'/>\
         <svg width='1' height='1'><path d='M8 0h1'/></svg>\
         <path d='M9 0h1' filter='url(#nothing)'/>";
    assert_eq!(
        drawn(content),
        [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]
    );
}

#[test]
fn what_is_hidden_or_no_shape_is_not_part_of_the_curve() {
    let content = "<style>.off{display:none}</style>\
         <title>t</title><sodipodi:namedview xmlns:sodipodi='urn:s' d='x'/>\
         <defs><path d='M90 0h1'/></defs><path d='M90 0h1' display='none'/>\
         <g class='off'><path d='M90 0h1'/></g><g style='display:none'><path d='M90 0h1'/></g>\
         <g visibility='hidden'><path d='M1 0h1' visibility='visible'/><path d='M90 0h1'/></g>\
         <switch><path d='M90 0h1' systemLanguage='fr'/><path d='M2 0h1'/><path d='M90 0h1'/></switch>\
         <text x='1 2 3'>abc</text><image href='/no/such/file.svg' width='9' height='9'/>\
         <image width='9' height='9' href='data:image/svg+xml,\
         &lt;svg xmlns=\"http://www.w3.org/2000/svg\">&lt;path d=\"M9 0h1\"/>&lt;/svg>'/>\
         <path/><path d=''/><path d='M90 0'/><path d='M3 0h1'/>";
    assert_eq!(drawn(content), [1.0, 2.0, 3.0]);
}

#[test]
fn the_place_on_the_page_does_not_matter() {
    let circle = "<circle cx='4' cy='3' r='2'/>";
    for root in [
        "",
        "viewBox='1 2 30 40'",
        "viewBox='1 2 30 40' width='210mm' height='297mm'",
        "width='100%' height='50'",
        "width='50' transform='rotate(30)'",
        "viewBox='0 0 10 10' preserveAspectRatio='none' width='1e4' style='opacity:0'",
    ] {
        let content = format!("{LINE}<g transform='translate(1 1)'>{circle}</g>");
        let svg = format!("<svg xmlns='http://www.w3.org/2000/svg' {root}>{content}</svg>");
        let curve = Curve::from_svg(&svg).unwrap();
        assert_eq!(starts(&curve), [v(1.0, 2.0), v(7.0, 4.0)], "{root}");
    }
}

#[test]
fn a_document_of_inkscape() {
    let svg = r##"<?xml version="1.0" encoding="UTF-8" standalone="no"?>
<svg width="210mm" height="297mm" viewBox="0 0 210 297" version="1.1" id="svg1"
   xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"
   xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"
   xmlns="http://www.w3.org/2000/svg" xmlns:svg="http://www.w3.org/2000/svg">
  <sodipodi:namedview id="namedview1" pagecolor="#ffffff" inkscape:document-units="mm" />
  <defs id="defs1"><inkscape:path-effect effect="spiro" id="path-effect1" is_visible="true" /></defs>
  <g inkscape:label="Layer 1" inkscape:groupmode="layer" id="layer1" transform="translate(-10,5)">
    <path style="fill:none;stroke:#000000;stroke-width:0.264583;-inkscape-stroke:none"
       d="m 30,40 c 0,10 20,10 20,0" id="path1" sodipodi:nodetypes="cc"
       inkscape:original-d="m 30,40 20,0" inkscape:path-effect="#path-effect1" />
    <path style="fill:#ff0000" id="path2" sodipodi:type="arc" sodipodi:rx="4" sodipodi:cx="1"
       d="m 104,100 a 4,4 0 0 1 -4,4 4,4 0 0 1 -4,-4 4,4 0 0 1 4,-4 4,4 0 0 1 4,4 z" />
  </g>
</svg>"##;
    let curve = Curve::from_svg(svg).unwrap();
    assert_eq!(starts(&curve), [v(20.0, 45.0), v(94.0, 105.0)]);
    let circle = &curve.components()[1];
    assert!(circle.is_closed());
    for p in along(circle) {
        assert!((p.distance(v(90.0, 105.0)) / 4.0 - 1.0).abs() < 1e-7);
    }
}

#[test]
fn entities_of_a_document_type_are_read() {
    let svg = "\u{feff}<!DOCTYPE svg [<!ENTITY d 'M1 2 L3 5'>]>\
               <svg xmlns='http://www.w3.org/2000/svg'><path d='&d;'/></svg>";
    assert_eq!(Curve::from_svg(svg).unwrap().extent(), 3.0);
    let svg = "<!DOCTYPE svg [<!ENTITY p '<path d=\"M1 2 L3 5\"/>'>]>\
               <svg xmlns='http://www.w3.org/2000/svg'>&p;<path d='M7 2h1'/><g>&p;</g></svg>";
    let xs: Vec<f64> = starts(&Curve::from_svg(svg).unwrap())
        .iter()
        .map(|p| p.x)
        .collect();
    assert_eq!(xs, [1.0, 7.0, 1.0]);
}

/// Elements with attributes that fit them more or less.
fn any_element() -> impl Strategy<Value = String> {
    let words = |text: &'static str| text.split_whitespace().collect::<Vec<_>>();
    let names = words(
        "path circle ellipse rect line polyline polygon g svg use symbol defs switch text style",
    );
    let attributes = words(
        "id href d points x y x1 y2 cx r rx ry width height transform viewBox \
         preserveAspectRatio style display",
    );
    let values = [
        "a",
        "#a",
        "M0 0h1",
        "M0 0A1 2 3 0 1 5 6z",
        "0,0 1,0 2,0",
        "1",
        "0",
        "-1",
        "50%",
        "1e300",
        "1e-300",
        "2mm",
        "none",
        "scale(1e200)",
        "rotate(1 2 3)",
        "matrix(0 0 0 0 0 0)",
        "0 0 1e-300 1e300",
        "xMaxYMin slice",
        "display:none",
        "é;:",
        "",
    ];
    let attribute = (
        prop::sample::select(attributes),
        prop::sample::select(values.to_vec()),
    );
    let given = prop::collection::btree_map(attribute.0, attribute.1, 0..6);
    let leaf = (prop::sample::select(names), given).prop_map(|(name, given)| {
        let given: Vec<_> = given.iter().map(|(k, v)| format!(" {k}='{v}'")).collect();
        format!("<{name}{}>|</{name}>", given.concat())
    });
    let nested = |inner: BoxedStrategy<String>| {
        let children = prop::collection::vec(inner.clone(), 0..4);
        (inner, children).prop_map(|(outer, children)| outer.replacen('|', &children.concat(), 1))
    };
    leaf.prop_recursive(3, 12, 4, move |inner| nested(inner.boxed()))
}

proptest! {
    #[test]
    fn documents_never_panic(elements in prop::collection::vec(any_element(), 0..5)) {
        let elements = elements.concat().replace('|', "");
        let svg = format!("<svg xmlns='http://www.w3.org/2000/svg'>{elements}</svg>");
        if let Ok(curve) = Curve::from_svg(&svg) {
            prop_assert!(curve.extent() > 0.0);
        }
    }
}
