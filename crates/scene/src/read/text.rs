//! Bytes to text.

use crate::SceneError;
use crate::error::Problem;

const BYTE_ORDER_MARK: &str = "\u{feff}";

/// The text of a file, without its byte order mark.
///
/// # Errors
/// Not UTF-8, a byte 0, which neither format can hold, or nothing but white space.
pub(super) fn text(name: &str, bytes: Vec<u8>) -> Result<String, SceneError> {
    let refused = |problem| Err(SceneError::of_file(name, problem));
    // UTF-16 has a byte 0 beside each ASCII letter, and most often a mark in front.
    if matches!(*bytes, [0xff, 0xfe, ..] | [0xfe, 0xff, ..] | [0, 1..=255, ..] | [1..=255, 0, ..]) {
        return refused(Problem::Utf16);
    }
    let mut text = match String::from_utf8(bytes) {
        Ok(text) => text,
        Err(error) => return refused(Problem::NotText(error.utf8_error().valid_up_to())),
    };
    if let Some(at) = text.bytes().position(|byte| byte == 0) {
        return refused(Problem::NotText(at));
    }
    if text.starts_with(BYTE_ORDER_MARK) {
        text.drain(..BYTE_ORDER_MARK.len());
    }
    if text.trim().is_empty() { refused(Problem::Empty) } else { Ok(text) }
}

/// Whether the first byte that is not blank is `{`.
pub(super) fn starts_like_json(bytes: &[u8]) -> bool {
    let bytes = bytes.strip_prefix(BYTE_ORDER_MARK.as_bytes()).unwrap_or(bytes);
    bytes.trim_ascii_start().starts_with(b"{")
}
