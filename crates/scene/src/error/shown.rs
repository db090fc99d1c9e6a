//! Text that is not ours, such as names and keys of files, as messages show it.

use std::fmt::Write;

/// Writes a text that is not ours on one line of at most about `most` columns.
///
/// Characters that a terminal would obey or hide stand as escapes: control characters, line
/// breaks, marks of direction, invisible and private ones. A longer text loses its middle, and
/// says how much. The work does not grow with what is left out.
#[must_use]
pub fn shown(text: &str, most: usize) -> String {
    let mut columns = 0;
    let mut whole = String::new();
    // Where the front ends if the text is too long: in the text, and as written.
    let mut front = (0, 0);
    for (at, c) in text.char_indices() {
        push_visible(c, &mut whole);
        columns += width(c);
        if columns <= most / 2 {
            front = (at + c.len_utf8(), whole.len());
        }
        if columns > most {
            let back = back(text, most - most / 2);
            whole.truncate(front.1);
            let left_out = back - front.0;
            let _ = write!(whole, "[... {left_out} bytes ...]");
            text[back..].chars().for_each(|c| push_visible(c, &mut whole));
            return whole;
        }
    }
    whole
}

/// Byte at which the longest end of a text begins that takes at most `most` columns.
fn back(text: &str, most: usize) -> usize {
    let mut columns = 0;
    let fits = |(_, c): &(usize, char)| {
        columns += width(*c);
        columns <= most
    };
    text.char_indices().rev().take_while(fits).last().map_or(text.len(), |(at, _)| at)
}

/// Appends a character, or its escape where it is not to be seen.
pub(super) fn push_visible(c: char, to: &mut String) {
    if is_visible(c) { to.push(c) } else { to.extend(c.escape_default()) }
}

/// Columns that a character takes as [`push_visible`] writes it, at most.
pub(super) fn width(c: char) -> usize {
    match is_visible(c) {
        false => c.escape_default().len(),
        // East Asian letters take two columns; which letters do depends on the terminal.
        true => 1 + usize::from(!c.is_ascii()),
    }
}

/// Whether a character shows itself and does nothing else, as [`shown`] sees it.
#[must_use]
pub fn is_visible(c: char) -> bool {
    if c.is_ascii() {
        return !c.is_ascii_control();
    }
    // The standard library escapes the categories C and Z of Unicode. The letter in front keeps
    // it from escaping what joins a letter, such as accents.
    let mut pair = String::from("x");
    pair.push(c);
    pair.escape_debug().nth(1) == Some(c) && !is_blank(c)
}

/// Whether a character of the categories L, M and S has no ink of its own.
///
/// Source: Unicode 16, `DerivedCoreProperties.txt`, Default_Ignorable_Code_Point, less what
/// is in category C; and the Braille pattern without dots.
fn is_blank(c: char) -> bool {
    matches!(
        c,
        '\u{34f}'
            | '\u{115f}'..='\u{1160}'
            | '\u{17b4}'..='\u{17b5}'
            | '\u{180b}'..='\u{180f}'
            | '\u{2800}'
            | '\u{3164}'
            | '\u{fe00}'..='\u{fe0f}'
            | '\u{ffa0}'
            | '\u{e0100}'..='\u{e01ef}'
    )
}
