//! Small curves and strokes at a distance, as drawings and maps have them.

use super::experiment::Shape;
use super::true_curves::{TrueCurves, arc, straight};
use curvecrust::DVec2;
use std::f64::consts::TAU;

/// Dense points, and whether they are of a closed curve.
type Polyline = (Vec<DVec2>, bool);

/// How far apart dense points on straight parts are.
const STEP: f64 = 0.25;
/// The length of a dot: five spacings.
const DOT: f64 = 5.0;
/// The sides of a rectangle.
const PAD: DVec2 = DVec2::new(6.0, 3.0);
/// The radius of an open circle.
const LETTER: f64 = 6.0;
/// The length of a stroke.
const STROKE: f64 = 15.0;

/// The shape with gaps of this length, where the spacing of samples is 1.
pub(super) fn curves(shape: Shape, gap: f64) -> TrueCurves {
    TrueCurves::polygonal(match shape {
        Shape::Dots => {
            let radius = DOT / TAU;
            let dot = |centre| (arc(centre, radius, 0.0, TAU, 60), true);
            grid([3, 3], DVec2::splat(2.0 * radius + gap))
                .map(dot)
                .collect()
        }
        Shape::Pads => grid([2, 3], PAD + gap).map(rectangle).collect(),
        Shape::LetterC => {
            let half = (gap / (2.0 * LETTER)).min(1.0).asin();
            let mut points = arc(DVec2::ZERO, LETTER, half, TAU - half, 300);
            points.push(LETTER * DVec2::from_angle(-half));
            vec![(points, false)]
        }
        Shape::StrokesInLine => {
            let pitch = DVec2::new(STROKE + gap, 0.0);
            grid([2, 1], pitch).map(stroke).collect()
        }
        Shape::ParallelStrokes => grid([1, 3], DVec2::new(0.0, gap)).map(stroke).collect(),
    })
}

/// Places in columns and rows.
fn grid([columns, rows]: [u32; 2], pitch: DVec2) -> impl Iterator<Item = DVec2> {
    let row = move |y| (0..columns).map(move |x| pitch * DVec2::new(f64::from(x), f64::from(y)));
    (0..rows).flat_map(row)
}

fn rectangle(corner: DVec2) -> Polyline {
    let corners = [(0.0, 0.0), (PAD.x, 0.0), (PAD.x, PAD.y), (0.0, PAD.y)];
    let corners = corners.map(|(x, y)| corner + DVec2::new(x, y));
    let next = corners.iter().cycle().skip(1);
    let sides = corners.iter().zip(next);
    (
        sides.flat_map(|(&a, &b)| straight(a, b, STEP)).collect(),
        true,
    )
}

fn stroke(start: DVec2) -> Polyline {
    let end = start + DVec2::new(STROKE, 0.0);
    (straight(start, end, STEP).chain([end]).collect(), false)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn least_gap(curves: &TrueCurves) -> f64 {
        let mut least = f64::INFINITY;
        for (i, one) in curves.parts.iter().enumerate() {
            for other in &curves.parts[..i] {
                for p in &one.points {
                    for q in &other.points {
                        least = least.min(p.distance(*q));
                    }
                }
            }
        }
        least
    }

    #[test]
    fn gaps_are_as_long_as_asked() {
        for (shape, parts) in [
            (Shape::Dots, 9),
            (Shape::Pads, 6),
            (Shape::StrokesInLine, 2),
            (Shape::ParallelStrokes, 3),
        ] {
            let found = curves(shape, 1.7);
            assert_eq!(found.parts.len(), parts);
            assert!((least_gap(&found) - 1.7).abs() < 1e-9, "{shape:?}");
        }
        let [letter] = &curves(Shape::LetterC, 1.7).parts[..] else {
            panic!("a letter is one curve")
        };
        let ends = [letter.points[0], letter.points[letter.points.len() - 1]];
        assert!((ends[0].distance(ends[1]) - 1.7).abs() < 1e-9);
    }
}
