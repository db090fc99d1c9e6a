//! Eight rays, and how far they are from one primitive.

use crate::simd::{Mask, Vec3};

/// The index of no primitive.
pub(crate) const NONE: u32 = u32::MAX;

/// Eight rays in flight. Units: directions have length 1, up to rounding.
#[derive(Clone, Copy)]
pub(crate) struct Rays<L> {
    pub(crate) origin: Vec3<L>,
    pub(crate) direction: Vec3<L>,
}

/// How far eight rays are from one primitive.
pub(crate) struct Distance<L> {
    /// NaN where there is no root.
    pub(crate) t: L,
    /// False where the primitive does not count: met from behind, or just left.
    pub(crate) met: Mask<L>,
}
