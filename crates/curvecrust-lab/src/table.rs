//! Tables as values: a header, and rows of typed fields. Markdown, CSV and HTML are made of the
//! same value, and nothing is read back from them.

use maud::{Markup, PreEscaped, Render, html};
use std::fmt::{self, Write};

/// A header and rows, each as long as the header.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// The names of the columns.
    pub header: Vec<String>,
    /// From the first to the last.
    pub rows: Vec<Vec<Field>>,
}

/// What stands in a row under a name of the header.
#[derive(Clone, Debug, PartialEq)]
pub enum Field {
    /// Words.
    Text(String),
    /// A whole number.
    Count(u64),
    /// A number, with as many digits as it needs.
    Number(f64),
    /// A share of a whole, in per cent.
    Share(f64),
    /// A number as somebody else wrote it, with its unit or with another one beside it.
    Written(String),
    /// A value that could be there and is not: a dash for readers, empty in CSV.
    Missing,
    /// Nothing.
    Empty,
}

impl Field {
    /// A number rounded to `digits` significant digits.
    #[must_use]
    pub fn rounded(value: f64, digits: usize) -> Self {
        Self::Number(rounded(value, digits))
    }

    /// A count, or nothing.
    #[must_use]
    pub fn count(value: Option<usize>) -> Self {
        value.map_or(Self::Empty, Self::from)
    }

    fn is_number(&self) -> bool {
        !matches!(self, Self::Text(_) | Self::Empty)
    }

    /// As a field of CSV; a missing one is empty.
    fn bare(&self) -> String {
        match self {
            Self::Missing => String::new(),
            field => field.to_string(),
        }
    }
}

impl From<&str> for Field {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<String> for Field {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl From<usize> for Field {
    fn from(count: usize) -> Self {
        Self::Count(count as u64)
    }
}

impl From<f64> for Field {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl fmt::Display for Field {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Text(text) | Self::Written(text) => f.write_str(text),
            Self::Count(count) => write!(f, "{count}"),
            Self::Number(number) => write!(f, "{number}"),
            Self::Share(share) => f.write_str(&percent(*share)),
            Self::Missing => f.write_str("–"),
            Self::Empty => Ok(()),
        }
    }
}

/// A number rounded to `digits` significant digits; 0 in place of -0.
#[must_use]
pub fn rounded(value: f64, digits: usize) -> f64 {
    let text = format!("{value:.*e}", digits.saturating_sub(1));
    text.parse().unwrap_or(value) + 0.0
}

/// A share in per cent; only 1 gives 100 %, and only 0 gives 0 %.
#[must_use]
pub fn percent(share: f64) -> String {
    if share >= 1.0 {
        "100 %".to_owned()
    } else if share > 0.0 && !(0.005..0.995).contains(&share) {
        format!("{:.1} %", (100.0 * share).clamp(0.1, 99.9))
    } else {
        format!("{:.0} %", 100.0 * share)
    }
}

impl Table {
    /// A table with a header and no rows.
    #[must_use]
    pub fn new<S: Into<String>>(header: impl IntoIterator<Item = S>) -> Self {
        Self {
            header: header.into_iter().map(Into::into).collect(),
            rows: Vec::new(),
        }
    }

    /// Markdown whose columns are in line on a terminal, and an empty line.
    #[must_use]
    pub fn to_markdown(&self) -> String {
        let rows = self.rows.iter();
        let mut lines: Vec<Vec<String>> = vec![self.header.clone()];
        lines.extend(rows.map(|row| row.iter().map(Field::to_string).collect()));
        let width = |column: usize| {
            let fields = lines.iter().filter_map(|line| line.get(column));
            fields.map(|field| field.chars().count()).max().unwrap_or(0)
        };
        let widths: Vec<usize> = (0..self.header.len()).map(width).collect();
        let rule = widths.iter().map(|&width| "-".repeat(width)).collect();
        lines.insert(1, rule);
        let mut text = String::new();
        for line in &lines {
            for (field, width) in line.iter().zip(&widths) {
                // Writing to a string cannot fail.
                let _ = write!(text, "| {field:<width$} ");
            }
            text += "|\n";
        }
        text + "\n"
    }

    /// CSV with a line for the header.
    ///
    /// # Errors
    /// If the rows are not all as long as the header.
    pub fn to_csv(&self) -> csv::Result<String> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(&self.header)?;
        self.written(writer)
    }

    /// CSV of the rows alone, to go on with a file that has a header.
    ///
    /// # Errors
    /// If the rows are not all of the same length.
    pub fn to_csv_lines(&self) -> csv::Result<String> {
        self.written(csv::Writer::from_writer(Vec::new()))
    }

    fn written(&self, mut writer: csv::Writer<Vec<u8>>) -> csv::Result<String> {
        for row in &self.rows {
            writer.write_record(row.iter().map(Field::bare))?;
        }
        let bytes = writer.into_inner().map_err(|e| e.into_error())?;
        Ok(String::from_utf8_lossy(&bytes).into_owned())
    }

    /// Whether a column holds numbers alone: they stand at its right.
    fn is_of_numbers(&self, column: usize) -> bool {
        let mut fields = self.rows.iter().filter_map(|row| row.get(column));
        fields.all(|field| field.is_number() || *field == Field::Empty)
    }
}

/// A line break, so that pages can be compared line by line.
pub const BREAK: PreEscaped<&str> = PreEscaped("\n");

impl Render for Table {
    fn render(&self) -> Markup {
        let class = |column| self.is_of_numbers(column).then_some("number");
        // A condition stays in one line with its sign.
        let unbroken = |text: &str| text.replace(" < ", "\u{a0}<\u{a0}");
        html! {
            div.scroll { table {
                (BREAK) tr { @for (i, name) in self.header.iter().enumerate() {
                    th class=[class(i)] { (unbroken(name)) }
                } }
                @for row in &self.rows {
                    (BREAK) tr { @for (i, field) in row.iter().enumerate() {
                        td class=[class(i)] { (unbroken(&field.to_string())) }
                    } }
                }
            } } (BREAK)
        }
    }
}

/// A table with its title and a paragraph about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// One line.
    pub title: String,
    /// Before the table; may be empty.
    pub about: String,
    /// The table.
    pub table: Table,
    /// After the table; may be empty.
    pub note: String,
}

impl Section {
    /// Markdown under a heading of `level` `#`.
    #[must_use]
    pub fn to_markdown(&self, level: usize) -> String {
        let paragraph = |text: &str| match text {
            "" => String::new(),
            text => format!("{text}\n\n"),
        };
        format!("{} {}\n\n", "#".repeat(level), self.title)
            + &paragraph(&self.about)
            + &self.table.to_markdown()
            + &paragraph(&self.note)
    }
}

impl Render for Section {
    fn render(&self) -> Markup {
        html! {
            section {
                (BREAK) h2 { (self.title) } (BREAK)
                @if !self.about.is_empty() { p { (self.about) } (BREAK) }
                (self.table)
                @if !self.note.is_empty() { p { (self.note) } (BREAK) }
            } (BREAK)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn section() -> Section {
        let mut table = Table::new(["x < 1", "n"]);
        table.rows = vec![
            vec!["a & b".into(), Field::Count(12)],
            vec!["\"c\", d".into(), Field::Missing],
        ];
        Section {
            title: "A < B".to_owned(),
            about: "words".to_owned(),
            table,
            note: String::new(),
        }
    }

    #[test]
    fn one_table_is_written_in_three_ways() {
        let section = section();
        assert_eq!(
            section.to_markdown(2),
            "## A < B\n\nwords\n\n\
             | x < 1  | n  |\n\
             | ------ | -- |\n\
             | a & b  | 12 |\n\
             | \"c\", d | –  |\n\n"
        );
        let csv = section.table.to_csv().unwrap();
        assert_eq!(csv, "x < 1,n\na & b,12\n\"\"\"c\"\", d\",\n");
        let html = section.render().into_string();
        for part in [
            "<h2>A &lt; B</h2>\n<p>words</p>\n",
            "<tr><th>x\u{a0}&lt;\u{a0}1</th><th class=\"number\">n</th></tr>",
            "<tr><td>a &amp; b</td><td class=\"number\">12</td></tr>",
        ] {
            assert!(html.contains(part), "{html}");
        }
    }

    #[test]
    fn rows_of_different_lengths_are_no_csv() {
        let mut table = section().table;
        table.rows[1].pop();
        assert!(table.to_csv().is_err());
    }

    #[test]
    fn digits_are_kept() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (1.0 / 3.0, "0.333333"),
            (1.5e-9, "0.0000000015"),
            (f64::INFINITY, "inf"),
        ] {
            assert_eq!(Field::rounded(value, 6).to_string(), text);
        }
        let shares = [1.0, 0.9999, 0.5, 0.0001, 0.0].map(percent);
        assert_eq!(shares, ["100 %", "99.9 %", "50 %", "0.1 %", "0 %"]);
    }
}
