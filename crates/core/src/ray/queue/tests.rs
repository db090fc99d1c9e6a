//! Queues beside a plain list of packets.

use super::{BREADTH, Departing, QUEUES, RayQueue, queue_of};
use crate::ray::{NONE, PACKETS, Rays};
use crate::simd::numbers::Numbers;
use crate::simd::{LANES, Lane, Lanes, Vec3};

type L = <f32 as Lane>::Portable;

/// A packet that was pushed: what it left, how many rays it has, and a number that marks them.
#[derive(Clone, Copy, Debug)]
struct Pushed {
    from: u32,
    live: usize,
    mark: f32,
    mixed: bool,
}

/// Rays that are marked: lane i of the origin is `mark` + i.
fn rays(mark: f32) -> Rays<L> {
    let x = L::from_array(std::array::from_fn(|lane| mark + lane as f32));
    let origin = Vec3 { x, y: L::splat(mark), z: L::splat(1.0) };
    Rays { origin, direction: Vec3 { x: L::splat(2.0), y: L::splat(mark), z: x } }
}

fn push(queue: &mut RayQueue<f32>, packet: Pushed) {
    let Pushed { from, live, mark, mixed } = packet;
    if mixed {
        let from = L::from_array(std::array::from_fn(|lane| f32::from_index(lane as u32 % 3)));
        queue.push_mixed(&rays(mark), L::splat(-mark), from, live);
    } else {
        queue.push(&Departing { rays: rays(mark), weight: Some(L::splat(-mark)), from });
    }
}

/// What [`RayQueue::runs`] are of a plain list: neighbours that left the same, put together.
fn runs(pushed: &[Pushed]) -> Vec<(u32, u32)> {
    let mut runs: Vec<(u32, u32)> = Vec::new();
    for (i, packet) in pushed.iter().enumerate() {
        let end = i as u32 + 1;
        match runs.last_mut() {
            Some(last) if last.0 == packet.from => last.1 = end,
            _ => runs.push((packet.from, end)),
        }
    }
    runs
}

/// Reads everything back that was pushed.
fn check(queue: &RayQueue<f32>, pushed: &[Pushed]) {
    assert_eq!(queue.len(), pushed.len());
    let found: Vec<_> = queue.runs().iter().map(|run| (run.from, run.end)).collect();
    assert_eq!(found, runs(pushed), "{pushed:?}");
    let mut rays = 0;
    for (i, packet) in pushed.iter().enumerate() {
        assert_eq!(queue.live(i) as usize, packet.live, "{pushed:?}, packet {i}");
        assert_eq!(queue.count(0..i), rays);
        rays += packet.live as u64;
        for lane in 0..LANES {
            let (slot, x) = (i * LANES + lane, packet.mark + lane as f32);
            assert_eq!(queue.ray(slot), ([x, packet.mark, 1.0], [2.0, packet.mark, x]));
            assert_eq!(queue.weights().ray(slot), -packet.mark);
            // Kept only where the run does not say it.
            let left = if packet.mixed { lane as u32 % 3 } else { NONE };
            let kept = queue.from().ray(slot).to_index();
            assert!(packet.from != NONE || kept == left, "{pushed:?}, slot {slot}: {kept}");
        }
        let whole = queue.rays::<L>(i).origin.x.to_array();
        assert_eq!(whole, std::array::from_fn(|lane| packet.mark + lane as f32));
        let gathered = queue.gather::<L>(|lane| i * LANES + LANES - 1 - lane);
        assert_eq!(gathered.origin.x.to_array()[0], packet.mark + 7.0);
    }
    assert_eq!(queue.count(0..pushed.len()), rays);
}

#[test]
fn runs_part_where_packets_left_another_primitive() {
    let mut numbers = Numbers::new(13);
    let mut queue = RayQueue::<f32>::new();
    for round in 0..2000 {
        queue.clear();
        let primitives = [1, 2, 5, 1000][round % 4];
        let len = [0, 1, 2, PACKETS][round / 4 % 4].max(numbers.below(PACKETS + 1));
        let mut pushed = Vec::new();
        while pushed.len() < len {
            // Packets that left several primitives are one run, and only the last one is not full.
            let mixed = numbers.one_in(3);
            let full = !mixed || pushed.len() + 1 < len;
            let live = if full { LANES } else { 1 + numbers.below(LANES) };
            let edge = [NONE, 0, NONE - 1][numbers.below(3)];
            let usual = numbers.below(primitives) as u32;
            let from = if numbers.one_in(8) { edge } else { usual };
            let from = if mixed { NONE } else { from };
            let mark = (round % 7 * 1000 + pushed.len() * 10) as f32;
            let packet = Pushed { from, live, mark, mixed };
            push(&mut queue, packet);
            pushed.push(packet);
        }
        queue.end_run();
        check(&queue, &pushed);
    }
}

#[test]
fn a_full_queue_holds_a_run_for_every_packet() {
    let mut queue = RayQueue::<f32>::new();
    let packet = |i| Pushed { from: i, live: LANES, mark: i as f32 * 8.0, mixed: false };
    let pushed: Vec<_> = (0..PACKETS as u32).map(packet).collect();
    for &packet in &pushed {
        push(&mut queue, packet);
    }
    queue.end_run();
    assert_eq!(queue.runs().len(), PACKETS);
    check(&queue, &pushed);
}

#[test]
fn eye_rays_are_counted_by_their_lanes() {
    let mut queue = RayQueue::<f32>::new();
    for packet in 0..PACKETS {
        queue.put_eye_rays(packet, rays(packet as f32).direction, 1 + packet % LANES);
    }
    queue.end_eye_rays(20);
    assert_eq!((queue.len(), queue.runs().len()), (20, 0));
    assert_eq!(queue.count(0..20), (0..20).map(|packet| 1 + packet % 8).sum::<u64>());
    assert_eq!(queue.ray(3 * LANES), ([0.0; 3], [2.0, 3.0, 3.0]));
}

#[test]
fn no_bounce_has_the_queue_of_the_next_one() {
    for bounce in 0..3 * BREADTH {
        let (this, next) = (queue_of(bounce), queue_of(bounce + 1));
        assert!(this < QUEUES && this != next, "bounce {bounce}");
        // The eye rays' and those at which packets are held are written once.
        assert!(next != queue_of(0));
        assert!((next == queue_of(BREADTH)) == (bounce + 1 == BREADTH));
    }
}
