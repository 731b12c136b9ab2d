//! Points in the types that users have.

use glam::{DVec2, Vec2};

/// Something that is a point of the plane: two coordinates, x before y.
///
/// Arrays, pairs and vectors of [`glam`], in double or single precision, owned or borrowed. With
/// the features `mint` and `geo-types` also the points of these crates. Single precision is
/// widened, which changes no value.
///
/// ```
/// use curvecrust::IntoPoint;
///
/// assert_eq!([1.0, 2.0].into_point(), (1.0f32, 2.0f32).into_point());
/// ```
pub trait IntoPoint {
    /// The point, in double precision.
    fn into_point(self) -> DVec2;
}

impl IntoPoint for DVec2 {
    fn into_point(self) -> DVec2 {
        self
    }
}

impl IntoPoint for Vec2 {
    fn into_point(self) -> DVec2 {
        self.as_dvec2()
    }
}

impl<T: Into<f64>> IntoPoint for [T; 2] {
    fn into_point(self) -> DVec2 {
        DVec2::from_array(self.map(Into::into))
    }
}

impl<T: Into<f64>> IntoPoint for (T, T) {
    fn into_point(self) -> DVec2 {
        DVec2::new(self.0.into(), self.1.into())
    }
}

impl<P: IntoPoint + Copy> IntoPoint for &P {
    fn into_point(self) -> DVec2 {
        (*self).into_point()
    }
}

#[cfg(feature = "mint")]
mod mint {
    use super::{DVec2, IntoPoint};

    impl<T: Into<f64>> IntoPoint for mint::Point2<T> {
        fn into_point(self) -> DVec2 {
            DVec2::new(self.x.into(), self.y.into())
        }
    }

    impl<T: Into<f64>> IntoPoint for mint::Vector2<T> {
        fn into_point(self) -> DVec2 {
            DVec2::new(self.x.into(), self.y.into())
        }
    }
}

#[cfg(feature = "geo-types")]
mod geo {
    use super::{DVec2, IntoPoint};
    use geo_types::{Coord, CoordNum, Point};

    impl<T: CoordNum + Into<f64>> IntoPoint for Coord<T> {
        fn into_point(self) -> DVec2 {
            DVec2::new(self.x.into(), self.y.into())
        }
    }

    impl<T: CoordNum + Into<f64>> IntoPoint for Point<T> {
        fn into_point(self) -> DVec2 {
            self.0.into_point()
        }
    }
}
