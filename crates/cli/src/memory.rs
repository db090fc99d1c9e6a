//! What a rendering will take, and whether there is so much.

use std::fmt;

use crate::exit::Failure;
use crate::format::Format;
use crate::machine;
use crate::size::Size;

/// Bytes that the program takes beside what is counted: its code, stacks, tiles and buffers.
const OWN: u64 = 16 << 20;

/// What a rendering is made of, as far as its memory goes. What a thread keeps of a tile, and its
/// stack, are not part of it.
pub(crate) struct Need {
    /// Columns of what is rendered.
    pub(crate) width: u32,
    /// Rows of what is rendered.
    pub(crate) height: u32,
    /// Samples a side.
    pub(crate) samples: u32,
    /// How it is written.
    pub(crate) format: Format,
    /// Whether there is a film, and not 8-bit levels from the first.
    pub(crate) film: bool,
    /// The scene's text and what is made of it, in bytes.
    pub(crate) scene: u64,
}

impl Need {
    /// Bytes at most: the picture, the scene and the grid.
    fn bytes(&self) -> u64 {
        let (width, height) = (u64::from(self.width), u64::from(self.height));
        let picture = self.format.bytes(self.width, self.height, self.film);
        let grid = (width + height) * u64::from(self.samples) * 4;
        picture + grid + self.scene
    }

    /// What is left of the limit: bytes for the stacks of deep paths, and how to have more.
    ///
    /// # Errors
    /// Exit code 3 if the limit is not enough, or the memory of the system or of its control
    /// group. Nothing has been taken then.
    pub(crate) fn within(&self, limit: Size) -> Result<(u64, &'static str), Failure> {
        let need = self.bytes();
        let refused = |why: fmt::Arguments<'_>| {
            let (width, height, size) = (self.width, self.height, Size(need));
            Failure::bad_input(format_args!(
                "a picture of {width}x{height} needs {size} of memory ({need} bytes), {why} render parts with --crop"
            ))
        };
        // First, since no larger limit of the program's own would help.
        let granted_by_group = match machine::memory_left() {
            None => u64::MAX,
            Some(left) => left.saturating_sub(OWN).checked_sub(need).ok_or_else(|| {
                let left = Size(left.saturating_sub(OWN));
                refused(format_args!(
                    "of which the memory cgroup leaves {left}: raise its limit, or"
                ))
            })?,
        };
        let left = limit.0.checked_sub(need).ok_or_else(|| {
            refused(format_args!("the limit is {limit}: raise --memory-limit, or"))
        })?;
        if !granted(need) {
            return Err(refused(format_args!("which the system does not grant:")));
        }
        Ok(match granted_by_group < left {
            true => (granted_by_group, "raise the limit of the memory cgroup"),
            false => (left, "raise --memory-limit"),
        })
    }
}

/// Whether the system has room for so many bytes. They are asked for and given back
/// untouched; what fails later, when they are taken in earnest, ends the program.
pub(crate) fn granted(bytes: u64) -> bool {
    let bytes = usize::try_from(bytes).unwrap_or(usize::MAX);
    // Seen from outside, or the compiler would leave out what is given back at once.
    std::hint::black_box(Vec::<u8>::new()).try_reserve_exact(bytes).is_ok()
}
