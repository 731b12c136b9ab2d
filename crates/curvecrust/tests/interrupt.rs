//! Long work ends when it is told to.

use curvecrust::curve::Curve;
use curvecrust::geometry::{Interrupt, Interrupted, Random};
use curvecrust::reconstruct::{Crust, HnnCrust, LeastDetour, Reconstructor, Shape};
use curvecrust::{DVec2, ReconstructOptions, reconstruct_with};
use std::time::Duration;

/// What the work returns if it is stopped once it has begun.
fn stopped<T: Send>(work: impl FnOnce() -> T + Send) -> Result<T, Interrupted> {
    let interrupt = Interrupt::new();
    std::thread::scope(|scope| {
        let switch = interrupt.clone();
        scope.spawn(move || {
            std::thread::sleep(Duration::from_millis(20));
            switch.stop();
        });
        interrupt.run(work)
    })
}

fn uniform(count: usize) -> Vec<DVec2> {
    let mut random = Random::new(7);
    let mut coordinate = || random.unit();
    (0..count)
        .map(|_| DVec2::new(coordinate(), coordinate()))
        .collect()
}

#[test]
fn every_step_of_a_reconstruction_stops() {
    let points = uniform(1_000_000);
    let algorithms: [&dyn Reconstructor; 3] = [&LeastDetour, &HnnCrust::MUTUAL, &Crust];
    for algorithm in algorithms {
        let options = ReconstructOptions {
            algorithm,
            ..ReconstructOptions::default()
        };
        let result = stopped(|| reconstruct_with(&points, &options));
        assert_eq!(result.err(), Some(Interrupted), "{}", algorithm.info().name);
    }
}

#[test]
fn a_tour_stops() {
    let points = uniform(20_000);
    let options = ReconstructOptions {
        shape: Some(Shape::Closed),
        curves: std::num::NonZeroU32::new(1),
        ..ReconstructOptions::default()
    };
    assert!(stopped(|| reconstruct_with(&points, &options)).is_err());
}

#[test]
fn sampling_stops() -> Result<(), Box<dyn std::error::Error>> {
    let wave: String = (0..20_000).map(|_| "q .5 1 1 0 q .5 -1 1 0").collect();
    let curve = Curve::from_path_data(&format!("M 0 0 {wave}"))?;
    assert!(stopped(|| curvecrust::sample(&curve, 0.5)).is_err());
    Ok(())
}
