//! Rays of a tile: eight at a time, in columns, queued by bounce, and packed without gaps.

mod column;
mod compact;
mod queue;
mod rays;

pub(crate) use column::{Column, PACKETS, RAYS, Slot, TILE_HEIGHT, TILE_WIDTH, Vec3Column};
pub(crate) use compact::Compactor;
pub(crate) use queue::{BREADTH, Departing, QUEUES, RayQueue, queue_of};
pub(crate) use rays::{Distance, NONE, Rays};
