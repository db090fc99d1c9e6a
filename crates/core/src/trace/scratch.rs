//! What a thread keeps from tile to tile.

use super::across::{Across, COLUMN_PACKETS};
use super::budget::Budget;
use super::frame::Frame;
use super::nearest::NearestHits;
use super::regroup::Regroup;
use super::shade::ShadeScratch;
use super::stack::Stack;
use crate::ray::{PACKETS, QUEUES, RayQueue};
use crate::simd::{LANES, Lane, Packed};

/// Room of one thread, made once a rendering and thread.
pub(crate) struct Scratch<'a, S: Lane> {
    /// The rays of each bounce; see [`crate::ray::queue_of`].
    pub(crate) queues: [Box<RayQueue<S>>; QUEUES],
    pub(crate) nearest: Box<NearestHits<S>>,
    pub(crate) shade: ShadeScratch<S>,
    pub(crate) regroup: Regroup<S>,
    pub(crate) stack: Stack<'a, S>,
    /// What of a tile's eye rays depends on the column.
    pub(crate) across: [Across<S>; COLUMN_PACKETS],
    /// Sums of samples.
    pub(crate) sums: Box<[Packed<S>; PACKETS]>,
}

impl<'a, S: Lane> Scratch<'a, S> {
    pub(crate) fn new(frame: &Frame<S>, budget: &'a Budget) -> Self {
        let scene = frame.scene;
        Self {
            queues: std::array::from_fn(|_| Box::new(RayQueue::new())),
            nearest: Box::new(NearestHits::new(scene.primitives.len())),
            shade: ShadeScratch::new(frame.occluders.len(), scene.lights.len()),
            regroup: Regroup::new(),
            stack: Stack::new(budget, frame.depth),
            across: [Across::EMPTY; COLUMN_PACKETS],
            sums: Box::new([[[S::ZERO; LANES]; 3]; PACKETS]),
        }
    }
}
