//! What is owed on the return: the entries of the stack.

use catoptric_scene::{MOST_MATERIALS, Phong, Scalar};

use crate::ray::{RAYS, Slot};
use crate::simd::{LANES, Lane, Packed};

/// Bytes of the stack that a ray takes at each bounce, in f32.
pub const RAY_BOUNCE_BYTES: usize = size_of::<PendingBounce<f32>>() / LANES;

/// Eight rays whose colour waits to be complete, or is.
#[derive(Clone, Copy)]
#[repr(align(32))]
pub(crate) struct PendingBounce<S> {
    /// Light sent back from where the rays met something.
    pub(crate) local: Packed<S>,
    /// The rays that wait. Lanes without a ray are the last ones and repeat the first.
    pub(crate) slots: [ReturnSlot; LANES],
}

impl<S: Lane> PendingBounce<S> {
    pub(super) const EMPTY: Self =
        Self { local: [[S::ZERO; LANES]; 3], slots: [ReturnSlot::NOTHING; LANES] };
}

/// The ray that a colour belongs to, and the material at whose mirror it waits for the reflected
/// ray's colour. In bits 0 to 8 the ray's slot, in bits 9 to 30 the material, or
/// [`ReturnSlot::END`] where no mirror is followed; an end is the same for all eight. Bit 31 says
/// in lane 0 that they are the lanes of one packet, whose first slot then stands in all of them; in
/// lane 1, that they are of one material.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) struct ReturnSlot(u32);

/// Each of a scene's materials has a number, and END is none of them.
const _: () = assert!(MOST_MATERIALS < ReturnSlot::END as usize);

impl ReturnSlot {
    /// No ray's slot.
    pub(crate) const NOTHING: Self = Self(u32::MAX);
    /// Stands in place of a material where no mirror is followed.
    pub(crate) const END: u32 = (1 << 22) - 1;
    const FLAG: u32 = 1 << 31;
    const SLOTS: u32 = RAYS as u32;

    /// Slots of eight rays that met the same, with material 0 until it is known.
    #[inline(always)]
    pub(crate) fn to_rays(slots: &[Slot; LANES]) -> [Self; LANES] {
        let mut all = slots.map(|slot| Self(u32::from(slot)));
        all[1].0 |= Self::FLAG;
        all
    }

    /// Slots of the rays of a packet that met the same, with material 0 until it is known.
    #[inline(always)]
    pub(crate) fn to_packet(packet: usize) -> [Self; LANES] {
        [Self(Self::FLAG | (packet * LANES) as u32); LANES]
    }

    /// The same ray, that waits at a mirror of some material.
    #[inline(always)]
    pub(super) fn at(self, material: u32) -> Self {
        Self(self.0 | (material * Self::SLOTS))
    }

    /// Expands a packet's compact form to one slot a lane, all reflecting off `material`, so that
    /// lanes can be regrouped.
    #[inline(always)]
    pub(crate) fn each(rays: &[Self; LANES], material: u32) -> [Self; LANES] {
        let packet = Self::packet(rays).is_some();
        let mut each = *rays;
        for (lane, slot) in each.iter_mut().enumerate() {
            *slot = Self(slot.0 & !Self::FLAG).at(material);
            if packet {
                slot.0 += lane as u32;
            }
        }
        each
    }

    /// The same ray, whose mirror is not followed.
    #[inline(always)]
    pub(crate) fn ended(self) -> Self {
        Self(Self::END * Self::SLOTS + self.0 % Self::SLOTS)
    }

    /// The packet whose lanes they are, if they are one packet.
    #[inline(always)]
    pub(crate) fn packet(slots: &[Self; LANES]) -> Option<usize> {
        if slots[0].0 & Self::FLAG != 0 { Some(slots[0].slot() / LANES) } else { None }
    }

    #[inline(always)]
    pub(super) fn are_of_one_material(slots: &[Self; LANES]) -> bool {
        slots[1].0 & Self::FLAG != 0
    }

    #[inline(always)]
    pub(crate) fn is_end(self) -> bool {
        self.material() == Self::END
    }

    #[inline(always)]
    pub(crate) fn slot(self) -> usize {
        (self.0 % Self::SLOTS) as usize
    }

    #[inline(always)]
    fn material(self) -> u32 {
        (self.0 & !Self::FLAG) / Self::SLOTS
    }

    /// How much of the reflected ray's colour is added; 0 where there is none.
    #[inline(always)]
    pub(crate) fn reflectance<S: Scalar>(self, materials: &[Phong<S>]) -> S {
        materials.get(self.material() as usize).map_or(S::ZERO, |material| material.mirror)
    }
}
