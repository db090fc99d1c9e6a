//! How to render.

use crate::Isa;

/// How to render; none of it changes a bit of the picture.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// Lowered to what the processor has.
    pub isa: Isa,
    /// Bytes that the stacks of all threads together may take.
    pub stack_limit: usize,
}

impl Default for Settings {
    /// The fastest instruction set of this processor, and 2 GiB of stacks.
    fn default() -> Self {
        Self { isa: Isa::detected(), stack_limit: 2 << 30 }
    }
}

/// The stacks of deep paths would pass the limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("paths are so deep that their stacks need more than {limit} bytes")]
pub struct StackFull {
    /// The limit, in bytes.
    pub limit: usize,
}
