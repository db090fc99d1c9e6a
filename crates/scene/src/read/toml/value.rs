//! One value as the parser has it.

use toml::Spanned;
use toml::de::{DeFloat, DeInteger, DeTable, DeValue};

use super::super::value::Value;

pub(super) fn value(parsed: DeValue<'_>) -> Value {
    match parsed {
        DeValue::String(text) => Value::Text(text.into_owned()),
        DeValue::Integer(digits) => integer(&digits),
        DeValue::Float(digits) => float(&digits),
        DeValue::Boolean(value) => Value::Boolean(value),
        DeValue::Datetime(date) => Value::Date(date.to_string()),
        DeValue::Array(entries) => {
            let len = entries.len();
            let first = entries.into_iter().take(Value::KEPT);
            Value::Array { first: first.map(|entry| value(entry.into_inner())).collect(), len }
        }
        DeValue::Table(entries) => table(entries),
    }
}

fn table(entries: DeTable<'_>) -> Value {
    let entry = |(key, inner): (Spanned<_>, Spanned<_>)| {
        (String::from(key.into_inner()), value(inner.into_inner()))
    };
    Value::Table(entries.into_iter().map(entry).collect())
}

/// Reads an integer. The parser has checked the digits and taken out underscores and prefix.
fn integer(digits: &DeInteger<'_>) -> Value {
    match i64::from_str_radix(digits.as_str(), digits.radix()) {
        Ok(integer) => Value::Number { nearest: integer as f64, integer: Some(integer) },
        // An integer beyond i64 is still a number, for keys that take any number.
        Err(_) if digits.radix() == 10 => {
            Value::Number { nearest: parsed(digits.as_str()), integer: None }
        }
        Err(_) => Value::Number { nearest: f64::INFINITY, integer: None },
    }
}

/// Reads a float. A number too large for f64 becomes infinite; the check of ranges refuses it.
fn float(digits: &DeFloat<'_>) -> Value {
    Value::Number { nearest: parsed(digits.as_str()), integer: None }
}

fn parsed(digits: &str) -> f64 {
    digits.parse().unwrap_or(f64::NAN)
}
