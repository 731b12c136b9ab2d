//! The ellipse that a cloud of points fills or surrounds.

use std::f64::consts::{PI, TAU};

use glam::DVec2;

use crate::spline::Guide;

/// Vertices of the ellipse.
const VERTICES: u32 = 24;

/// An ellipse by the mean and the scatter of points.
pub(crate) struct Ellipse {
    mean: DVec2,
    axis: DVec2,
    /// The deviations of the points along its axis and across.
    deviations: DVec2,
}

impl Ellipse {
    pub(crate) fn of(points: &[DVec2]) -> Self {
        let count = points.len().max(1) as f64;
        let mean = points.iter().sum::<DVec2>() / count;
        let (mut squares, mut product) = (DVec2::ZERO, 0.0);
        for p in points {
            let d = *p - mean;
            squares += d * d / count;
            product += d.x * d.y / count;
        }
        let half = 0.5 * (squares.x + squares.y);
        let apart = (0.5 * (squares.x - squares.y)).hypot(product);
        Self {
            mean,
            axis: DVec2::from_angle(0.5 * (2.0 * product).atan2(squares.x - squares.y)),
            deviations: DVec2::new((half + apart).sqrt(), (half - apart).max(0.0).sqrt()),
        }
    }

    /// The area of the ellipse that points of this scatter fill evenly: its half axes are twice
    /// their deviations.
    pub(crate) fn area(&self) -> f64 {
        let area = 4.0 * PI * self.deviations.element_product();
        area.max(f64::MIN_POSITIVE)
    }

    /// The ellipse that points of this scatter surround: its half axes are the deviations times
    /// the root of two.
    pub(crate) fn guide(&self) -> Guide {
        let radii = 2f64.sqrt() * self.deviations;
        let at = |i: u32| {
            let place = DVec2::from_angle(TAU * f64::from(i) / f64::from(VERTICES)) * radii;
            self.mean + self.axis.rotate(place)
        };
        let vertices: Vec<DVec2> = (0..VERTICES).map(at).collect();
        let after = vertices.iter().cycle().skip(1);
        let spacing = vertices.iter().zip(after).map(|(a, b)| a.distance(*b));
        Guide {
            spacing: spacing.collect(),
            // All points take part.
            sigma: vec![radii.x; vertices.len()],
            vertices,
            closed: true,
            creases: Vec::new(),
            even: false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_circle_surrounds_its_points_and_a_disc_is_filled_by_its_own() {
        let circle: Vec<DVec2> = (0..60)
            .map(|i| DVec2::from_angle(f64::from(i) * TAU / 60.0) + DVec2::X)
            .collect();
        for vertex in Ellipse::of(&circle).guide().vertices {
            assert!((vertex.distance(DVec2::X) - 1.0).abs() < 1e-12);
        }
        // Rings of the same area each.
        let disc: Vec<DVec2> = (0..50)
            .flat_map(|r| {
                let radius = ((f64::from(r) + 0.5) / 50.0).sqrt();
                circle.iter().map(move |p| radius * (*p - DVec2::X))
            })
            .collect();
        assert!((Ellipse::of(&disc).area() / PI - 1.0).abs() < 1e-3);
    }
}
