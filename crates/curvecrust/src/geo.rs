//! Curves as the geometries of `geo-types`, which GeoJSON, WKT and shapefile crates read.

use crate::curves::{Curves, Polyline};
use geo_types::{LineString, MultiLineString, MultiPolygon, Polygon};

impl From<&Polyline> for LineString<f64> {
    /// A closed curve ends with its first point once more.
    fn from(polyline: &Polyline) -> Self {
        let first = polyline.points().first().filter(|_| polyline.is_closed());
        let points = polyline.points().iter().chain(first);
        points.map(|p| (p.x, p.y)).collect()
    }
}

impl Curves {
    /// The closed curves as polygons: a curve whose nesting is odd is a hole of the one right
    /// around it.
    ///
    /// ```
    /// use std::f64::consts::TAU;
    ///
    /// let ring = |n: u32, radius: f64| {
    ///     (0..n).map(move |i| {
    ///         let (y, x) = (f64::from(i) * TAU / f64::from(n)).sin_cos();
    ///         [radius * x, radius * y]
    ///     })
    /// };
    /// let curves = curvecrust::reconstruct(ring(8, 2.0).chain(ring(20, 6.0)))?;
    /// let polygons = curves.to_multi_polygon();
    /// assert_eq!(polygons.0.len(), 1);
    /// assert_eq!(polygons.0[0].interiors().len(), 1);
    /// # Ok::<(), curvecrust::Error>(())
    /// ```
    #[must_use]
    pub fn to_multi_polygon(&self) -> MultiPolygon<f64> {
        let polylines = self.polylines();
        let hole_of = |curve: &Polyline| {
            let is_hole = curve.nesting().is_some_and(|nesting| nesting % 2 == 1);
            curve.parent().filter(|_| is_hole)
        };
        let mut holes = vec![Vec::new(); polylines.len()];
        for (at, curve) in polylines.iter().enumerate() {
            if let Some(outside) = hole_of(curve) {
                holes[outside].push(LineString::from(&polylines[at]));
            }
        }
        let curves = polylines.iter().zip(holes);
        let outsides = curves.filter(|(curve, _)| curve.is_closed() && hole_of(curve).is_none());
        outsides
            .map(|(curve, holes)| Polygon::new(curve.into(), holes))
            .collect()
    }

    /// The open curves.
    #[must_use]
    pub fn to_multi_line_string(&self) -> MultiLineString<f64> {
        let open = self.iter().filter(|curve| !curve.is_closed());
        MultiLineString(open.map(LineString::from).collect())
    }
}
