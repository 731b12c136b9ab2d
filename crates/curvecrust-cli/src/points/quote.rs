//! Parts of a file in messages.

/// Characters of a part that are shown.
const MOST_CHARACTERS: usize = 40;
/// Parts of a list that are shown.
const MOST_ITEMS: usize = 8;

/// What stands in a file, short and without what would steer a terminal.
pub(super) fn quoted(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(bytes);
    let mut quoted = String::new();
    for c in text.chars().take(MOST_CHARACTERS) {
        match c {
            '\'' | '"' | '\\' => quoted.push(c),
            _ => quoted.extend(c.escape_debug()),
        }
    }
    if text.chars().nth(MOST_CHARACTERS).is_some() {
        quoted.push_str("...");
    }
    quoted
}

/// That the names stand for what is not read.
pub(super) fn left_out<'a>(names: impl ExactSizeIterator<Item = &'a [u8]>) -> String {
    let verb = if names.len() == 1 { "is" } else { "are" };
    format!("{} {verb} left out", listed(names))
}

/// The first of the names, each in backticks, and how many more there are.
pub(super) fn listed<'a>(names: impl ExactSizeIterator<Item = &'a [u8]>) -> String {
    let count = names.len();
    let shown = names
        .take(MOST_ITEMS)
        .map(|name| format!("`{}`", quoted(name)));
    let mut list = shown.collect::<Vec<_>>().join(", ");
    if count > MOST_ITEMS {
        list += &format!(" and {} more", count - MOST_ITEMS);
    }
    list
}
