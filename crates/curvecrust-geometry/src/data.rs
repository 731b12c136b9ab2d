//! The types of this crate as data of serde. Data that are read are checked as by the constructors.

use glam::DVec2;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::chains::Chain;
use crate::edge_set::{Edge, EdgeSet};
use crate::point_id::PointId;
use crate::point_set::PointSet;

/// A list of points.
impl Serialize for PointSet {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.points().serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for PointSet {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Self::new(Vec::<DVec2>::deserialize(deserializer)?).map_err(D::Error::custom)
    }
}

/// The two ends.
impl Serialize for Edge {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.ends().serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Edge {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let [p, q] = <[PointId; 2]>::deserialize(deserializer)?;
        let message = || D::Error::custom(format_args!("an edge joins point {p} to itself"));
        Self::new(p, q).ok_or_else(message)
    }
}

/// Edges in any order, and at least as many vertices.
#[derive(Serialize, Deserialize)]
#[serde(rename = "EdgeSet")]
struct Edges<E> {
    vertex_count: usize,
    edges: E,
}

impl Serialize for EdgeSet {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let data = Edges {
            vertex_count: self.vertex_count(),
            edges: self.edges(),
        };
        data.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for EdgeSet {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let data = Edges::<Vec<Edge>>::deserialize(deserializer)?;
        Ok(Self::new(data.vertex_count, data.edges))
    }
}

/// The vertices in order.
#[derive(Serialize, Deserialize)]
#[serde(rename = "Chain")]
struct Vertices<V> {
    vertices: V,
    closed: bool,
}

impl Serialize for Chain {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let data = Vertices {
            vertices: self.vertices(),
            closed: self.is_closed(),
        };
        data.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Chain {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Vertices { vertices, closed } = Vertices::<Vec<PointId>>::deserialize(deserializer)?;
        let least = if closed { 3 } else { 2 };
        if vertices.len() < least {
            let count = vertices.len();
            return Err(D::Error::custom(format_args!(
                "a chain of {count} vertices"
            )));
        }
        let chain = Self::of(vertices, closed);
        if chain.edges().count() < chain.edge_count() {
            return Err(D::Error::custom("a chain that stays at a vertex"));
        }
        Ok(chain)
    }
}

#[cfg(test)]
mod tests {
    use std::fmt::Debug;

    use serde::de::DeserializeOwned;

    use super::*;
    use crate::component::Component;
    use crate::segment::Segment;

    /// What is written reads back as it was.
    fn round_trip<T: Serialize + DeserializeOwned + PartialEq + Debug>(value: &T, json: &str) {
        assert_eq!(serde_json::to_string(value).unwrap(), json);
        assert_eq!(&serde_json::from_str::<T>(json).unwrap(), value);
    }

    #[test]
    fn data_is_plain_and_reads_back() {
        let points = PointSet::from_points([[0.0, 1.0], [2.0, 0.5]]).unwrap();
        round_trip(&points, "[[0.0,1.0],[2.0,0.5]]");
        let id = PointId::from;
        round_trip(&id(7), "7");
        let edge = |p, q| Edge::new(id(p), id(q)).unwrap();
        round_trip(&edge(2, 1), "[1,2]");
        let set = EdgeSet::new(4, [edge(0, 1), edge(1, 2)]);
        round_trip(&set, r#"{"vertex_count":4,"edges":[[0,1],[1,2]]}"#);
        round_trip(&set.chains()[0], r#"{"vertices":[0,1,2],"closed":false}"#);
        let segment = Segment::new(DVec2::ZERO, DVec2::X);
        round_trip(&segment, r#"{"a":[0.0,0.0],"b":[1.0,0.0]}"#);
        let ring = Component {
            range: 1..4,
            closed: true,
        };
        round_trip(&ring, r#"{"range":{"start":1,"end":4},"closed":true}"#);
    }

    #[test]
    fn what_breaks_a_guarantee_is_refused() {
        let error = serde_json::from_str::<PointSet>("[[0.0,1.0],[0.0,1.0]]").unwrap_err();
        assert!(
            error.to_string().starts_with("points 0 and 1 are both"),
            "{error}"
        );
        assert!(serde_json::from_str::<Edge>("[3,3]").is_err());
        // Edges in any order, and ends that are beyond the vertices.
        let set: EdgeSet =
            serde_json::from_str(r#"{"vertex_count":1,"edges":[[2,1],[0,1],[1,2]]}"#).unwrap();
        assert_eq!((set.vertex_count(), set.len()), (3, 2));
        for bad in [
            r#"{"vertices":[0],"closed":false}"#,
            r#"{"vertices":[0,1],"closed":true}"#,
            r#"{"vertices":[0,1,1,2],"closed":false}"#,
            r#"{"vertices":[0,1,2,0],"closed":true}"#,
        ] {
            assert!(serde_json::from_str::<Chain>(bad).is_err(), "{bad}");
        }
    }
}
