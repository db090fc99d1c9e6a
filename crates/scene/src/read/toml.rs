//! TOML text to a draft, part by part.
//!
//! The parser's tree is fifty times as large as its text. Therefore a long text is cut into parts
//! between its tables (`parts`), each a TOML text of its own, and one part is parsed at a time.

mod parts;
mod value;

use std::ops::Range;

use ::toml::Spanned;
use ::toml::de::{DeTable, DeValue, Error};

use super::draft::{KEYS, List, MATERIALS, Reader};
use super::located::{Located, stands_for_array};
use super::memory::Memory;
use super::text::starts_like_json;
use crate::SceneError;
use crate::error::{Problem, Segment, Target};
use parts::{Part, parts};
use value::value;

/// Reads a text. The parser refuses nesting deeper than 80, so recursion over values ends.
pub(super) fn read(name: &str, text: &str, reader: &mut Reader) -> Result<(), SceneError> {
    let refused = |problem| SceneError::of_file(name, problem);
    let broken = |message: String, place: Range<usize>| {
        SceneError::from(Problem::Syntax(message)).shown(name, text, place)
    };
    for part in parts(text, reader.memory()).map_err(refused)? {
        reader.memory().for_a_moment(part.cost()).map_err(refused)?;
        let own = part.text(text);
        let root = DeTable::parse(&own).map_err(|error| {
            broken(explained(&error, text), part.place(error.span().unwrap_or(0..0)))
        })?;
        read_part(root.into_inner(), reader).map_err(|stop| match stop {
            Stop::Problem(problem) => refused(problem),
            // The parser's own words for a name twice in one part.
            Stop::Twice(key) => broken("duplicate key".to_owned(), part.place(key)),
        })?;
    }
    Ok(())
}

/// The parser's message, with a hint where the text looks like JSON.
fn explained(error: &Error, text: &str) -> String {
    let mut message = error.message().to_owned();
    if starts_like_json(text.as_bytes()) {
        message += "; the file looks like JSON, which needs a name that ends in .json";
    }
    message
}

/// Why reading ends before the text does.
enum Stop {
    Problem(Problem),
    /// A material has the name of one in another part.
    Twice(Range<usize>),
}

fn read_part(mut root: DeTable<'_>, reader: &mut Reader) -> Result<(), Stop> {
    for key in root.keys() {
        reader.key(key.get_ref());
    }
    for key in KEYS {
        let Some(found) = root.remove(key) else { continue };
        match (found.into_inner(), List::of_key(key)) {
            (DeValue::Array(entries), Some(list)) => {
                for entry in entries {
                    reader.entry(list, &value(entry.into_inner())).map_err(Stop::Problem)?;
                }
            }
            (DeValue::Table(named), None) if key == MATERIALS => {
                // The parser sorts names by the alphabet; materials keep the order of the file.
                let mut named: Vec<_> = named.into_iter().collect();
                named.sort_by_key(|(name, _)| name.span().start);
                for (name, stated) in named {
                    let stated = value(stated.into_inner());
                    let new = reader.material(name.get_ref(), &stated);
                    if !new.map_err(Stop::Problem)? {
                        return Err(Stop::Twice(name.span()));
                    }
                }
            }
            (other, _) => reader.setting(key, &value(other)),
        }
    }
    Ok(())
}

/// Finds a key in a text that has been read before.
pub(super) fn locate(text: &str, path: &[Segment], target: Target) -> Option<Located> {
    let mut path = path.to_vec();
    for part in parts(text, &Memory::new(u64::MAX)).ok()? {
        let own = part.text(text);
        let root = DeTable::parse(&own).ok()?;
        // A list may go on in later parts: count off the entries of this one.
        if let [Segment::Key(key), Segment::Index(index), ..] = path.as_mut_slice()
            && let Some(found) = root.get_ref().get(key.as_str())
            && let DeValue::Array(entries) = found.get_ref()
        {
            if *index < entries.len() {
                return locate_in(&part, root, &path, target);
            }
            *index -= entries.len();
            continue;
        }
        if let Some(located) = locate_in(&part, root, &path, target) {
            return Some(located);
        }
    }
    None
}

/// Finds a key in one part; the place is that in the whole text.
fn locate_in(
    part: &Part,
    root: Spanned<DeTable<'_>>,
    path: &[Segment],
    target: Target,
) -> Option<Located> {
    // Walk down the path; the span is always that of the last segment walked.
    let mut span = root.span();
    let mut at = &DeValue::Table(root.into_inner());
    let located = |span, value, depth| Located { span: part.place(span), value, depth };
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
            // The path may point into a number that stands for an array.
            _ => {
                let value = value(at.clone());
                let found = stands_for_array(&value, &path[depth..]);
                return found.then(|| located(span, value, depth));
            }
        };
        at = child.get_ref();
    }
    Some(located(span, value(at.clone()), path.len()))
}
