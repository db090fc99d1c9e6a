//! The line of a text that a message is about.

use std::ops::Range;

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};

use super::shown::{self, push_visible, width};

/// Most columns of a file's name.
pub(super) const NAME: usize = 240;

/// Line and column of a byte, both from 1, the column in characters. A byte past the end
/// or inside a character counts as the nearest place before it.
pub(super) fn line_column(text: &str, byte: usize) -> (usize, usize) {
    let before = &text[..boundary(text, byte)];
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    let line = before.bytes().filter(|&b| b == b'\n').count() + 1;
    (line, before[line_start..].chars().count() + 1)
}

/// ` --> file:line:column` and the line, with the bytes of the span underlined as far as
/// they lie on it. A long line is cut to what is around them.
pub(super) fn render(file: &str, text: &str, line: usize, span: Range<usize>) -> String {
    // Clamp the span to one line: it may end lines below, or past the text.
    let start = boundary(text, span.start);
    let (_, column) = line_column(text, start);
    let line_start = text[..start].rfind('\n').map_or(0, |newline| newline + 1);
    let line_end = text[start..].find('\n').map_or(text.len(), |newline| start + newline);
    let end = boundary(text, span.end.clamp(start, line_end));
    let ends = text[start..line_end].strip_suffix('\r').map_or(line_end, |_| line_end - 1);

    // Cut each part by itself, so that a long marked part leaves room for what is around it.
    let (marked, marked_whole) = front(&text[start..end.min(ends)], MARKED);
    let (before, before_whole) = back(&text[line_start..start], AROUND);
    let (behind, behind_whole) = match marked_whole {
        true => front(&text[end.min(ends)..ends], AROUND),
        false => (String::new(), false),
    };
    // The mark's place is counted in what is shown, not in the text.
    let mut shown = String::new();
    shown += if before_whole { "" } else { CUT };
    shown += &before;
    let mark = shown.len()..shown.len() + marked.len();
    shown += &marked;
    shown += &behind;
    shown += if behind_whole { "" } else { CUT };

    // The library draws the margin and the underline.
    let file = shown::shown(file, NAME);
    let snippet = Snippet::source(shown)
        .line_start(line)
        .path(&file)
        .annotation(AnnotationKind::Primary.span(mark));
    let rendered = Renderer::plain().render(&[Group::with_level(Level::ERROR).element(snippet)]);
    // The renderer counts columns in the cut line, so its place is replaced by the true one.
    let (place, lines) = rendered.split_once('\n').unwrap_or((&rendered, ""));
    let (margin, _) = place.split_once("-->").unwrap_or_default();
    format!("{margin}--> {file}:{line}:{column}\n{lines}")
}

/// Most columns of the marked part of a line.
const MARKED: usize = 60;

/// Most columns of a line before the marked part, and as many behind it.
const AROUND: usize = 36;

/// Mark for the part of a line that is not shown.
const CUT: &str = "...";

/// The visible beginning of a part of a line, and whether that is all of it.
fn front(part: &str, most: usize) -> (String, bool) {
    let kept = kept(part.chars(), most);
    (part.chars().take(kept).map(visible).collect(), part.chars().nth(kept).is_none())
}

/// The visible end of a part of a line, and whether that is all of it.
fn back(part: &str, most: usize) -> (String, bool) {
    let kept = kept(part.chars().rev(), most);
    let start = part.char_indices().rev().take(kept).last().map_or(part.len(), |(at, _)| at);
    (part[start..].chars().map(visible).collect(), start == 0)
}

/// How many of some characters fit.
fn kept(characters: impl Iterator<Item = char>, most: usize) -> usize {
    let ends = characters.scan(0, |columns, c| {
        *columns += if c == '\t' { TAB.len() } else { width(c) };
        Some(*columns)
    });
    ends.take_while(|columns| *columns <= most).count()
}

/// Spaces that a tab is shown as.
const TAB: &str = "    ";

fn visible(c: char) -> String {
    let mut text = String::new();
    if c == '\t' {
        text += TAB
    } else {
        push_visible(c, &mut text)
    }
    text
}

/// The last character boundary that is not after a byte.
fn boundary(text: &str, byte: usize) -> usize {
    (0..=byte.min(text.len())).rev().find(|&at| text.is_char_boundary(at)).unwrap_or(0)
}
