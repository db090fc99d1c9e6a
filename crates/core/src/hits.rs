//! The hits of a level, sorted by the primitive that was met.
//!
//! For each primitive there are two lists: of packets all of whose rays met it, and of single
//! rays of other packets. Lists are linked by index, so that there is nothing to grow; which
//! hit comes first does not matter.

use crate::lanes::{LANES, Lane, Lanes};
use crate::nearest::Nearest;
use crate::packet::NONE;
use crate::wave::{PACKETS, RayPacket, Slot};

/// The end of a list.
const END: u16 = u16::MAX;

/// The first packet and the first single ray of a primitive's lists.
#[derive(Clone, Copy)]
struct Lists {
    packet: u16,
    ray: u16,
}

const EMPTY: Lists = Lists { packet: END, ray: END };

/// What a level's rays met.
pub(crate) struct Hits {
    lists: Vec<Lists>,
    next_packet: [u16; PACKETS],
    next_ray: [u16; PACKETS * LANES],
    /// Primitives whose lists are not empty.
    met: [u32; PACKETS * LANES],
    len: usize,
}

impl Hits {
    pub(crate) fn new(primitives: usize) -> Self {
        Self {
            lists: vec![EMPTY; primitives],
            next_packet: [END; PACKETS],
            next_ray: [END; PACKETS * LANES],
            met: [NONE; PACKETS * LANES],
            len: 0,
        }
    }

    /// Sorts the rays of a packet; how many of its lanes met nothing.
    #[inline(always)]
    pub(crate) fn sort<L: Lanes>(
        &mut self,
        at: usize,
        packet: &RayPacket<L::Scalar>,
        nearest: &Nearest<L::Scalar>,
    ) -> usize {
        let first = nearest.index[0].to_index();
        let same = L::from_array(nearest.index).same_bits(L::index(first));
        if packet.live as usize == LANES && same.all() {
            if first == NONE {
                return LANES;
            }
            self.next_packet[at % PACKETS] =
                std::mem::replace(&mut self.lists(first).packet, at as u16);
            return 0;
        }
        let mut misses = LANES;
        for lane in 0..LANES.min(packet.live as usize) {
            let index = nearest.index[lane].to_index();
            if index != NONE {
                let slot = at * LANES + lane;
                self.next_ray[slot % (PACKETS * LANES)] =
                    std::mem::replace(&mut self.lists(index).ray, slot as u16);
                misses -= 1;
            }
        }
        misses
    }

    /// The lists of a primitive that was met.
    #[inline(always)]
    fn lists(&mut self, primitive: u32) -> &mut Lists {
        let lists = &mut self.lists[primitive as usize];
        if lists.packet == END && lists.ray == END {
            self.met[self.len % (PACKETS * LANES)] = primitive;
            self.len += 1;
        }
        lists
    }

    /// A primitive whose lists are not empty, to be taken next.
    #[inline(always)]
    pub(crate) fn next_met(&mut self) -> Option<u32> {
        self.len = self.len.checked_sub(1)?;
        Some(self.met[self.len % (PACKETS * LANES)])
    }

    /// Takes a packet all of whose rays met a primitive.
    #[inline(always)]
    pub(crate) fn take_packet(&mut self, primitive: u32) -> Option<usize> {
        let lists = &mut self.lists[primitive as usize];
        let packet = lists.packet;
        if packet == END {
            return None;
        }
        lists.packet = self.next_packet[packet as usize % PACKETS];
        Some(packet as usize)
    }

    /// Takes up to eight single rays that met a primitive; how many.
    #[inline(always)]
    pub(crate) fn take_rays(&mut self, primitive: u32, slots: &mut [Slot; LANES]) -> usize {
        let lists = &mut self.lists[primitive as usize];
        let mut taken = 0;
        while taken < LANES && lists.ray != END {
            slots[taken] = lists.ray;
            lists.ray = self.next_ray[lists.ray as usize % (PACKETS * LANES)];
            taken += 1;
        }
        taken
    }
}
