//! The stack beside a recursion on plain numbers, and what it takes of the budget.

mod budget;
mod driver;
mod paths;

use catoptric_scene::MOST_MATERIALS;

use super::super::budget::Budget;
use super::super::pending::ReturnSlot;
use super::{Stack, room};
use crate::ray::{PACKETS, RAYS};
use crate::simd::numbers::{Numbers, TestScalar};
use crate::simd::{LANES, Lane, Vec3};
use driver::Driver;
use paths::{Paths, materials};

type L = <f32 as Lane>::Portable;

/// Traces paths and compares colours and counts with the recursion's.
fn check(paths: &Paths, budget: &Budget, depth: u32, numbers: &mut Numbers) {
    let materials = materials();
    let mut driver = Driver::new(paths, &materials, Stack::new(budget, depth), numbers);
    driver.trace();
    for ray in 0..paths.len() {
        let found = driver.colour(ray);
        let expected = paths.recursion(&materials, ray, 0);
        let same = found.iter().zip(expected).all(|(found, expected)| found.is(expected));
        assert!(same, "ray {ray} of {}: {found:?}, not {expected:?}", paths.len());
    }
    let rays: Vec<_> = driver.counts().depths.iter().map(|count| count.rays).collect();
    assert_eq!(rays, paths.rays(), "the counts of every bounce");
}

/// The first bounces are not to grow: the budget has nothing to give.
#[test]
fn colours_are_the_recursions() {
    let mut numbers = Numbers::new(21);
    for round in 0..300 {
        let rays = if round % 3 == 0 { RAYS } else { 1 + numbers.below(RAYS) };
        let depth = numbers.below(Stack::<f32>::FIRST + 1);
        let paths = Paths::random(rays, depth, &mut numbers);
        check(&paths, &Budget::new(0), depth as u32, &mut numbers);
    }
}

/// Some rays pass the bounce from which on packets go one by one.
#[test]
fn deep_colours_are_the_recursions() {
    let mut numbers = Numbers::new(22);
    for rays in [1, 8, 9, 30] {
        let paths = Paths::deep(rays, &mut numbers);
        check(&paths, &Budget::new(1 << 30), u32::MAX, &mut numbers);
    }
}

/// Each ray of a tile meets a primitive of its own, and ends there; or goes on and ends alone.
#[test]
fn the_bound_of_entries_is_reached_and_not_passed() {
    let mut numbers = Numbers::new(23);
    for depth in 0..4 {
        let paths = Paths::alone(RAYS, depth, &mut numbers);
        let (budget, materials) = (Budget::new(0), materials());
        let stack = Stack::new(&budget, depth as u32);
        let mut driver = Driver::new(&paths, &materials, stack, &mut numbers);
        driver.trace();
        assert_eq!(driver.most_entries, room(depth), "{depth} reflections");
    }
}

/// Slots and materials are kept apart, up to the last of each.
#[test]
fn a_return_slot_holds_any_ray_and_material() {
    for material in [0, 1, 511, 512, MOST_MATERIALS as u32 - 1] {
        for packet in 0..PACKETS {
            let slots = ReturnSlot::to_packet(packet);
            assert_eq!(ReturnSlot::packet(&slots), Some(packet));
            for (lane, slot) in ReturnSlot::each(&slots, material).into_iter().enumerate() {
                assert_eq!((slot.slot(), slot.is_end()), (packet * LANES + lane, false));
                assert!(slot.ended().is_end() && slot.ended().slot() == slot.slot());
                assert!(slots[lane].at(ReturnSlot::END).is_end());
            }
            let singles = std::array::from_fn(|lane| ((lane * 64 + packet) % RAYS) as u16);
            let rays = ReturnSlot::to_rays(&singles);
            assert_eq!(ReturnSlot::packet(&rays), None);
            for (lane, slot) in ReturnSlot::each(&rays, material).into_iter().enumerate() {
                assert_eq!((slot.slot(), slot.is_end()), (singles[lane].into(), false));
            }
            assert!(ReturnSlot::are_of_one_material(&rays.map(|slot| slot.at(material))));
            assert!(!ReturnSlot::are_of_one_material(&ReturnSlot::each(&rays, material)));
        }
    }
}

/// Eight colours of one number.
fn colour(number: f32) -> Vec3<L> {
    Vec3::splat(glam::Vec3::splat(number))
}
