//! In a process of its own: the time of all threads is counted, those of other tests included.

use curvecrust_benches::growth::seconds;
use std::path::Path;
use std::time::Duration;

#[test]
fn work_takes_time_and_waiting_hardly_any() {
    let busy = seconds(|| (0..2_000_000u64).fold(1, |a, b| std::hint::black_box(a ^ b)));
    assert!(busy > 0.0);
    // Elsewhere the time of the clock is taken.
    if Path::new("/proc/self/schedstat").exists() {
        assert!(seconds(|| std::thread::sleep(Duration::from_millis(50))) < 0.04);
    }
}
