//! The answers against the libraries, on every fixture, and on what is no request.

use super::*;
use crate::message::bytes;
use curvecrust::medial_axis::measure;
use curvecrust::sampling::{Condition, sample};
use curvecrust::{DVec2, ReconstructOptions, reconstruct_with};
use curvecrust_testing::fixtures;
use serde_json::{Value, json};

/// An answer, taken apart.
struct Got(Value, Vec<f64>);

impl Got {
    fn array(&self, name: &str) -> &[f64] {
        let range = &self.0["arrays"][name];
        let end = |i: usize| usize::try_from(range[i].as_u64().unwrap()).unwrap();
        &self.1[end(0)..end(1)]
    }
}

fn ask(engine: &mut Engine, header: &Value, points: &[DVec2]) -> Got {
    let numbers: Vec<f64> = points.iter().flat_map(|p| p.to_array()).collect();
    let answer = engine.answer(&bytes(header, &numbers));
    let received = Received::parse(&answer).unwrap();
    Got(
        serde_json::from_slice(received.header).unwrap(),
        received.numbers(),
    )
}

#[test]
fn edges_are_those_of_the_library_on_all_fixtures() {
    let mut engine = Engine::default();
    for (name, points) in fixtures::points() {
        for &algorithm in ALGORITHMS {
            let options = ReconstructOptions {
                algorithm,
                ..Default::default()
            };
            let edges = reconstruct_with(&points, &options)
                .unwrap()
                .edges()
                .concat();
            let wanted: Vec<f64> = edges.iter().map(|&index| index as f64).collect();
            let header =
                json!({"reconstruct": {"algorithm": algorithm.info().name, "reasons": true}});
            let got = ask(&mut engine, &header, &points);
            assert_eq!(
                got.array("edges"),
                wanted,
                "{name}: {}",
                algorithm.info().name
            );
        }
    }
}

#[test]
fn samples_are_those_of_the_library_on_all_fixtures() {
    let mut engine = Engine::default();
    for entry in fixtures::Manifest::read().unwrap().curves {
        let svg = std::fs::read_to_string(fixtures::path(&entry.file)).unwrap();
        let got = ask(&mut engine, &json!({"curve": {"svg": svg}}), &[]);
        assert!(!got.array("dense").is_empty(), "{}", entry.name);
        let header = json!({"sample": {"condition": "rho", "bound": 0.9}});
        let got = ask(&mut engine, &header, &[]);
        let curve = curvecrust::curve::Curve::from_svg(&svg).unwrap();
        let wanted = sample(&measure(&curve).unwrap(), Condition::rho(0.9).unwrap()).unwrap();
        let wanted: Vec<f64> = wanted
            .samples
            .points()
            .iter()
            .flat_map(|p| p.to_array())
            .collect();
        assert_eq!(got.array("samples"), wanted, "{}", entry.name);
    }
}

#[test]
fn counts_fall_from_bound_to_bound() {
    let mut engine = Engine::default();
    let d = "M 0 0 H 4 A 1 1 0 0 1 4 2 H 0 A 1 1 0 0 1 0 0 Z";
    ask(&mut engine, &json!({"curve": {"path": d}}), &[]);
    let got = ask(&mut engine, &json!("counts"), &[]);
    let counts = got.0["counts"].as_array().unwrap().iter();
    let counts: Vec<u64> = counts
        .map(|count| count["samples"].as_u64().unwrap())
        .collect();
    assert!(counts.is_sorted_by(|a, b| a >= b), "{counts:?}");
}

/// Shapes, transforms, corners and crossings, as drawings have them.
#[test]
fn corners_are_samples_and_crossings_are_cut() {
    let mut engine = Engine::default();
    let svg = "<svg xmlns='http://www.w3.org/2000/svg'><g transform='translate(5 5) scale(2)'>
        <rect width='4' height='3'/><use href='#c'/></g><defs><circle id='c' cx='9' r='2'/></defs></svg>";
    let got = ask(&mut engine, &json!({"curve": {"svg": svg}}), &[]);
    assert_eq!((&got.0["corners"], &got.0["cuts"]), (&json!(4), &json!(0)));
    let header = json!({"sample": {"condition": "rho", "bound": 0.9}});
    let got = ask(&mut engine, &header, &[]);
    assert_eq!(got.0["exact"], true);
    assert_eq!(got.0["decoder"], "least-detour");
    let samples: Vec<&[f64]> = got.array("samples").chunks_exact(2).collect();
    for corner in [[5.0, 5.0], [13.0, 5.0], [13.0, 11.0], [5.0, 11.0]] {
        assert!(samples.contains(&&corner[..]), "{corner:?}");
    }
    let cross = json!({"curve": {"path": "M 0 1 H 2 M 1 0 V 2"}});
    let got = ask(&mut engine, &cross, &[]);
    assert_eq!(got.0["cuts"], 1);
}

#[test]
fn what_cannot_be_answered_is_an_error_in_words() {
    let mut engine = Engine::default();
    let equal = [DVec2::ONE, DVec2::ONE];
    for (header, points) in [
        (json!("nothing"), &[][..]),
        (json!({"sample": {"condition": "rho", "bound": 0.9}}), &[]),
        (json!({"curve": {"svg": "<svg"}}), &[]),
        (json!({"curve": {"path": "M 0 0"}}), &[]),
        (json!({"reconstruct": {"algorithm": "none"}}), &[]),
        (
            json!({"reconstruct": {"algorithm": "crust", "shape": "closed"}}),
            &equal,
        ),
        (
            json!({"reconstruct": {"algorithm": "crust"}}),
            &[DVec2::NAN],
        ),
        (json!({"points": {"name": "a", "text": "b"}}), &[]),
    ] {
        let got = ask(&mut engine, &header, points);
        assert!(got.0["error"].as_str().unwrap().len() > 10, "{header}");
    }
    let got = ask(
        &mut engine,
        &json!({"reconstruct": {"algorithm": "crust"}}),
        &equal,
    );
    assert_eq!(got.0["duplicates"], 1);
    assert!(engine.answer(b"no message").len() > 20);
}
