//! Numbers that can be coordinates.

use super::Problem;
use super::quote::quoted;
use crate::number::Number;

/// The coordinate that a token stands for, which may have a comma in front of its decimals.
pub(super) fn coordinate(token: &[u8], has_decimal_commas: bool) -> Result<f64, Problem> {
    match number(token, has_decimal_commas) {
        Some(value) => in_range(value, || quoted(token)),
        None => Err(Problem::NotANumber(quoted(token))),
    }
}

pub(super) fn is_number(token: &[u8], has_decimal_commas: bool) -> bool {
    number(token, has_decimal_commas).is_some()
}

/// The number of a token, which may have a comma in front of its decimals.
pub(super) fn number(token: &[u8], has_decimal_commas: bool) -> Option<f64> {
    let text = str::from_utf8(token).ok()?;
    let number = text.parse().ok();
    // With a point as well, a comma would separate thousands.
    let is_decimal = || has_decimal_commas && text.contains(',') && !text.contains('.');
    number.or_else(|| {
        is_decimal()
            .then(|| text.replacen(',', ".", 1).parse().ok())
            .flatten()
    })
}

/// The number itself, if a point set can hold it.
pub(super) fn in_double_range(value: f64) -> Result<f64, Problem> {
    in_range(value, || Number(value).to_string())
}

/// The number itself, if a point set can hold it; `found` is what stood there.
fn in_range(value: f64, found: impl FnOnce() -> String) -> Result<f64, Problem> {
    use curvecrust::geometry::PointSet;
    let magnitude = value.abs();
    if !value.is_finite() {
        Err(Problem::NotFinite(found()))
    } else if magnitude > PointSet::MAX_MAGNITUDE
        || (magnitude < PointSet::MIN_MAGNITUDE && magnitude > 0.0)
    {
        Err(Problem::Magnitude(found()))
    } else {
        Ok(value)
    }
}
