//! What HNN-Crust allocates at its peak. Alone in its program, so that nothing else allocates.

use curvecrust_reconstruct::hnn_crust;
use curvecrust_testing::planted::many_curves;
use peak_alloc::PeakAlloc;

#[global_allocator]
static ALLOCATOR: PeakAlloc = PeakAlloc;

#[test]
fn hnn_crust_stays_below_48_bytes_a_point() {
    let points = many_curves(1_000_000, 1).unwrap().points;
    let before = ALLOCATOR.current_usage();
    ALLOCATOR.reset_peak_usage();
    let edges = hnn_crust(&points);
    let bytes = (ALLOCATOR.peak_usage() - before) as f64 / points.len() as f64;
    assert_eq!(edges.len(), points.len());
    println!("{bytes:.1} bytes a point beyond the input");
    assert!(bytes < 48.0, "{bytes}");
}
