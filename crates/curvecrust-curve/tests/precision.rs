//! Drawings in double precision, what draws nothing, and which elements are chosen.
#![allow(
    clippy::panic,
    clippy::unwrap_used,
    reason = "clippy knows helpers of tests as tests in modules only"
)]

use curvecrust_curve::svg::{Drawing, Selection};
use curvecrust_curve::{Curve, CurveError};
use glam::DVec2;

fn document(content: &str) -> String {
    format!(
        "<svg xmlns='http://www.w3.org/2000/svg' \
         xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape'>\n{content}</svg>"
    )
}

/// The radius of curvature at the start of each segment.
fn radii(curve: &Curve) -> Vec<f64> {
    let segments = curve.components()[0].segments().iter();
    let radius = segments.map(|s| {
        let [a, b, c, _] = s.control_points();
        let (first, second) = (3.0 * (b - a), 6.0 * (a - 2.0 * b + c));
        first.length().powi(3) / first.perp_dot(second).abs()
    });
    radius.collect()
}

#[test]
fn circles_have_the_curvature_of_circles() {
    let circle = Curve::from_svg(&document("<circle cx='5' cy='-3' r='7'/>")).unwrap();
    for radius in radii(&circle) {
        assert!((radius / 7.0 - 1.0).abs() < 1e-6, "{radius}");
    }
}

#[test]
fn shapes_are_their_arcs() {
    for (shape, d) in [
        (
            "<ellipse rx='10' ry='4'/>",
            "M 10 0 A 10 4 0 0 1 0 4 A 10 4 0 0 1 -10 0 A 10 4 0 0 1 0 -4 A 10 4 0 0 1 10 0 Z",
        ),
        (
            "<rect width='10' height='4' rx='1'/>",
            "M 1 0 H 9 A 1 1 0 0 1 10 1 V 3 A 1 1 0 0 1 9 4 H 1 A 1 1 0 0 1 0 3 V 1 \
             A 1 1 0 0 1 1 0 Z",
        ),
    ] {
        let path = Curve::from_path_data(d).unwrap();
        assert_eq!(Curve::from_svg(&document(shape)).unwrap(), path, "{shape}");
    }
}

#[test]
fn coordinates_of_maps_keep_their_digits() {
    let far = DVec2::new(412_345.678, 5_812_345.678);
    let moved = "transform='translate(412345.678,5812345.678)'";
    for content in [
        format!("<circle {moved} r='3'/>"),
        format!("<g {moved}><circle r='1' transform='scale(3)'/></g>"),
        format!("<circle id='c' cx='0' r='3' {moved}/>"),
        "<circle cx='412345.678' cy='5812345.678' r='3'/>".to_owned(),
        "<symbol id='s' viewBox='-1 -1 2 2'><circle r='1'/></symbol>
         <use href='#s' x='412342.678' y='5812342.678' width='6' height='6'/>"
            .to_owned(),
        "<svg x='412342.678' y='5812342.678' width='6' height='6' viewBox='-1 -1 2 2'>
         <circle r='1'/></svg>"
            .to_owned(),
    ] {
        let curve = Curve::from_svg(&document(&content)).unwrap();
        for segment in curve.components()[0].segments() {
            let distance = segment.start().distance(far);
            assert!((distance - 3.0).abs() < 1e-9 * far.length(), "{content}");
            assert!((distance - 3.0).abs() < 5e-9, "{content}: {distance}");
        }
    }
}

#[test]
fn a_subpath_of_one_point_draws_nothing() {
    for (content, told) in [
        ("<path d='M0 0h1M5 5z'/>", &["<path> in line 2"][..]),
        (
            "<path d='M0 0h1'/><path id='p' d='M5 5L5 5'/>",
            &["<path id=\"p\"> in line 2"],
        ),
        (
            "<path d='M0 0h1'/>\n<line x1='3' x2='3'/>",
            &["<line> in line 3"],
        ),
        ("<path d='M0 0h1'/><polyline points='1,1'/>", &[]),
        ("<path d='M0 0h1M3 3'/>", &[]),
    ] {
        let drawing = Drawing::new(&document(content)).unwrap();
        assert_eq!(drawing.components().len(), 1, "{content}");
        let points: Vec<String> = drawing.points().map(|e| e.to_string()).collect();
        assert_eq!(points, told, "{content}");
    }
    let alone = Curve::from_path_data("M 0 0 L 0 0 M 1 1 h 2");
    assert_eq!(alone.unwrap().components().len(), 1);
}

const LAYERS: &str = "
    <rect id='background' width='9' height='9'/>
    <g inkscape:label='Layer 1' id='g1'><path class='thin dark' d='M1 0h1'/><path d='M2 0h1'/></g>
    <g inkscape:label='Layer 2'><path class='dark' d='M3 0h1'/><use href='#g1' x='10'/></g>
    <path id='broken' d='M4 0 h'/>";

fn selected(select: &[&str], exclude: &[&str]) -> Result<Vec<f64>, CurveError> {
    let owned = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect();
    let selection = Selection {
        select: owned(select),
        exclude: owned(exclude),
    };
    let drawing = Drawing::selected(&document(LAYERS), &selection)?;
    let components = drawing.components().iter();
    Ok(components.map(|c| c.segments()[0].start().x).collect())
}

#[test]
fn elements_are_chosen_by_id_class_or_layer() {
    for (select, exclude, expected) in [
        // Where it is used, too.
        (&["Layer 1"][..], &[][..], &[1.0, 2.0, 11.0, 12.0][..]),
        (&["dark"], &[], &[1.0, 3.0, 11.0]),
        (&["dark"], &["Layer 2"], &[1.0]),
        (&["g1", "Layer 2"], &["thin"], &[2.0, 3.0, 12.0]),
        (&[], &["broken", "background", "g1"], &[3.0]),
        (&["background"], &[], &[0.0]),
    ] {
        let found = selected(select, exclude).unwrap();
        assert_eq!(found, expected, "{select:?} without {exclude:?}");
    }
    let error = |select, exclude| selected(select, exclude).unwrap_err().to_string();
    assert!(error(&[], &[]).starts_with("<path id=\"broken\"> in line 6: path data is malformed"));
    assert!(error(&["broken"], &[]).starts_with("<path id=\"broken\"> in line 6"));
    assert_eq!(
        error(&["Layer 3"], &[]),
        "no element has the id, the class or the label \"Layer 3\": give one that is there"
    );
}

#[test]
fn the_last_important_declaration_counts() {
    for (style, drawn) in [
        (".a{display:none}", false),
        (".a{display:none}path{display:inline}", false),
        ("path{display:none}.a{display:inline}", true),
        ("path{display:none !important}.a{display:inline}", false),
        (
            "path{display:none !important}.a{display:inline !important}",
            true,
        ),
        (".a{visibility:hidden}", false),
        ("svg{visibility:hidden}.a{visibility:visible}", true),
        ("@media print { .a { display: none } }", true),
    ] {
        let content = format!("<style>{style}</style><path class='a' d='M0 0h1'/>");
        let drawing = Drawing::new(&document(&content)).unwrap();
        assert_eq!(drawing.components().len(), usize::from(drawn), "{style}");
    }
}
