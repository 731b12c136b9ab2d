//! Outlines of things, drawn by hand.

use curvecrust::geometry::DVec2;

use super::{Truth, along, closed};

/// Things by their names; those that are not drawn here are drawings of the fixtures.
pub(in super::super) const THINGS: [&str; 18] = [
    "apple", "cup", "mouse", "bottle", "duck", "hand", "leaf", "goldfish", "teapot", "pear", "rat",
    "mug", "fish", "cat", "violin", "glove", "key", "oak-leaf",
];

/// Cubics end to end by their control points, the last of which is the first one.
const CUBICS: [(&str, &str); 3] = [
    (
        "apple",
        "50,78 40,86 12,88 8,52 6,22 34,-2 50,8 66,-2 96,22 92,54 88,86 64,86 56,79 56,86 60,92 \
     66,96 60,99 56,97 54,96 52,90 51,84 50,78",
    ),
    (
        "cup",
        "10,90 33,90 47,90 70,90 70,84 70,80 70,74 104,84 104,28 66,34 64,20 60,10 52,8 44,6 36,6 \
     28,8 20,10 14,20 12,60 11,70 10,80 10,90",
    ),
    (
        "mouse",
        "2,30 10,46 22,54 32,56 28,74 50,78 48,58 70,72 104,66 106,32 124,30 140,40 150,52 154,50 \
     154,48 152,44 140,28 122,20 104,22 98,16 40,16 14,20 6,22 0,24 2,30",
    ),
];

/// Points that a smooth curve runs through.
const SMOOTH: [(&str, &str); 9] = [
    (
        "bottle",
        "40,4 60,4 64,8 64,60 62,72 55,82 54,92 54,108 56,110 56,116 50,117 44,116 44,110 46,108 \
     46,92 45,82 38,72 36,60 36,8",
    ),
    (
        "duck",
        "4,42 14,58 26,60 38,50 52,44 66,50 72,62 66,72 64,84 72,94 84,94 92,86 94,78 108,74 \
     108,68 94,66 92,60 98,48 98,34 88,20 70,12 44,12 22,20 10,30",
    ),
    (
        "hand",
        "30,2 62,2 66,24 78,36 92,48 98,58 93,62 84,56 72,48 70,60 74,84 72,92 66,92 63,84 60,64 \
     58,92 55,102 49,102 47,92 47,64 42,88 38,96 32,94 32,86 36,60 27,78 22,83 17,79 19,70 \
     26,48 25,28",
    ),
    (
        "leaf",
        "50,0 51,16 66,14 84,26 92,46 88,70 74,90 56,108 48,114 42,106 26,88 12,66 10,44 20,24 \
     36,14 48,16 47,0",
    ),
    (
        "goldfish",
        "4,40 14,52 30,62 40,66 46,82 60,84 64,66 78,58 92,50 108,66 118,70 114,54 110,42 114,28 \
     118,14 106,20 92,34 78,26 66,20 60,8 50,8 46,18 30,20 14,28",
    ),
    (
        "teapot",
        "30,10 70,10 84,22 90,34 104,38 112,52 122,66 116,70 104,62 90,60 80,72 62,80 58,86 58,92 \
     50,95 42,92 42,86 38,80 22,72 10,70 0,58 2,40 12,28 20,20",
    ),
    (
        "pear",
        "50,6 70,8 84,24 82,44 72,58 66,74 60,86 53,90 55,100 50,102 47,90 40,86 34,74 28,58 \
     18,44 16,24 30,8",
    ),
    (
        "rat",
        "2,30 14,44 24,48 28,60 40,62 44,52 66,60 92,54 108,36 130,34 150,44 168,40 182,50 184,46 \
     170,34 150,37 130,27 110,22 96,14 84,14 80,18 50,18 46,12 34,12 32,20 12,24",
    ),
    (
        "mug",
        "14,6 66,6 70,10 71,20 84,22 96,34 98,52 90,66 74,68 72,84 70,88 12,88 10,84 10,10",
    ),
];

/// The outline of a thing that is drawn here, about 2 wide.
pub(in super::super) fn outline(name: &str) -> Option<Truth> {
    let named = |list: &[(&str, &'static str)]| {
        let found = list.iter().find(|(n, _)| *n == name);
        found.map(|(_, places)| parsed(places))
    };
    let cubic = |[a, b, c, d]: [DVec2; 4]| {
        along(400, 0.0, 1.0, move |t| {
            let s = 1.0 - t;
            s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d
        })
    };
    if let Some(p) = named(&CUBICS) {
        let starts = (0..p.len() - 1).step_by(3);
        let pieces = starts.flat_map(|i| cubic([p[i], p[i + 1], p[i + 2], p[i + 3]]));
        return Some(closed(pieces.collect()));
    }
    let p = named(&SMOOTH)?;
    let at = |i: usize| p[i % p.len()];
    // E. Catmull, R. Rom, 1974: the tangent at a point is that of the chord of its neighbours.
    let pieces = (0..p.len()).flat_map(|i| {
        let [before, a, d, after] = [at(i + p.len() - 1), at(i), at(i + 1), at(i + 2)];
        cubic([a, a + (d - before) / 6.0, d - (after - a) / 6.0, d])
    });
    Some(closed(pieces.collect()))
}

/// Coordinates of about 0 to 100, as text.
fn parsed(places: &str) -> Vec<DVec2> {
    let pairs = places.split_whitespace().filter_map(|pair| {
        let (x, y) = pair.split_once(',')?;
        Some(DVec2::new(x.parse().ok()?, y.parse().ok()?) / 50.0)
    });
    pairs.collect()
}
