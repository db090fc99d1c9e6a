//! What stacks take of the budget, and give back.

use super::{Budget, Numbers, ReturnSlot, Stack, colour};
use crate::ray::{PACKETS, RAYS};

/// Bytes that are left of a budget.
fn left(budget: &Budget, limit: usize) -> usize {
    let (mut fits, mut refused) = (0, limit + 1);
    while fits + 1 < refused {
        let middle = fits + (refused - fits) / 2;
        if budget.take(middle) {
            budget.give_back(middle);
            fits = middle;
        } else {
            refused = middle;
        }
    }
    fits
}

/// Pushes a bounce of so many rays; false where there was no room.
fn go_down(stack: &mut Stack<f32>, rays: usize) -> bool {
    if !stack.make_room(rays) {
        return false;
    }
    // The room is there, for as many entries as rays, and for one bounce more.
    assert!(stack.len + rays <= stack.entries.len() && stack.bounce + 1 < stack.bounces.len());
    for packet in 0..rays.min(PACKETS) {
        stack.push(colour(1.0), &ReturnSlot::to_packet(packet), 0, 0);
    }
    stack.descend();
    true
}

#[test]
fn a_budget_gives_what_it_has_and_no_more() {
    let budget = Budget::new(100);
    assert!(budget.take(60) && !budget.take(41) && !budget.take(usize::MAX) && budget.take(40));
    assert!(!budget.take(1) && budget.take(0));
    budget.give_back(30);
    assert_eq!(left(&budget, 100), 30);
    assert!(!budget.is_refused(), "what was not given ends nothing yet");
    budget.refuse();
    assert!(budget.is_refused());
}

#[test]
fn stacks_take_what_they_grew_by_and_give_it_back() {
    let mut numbers = Numbers::new(24);
    for limit in [0, 1, 1000, 200_000, 1_000_000, 10_000_000] {
        let budget = Budget::new(limit);
        let mut first = Stack::<f32>::new(&budget, u32::MAX);
        let mut second = Stack::<f32>::new(&budget, u32::MAX);
        assert_eq!(left(&budget, limit), limit, "a new stack takes nothing");
        let mut bounces = 0;
        // Each grows in turn until one is refused, which takes nothing.
        let refused = loop {
            let stack = if numbers.one_in(2) { &mut first } else { &mut second };
            if !go_down(stack, numbers.below(RAYS + 1)) {
                break stack.granted;
            }
            bounces += 1;
            assert_eq!(left(&budget, limit), limit - first.granted - second.granted);
            assert!(!budget.is_refused());
        };
        assert!(bounces >= Stack::<f32>::FIRST, "{bounces} bounces of {limit} bytes");
        assert!(first.granted + second.granted <= limit && refused <= limit);
        assert_eq!(left(&budget, limit), limit - first.granted - second.granted);
        assert!(first.is_refused() && second.is_refused(), "every stack is told");
        // Once one was refused, no other grows, whatever is left.
        let (entries, granted) = (second.entries.len(), second.granted);
        assert!(!second.make_room(second.entries.len() + 1));
        assert_eq!((second.entries.len(), second.granted), (entries, granted));
        drop(first);
        assert_eq!(left(&budget, limit), limit - granted);
        drop(second);
        assert_eq!(left(&budget, limit), limit, "all is given back");
    }
}

/// While it is copied, the old buffer counts too.
#[test]
fn a_stack_asks_for_old_and_new_together() {
    let unlimited = Budget::new(usize::MAX);
    let mut stack = Stack::<f32>::new(&unlimited, 0);
    let old = size_of_val(&*stack.entries) + size_of_val(&*stack.children);
    assert!(stack.make_room(RAYS + 1));
    let more = stack.granted;
    assert!(more >= old / 4);
    for (limit, enough) in [(old + more, true), (old + more - 1, false)] {
        let budget = Budget::new(limit);
        let mut stack = Stack::<f32>::new(&budget, 0);
        assert_eq!(stack.make_room(RAYS + 1), enough, "{limit} bytes");
        let granted = if enough { more } else { 0 };
        assert_eq!((stack.granted, left(&budget, limit)), (granted, limit - granted));
    }
}
