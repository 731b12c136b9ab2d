//! What the examples share: points from a file that is named on the command line.

use std::error::Error;

/// The points of the file, two numbers a line, separated by white space or a comma; `None` where no
/// file is named.
pub(crate) fn points_of_argument() -> Result<Option<Vec<[f64; 2]>>, Box<dyn Error>> {
    let Some(path) = std::env::args().nth(1) else {
        return Ok(None);
    };
    let text = std::fs::read_to_string(path)?;
    let point = |line: &str| match line
        .replace(',', " ")
        .split_whitespace()
        .collect::<Vec<_>>()[..]
    {
        [x, y] => Ok([x.parse()?, y.parse()?]),
        _ => Err(format!("not two numbers: {line:?}").into()),
    };
    text.lines().map(point).collect::<Result<_, _>>().map(Some)
}
