//! The hits of a level, sorted by the primitive that was met.
//!
//! For each primitive there are two lists: of packets all of whose rays met it, and of other
//! packets, each with those of its lanes that did. Lists are linked by index, so that there is
//! nothing to grow; which hit comes first does not matter.

use crate::lanes::{LANES, Lane, Lanes};
use crate::nearest::Nearest;
use crate::packet::NONE;
use crate::plane::{PACKETS, RAYS, Slot};

/// The end of a list.
const END: u16 = u16::MAX;

/// Of each set of lanes, these lanes, one after another.
const LANES_OF: [[u8; LANES]; 1 << LANES] = {
    let mut of = [[0; LANES]; 1 << LANES];
    let mut set = 0;
    while set < 1 << LANES {
        let (mut lane, mut len) = (0, 0);
        while lane < LANES {
            if set >> lane & 1 != 0 {
                of[set][len] = lane as u8;
                len += 1;
            }
            lane += 1;
        }
        set += 1;
    }
    of
};

/// The first packet and the first part of one in a primitive's lists.
#[derive(Clone, Copy)]
struct Lists {
    packet: u16,
    part: u16,
}

const EMPTY: Lists = Lists { packet: END, part: END };

/// Lanes of a packet.
#[derive(Clone, Copy)]
struct Part {
    next: u16,
    packet: u8,
    lanes: u8,
}

/// What a level's rays met.
pub(crate) struct Hits {
    lists: Vec<Lists>,
    next_packet: [u16; PACKETS],
    parts: [Part; RAYS],
    parts_len: usize,
    /// Primitives whose lists are not empty.
    met: [u32; RAYS],
    met_len: usize,
}

/// Single rays that met one primitive.
pub(crate) struct Singles {
    /// Eight more: they are written eight at a time.
    slots: [Slot; RAYS + LANES],
    len: usize,
}

impl Hits {
    pub(crate) fn new(primitives: usize) -> Self {
        Self {
            lists: vec![EMPTY; primitives],
            next_packet: [END; PACKETS],
            parts: [Part { next: END, packet: 0, lanes: 0 }; RAYS],
            parts_len: 0,
            met: [NONE; RAYS],
            met_len: 0,
        }
    }

    /// Forgets what an earlier level's rays met.
    #[inline(always)]
    pub(crate) fn clear(&mut self) {
        self.parts_len = 0;
    }

    /// Sorts the rays of a packet, in its first `live` lanes; how many of its lanes met nothing.
    #[inline(always)]
    pub(crate) fn sort<L: Lanes>(
        &mut self,
        packet: usize,
        live: usize,
        nearest: &Nearest<L::Scalar>,
    ) -> usize {
        let index = nearest.index.packet::<L>(packet);
        let first = nearest.index.ray(packet * LANES).to_index();
        if live == LANES && index.same_bits(L::index(first)).all() {
            if first == NONE {
                return LANES;
            }
            self.next_packet[packet % PACKETS] =
                std::mem::replace(&mut self.lists(first).packet, packet as u16);
            return 0;
        }
        let missed = index.same_bits(L::index(NONE)).bits();
        let mut rest = !missed & ((1 << live) - 1);
        let misses = LANES - rest.count_ones() as usize;
        while rest != 0 {
            let lane = rest.trailing_zeros() as usize;
            let primitive = nearest.index.ray(packet * LANES + lane).to_index();
            let lanes = index.same_bits(L::index(primitive)).bits() & rest;
            rest &= !lanes;
            let at = self.parts_len % RAYS;
            let next = std::mem::replace(&mut self.lists(primitive).part, at as u16);
            self.parts[at] = Part { next, packet: packet as u8, lanes: lanes as u8 };
            self.parts_len += 1;
        }
        misses
    }

    /// The lists of a primitive that was met.
    #[inline(always)]
    fn lists(&mut self, primitive: u32) -> &mut Lists {
        let lists = &mut self.lists[primitive as usize];
        if lists.packet == END && lists.part == END {
            self.met[self.met_len % RAYS] = primitive;
            self.met_len += 1;
        }
        lists
    }

    /// A primitive whose lists are not empty, to be taken next.
    #[inline(always)]
    pub(crate) fn next_met(&mut self) -> Option<u32> {
        self.met_len = self.met_len.checked_sub(1)?;
        Some(self.met[self.met_len % RAYS])
    }

    /// Takes all packets all of whose rays met a primitive: the first of them.
    #[inline(always)]
    pub(crate) fn take_packets(&mut self, primitive: u32) -> Option<usize> {
        let first = std::mem::replace(&mut self.lists[primitive as usize].packet, END);
        (first != END).then_some(first as usize)
    }

    /// The one after a packet that was taken.
    #[inline(always)]
    pub(crate) fn next_packet(&self, packet: usize) -> Option<usize> {
        let next = self.next_packet[packet % PACKETS];
        (next != END).then_some(next as usize)
    }

    /// Takes all single rays that met a primitive.
    #[inline(always)]
    pub(crate) fn take_singles(&mut self, primitive: u32, singles: &mut Singles) {
        let mut part = std::mem::replace(&mut self.lists[primitive as usize].part, END);
        singles.len = 0;
        while part != END {
            let Part { next, packet, lanes } = self.parts[part as usize % RAYS];
            part = next;
            let Some(to) = singles.slots[singles.len..].first_chunk_mut::<LANES>() else { break };
            for (to, lane) in to.iter_mut().zip(LANES_OF[lanes as usize]) {
                *to = Slot::from(packet) * LANES as Slot + Slot::from(lane);
            }
            singles.len += lanes.count_ones() as usize;
        }
    }
}

impl Singles {
    pub(crate) fn new() -> Self {
        Self { slots: [0; RAYS + LANES], len: 0 }
    }

    /// How many groups of eight they make, the last one perhaps of fewer.
    #[inline(always)]
    pub(crate) fn groups(&self) -> usize {
        self.len.div_ceil(LANES)
    }

    /// The slots of a group, and how many they are; the others repeat the first.
    #[inline(always)]
    pub(crate) fn group(&self, group: usize) -> ([Slot; LANES], usize) {
        let slots = &self.slots[group * LANES..];
        let mut slots = slots.first_chunk().copied().unwrap_or_default();
        let live = LANES.min(self.len - group * LANES);
        let first = slots[0];
        slots[live..].fill(first);
        (slots, live)
    }
}
