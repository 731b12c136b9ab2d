//! JSON as text, and the places of its errors.

use super::{Flaw, Place, Problem};
use serde::de::DeserializeOwned;

/// Parses JSON; errors know their place, if they have one.
pub(super) fn parse<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, Flaw> {
    serde_json::from_slice(bytes).map_err(|error| {
        let (line, column) = (error.line(), error.column());
        let message = error.to_string();
        let suffix = format!(" at line {line} column {column}");
        let message = message.strip_suffix(&suffix).unwrap_or(&message);
        let place = match line {
            // The text is JSON, but not of the kind that is read.
            0 => Place::File,
            _ => Place::Column(line as u64, column),
        };
        Problem::Json(message.to_owned()).at(place)
    })
}
