//! A drawing becomes samples, and the samples become the drawing's polygons again.
//!
//!     cargo run --example svg_to_samples [FILE.svg]

#![allow(clippy::print_stdout, reason = "a program for a terminal")]

use curvecrust::curve::Curve;
use curvecrust::{reconstruct, sample};
use std::error::Error;

/// A ring with a waist, and a circle beside it.
const DRAWING: &str = r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 200 100">
  <path d="M 0 50 C 0 0 40 40 60 40 S 120 0 120 50 S 80 60 60 60 S 0 100 0 50 Z"/>
  <circle cx="160" cy="50" r="20"/>
</svg>"#;

fn main() -> Result<(), Box<dyn Error>> {
    let document = match std::env::args().nth(1) {
        Some(path) => std::fs::read_to_string(path)?,
        None => DRAWING.to_owned(),
    };
    let curve = Curve::from_svg(&document)?;
    for rho in [0.3, 0.5, 0.7, 0.895] {
        let samples = sample(&curve, rho)?;
        // What is reconstructed is bare points; that they are in order is not used.
        let curves = reconstruct(samples.points())?;
        println!(
            "rho < {rho}: {} samples, {} curves of {} points",
            samples.len(),
            curves.len(),
            curves
                .iter()
                .map(|curve| curve.points().len())
                .sum::<usize>(),
        );
    }
    Ok(())
}
