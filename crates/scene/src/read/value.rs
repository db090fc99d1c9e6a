//! What a scene file holds, in either format.

use std::collections::BTreeMap;

use crate::error::number;

/// One value, as both formats have it.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value {
    /// The null of JSON.
    Null,
    Boolean(bool),
    /// A number: the nearest f64, and the exact integer where it was written as one.
    Number {
        nearest: f64,
        integer: Option<i64>,
    },
    Text(String),
    /// A date of TOML, as written.
    Date(String),
    /// An array: the first entries, [`Value::KEPT`] at most, and how many there are. No key of a
    /// scene takes more, but for the lists of bodies, which are read entry by entry.
    Array {
        first: Vec<Value>,
        len: usize,
    },
    Table(BTreeMap<String, Value>),
}

impl Value {
    /// Most entries of an array that are kept. Messages show arrays up to this length in full.
    pub(super) const KEPT: usize = 4;

    /// The value as messages name it: a number or a short list of numbers in full.
    pub(super) fn describe(&self) -> String {
        match self {
            Self::Null => "null".to_owned(),
            Self::Boolean(value) => value.to_string(),
            Self::Number { nearest, .. } => number(*nearest),
            Self::Text(text) if text.chars().count() <= 60 => format!("{text:?}"),
            Self::Text(text) => {
                let start: String = text.chars().take(60).collect();
                format!("{start:?}... (shortened)")
            }
            Self::Date(text) => format!("the date {text}"),
            Self::Array { first, len } => {
                let numbers = first.iter().all(|value| matches!(value, Self::Number { .. }));
                if numbers && first.len() == *len {
                    let inside: Vec<_> = first.iter().map(Self::describe).collect();
                    format!("[{}]", inside.join(", "))
                } else {
                    format!("an array of {len}")
                }
            }
            Self::Table(_) => "a table".to_owned(),
        }
    }
}
