//! The packet loop on paths: whole packets, gathered rays, and rays that are regrouped.

use std::collections::BTreeMap;
use std::ops::Range;

use catoptric_scene::{Counts, Phong};

use super::super::super::pending::ReturnSlot;
use super::super::super::regroup::Regroup;
use super::paths::{BACKGROUND, Paths};
use super::{L, Stack, room};
use crate::ray::{BREADTH, Compactor, Departing, NONE, QUEUES, RayQueue, Rays, Slot, queue_of};
use crate::simd::numbers::{Numbers, TestScalar};
use crate::simd::{LANES, Lanes, Mask, Vec3};

/// Rays that carry the number of their path as the first component of their direction.
pub(super) struct Driver<'a> {
    paths: &'a Paths,
    materials: &'a [Phong],
    numbers: &'a mut Numbers,
    stack: Stack<'a, f32>,
    queues: [RayQueue<f32>; QUEUES],
    regroup: Regroup<f32>,
    /// The most entries that the stack held while all rays went side by side.
    pub(super) most_entries: usize,
}

impl<'a> Driver<'a> {
    pub(super) fn new(
        paths: &'a Paths,
        materials: &'a [Phong],
        stack: Stack<'a, f32>,
        numbers: &'a mut Numbers,
    ) -> Self {
        let queues = std::array::from_fn(|_| RayQueue::new());
        let regroup = Regroup::new();
        Self { paths, materials, numbers, stack, queues, regroup, most_entries: 0 }
    }

    pub(super) fn colour(&self, ray: usize) -> [f32; 3] {
        self.stack.colours(0).ray(ray)
    }

    pub(super) fn counts(&mut self) -> Counts {
        self.stack.take_counts()
    }

    /// Goes down and comes up as `wavefront::trace` does.
    pub(super) fn trace(&mut self) {
        let rays = self.paths.len();
        let mut packets = 0..rays.div_ceil(LANES);
        for packet in packets.clone() {
            let live = LANES.min(rays - packet * LANES);
            let rays = std::array::from_fn(|lane| packet * LANES + lane.min(live - 1));
            self.queues[0].put_eye_rays(packet, direction(rays), live);
        }
        self.queues[0].end_eye_rays(packets.end);
        self.stack.start();
        let mut held = 0;
        loop {
            let bounce = self.stack.bounce();
            if bounce == BREADTH {
                held = packets.end;
            }
            let next = self.bounce(packets);
            if next > 0 {
                self.stack.descend();
                packets = if bounce + 1 == BREADTH { 0..1 } else { 0..next };
                continue;
            }
            loop {
                self.stack.fold::<L>(self.materials, BACKGROUND.into());
                match self.stack.bounce() {
                    0 => return,
                    BREADTH if held < self.queues[queue_of(BREADTH)].len() => break,
                    _ => self.stack.ascend(),
                }
            }
            packets = held..held + 1;
        }
    }

    /// Traces packets of the bounce in flight; how many packets go on.
    fn bounce(&mut self, packets: Range<usize>) -> usize {
        let bounce = self.stack.bounce();
        let queue = &self.queues[queue_of(bounce)];
        let rays = queue.count(packets.clone());
        assert!(self.stack.make_room(rays as usize), "the room for {rays} rays was promised");
        let before = self.stack.len;
        // Who meets which primitive, in which lanes of which packets.
        let mut met = BTreeMap::<u32, Vec<(usize, u32)>>::new();
        let mut missed = false;
        for packet in packets.clone() {
            let mut sets = BTreeMap::<u32, u32>::new();
            for lane in 0..queue.live(packet) as usize {
                match self.paths.met(path(queue, packet * LANES + lane), bounce) {
                    Some(met) => *sets.entry(met.primitive).or_default() |= 1 << lane,
                    None => missed = true,
                }
            }
            for (primitive, lanes) in sets {
                met.entry(primitive).or_default().push((packet, lanes));
            }
        }
        self.queues[queue_of(bounce + 1)].clear();
        for (primitive, packets) in met {
            self.shade(primitive, &packets);
        }
        let next = &mut self.queues[queue_of(bounce + 1)];
        self.regroup.close::<L>(next, &mut self.stack);
        if missed {
            self.stack.missed(packets.start, packets.len());
        }
        self.stack.count().rays += rays;
        // A ray pushes one entry at most; see `room`.
        let pushed = self.stack.pending().len();
        assert!(pushed == self.stack.len - before && pushed as u64 <= rays, "{pushed} entries");
        if bounce <= BREADTH {
            self.most_entries = self.most_entries.max(self.stack.len);
            assert!(bounce == BREADTH || self.stack.len <= room(bounce));
        }
        self.queues[queue_of(bounce + 1)].len()
    }

    /// The groups of one primitive: packets that met it whole, then all others by eights.
    fn shade(&mut self, primitive: u32, packets: &[(usize, u32)]) {
        let mut compactor = Compactor::new();
        for &(packet, lanes) in packets {
            if lanes == 0xff {
                let slots = std::array::from_fn(|lane| (packet * LANES + lane) as Slot);
                self.spawn(primitive, &slots, ReturnSlot::to_packet(packet), LANES);
            } else {
                compactor.add(packet, lanes);
            }
        }
        compactor.fill_up();
        for group in 0..compactor.groups() {
            let (slots, live) = compactor.group(group);
            self.spawn(primitive, &slots, ReturnSlot::to_rays(&slots), live);
        }
    }

    /// Sends on the rays of a group whose paths go on, as `shade` does.
    fn spawn(
        &mut self,
        primitive: u32,
        at: &[Slot; LANES],
        slots: [ReturnSlot; LANES],
        live: usize,
    ) {
        let bounce = self.stack.bounce();
        let Ok([queue, next]) =
            self.queues.get_disjoint_mut([queue_of(bounce), queue_of(bounce + 1)])
        else {
            unreachable!("two queues");
        };
        let rays = at.map(|slot| path(queue, slot.into()));
        let local = rays.map(|ray| self.paths.met(ray, bounce).expect("it met something").local);
        let local: [_; 3] = std::array::from_fn(|i| local.map(|colour| colour[i]));
        let colour = Vec3::<L>::from_arrays(&local);
        let material = primitive % self.materials.len() as u32;
        let goes_on = rays.map(|ray| !self.paths.ends(ray, bounce));
        let lanes =
            |set: &dyn Fn(usize) -> bool| -> Vec<_> { (0..live).filter(|&i| set(i)).collect() };
        let (on, ending) = (lanes(&|lane| goes_on[lane]), lanes(&|lane| !goes_on[lane]));

        let rays = Rays { origin: Vec3::zero(), direction: direction(rays) };
        let from = if self.numbers.one_in(4) { NONE } else { primitive };
        let weight = self.numbers.one_in(2).then(|| L::splat(0.5));
        let departing = Departing { rays, weight, from };
        if on.len() == LANES {
            self.stack.push::<L>(colour, &slots, material, next.len());
            return next.push(&departing);
        }
        if on.is_empty() && self.numbers.one_in(2) {
            return self.stack.push_end::<L>(colour, &slots);
        }
        let each = ReturnSlot::each(&slots, material);
        if let Some(&first) = ending.first() {
            let lane = |lane| if ending.contains(&lane) { lane } else { first };
            let ended = std::array::from_fn(|i| each[lane(i)].ended());
            let all = local.map(|x| std::array::from_fn(|i| x[lane(i)]));
            self.stack.push_end(Vec3::<L>::from_arrays(&all), &ended);
        }
        let set = Mask::<L>::from_array(std::array::from_fn(|i| f32::truth(on.contains(&i))));
        self.regroup.add(&departing, set, (&local, &each), next, &mut self.stack);
    }
}

/// Directions that carry paths.
fn direction(paths: [usize; LANES]) -> Vec3<L> {
    Vec3 { x: L::from_array(paths.map(|path| path as f32)), ..Vec3::zero() }
}

/// The path of the ray in a slot.
fn path(queue: &RayQueue<f32>, slot: usize) -> usize {
    queue.directions().ray(slot)[0] as usize
}
