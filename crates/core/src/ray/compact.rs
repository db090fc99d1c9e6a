//! Compaction: single rays of many packets, put together to eights.

use super::column::{RAYS, Slot};
use crate::simd::LANES;

/// The lanes of each set of lanes, one after another.
const LANES_OF: [[Slot; LANES]; 1 << LANES] = {
    let mut of = [[0; LANES]; 1 << LANES];
    let mut set = 0;
    while set < 1 << LANES {
        let (mut lane, mut len) = (0, 0);
        while lane < LANES {
            if set >> lane & 1 != 0 {
                of[set][len] = lane as Slot;
                len += 1;
            }
            lane += 1;
        }
        set += 1;
    }
    of
};

/// Gathers the slots of single rays into groups of eight.
///
/// Only packets that did not meet the primitive whole add rays, seven at most each: so there are
/// always fewer than [`RAYS`], and an index taken modulo that is itself. Eight slots more, for they
/// are written eight at a time.
pub(crate) struct Compactor {
    slots: [Slot; RAYS + LANES],
    len: usize,
}

impl Compactor {
    pub(crate) fn new() -> Self {
        Self { slots: [0; RAYS + LANES], len: 0 }
    }

    #[inline(always)]
    pub(crate) fn clear(&mut self) {
        self.len = 0;
    }

    /// Adds lanes of a packet, lane i as bit i.
    #[inline(always)]
    pub(crate) fn add(&mut self, packet: usize, lanes: u32) {
        let mut slots = LANES_OF[lanes as usize % (1 << LANES)];
        for slot in &mut slots {
            *slot += (packet * LANES) as Slot;
        }
        self.put(slots);
        self.len += lanes.count_ones() as usize;
    }

    /// Lanes of the last group without a ray repeat its first.
    #[inline(always)]
    pub(crate) fn fill_up(&mut self) {
        self.put([self.slots[self.len / LANES * LANES % RAYS]; LANES]);
    }

    #[inline(always)]
    fn put(&mut self, slots: [Slot; LANES]) {
        if let Some(to) = self.slots[self.len % RAYS..].first_chunk_mut() {
            *to = slots;
        }
    }

    /// How many groups of eight they make, the last one perhaps of fewer.
    #[inline(always)]
    pub(crate) fn groups(&self) -> usize {
        self.len.div_ceil(LANES)
    }

    /// The slots of a group, and how many they are; the others repeat the first.
    #[inline(always)]
    pub(crate) fn group(&self, group: usize) -> ([Slot; LANES], usize) {
        let slots = &self.slots[group * LANES % RAYS..];
        let slots = slots.first_chunk().copied().unwrap_or_default();
        (slots, LANES.min(self.len - group * LANES))
    }
}
