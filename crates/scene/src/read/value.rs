//! What a scene file holds, in either format.

use std::collections::BTreeMap;

use crate::error::number;

/// One value, as both formats have it.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value {
    /// JSON only.
    Null,
    Boolean(bool),
    /// A number: its nearest f64, and itself where it was written as an integer.
    Number {
        nearest: f64,
        integer: Option<i64>,
    },
    Text(String),
    /// TOML only, as written.
    Date(String),
    Array(Vec<Value>),
    Table(BTreeMap<String, Value>),
}

impl Value {
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
            Self::Array(values) => {
                let numbers = values.iter().all(|value| matches!(value, Self::Number { .. }));
                if numbers && values.len() <= 4 {
                    let inside: Vec<_> = values.iter().map(Self::describe).collect();
                    format!("[{}]", inside.join(", "))
                } else {
                    format!("an array of {}", values.len())
                }
            }
            Self::Table(_) => "a table".to_owned(),
        }
    }
}
