//! How often things are run, without a clock.

use std::cell::RefCell;
use std::time::Duration;

use catoptric_study::Unwatched;
use catoptric_study::timing::{Repeat, Times, in_turn, more_in_turn, noise};

fn times(ms: &[u64]) -> Times {
    let mut times = Times::default();
    for &ms in ms {
        times.add(Duration::from_millis(ms));
    }
    times
}

/// 20 runs, however long they take together; one where it takes over 2 s.
#[test]
fn each_is_run_20_times_or_once_where_it_is_long() {
    let runs = |ms: u64| {
        let run = |_| Some(Duration::from_millis(ms));
        in_turn(1, Repeat::Enough, &Unwatched, run)[0].runs()
    };
    assert_eq!((runs(1), runs(1900), runs(2000), runs(2001)), (20, 20, 20, 1));
}

#[test]
fn things_take_turns_and_what_fails_is_left_out() {
    let order = RefCell::new(Vec::new());
    let run = |i| {
        order.borrow_mut().push(i);
        (i != 1).then_some(Duration::from_millis(1))
    };
    let times = in_turn(3, Repeat::Times(2), &Unwatched, run);
    assert_eq!(*order.borrow(), [0, 1, 2, 0, 2]);
    assert_eq!(times.iter().map(Times::runs).collect::<Vec<_>>(), [2, 0, 2]);
}

#[test]
fn runs_made_before_count() {
    let run = |_| Some(Duration::from_millis(1));
    let before = vec![times(&[5, 6, 7]), times(&[5])];
    let after = more_in_turn(before, Repeat::Times(2), &Unwatched, run);
    assert_eq!(after.iter().map(Times::runs).collect::<Vec<_>>(), [3, 2]);
    assert_eq!((after[0].min_ms(), after[1].min_ms()), (Some(5.0), Some(1.0)));
}

#[test]
fn a_machine_that_is_not_quiet_is_said_to_be_so() {
    assert_eq!(noise(&[times(&[10, 15, 15]), times(&[7]), Times::default()]), None);
    let said = noise(&[times(&[10, 11]), times(&[10, 16, 20]), times(&[1, 3, 3])]).expect("noise");
    assert!(said.contains("of 3 rows 2") && said.contains("3.0 times at most"), "{said}");
}
