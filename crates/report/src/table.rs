//! Rows: the one form in which every study states what it measured.

use std::fmt;

use serde::{Serialize, Serializer};

/// Rows of one kind.
#[derive(Clone, Debug)]
pub struct Table {
    /// A name for files and keys: lower case, hyphens.
    pub name: &'static str,
    /// One sentence: what the rows are, and what they show.
    pub caption: String,
    /// What each cell of a row is.
    pub columns: &'static [Column],
    /// Each as long as `columns`.
    pub rows: Vec<Vec<Cell>>,
}

/// What the cells of a column are.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Column {
    /// The key in JSON and CSV: lower case, underscores, with the unit where there is one.
    pub key: &'static str,
    /// The heading for people.
    pub heading: &'static str,
    /// One sentence: what it is, with its unit.
    pub meaning: &'static str,
}

/// A measured value.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// A word or a sentence.
    Text(String),
    /// A whole number.
    Count(u64),
    /// A number; for machines with all its digits. Not finite: null in JSON.
    Number(f64),
    /// Yes or no; true or false for machines.
    Truth(bool),
    /// Not measured, or not defined.
    Nothing,
}

impl Table {
    /// A table without rows.
    #[must_use]
    pub fn new(name: &'static str, columns: &'static [Column], caption: impl Into<String>) -> Self {
        Self { name, caption: caption.into(), columns, rows: Vec::new() }
    }

    /// Adds a row.
    ///
    /// # Panics
    /// If it has not one cell a column.
    pub fn push<const N: usize>(&mut self, cells: [Cell; N]) {
        assert_eq!(N, self.columns.len(), "{}: one cell a column", self.name);
        self.rows.push(cells.into());
    }
}

impl From<&str> for Cell {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl From<u32> for Cell {
    fn from(count: u32) -> Self {
        Self::Count(count.into())
    }
}

impl From<u64> for Cell {
    fn from(count: u64) -> Self {
        Self::Count(count)
    }
}

impl From<usize> for Cell {
    fn from(count: usize) -> Self {
        Self::Count(count as u64)
    }
}

impl From<f64> for Cell {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<bool> for Cell {
    fn from(truth: bool) -> Self {
        Self::Truth(truth)
    }
}

impl<T: Into<Cell>> From<Option<T>> for Cell {
    fn from(cell: Option<T>) -> Self {
        cell.map_or(Self::Nothing, Into::into)
    }
}

impl fmt::Display for Cell {
    /// Writes the cell as people read it: four digits of a number.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Text(text) => f.write_str(text),
            Self::Count(count) => write!(f, "{count}"),
            Self::Number(number) => write_number(f, *number),
            Self::Truth(truth) => f.write_str(if *truth { "yes" } else { "no" }),
            Self::Nothing => f.write_str("-"),
        }
    }
}

fn write_number(f: &mut fmt::Formatter<'_>, number: f64) -> fmt::Result {
    let size = number.abs();
    let whole = number.fract() == 0.0 && size < 1e5;
    if whole || !number.is_finite() {
        write!(f, "{number}")
    } else if !(1e-3..1e5).contains(&size) {
        write!(f, "{number:.2e}")
    } else {
        // 1234.5 has no decimals, 0.0012345 has six.
        let before = size.log10().floor() as i32 + 1;
        let decimals = usize::try_from(4 - before).unwrap_or(0);
        write!(f, "{number:.decimals$}")
    }
}

impl Serialize for Cell {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Text(text) => to.serialize_str(text),
            Self::Count(count) => to.serialize_u64(*count),
            // JSON has no NaN; serde_json writes null for it.
            Self::Number(number) => to.serialize_f64(*number),
            Self::Truth(truth) => to.serialize_bool(*truth),
            Self::Nothing => to.serialize_none(),
        }
    }
}
