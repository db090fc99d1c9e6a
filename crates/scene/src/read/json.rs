//! JSON text to a draft, entry by entry.

mod locate;
mod value;

use std::fmt;

use serde::de::{DeserializeSeed, Deserializer, Error, MapAccess, SeqAccess, Visitor};

pub(super) use locate::locate;

use super::draft::{KEYS, List, MATERIALS, Reader};
use super::text::starts_like_json;
use super::value::Value;
use crate::SceneError;
use crate::error::Problem;
use value::{ValueSeed, ValueVisitor, twice};

/// Reads a text. The parser refuses nesting deeper than 127, so recursion ends.
pub(super) fn read(name: &str, text: &str, reader: &mut Reader) -> Result<(), SceneError> {
    // Beside the entries the parser holds at most one long text, for a moment.
    let refused = |problem| SceneError::of_file(name, problem);
    reader.memory().for_a_moment(text.len() as u64).map_err(refused)?;
    let mut stopped = None;
    let mut parser = serde_json::Deserializer::from_str(text);
    let top = At { place: Place::Top, reader, stopped: &mut stopped };
    let parsed = top.deserialize(&mut parser).and_then(|whole| {
        parser.end()?;
        Ok(whole)
    });
    if let Some(problem) = stopped {
        return Err(refused(problem));
    }
    match parsed {
        Ok(None) => Ok(()),
        Ok(Some(value)) => {
            reader.not_a_table(&value);
            Ok(())
        }
        Err(error) => Err(broken(name, text, &error)),
    }
}

/// The error of broken syntax, with its place.
fn broken(name: &str, text: &str, error: &serde_json::Error) -> SceneError {
    // The parser appends the place, which this program words itself.
    let message = error.to_string();
    let place = format!(" at line {} column {}", error.line(), error.column());
    let message = message.strip_suffix(&place).unwrap_or(&message);
    let byte = last_read(text, error.line(), error.column());
    let message = explained(message, text, byte);
    SceneError::from(Problem::Syntax(message)).at(name, text, byte)
}

/// The byte that the parser's line and column mean. Lines count from 1; the column is how many
/// bytes of the line were read, so column 0 is the line break before.
fn last_read(text: &str, line: usize, column: usize) -> usize {
    let before: usize = text.split_inclusive('\n').take(line.saturating_sub(1)).map(str::len).sum();
    (before + column).saturating_sub(1)
}

/// The parser's message, for people who do not know how the parser reads.
fn explained(message: &str, text: &str, byte: usize) -> String {
    // Some programs write these words for numbers that JSON does not have.
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

/// A value of the scene whose parts are read one by one.
#[derive(Clone, Copy)]
enum Place {
    Top,
    List(List),
    Materials,
}

/// Reads the value of a place, part by part. A value of another type than belongs there comes back
/// whole.
struct At<'a> {
    place: Place,
    reader: &'a mut Reader,
    /// Why reading ended, if not because of the text.
    stopped: &'a mut Option<Problem>,
}

impl At<'_> {
    fn at(&mut self, place: Place) -> At<'_> {
        At { place, reader: self.reader, stopped: self.stopped }
    }

    /// Ends the parsing where the memory is not enough.
    fn go_on<T, E: Error>(&mut self, read: Result<T, Problem>) -> Result<T, E> {
        read.map_err(|problem| {
            *self.stopped = Some(problem);
            E::custom("no memory")
        })
    }
}

impl<'de> DeserializeSeed<'de> for At<'_> {
    type Value = Option<Value>;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Option<Value>, D::Error> {
        from.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for At<'_> {
    type Value = Option<Value>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a value")
    }

    fn visit_unit<E: Error>(self) -> Result<Option<Value>, E> {
        ValueVisitor::TOP.visit_unit().map(Some)
    }

    fn visit_bool<E: Error>(self, value: bool) -> Result<Option<Value>, E> {
        ValueVisitor::TOP.visit_bool(value).map(Some)
    }

    fn visit_i64<E: Error>(self, integer: i64) -> Result<Option<Value>, E> {
        ValueVisitor::TOP.visit_i64(integer).map(Some)
    }

    fn visit_u64<E: Error>(self, integer: u64) -> Result<Option<Value>, E> {
        ValueVisitor::TOP.visit_u64(integer).map(Some)
    }

    fn visit_f64<E: Error>(self, nearest: f64) -> Result<Option<Value>, E> {
        ValueVisitor::TOP.visit_f64(nearest).map(Some)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Option<Value>, E> {
        ValueVisitor::TOP.visit_str(text).map(Some)
    }

    fn visit_seq<A: SeqAccess<'de>>(mut self, mut entries: A) -> Result<Option<Value>, A::Error> {
        let Place::List(list) = self.place else {
            return ValueVisitor::TOP.visit_seq(entries).map(Some);
        };
        while let Some(value) = entries.next_element_seed(ValueSeed::TOP)? {
            let read = self.reader.entry(list, &value);
            self.go_on(read)?;
        }
        Ok(None)
    }

    fn visit_map<A: MapAccess<'de>>(mut self, mut entries: A) -> Result<Option<Value>, A::Error> {
        match self.place {
            Place::List(_) => return ValueVisitor::TOP.visit_map(entries).map(Some),
            // Names are the keys here. The reader knows which it has seen.
            Place::Materials => {
                while let Some(name) = entries.next_key::<String>()? {
                    let value = entries.next_value_seed(ValueSeed::TOP)?;
                    let read = self.reader.material(&name, &value);
                    if !self.go_on(read)? {
                        return Err(twice(&name));
                    }
                }
            }
            Place::Top => {
                // Serde accepts a key twice; the format does not.
                let mut seen = [false; KEYS.len()];
                while let Some(key) = entries.next_key::<String>()? {
                    self.reader.key(&key);
                    if let Some(known) = KEYS.iter().position(|known| *known == key)
                        && std::mem::replace(&mut seen[known], true)
                    {
                        return Err(twice(&key));
                    }
                    // Lists and materials are read in parts, so that no tree of them is made.
                    let place = match List::of_key(&key) {
                        Some(list) => Some(Place::List(list)),
                        None => (key == MATERIALS).then_some(Place::Materials),
                    };
                    let value = match place {
                        Some(place) => entries.next_value_seed(self.at(place))?,
                        None => Some(entries.next_value_seed(ValueSeed::TOP)?),
                    };
                    if let Some(value) = value {
                        self.reader.setting(&key, &value);
                    }
                }
            }
        }
        Ok(None)
    }
}
