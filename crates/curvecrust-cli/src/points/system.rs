//! Coordinate reference systems, as far as files name them.

/// What a note says about longitude and latitude.
pub(super) const DEGREES: &str = "lengths are in degrees";

/// Codes of EPSG whose coordinates are degrees: those that maps and receivers are in.
const GEOGRAPHIC: &[u32] = &[
    4019, 4148, 4152, 4167, 4171, 4189, 4202, 4203, 4230, 4258, 4267, 4269, 4277, 4283, 4289, 4312,
    4313, 4314, 4322, 4326, 4490, 4555, 4612, 4617, 4619, 4659, 4674, 4759, 4937, 4955, 4979, 5340,
    6318, 6319, 6668, 7843, 7844, 7912, 8999, 9000, 9057, 9754, 9755,
];

/// A coordinate reference system.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct System {
    /// What messages call it.
    pub(super) name: String,
    /// Whether x and y are longitude and latitude.
    pub(super) is_geographic: bool,
}

impl System {
    /// That of a number which PostGIS and its like put in front of a geometry.
    pub(super) fn of_srid(srid: u32) -> Self {
        Self {
            name: format!("SRID {srid}"),
            is_geographic: GEOGRAPHIC.contains(&srid),
        }
    }
}
