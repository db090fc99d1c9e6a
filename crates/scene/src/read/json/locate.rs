//! The place of a key in a JSON text.

use std::fmt;
use std::ops::Range;

use serde::de::{DeserializeSeed, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde_json::value::RawValue;

use super::super::located::{Located, stands_for_array};
use super::super::value::Value;
use super::value::ValueSeed;
use crate::error::Segment;

/// Finds a key in a text that has been parsed before. The place is that of the value, also where
/// the key itself is wrong.
pub(in super::super) fn locate(text: &str, path: &[Segment]) -> Option<Located> {
    let mut raw: &RawValue = serde_json::from_str(text).ok()?;
    for (depth, segment) in path.iter().enumerate() {
        let inner = raw.get();
        let child = match segment {
            Segment::Key(_) if inner.starts_with('{') => child(inner, segment),
            Segment::Index(_) if inner.starts_with('[') => child(inner, segment),
            _ => {
                let value = value(inner)?;
                let found = stands_for_array(&value, &path[depth..]);
                return found.then(|| Located { span: span(text, inner), value, depth });
            }
        };
        raw = child?;
    }
    let value = value(raw.get())?;
    Some(Located { span: span(text, raw.get()), value, depth: path.len() })
}

fn value(text: &str) -> Option<Value> {
    ValueSeed::TOP.deserialize(&mut serde_json::Deserializer::from_str(text)).ok()
}

/// The bytes of a part that was borrowed from the text.
fn span(text: &str, part: &str) -> Range<usize> {
    let start = part.as_ptr() as usize - text.as_ptr() as usize;
    start..start + part.len()
}

/// The part of a table or an array that a segment names; other parts are skipped, not kept.
fn child<'t>(text: &'t str, segment: &Segment) -> Option<&'t RawValue> {
    Child(segment).deserialize(&mut serde_json::Deserializer::from_str(text)).ok()?
}

struct Child<'a>(&'a Segment);

impl<'de> DeserializeSeed<'de> for Child<'_> {
    type Value = Option<&'de RawValue>;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Self::Value, D::Error> {
        from.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Child<'_> {
    type Value = Option<&'de RawValue>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a table or an array")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut entries: A) -> Result<Self::Value, A::Error> {
        let mut found = None;
        for index in 0.. {
            if *self.0 == Segment::Index(index) {
                found = entries.next_element()?;
                if found.is_none() {
                    break;
                }
            } else if entries.next_element::<IgnoredAny>()?.is_none() {
                break;
            }
        }
        Ok(found)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Self::Value, A::Error> {
        let mut found = None;
        while let Some(key) = entries.next_key::<String>()? {
            if matches!(self.0, Segment::Key(wanted) if *wanted == key) {
                found = Some(entries.next_value()?);
            } else {
                entries.next_value::<IgnoredAny>()?;
            }
        }
        Ok(found)
    }
}
