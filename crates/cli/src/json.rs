//! JSON documents.

use std::io::{self, Write};

use catoptric_scene::is_visible;
use serde::Serialize;

/// Writes one document and a line break.
///
/// Characters that a terminal would obey or hide are escaped, also where JSON need not.
pub(crate) fn write(to: &mut dyn Write, document: &impl Serialize) -> io::Result<()> {
    let text = serde_json::to_string_pretty(document)?;
    to.write_all(escaped(&text).as_bytes())?;
    writeln!(to)
}

/// The same document. Only its strings hold such characters, so escapes can stand for them.
pub(crate) fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        if c == '\n' || is_visible(c) {
            escaped.push(c);
        } else {
            let units = &mut [0; 2];
            c.encode_utf16(units).iter().for_each(|unit| escaped += &format!("\\u{unit:04x}"));
        }
    }
    escaped
}
