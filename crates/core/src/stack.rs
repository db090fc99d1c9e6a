//! The stack: what every level of a tile still owes, and what was counted there.
//!
//! A mirror has one child, so each eye ray's stack is a chain, and the rays in flight (origin,
//! direction, weight) are held once, in the waves. Of a level below them there is kept, for each
//! ray that met something, only what is needed on the return: the local light, whose it is, and
//! the mirror that says how much of the mirrored ray's colour is added to it. That is 16 bytes a
//! ray and level in f32. The colours that come back exist for one level at a time.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use catoptric_scene::{Counts, DepthCount, MOST_PRIMITIVES, Phong, Scalar};

use crate::lanes::{LANES, Lane, Lanes};
use crate::packet::wave_of;
use crate::plane::{PACKETS, RAYS, Slot, Vectors};
use crate::vec3::{Packed, Vec3};

/// Bytes of a stack that a ray takes at each level, in f32.
pub const RAY_LEVEL_BYTES: usize = size_of::<Pending<f32>>() / LANES;

/// Eight rays whose colour waits to be complete, or is.
#[derive(Clone, Copy)]
#[repr(align(32))]
pub(crate) struct Pending<S> {
    /// What lamps send back from where the rays met something.
    pub(crate) local: Packed<S>,
    /// Whose it is. Lanes without a ray are the last ones and repeat the first.
    pub(crate) owed: [Owed; LANES],
}

impl<S: Lane> Pending<S> {
    const EMPTY: Self = Self { local: [[S::ZERO; LANES]; 3], owed: [Owed::NOTHING; LANES] };
}

/// The ray that a colour belongs to, and by the mirror of which material its mirrored ray's colour
/// is added. In bits 0 to 8 the ray's slot, in bits 9 to 30 the material, or [`Owed::END`] where no
/// mirror is followed; that is the same for all eight. Bit 31 says in lane 0 that they are the
/// lanes of one packet, whose first slot then stands in all of them; in lane 1, that they are of
/// one material.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) struct Owed(u32);

/// A scene's materials are no more than its primitives.
const _: () = assert!(MOST_PRIMITIVES < Owed::END as usize);

impl Owed {
    /// Of no ray.
    pub(crate) const NOTHING: Self = Self(u32::MAX);
    /// In place of a material.
    pub(crate) const END: u32 = (1 << 22) - 1;
    const FLAG: u32 = 1 << 31;
    const SLOTS: u32 = RAYS as u32;

    /// By eight rays that met the same. Of material 0, until it is known.
    #[inline(always)]
    pub(crate) fn to_rays(slots: &[Slot; LANES]) -> [Self; LANES] {
        let mut owed = slots.map(|slot| Self(u32::from(slot)));
        owed[1].0 |= Self::FLAG;
        owed
    }

    /// By the rays of a packet that met the same. Of material 0, until it is known.
    #[inline(always)]
    pub(crate) fn to_packet(packet: usize) -> [Self; LANES] {
        [Self(Self::FLAG | (packet * LANES) as u32); LANES]
    }

    /// By the mirror of that material.
    #[inline(always)]
    fn by(self, material: u32) -> Self {
        Self(self.0 | (material * Self::SLOTS))
    }

    /// Of rays that met the same, those by the mirror of that material, lane by lane, so that they
    /// can be put together with others.
    #[inline(always)]
    pub(crate) fn each(rays: &[Self; LANES], material: u32) -> [Self; LANES] {
        let packet = Self::packet(rays).is_some();
        let mut each = *rays;
        for (lane, owed) in each.iter_mut().enumerate() {
            *owed = Self(owed.0 & !Self::FLAG).by(material);
            if packet {
                owed.0 += lane as u32;
            }
        }
        each
    }

    /// The same ray, whose mirror is not followed.
    #[inline(always)]
    pub(crate) fn ended(self) -> Self {
        Self(Self::END * Self::SLOTS + self.0 % Self::SLOTS)
    }

    /// The packet whose lanes they are.
    #[inline(always)]
    pub(crate) fn packet(owed: &[Self; LANES]) -> Option<usize> {
        if owed[0].0 & Self::FLAG != 0 { Some(owed[0].slot() / LANES) } else { None }
    }

    #[inline(always)]
    fn are_of_one_material(owed: &[Self; LANES]) -> bool {
        owed[1].0 & Self::FLAG != 0
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

    /// How much of the mirrored ray's colour is added; 0 where there is none.
    #[inline(always)]
    pub(crate) fn k<S: Scalar>(self, materials: &[Phong<S>]) -> S {
        materials.get(self.material() as usize).map_or(S::ZERO, |material| material.mirror)
    }
}

/// The stack of one thread. It grows as rays go deep and is kept between tiles.
pub(crate) struct Stack<'a, S: Lane> {
    /// All levels down to the one in flight, one after another. The first of a level's packets
    /// that is no end waits for the first packet of the next wave, and so on.
    packets: Vec<Pending<S>>,
    /// How many packets that is.
    len: usize,
    levels: Vec<Level>,
    depth: usize,
    /// Complete colours of a wave's rays, for each of the waves.
    colours: [Box<Vectors<S>>; 4],
    budget: &'a Budget,
    granted: usize,
}

#[derive(Clone, Copy, Default)]
struct Level {
    /// Its first packet.
    start: usize,
    /// Packets of the wave in which some ray met nothing are among so many, from this one on.
    first_missed: u8,
    missed: u8,
    count: DepthCount,
}

/// Entries of eight rays that a tile leaves on the stack, at most, when its rays have been mirrored
/// up to `reflections` times and all go side by side.
///
/// Each entry holds at least one ray that is in no other entry of its level, so a level pushes at
/// most as many entries as it has rays: no more, whatever the rays met, whether their mirrors are
/// followed or not, and wherever a cut by weight parts the rays of an entry. The bound is reached,
/// where each ray of a tile meets a primitive of its own and ends there.
///
/// All levels together: a ray ends once, so at most [`RAYS`] entries hold rays that end. The
/// others hold rays that go on; they are as many as the packets of the next wave, all of them full
/// but the last: at most [`PACKETS`] a level, and none on the last one.
const fn room(reflections: usize) -> usize {
    RAYS + PACKETS * reflections
}

/// Bytes that the stacks of all threads may take.
pub(crate) struct Budget {
    pub(crate) limit: usize,
    taken: AtomicUsize,
    /// Some stack was refused what it asked for: the picture will not be whole.
    refused: AtomicBool,
}

impl Budget {
    pub(crate) fn new(limit: usize) -> Self {
        Self { limit, taken: AtomicUsize::new(0), refused: AtomicBool::new(false) }
    }

    /// Whether some stack could not grow: the rendering ends, in every thread.
    #[inline(always)]
    pub(crate) fn is_refused(&self) -> bool {
        self.refused.load(Ordering::Relaxed)
    }

    /// Takes bytes if the limit allows it.
    fn take(&self, bytes: usize) -> bool {
        let within = |taken: usize| taken.checked_add(bytes).filter(|&sum| sum <= self.limit);
        self.taken.fetch_update(Ordering::Relaxed, Ordering::Relaxed, within).is_ok()
    }

    fn give_back(&self, bytes: usize) {
        self.taken.fetch_sub(bytes, Ordering::Relaxed);
    }
}

impl<'a, S: Lane> Stack<'a, S> {
    /// Reflections that a new stack has room for, at most.
    const FIRST: usize = 24;

    /// An empty stack for so many reflections.
    ///
    /// It holds whatever a tile can leave on its first levels, so these never count against the
    /// limit: see [`room`]. A shallow picture does not pay for levels that it does not reach.
    pub(crate) fn new(budget: &'a Budget, depth: u32) -> Self {
        let reflections = Self::FIRST.min(depth as usize);
        Self {
            packets: vec![Pending::EMPTY; room(reflections)],
            len: 0,
            levels: vec![Level::default(); reflections + 2],
            depth: 0,
            colours: std::array::from_fn(|_| Box::new(Vectors::zero())),
            budget,
            granted: 0,
        }
    }

    /// Whether some thread's stack was refused more, so that nothing further is of use.
    #[inline(always)]
    pub(crate) fn is_refused(&self) -> bool {
        self.budget.is_refused()
    }

    /// Makes room for what the level in flight pushes, and for one level below it; false if the
    /// limit forbids it. `rays` is how many rays the level has, which is the most that it pushes:
    /// see [`room`].
    #[inline(always)]
    pub(crate) fn make_room(&mut self, rays: usize) -> bool {
        (self.len + rays <= self.packets.len() && self.depth + 1 < self.levels.len())
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
        let lacking = (self.len + rays).saturating_sub(self.packets.len());
        let more_packets = if lacking > 0 { lacking.max(self.packets.len() / 4) } else { 0 };
        let full = self.depth + 1 >= self.levels.len();
        let more_levels = if full { self.levels.len().div_ceil(4) } else { 0 };
        let more = more_packets * size_of::<Pending<S>>() + more_levels * size_of::<Level>();
        let old = copied(&self.packets, more_packets) + copied(&self.levels, more_levels);
        let taken = !self.budget.is_refused() && self.budget.take(more + old);
        let grown = taken
            && self.packets.try_reserve_exact(more_packets).is_ok()
            && self.levels.try_reserve_exact(more_levels).is_ok();
        if grown {
            self.packets.resize(self.packets.len() + more_packets, Pending::EMPTY);
            self.levels.resize(self.levels.len() + more_levels, Level::default());
            self.budget.give_back(old);
            self.granted += more;
        } else {
            if taken {
                self.budget.give_back(more + old);
            }
            self.budget.refused.store(true, Ordering::Relaxed);
        }
        grown
    }

    /// Puts the level of eye rays in place of all there is.
    #[inline(always)]
    pub(crate) fn start(&mut self) -> &mut DepthCount {
        self.len = 0;
        self.depth = 0;
        self.count()
    }

    #[inline(always)]
    pub(crate) fn depth(&self) -> usize {
        self.depth
    }

    /// The counters of the level in flight.
    #[inline(always)]
    pub(crate) fn count(&mut self) -> &mut DepthCount {
        &mut self.levels[self.depth].count
    }

    /// Packets of the level in flight.
    #[inline(always)]
    pub(crate) fn level(&self) -> &[Pending<S>] {
        &self.packets[self.levels[self.depth].start..self.len]
    }

    /// Some rays among so many packets from `first` on met nothing.
    #[inline(always)]
    pub(crate) fn missed(&mut self, first: usize, packets: usize) {
        let level = &mut self.levels[self.depth];
        (level.first_missed, level.missed) = (first as u8, packets as u8);
    }

    /// Puts eight rays of the level in flight on the stack, and by the mirror of which material.
    #[inline(always)]
    pub(crate) fn push<L: Lanes<Scalar = S>>(
        &mut self,
        local: Vec3<L>,
        rays: &[Owed; LANES],
        material: u32,
    ) {
        let pending = &mut self.packets[self.len];
        let mut owed = *rays;
        for owed in &mut owed {
            *owed = owed.by(material);
        }
        (pending.local, pending.owed) = (local.to_arrays(), owed);
        self.len += 1;
    }

    /// The next level is in flight.
    #[inline(always)]
    pub(crate) fn descend(&mut self) {
        self.depth += 1;
        self.levels[self.depth].start = self.len;
    }

    /// The level above is in flight.
    #[inline(always)]
    pub(crate) fn ascend(&mut self) {
        self.depth -= 1;
    }

    /// Complete colours of a level's wave.
    #[inline(always)]
    pub(crate) fn colours(&self, depth: usize) -> &Vectors<S> {
        &self.colours[wave_of(depth)]
    }

    /// Those of eye rays.
    #[inline(always)]
    pub(crate) fn eye_colours(&mut self) -> &mut Vectors<S> {
        &mut self.colours[0]
    }

    /// Takes the level in flight off the stack: completes its rays' colours, local + k · what comes
    /// back from the level below, as the recursion forms them.
    #[inline(always)]
    pub(crate) fn fold<L: Lanes<Scalar = S>>(
        &mut self,
        materials: &[Phong<S>],
        background: S::Vec3,
    ) {
        let Level { start, first_missed, missed, .. } = self.levels[self.depth];
        let Ok([colours, below]) =
            self.colours.get_disjoint_mut([wave_of(self.depth), wave_of(self.depth + 1)])
        else {
            unreachable!("two waves");
        };
        self.levels[self.depth].missed = 0;
        for packet in first_missed..first_missed + missed {
            colours.put(packet as usize, Vec3::<L>::splat(background));
        }
        let mut first_below = 0;
        for pending in &self.packets[start..self.len] {
            let (mut colour, owed) = (Vec3::<L>::from_arrays(&pending.local), &pending.owed);
            if !owed[0].is_end() {
                let k = if Owed::are_of_one_material(owed) {
                    L::splat(owed[0].k(materials))
                } else {
                    L::gather(|lane| owed[lane].k(materials))
                };
                colour = fold(colour, k, below.packet(first_below));
                first_below += 1;
            }
            match Owed::packet(owed) {
                Some(packet) => colours.put(packet, colour),
                None => colours.scatter(|lane| owed[lane].slot(), colour),
            }
        }
        self.len = start;
    }

    /// Adds what this stack counted and counts from 0 again.
    pub(crate) fn take_counts(&mut self) -> Counts {
        let used = self.levels.iter().rposition(|l| l.count.rays > 0).map_or(0, |last| last + 1);
        let take = |level: &mut Level| std::mem::take(&mut level.count);
        Counts { depths: self.levels[..used].iter_mut().map(take).collect() }
    }
}

/// Bytes of a buffer that exist beside its copy while it takes more entries.
fn copied<T>(buffer: &[T], more: usize) -> usize {
    if more > 0 { size_of_val(buffer) } else { 0 }
}

/// The colour of a ray whose mirrored ray came back.
#[inline(always)]
fn fold<L: Lanes>(local: Vec3<L>, k: L, back: Vec3<L>) -> Vec3<L> {
    local + back * k
}

impl<S: Lane> Drop for Stack<'_, S> {
    fn drop(&mut self) {
        self.budget.give_back(self.granted);
    }
}
