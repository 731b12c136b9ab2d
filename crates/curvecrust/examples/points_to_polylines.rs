//! Points in no order become curves in order.
//!
//!     cargo run --example points_to_polylines [FILE]
//!
//! FILE holds two numbers a line; without one, the points of two rings and a stroke are taken.

#![allow(clippy::print_stdout, reason = "a program for a terminal")]

mod support;

use curvecrust::{DVec2, reconstruct};
use std::error::Error;
use std::f64::consts::TAU;

fn main() -> Result<(), Box<dyn Error>> {
    let points = support::points_of_argument()?.unwrap_or_else(rings_and_a_stroke);
    let curves = reconstruct(&points)?;
    for curve in &curves {
        let kind = match (curve.is_closed(), curve.nesting()) {
            (true, Some(nesting)) if nesting % 2 == 1 => "hole",
            (true, _) => "ring",
            (false, _) => "open curve",
        };
        println!("{kind} through points {:?}", curve.indices());
    }
    println!("{} points on no curve", curves.isolated().len());
    Ok(())
}

fn rings_and_a_stroke() -> Vec<[f64; 2]> {
    let ring = |n: u32, radius: f64| {
        (0..n).map(move |i| DVec2::from_angle(TAU * f64::from(i) / f64::from(n)) * radius)
    };
    let stroke = (0..12).map(|i| DVec2::new(9.0 + f64::from(i) / 2.0, (f64::from(i) / 3.0).sin()));
    let mut points: Vec<_> = ring(30, 6.0).chain(ring(14, 2.0)).chain(stroke).collect();
    // Any order does; this one is by x.
    points.sort_by(|p, q| p.x.total_cmp(&q.x));
    points.into_iter().map(|p| p.to_array()).collect()
}
