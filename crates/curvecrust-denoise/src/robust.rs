//! Medians and quantiles.

/// Turns the median of absolute values into the standard deviation of a normal distribution.
pub(crate) const NORMAL: f64 = 1.4826;

/// The middle value, the upper one of two; 0 of none.
pub(crate) fn median(values: &mut [f64]) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let middle = values.len() / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}
