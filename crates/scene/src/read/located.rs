//! The place of a key's value in the text.

use std::ops::Range;

use super::value::Value;
use crate::error::Segment;

/// A key's value in the text.
pub(super) struct Located {
    /// Bytes of the value, or of the key if that was asked for.
    pub(super) span: Range<usize>,
    pub(super) value: Value,
    /// Segments of the path that were walked: fewer than all where a number stands for an
    /// array.
    pub(super) depth: usize,
}

/// Whether a number stands in place of the array that the rest of a path points into.
pub(super) fn stands_for_array(value: &Value, rest: &[Segment]) -> bool {
    matches!(value, Value::Number { .. }) && matches!(rest, [Segment::Index(_)])
}
