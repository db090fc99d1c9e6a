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

#[cfg(test)]
mod tests {
    use super::{Compactor, Slot};
    use crate::ray::{PACKETS, RAYS};
    use crate::simd::LANES;
    use crate::simd::numbers::Numbers;

    /// The slots of some lanes of packets, one after another.
    fn plain(added: &[(usize, u32)]) -> Vec<Slot> {
        let lanes = |&(packet, lanes): &(usize, u32)| {
            let set = (0..LANES).filter(move |lane| lanes >> lane & 1 != 0);
            set.map(move |lane| (packet * LANES + lane) as Slot)
        };
        added.iter().flat_map(lanes).collect()
    }

    /// Adds lanes and reads the groups back: each eight of the plain list, filled up with its
    /// first.
    fn check(compactor: &mut Compactor, added: &[(usize, u32)]) {
        compactor.clear();
        for &(packet, lanes) in added {
            compactor.add(packet, lanes);
        }
        compactor.fill_up();
        let plain = plain(added);
        assert_eq!(compactor.groups(), plain.len().div_ceil(LANES), "{added:?}");
        for (group, expected) in plain.chunks(LANES).enumerate() {
            let (slots, live) = compactor.group(group);
            assert_eq!(&slots[..live], expected, "{added:?}, group {group}");
            assert!(slots[live..].iter().all(|&slot| slot == expected[0]), "{added:?}: {slots:?}");
        }
    }

    #[test]
    fn every_set_of_lanes_is_its_slots() {
        let mut compactor = Compactor::new();
        check(&mut compactor, &[]);
        for packet in [0, 1, 31, PACKETS - 1] {
            for lanes in 0..1 << LANES {
                check(&mut compactor, &[(packet, lanes)]);
            }
        }
    }

    #[test]
    fn single_rays_are_put_together_in_their_order() {
        let mut numbers = Numbers::new(11);
        let mut compactor = Compactor::new();
        for _ in 0..2000 {
            let mut added = Vec::new();
            for packet in 0..PACKETS {
                if numbers.one_in(3) {
                    added.push((packet, numbers.below(0xff) as u32));
                }
            }
            check(&mut compactor, &added);
        }
    }

    /// Seven lanes of each packet: the most there are.
    #[test]
    fn a_full_tile_of_single_rays_has_room() {
        let mut compactor = Compactor::new();
        for missing in 0..LANES {
            let added: Vec<_> =
                (0..PACKETS).map(|packet| (packet, 0xff & !(1 << missing))).collect();
            assert_eq!(plain(&added).len(), RAYS - PACKETS);
            check(&mut compactor, &added);
        }
    }
}
