//! JSON text to values.

use std::collections::BTreeMap;
use std::fmt;
use std::ops::Range;

use serde::Deserialize;
use serde::de::{Deserializer, Error, MapAccess, SeqAccess, Visitor};
use serde_json::value::RawValue;

use super::text::starts_like_json;
use super::{Located, Value, stands_for_array};
use crate::SceneError;
use crate::error::{Problem, Segment};

/// Parses a text. The parser refuses nesting deeper than 127, so recursion ends.
pub(super) fn parse(name: &str, text: &str) -> Result<Value, SceneError> {
    serde_json::from_str(text).map_err(|error| {
        // The parser appends the place, which this program words itself.
        let message = error.to_string();
        let place = format!(" at line {} column {}", error.line(), error.column());
        let message = message.strip_suffix(&place).unwrap_or(&message);
        let byte = last_read(text, error.line(), error.column());
        let message = explained(message, text, byte);
        SceneError::from(Problem::Syntax(message)).at(name, text, byte)
    })
}

/// The byte that a place of the parser's means: its lines count from 1, its columns are the
/// bytes of the line that were read. Column 0 is the line break before.
fn last_read(text: &str, line: usize, column: usize) -> usize {
    let before: usize = text.split_inclusive('\n').take(line.saturating_sub(1)).map(str::len).sum();
    (before + column).saturating_sub(1)
}

/// The parser's message, for those who do not know how it reads.
fn explained(message: &str, text: &str, byte: usize) -> String {
    // What some programs write for a number that JSON does not have.
    let rest = text.get(byte..).unwrap_or_default();
    if let Some(word) = ["NaN", "Infinity"].iter().find(|word| rest.starts_with(**word)) {
        return format!("found {word}; allowed: finite numbers");
    }
    if !starts_like_json(text.as_bytes()) {
        return format!(
            "{message}; a scene in JSON starts with {{, one in TOML needs a name that does not end in .json"
        );
    }
    match message.strip_prefix("EOF ") {
        Some(rest) => format!("the text ends {rest}"),
        None if message == "number out of range" => {
            "number out of range; allowed: at most 1.7976931348623157e308, the largest of f64"
                .to_owned()
        }
        None => message.to_owned(),
    }
}

/// Finds a key in a text that has been parsed before. A key itself is shown at its value.
pub(super) fn locate(text: &str, path: &[Segment]) -> Option<Located> {
    let mut raw: &RawValue = serde_json::from_str(text).ok()?;
    for (depth, segment) in path.iter().enumerate() {
        let inner = raw.get();
        let child = match segment {
            Segment::Key(key) if inner.starts_with('{') => {
                serde_json::from_str::<BTreeMap<String, &RawValue>>(inner).ok()?.remove(key)
            }
            Segment::Index(index) if inner.starts_with('[') => {
                serde_json::from_str::<Vec<&RawValue>>(inner).ok()?.get(*index).copied()
            }
            _ => {
                let value = serde_json::from_str(inner).ok()?;
                let found = stands_for_array(&value, &path[depth..]);
                return found.then(|| Located { span: span(text, inner), value, depth });
            }
        };
        raw = child?;
    }
    let value = serde_json::from_str(raw.get()).ok()?;
    Some(Located { span: span(text, raw.get()), value, depth: path.len() })
}

/// The bytes of a part that was borrowed from the text.
fn span(text: &str, part: &str) -> Range<usize> {
    let start = part.as_ptr() as usize - text.as_ptr() as usize;
    start..start + part.len()
}

impl<'de> Deserialize<'de> for Value {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ValueVisitor)
    }
}

struct ValueVisitor;

impl<'de> Visitor<'de> for ValueVisitor {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a value")
    }

    fn visit_unit<E>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    fn visit_bool<E>(self, value: bool) -> Result<Value, E> {
        Ok(Value::Boolean(value))
    }

    fn visit_i64<E>(self, integer: i64) -> Result<Value, E> {
        Ok(Value::Number { nearest: integer as f64, integer: Some(integer) })
    }

    fn visit_u64<E>(self, integer: u64) -> Result<Value, E> {
        Ok(Value::Number { nearest: integer as f64, integer: i64::try_from(integer).ok() })
    }

    fn visit_f64<E>(self, nearest: f64) -> Result<Value, E> {
        Ok(Value::Number { nearest, integer: None })
    }

    fn visit_str<E>(self, text: &str) -> Result<Value, E> {
        Ok(Value::Text(text.to_owned()))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut entries: A) -> Result<Value, A::Error> {
        let mut values = Vec::new();
        while let Some(value) = entries.next_element()? {
            values.push(value);
        }
        Ok(Value::Array(values))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Value, A::Error> {
        let mut table = BTreeMap::new();
        while let Some(key) = entries.next_key::<String>()? {
            // Serde would keep the last of two equal keys without a word.
            if table.contains_key(&key) {
                return Err(A::Error::custom(format_args!("the key {key:?} is there twice")));
            }
            let value = entries.next_value()?;
            table.insert(key, value);
        }
        Ok(Value::Table(table))
    }
}
