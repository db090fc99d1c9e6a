//! The line of a text that a message is about.

use std::ops::Range;

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};

/// Line and column of a byte, both from 1, the column in characters. A byte past the end
/// or inside a character counts as the nearest place before it.
pub(super) fn line_column(text: &str, byte: usize) -> (usize, usize) {
    let before = &text[..boundary(text, byte)];
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    let line = before.bytes().filter(|&b| b == b'\n').count() + 1;
    (line, before[line_start..].chars().count() + 1)
}

/// ` --> file:line:column` and the line, with the bytes of the span underlined as far as
/// they lie on it. The renderer shortens a very long line around them.
pub(super) fn render(file: &str, text: &str, line: usize, span: Range<usize>) -> String {
    let start = boundary(text, span.start);
    let line_start = text[..start].rfind('\n').map_or(0, |newline| newline + 1);
    let line_end = text[start..].find('\n').map_or(text.len(), |newline| start + newline);
    let end = boundary(text, span.end.clamp(start, line_end));
    // Only the one line is handed over: the renderer reads all that it gets.
    let snippet = Snippet::source(&text[line_start..line_end])
        .line_start(line)
        .path(file)
        .annotation(AnnotationKind::Primary.span(start - line_start..end - line_start));
    Renderer::plain().render(&[Group::with_level(Level::ERROR).element(snippet)])
}

/// The nearest place not after a byte where a character starts.
fn boundary(text: &str, byte: usize) -> usize {
    (0..=byte.min(text.len())).rev().find(|&at| text.is_char_boundary(at)).unwrap_or(0)
}
