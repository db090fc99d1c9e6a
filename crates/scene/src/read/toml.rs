//! TOML text to values.

use ::toml::Spanned;
use ::toml::de::{DeFloat, DeInteger, DeTable, DeValue};

use super::text::starts_like_json;
use super::{Located, Value, stands_for_array};
use crate::SceneError;
use crate::error::{Problem, Segment, Target};

/// Parses a text. The parser refuses nesting deeper than 80, so the recursion below ends.
pub(super) fn parse(name: &str, text: &str) -> Result<Value, SceneError> {
    match DeTable::parse(text) {
        Ok(root) => Ok(table(root.into_inner())),
        Err(error) => {
            let mut message = error.message().to_owned();
            if starts_like_json(text.as_bytes()) {
                message += "; the file looks like JSON, which needs a name that ends in .json";
            }
            let problem = SceneError::from(Problem::Syntax(message));
            Err(problem.shown(name, text, error.span().unwrap_or(0..0)))
        }
    }
}

/// Finds a key in a text that has been parsed before.
pub(super) fn locate(text: &str, path: &[Segment], target: Target) -> Option<Located> {
    let root = DeTable::parse(text).ok()?;
    let mut span = root.span();
    let mut at = &DeValue::Table(root.into_inner());
    for (depth, segment) in path.iter().enumerate() {
        let child = match (segment, at) {
            (Segment::Key(key), DeValue::Table(entries)) => {
                let (found, child) = entries.get_key_value(key.as_str())?;
                span = if target == Target::Key { found.span() } else { child.span() };
                child
            }
            (Segment::Index(index), DeValue::Array(entries)) => {
                let child = entries.get(*index)?;
                span = child.span();
                child
            }
            _ => {
                let value = value(at.clone());
                let found = stands_for_array(&value, &path[depth..]);
                return found.then_some(Located { span, value, depth });
            }
        };
        at = child.get_ref();
    }
    Some(Located { span, value: value(at.clone()), depth: path.len() })
}

fn table(entries: DeTable<'_>) -> Value {
    let entry = |(key, inner): (Spanned<_>, Spanned<_>)| {
        (String::from(key.into_inner()), value(inner.into_inner()))
    };
    Value::Table(entries.into_iter().map(entry).collect())
}

fn value(parsed: DeValue<'_>) -> Value {
    match parsed {
        DeValue::String(text) => Value::Text(text.into_owned()),
        DeValue::Integer(digits) => integer(&digits),
        DeValue::Float(digits) => float(&digits),
        DeValue::Boolean(value) => Value::Boolean(value),
        DeValue::Datetime(date) => Value::Date(date.to_string()),
        DeValue::Array(entries) => {
            Value::Array(entries.into_iter().map(|entry| value(entry.into_inner())).collect())
        }
        DeValue::Table(entries) => table(entries),
    }
}

/// The parser has checked the digits and taken out the underscores and the prefix.
fn integer(digits: &DeInteger<'_>) -> Value {
    match i64::from_str_radix(digits.as_str(), digits.radix()) {
        Ok(integer) => Value::Number { nearest: integer as f64, integer: Some(integer) },
        // Longer than i64: still a number where any number will do.
        Err(_) if digits.radix() == 10 => {
            Value::Number { nearest: parsed(digits.as_str()), integer: None }
        }
        Err(_) => Value::Number { nearest: f64::INFINITY, integer: None },
    }
}

/// A number too large for f64 becomes infinite, and is refused with the ranges.
fn float(digits: &DeFloat<'_>) -> Value {
    Value::Number { nearest: parsed(digits.as_str()), integer: None }
}

fn parsed(digits: &str) -> f64 {
    digits.parse().unwrap_or(f64::NAN)
}
