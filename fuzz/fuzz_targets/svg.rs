//! SVG documents and path strings: any text is read, or refused by an error that can be shown.

#![no_main]

use curvecrust::curve::{Curve, CurveError};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    hold(Curve::from_svg(text));
    hold(Curve::from_path_data(text));
    // Path data in a document is what they are alone.
    if let Ok(curve) = Curve::from_path_data(text)
        && text
            .chars()
            .all(|c| c.is_ascii_alphanumeric() || " -+.,".contains(c))
    {
        let document = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><path d="{text}"/></svg>"#
        );
        assert_eq!(Curve::from_svg(&document).as_ref(), Ok(&curve));
    }
});

/// The guarantees of a curve.
fn hold(curve: Result<Curve, CurveError>) {
    let curve = match curve {
        Ok(curve) => curve,
        Err(error) => {
            assert!(!error.to_string().is_empty());
            return;
        }
    };
    let (low, high) = curve.bounding_box();
    assert!(low.is_finite() && high.is_finite() && low.cmple(high).all());
    assert!(curve.extent() > 0.0);
    assert!(!curve.components().is_empty());
    for component in curve.components() {
        let segments = component.segments();
        assert!(
            segments
                .windows(2)
                .all(|pair| pair[0].end() == pair[1].start())
        );
        if component.is_closed() {
            assert_eq!(segments[0].start(), segments[segments.len() - 1].end());
        }
        for segment in segments {
            for t in [0.0, 0.3, 1.0] {
                assert!(segment.point(t).is_finite());
                assert!((segment.tangent(t).length() - 1.0).abs() < 1e-9);
            }
        }
    }
}
