//! The stack: what every bounce of a tile still owes, and what was counted there.
//!
//! A mirror has one child, so each eye ray's stack is a chain, and the rays in flight (origin,
//! direction, weight) are held once, in the queues. Below a bounce there is kept, for each ray that
//! met something, only what is needed on the return: the local light, whose it is, and the mirror
//! that says how much of the reflected ray's colour is added to it. That is 16 bytes a ray and
//! bounce in f32, and a byte for eight rays that says which packet they wait for. The colours that
//! come back exist for one bounce at a time.

use catoptric_scene::{Counts, DepthCount, Phong};

use super::budget::Budget;
use super::pending::{PendingBounce, ReturnSlot};
use crate::ray::{PACKETS, QUEUES, RAYS, Vec3Column, queue_of};
use crate::simd::{LANES, Lane, Lanes, Vec3};

/// A packet of the next queue.
type Child = u8;

const _: () = assert!(PACKETS <= 1 << Child::BITS);

/// A path went deeper than the memory limit allows.
pub(crate) struct TooDeep;

/// The stack of one thread. It grows as rays go deep and is kept between tiles.
pub(crate) struct Stack<'a, S: Lane> {
    /// All bounces down to the one in flight, one after another.
    entries: Vec<PendingBounce<S>>,
    /// The packet of the next queue that each entry waits for; an end waits for none.
    children: Vec<Child>,
    /// How many entries that is.
    len: usize,
    bounces: Vec<BounceRecord>,
    bounce: usize,
    /// Complete colours of a queue's rays, for each of the queues.
    colours: [Box<Vec3Column<S>>; QUEUES],
    budget: &'a Budget,
    granted: usize,
}

/// A bounce's place on the stack, and what was counted there.
#[derive(Clone, Copy, Default)]
struct BounceRecord {
    /// The first entry.
    start: usize,
    /// Packets of the queue in which some ray met nothing are among so many, from this one on.
    first_missed: u8,
    missed: u8,
    count: DepthCount,
}

/// Entries of eight rays that a tile leaves on the stack, at most, when its rays have been mirrored
/// up to `reflections` times and all go side by side.
///
/// Each entry holds at least one ray that is in no other entry of its bounce, so a bounce pushes at
/// most as many entries as it has rays: no more, whatever the rays met, whether their mirrors are
/// followed or not, and wherever a cut by weight parts the rays of an entry. The bound is reached,
/// where each ray of a tile meets a primitive of its own and ends there.
///
/// All bounces together: a ray ends once, so at most [`RAYS`] entries hold rays that end. The
/// others hold rays that go on; they are as many as the packets of the next queue, all of them full
/// but the last: at most [`PACKETS`] a bounce, and none on the last one.
const fn room(reflections: usize) -> usize {
    RAYS + PACKETS * reflections
}

impl<'a, S: Lane> Stack<'a, S> {
    /// Reflections that a new stack has room for, at most.
    const FIRST: usize = 24;

    /// An empty stack for so many reflections.
    ///
    /// It holds whatever a tile can leave on its first bounces, so these never count against the
    /// limit: see [`room`]. A shallow picture does not pay for bounces that it does not reach.
    pub(crate) fn new(budget: &'a Budget, depth: u32) -> Self {
        let reflections = Self::FIRST.min(depth as usize);
        Self {
            entries: vec![PendingBounce::EMPTY; room(reflections)],
            children: vec![0; room(reflections)],
            len: 0,
            bounces: vec![BounceRecord::default(); reflections + 2],
            bounce: 0,
            colours: std::array::from_fn(|_| Box::new(Vec3Column::zero())),
            budget,
            granted: 0,
        }
    }

    /// Whether some thread's stack was refused more, so that nothing further is of use.
    #[inline(always)]
    pub(crate) fn is_refused(&self) -> bool {
        self.budget.is_refused()
    }

    /// Makes room for what the bounce in flight pushes, and for one bounce below it; false if the
    /// limit forbids it. `rays` is how many rays the bounce has, which is the most that it pushes:
    /// see [`room`].
    #[inline(always)]
    pub(crate) fn make_room(&mut self, rays: usize) -> bool {
        (self.len + rays <= self.entries.len() && self.bounce + 1 < self.bounces.len())
            || self.grow(rays)
    }

    /// Adds a quarter to what is full, or as much as is asked for, unless this stack or another was
    /// refused more. Out of line: it holds no lanes.
    ///
    /// While what is full is copied, the old and the new buffer exist together, so both count
    /// against the budget; what was old is given back once it is gone.
    #[cold]
    #[inline(never)]
    fn grow(&mut self, rays: usize) -> bool {
        let lacking = (self.len + rays).saturating_sub(self.entries.len());
        let more_entries = if lacking > 0 { lacking.max(self.entries.len() / 4) } else { 0 };
        let full = self.bounce + 1 >= self.bounces.len();
        let more_bounces = if full { self.bounces.len().div_ceil(4) } else { 0 };
        let more = more_entries * (size_of::<PendingBounce<S>>() + size_of::<Child>())
            + more_bounces * size_of::<BounceRecord>();
        let old = copied(&self.entries, more_entries)
            + copied(&self.children, more_entries)
            + copied(&self.bounces, more_bounces);
        let taken = !self.budget.is_refused() && self.budget.take(more + old);
        let grown = taken
            && self.entries.try_reserve_exact(more_entries).is_ok()
            && self.children.try_reserve_exact(more_entries).is_ok()
            && self.bounces.try_reserve_exact(more_bounces).is_ok();
        if grown {
            self.entries.resize(self.entries.len() + more_entries, PendingBounce::EMPTY);
            self.children.resize(self.entries.len(), 0);
            self.bounces.resize(self.bounces.len() + more_bounces, BounceRecord::default());
            self.budget.give_back(old);
            self.granted += more;
        } else {
            if taken {
                self.budget.give_back(more + old);
            }
            self.budget.refuse();
        }
        grown
    }

    /// Puts the bounce of eye rays in place of all there is.
    #[inline(always)]
    pub(crate) fn start(&mut self) -> &mut DepthCount {
        self.len = 0;
        self.bounce = 0;
        self.count()
    }

    #[inline(always)]
    pub(crate) fn bounce(&self) -> usize {
        self.bounce
    }

    /// The counters of the bounce in flight.
    #[inline(always)]
    pub(crate) fn count(&mut self) -> &mut DepthCount {
        &mut self.bounces[self.bounce].count
    }

    /// Entries of the bounce in flight.
    #[inline(always)]
    pub(crate) fn pending(&self) -> &[PendingBounce<S>] {
        &self.entries[self.bounces[self.bounce].start..self.len]
    }

    /// Some rays among so many packets from `first` on met nothing.
    #[inline(always)]
    pub(crate) fn missed(&mut self, first: usize, packets: usize) {
        let bounce = &mut self.bounces[self.bounce];
        (bounce.first_missed, bounce.missed) = (first as u8, packets as u8);
    }

    /// Puts eight rays of the bounce in flight on the stack, which wait at the mirror of a material
    /// for packet `child` of the next queue.
    #[inline(always)]
    pub(crate) fn push<L: Lanes<Scalar = S>>(
        &mut self,
        local: Vec3<L>,
        slots: &[ReturnSlot; LANES],
        material: u32,
        child: usize,
    ) {
        let pending = &mut self.entries[self.len];
        let mut slots = *slots;
        for slot in &mut slots {
            *slot = slot.at(material);
        }
        (pending.local, pending.slots) = (local.to_arrays(), slots);
        self.children[self.len] = child as Child;
        self.len += 1;
    }

    /// Puts eight rays on the stack that wait for nothing.
    #[inline(always)]
    pub(crate) fn push_end<L: Lanes<Scalar = S>>(
        &mut self,
        local: Vec3<L>,
        slots: &[ReturnSlot; LANES],
    ) {
        self.push(local, slots, ReturnSlot::END, 0);
    }

    /// Makes the next bounce the one in flight.
    #[inline(always)]
    pub(crate) fn descend(&mut self) {
        self.bounce += 1;
        self.bounces[self.bounce].start = self.len;
    }

    /// Makes the bounce above the one in flight.
    #[inline(always)]
    pub(crate) fn ascend(&mut self) {
        self.bounce -= 1;
    }

    /// Complete colours of a bounce's rays.
    #[inline(always)]
    pub(crate) fn colours(&self, bounce: usize) -> &Vec3Column<S> {
        &self.colours[queue_of(bounce)]
    }

    /// Complete colours of the eye rays.
    #[inline(always)]
    pub(crate) fn eye_colours(&mut self) -> &mut Vec3Column<S> {
        &mut self.colours[0]
    }

    /// Takes the bounce in flight off the stack: completes its rays' colours, local + reflectance ·
    /// what comes back from the bounce below, as the recursion forms them.
    #[inline(always)]
    pub(crate) fn fold<L: Lanes<Scalar = S>>(
        &mut self,
        materials: &[Phong<S>],
        background: S::Vec3,
    ) {
        let BounceRecord { start, first_missed, missed, .. } = self.bounces[self.bounce];
        let Ok([colours, below]) =
            self.colours.get_disjoint_mut([queue_of(self.bounce), queue_of(self.bounce + 1)])
        else {
            unreachable!("two queues");
        };
        self.bounces[self.bounce].missed = 0;
        for packet in first_missed..first_missed + missed {
            colours.put(packet as usize, Vec3::<L>::splat(background));
        }
        let children = &self.children[start..self.len];
        for (pending, &child) in self.entries[start..self.len].iter().zip(children) {
            let (mut colour, slots) = (Vec3::<L>::from_arrays(&pending.local), &pending.slots);
            if !slots[0].is_end() {
                let reflectance = if ReturnSlot::are_of_one_material(slots) {
                    L::splat(slots[0].reflectance(materials))
                } else {
                    L::gather(|lane| slots[lane].reflectance(materials))
                };
                colour = fold(colour, reflectance, below.packet(child.into()));
            }
            match ReturnSlot::packet(slots) {
                Some(packet) => colours.put(packet, colour),
                None => colours.scatter(|lane| slots[lane].slot(), colour),
            }
        }
        self.len = start;
    }

    /// Adds what this stack counted and counts from 0 again.
    pub(crate) fn take_counts(&mut self) -> Counts {
        let used = self.bounces.iter().rposition(|b| b.count.rays > 0).map_or(0, |last| last + 1);
        let take = |bounce: &mut BounceRecord| std::mem::take(&mut bounce.count);
        Counts { depths: self.bounces[..used].iter_mut().map(take).collect() }
    }
}

/// Bytes of a buffer that exist beside its copy while it takes more entries.
fn copied<T>(buffer: &[T], more: usize) -> usize {
    if more > 0 { size_of_val(buffer) } else { 0 }
}

/// The colour of a ray whose reflected ray came back.
#[inline(always)]
fn fold<L: Lanes>(local: Vec3<L>, reflectance: L, back: Vec3<L>) -> Vec3<L> {
    local + back * reflectance
}

impl<S: Lane> Drop for Stack<'_, S> {
    fn drop(&mut self) {
        self.budget.give_back(self.granted);
    }
}

#[cfg(test)]
mod tests;
