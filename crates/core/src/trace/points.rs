//! Points that are shaded side by side, eight at a time.

use crate::simd::{LANES, Lane, Lanes, Mask, Packed, Vec3};

/// Packets of points that are shaded side by side, each a bit of a u32. They stay in the nearest
/// cache.
pub(crate) const BATCH: usize = 16;

const _: () = assert!(BATCH <= u32::BITS as usize);

/// Eight points on a primitive.
#[derive(Clone, Copy)]
#[repr(C, align(32))]
pub(crate) struct ShadePoints<S> {
    pub(crate) normal: Packed<S>,
    /// Directions of reflected rays; left out where nothing asks for them.
    pub(crate) reflected: Packed<S>,
    /// The light so far.
    pub(crate) colour: Packed<S>,
    /// How many lanes hold a point, the first ones.
    pub(crate) live: u32,
    pub(crate) shadow: ShadowRays<S>,
}

/// Shadow rays: from eight points to a light.
#[derive(Clone, Copy)]
#[repr(C, align(32))]
pub(crate) struct ShadowRays<S> {
    /// Unit vectors.
    pub(crate) direction: Packed<S>,
    pub(crate) distance: [S; LANES],
    /// n·l.
    pub(crate) facing: [S; LANES],
    /// All ones where the light is seen, as far as is known.
    pub(crate) lit: [S; LANES],
}

impl<S: Lane> ShadePoints<S> {
    pub(crate) const EMPTY: Self = {
        let (one, three) = ([S::ZERO; LANES], [[S::ZERO; LANES]; 3]);
        let shadow = ShadowRays { direction: three, distance: one, facing: one, lit: one };
        Self { normal: three, reflected: three, colour: three, live: 0, shadow }
    };
}

impl<S: Lane> ShadowRays<S> {
    /// Unit vectors and distances to the light.
    #[inline(always)]
    pub(crate) fn way<L: Lanes<Scalar = S>>(&self) -> (Vec3<L>, L) {
        (Vec3::from_arrays(&self.direction), L::from_array(self.distance))
    }

    #[inline(always)]
    pub(crate) fn lit<L: Lanes<Scalar = S>>(&self) -> Mask<L> {
        Mask::from_array(self.lit)
    }

    /// Takes the light from some lanes.
    #[inline(always)]
    pub(crate) fn darken<L: Lanes<Scalar = S>>(&mut self, dark: Mask<L>) {
        self.lit = self.lit::<L>().without(dark).to_array();
    }
}
