//! One JSON value of bounded size.

use std::collections::BTreeMap;
use std::fmt;

use serde::de::{DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};

use super::super::value::Value;

/// Levels below a value that are kept: its keys, a key's numbers, and one more to tell a number
/// from what is none. No value of a scene is nested deeper.
const LEVELS: u32 = 3;

/// Most keys of a table that are kept. Any table of a scene has fewer, so where there are more, at
/// least one of the kept keys is unknown and the table is refused.
const TABLE_KEYS: usize = 32;

/// The error of a key that is there twice in one table.
pub(super) fn twice<E: Error>(key: &str) -> E {
    E::custom(format_args!("the key {key:?} is there twice"))
}

/// Reads a value at a depth: 0 for the value itself, 1 for its parts, and on.
#[derive(Clone, Copy)]
pub(super) struct ValueSeed(u32);

impl ValueSeed {
    /// The seed of a value that is not part of another.
    pub(super) const TOP: Self = Self(0);
}

impl<'de> DeserializeSeed<'de> for ValueSeed {
    type Value = Value;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Value, D::Error> {
        from.deserialize_any(ValueVisitor(self.0))
    }
}

/// Visitor behind [`ValueSeed`], at the same depth.
pub(super) struct ValueVisitor(u32);

impl ValueVisitor {
    /// The visitor of a value that is not part of another.
    pub(super) const TOP: Self = Self(0);

    fn below(&self) -> Option<ValueSeed> {
        (self.0 < LEVELS).then_some(ValueSeed(self.0 + 1))
    }
}

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
        let mut first = Vec::new();
        if let Some(below) = self.below() {
            while first.len() < Value::KEPT
                && let Some(value) = entries.next_element_seed(below)?
            {
                first.push(value);
            }
        }
        let mut len = first.len();
        while entries.next_element::<IgnoredAny>()?.is_some() {
            len += 1;
        }
        Ok(Value::Array { first, len })
    }

    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Value, A::Error> {
        let mut table = BTreeMap::new();
        if let Some(below) = self.below() {
            while table.len() < TABLE_KEYS
                && let Some(key) = entries.next_key::<String>()?
            {
                // Serde would keep the last of two equal keys without a word.
                if table.contains_key(&key) {
                    return Err(twice::<A::Error>(&key));
                }
                let value = entries.next_value_seed(below)?;
                table.insert(key, value);
            }
        }
        while entries.next_entry::<IgnoredAny, IgnoredAny>()?.is_some() {}
        Ok(Value::Table(table))
    }
}
