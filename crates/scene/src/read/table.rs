//! The keys of one table, and the types of what they hold.

use std::collections::BTreeMap;

use super::nearest::list;
use super::value::Value;
use crate::error::{Fault, Trail};
use crate::validate::allowed::Allowed;

/// A table whose keys are all known. Each method answers `None` where the table does not have the
/// key, and an error that names the key where its value has another type.
pub(super) struct Table<'a> {
    pub(super) trail: &'a Trail<'a>,
    entries: &'a BTreeMap<String, Value>,
}

impl<'a> Table<'a> {
    /// Opens a value as a table that may have the `known` keys and no others.
    pub(super) fn open(
        value: &'a Value,
        trail: &'a Trail<'a>,
        known: &[&'static str],
    ) -> Result<Self, Fault> {
        let Value::Table(entries) = value else {
            let allowed = format!("a table with the keys {}", known.join(", "));
            return Err(Fault::new(*trail, value.describe(), allowed));
        };
        for key in entries.keys() {
            check_key(key, trail, known)?;
        }
        Ok(Self { trail, entries })
    }

    /// The value of a key and the key's path.
    pub(super) fn get(&self, key: &'a str) -> Option<(&'a Value, Trail<'a>)> {
        Some((self.entries.get(key)?, self.trail.key(key)))
    }

    /// The path of a required key that is missing, as a fault.
    pub(super) fn missing(&self, key: &str, allowed: impl Into<String>) -> Fault {
        Fault::new(self.trail.key(key), "nothing, and it is required".to_owned(), allowed)
    }

    /// A number, written with a fraction or without.
    pub(super) fn number(&self, key: &'a str, allowed: &Allowed) -> Result<Option<f64>, Fault> {
        let Some((value, trail)) = self.get(key) else {
            return Ok(None);
        };
        match value {
            Value::Number { nearest, .. } => Ok(Some(*nearest)),
            _ => Err(Fault::new(trail, value.describe(), allowed.text)),
        }
    }

    /// A number without a fraction, written without one.
    pub(super) fn integer(&self, key: &'a str, allowed: &Allowed) -> Result<Option<u32>, Fault> {
        let Some((value, trail)) = self.get(key) else {
            return Ok(None);
        };
        let integer = match value {
            Value::Number { integer: Some(integer), .. } => u32::try_from(*integer).ok(),
            _ => None,
        };
        integer.map(Some).ok_or_else(|| {
            let mut found = value.describe();
            if matches!(value, Value::Number { nearest, integer: None } if nearest.fract() == 0.0) {
                found += " written with a fraction or an exponent";
            }
            Fault::new(trail, found, allowed.text)
        })
    }

    /// Three numbers; `names` is `[x, y, z]` or the like.
    pub(super) fn triple(
        &self,
        key: &'a str,
        names: &str,
        allowed: &Allowed,
    ) -> Result<Option<[f64; 3]>, Fault> {
        let Some((value, trail)) = self.get(key) else {
            return Ok(None);
        };
        three(value, trail, names, allowed).map(Some)
    }

    /// Three numbers, or one that stands for all three.
    pub(super) fn light(&self, key: &'a str, allowed: &Allowed) -> Result<Option<[f64; 3]>, Fault> {
        let Some((value, trail)) = self.get(key) else {
            return Ok(None);
        };
        match value {
            Value::Number { nearest, .. } => Ok(Some([*nearest; 3])),
            _ => three(value, trail, "one number or [r, g, b]", allowed).map(Some),
        }
    }

    /// A text.
    pub(super) fn text(&self, key: &'a str, allowed: &str) -> Result<Option<&'a str>, Fault> {
        match self.get(key) {
            None => Ok(None),
            Some((Value::Text(text), _)) => Ok(Some(text)),
            Some((other, trail)) => Err(Fault::new(trail, other.describe(), allowed)),
        }
    }

    /// The meaning of one of two words.
    pub(super) fn word<T: Copy>(
        &self,
        key: &'a str,
        words: [(&'static str, T); 2],
    ) -> Result<Option<T>, Fault> {
        let Some((value, trail)) = self.get(key) else {
            return Ok(None);
        };
        let stated = |word: &str| matches!(value, Value::Text(text) if text == word);
        let chosen = words.iter().find(|(word, _)| stated(word));
        chosen.map(|(_, meaning)| Some(*meaning)).ok_or_else(|| {
            let [(first, _), (second, _)] = words;
            Fault::new(trail, value.describe(), format!("{first:?} or {second:?}"))
        })
    }
}

/// Checks that a table may have a key.
pub(super) fn check_key(key: &str, trail: &Trail<'_>, known: &[&'static str]) -> Result<(), Fault> {
    if known.contains(&key) {
        return Ok(());
    }
    let allowed = list(key, known.iter().copied());
    Err(Fault::key(trail.key(key), "an unknown key".to_owned(), allowed))
}

fn three(
    value: &Value,
    trail: Trail<'_>,
    names: &str,
    allowed: &Allowed,
) -> Result<[f64; 3], Fault> {
    let text = || format!("{names}, each {}", allowed.text);
    let Value::Array { first, .. } = value else {
        return Err(Fault::new(trail, value.describe(), text()));
    };
    let entries: &[Value; 3] =
        first.as_slice().try_into().map_err(|_| Fault::new(trail, value.describe(), text()))?;
    let mut numbers = [0.0; 3];
    for (index, (number, entry)) in numbers.iter_mut().zip(entries).enumerate() {
        let Value::Number { nearest, .. } = entry else {
            return Err(Fault::new(trail.index(index), entry.describe(), allowed.text));
        };
        *number = *nearest;
    }
    Ok(numbers)
}
