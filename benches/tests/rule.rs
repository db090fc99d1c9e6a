//! When a line is worse than the noise.

use catoptric_benches::history::entry::Entry;
use catoptric_benches::history::rule::{LEAST_MARGIN, Limits, Verdict, judge, judge_all};

use super::line;

/// A line with those speed-ups and no spread.
fn with(min: f64, median: f64) -> Entry {
    Entry { over_same_min: min, over_same_median: median, over_same_spread: 0.0, ..line() }
}

fn worse(earlier: &[Entry], line: &Entry) -> bool {
    matches!(judge(earlier, line), Verdict::Worse(_))
}

#[test]
fn both_speed_ups_must_fall_below_their_limits() {
    let earlier = [with(11.0, 10.5), with(10.0, 9.5), with(10.5, 10.0)];
    let keep = 1.0 - LEAST_MARGIN;
    let limits = Limits { min: 10.0 * keep, median: 9.5 * keep, margin: LEAST_MARGIN, lines: 3 };
    assert_eq!(judge(&earlier, &with(limits.min, limits.median)), Verdict::Fine(limits));
    let (low_min, low_median) = (limits.min - 0.01, limits.median - 0.01);
    assert_eq!(judge(&earlier, &with(low_min, 10.5)), Verdict::Fine(limits), "min alone");
    assert_eq!(judge(&earlier, &with(11.0, low_median)), Verdict::Fine(limits), "median alone");
    assert_eq!(judge(&earlier, &with(low_min, low_median)), Verdict::Worse(limits));
}

#[test]
fn the_margin_is_the_largest_spread_of_all_lines() {
    let found = with(9.2, 9.2);
    let noisy = |entry: &Entry| Entry { over_same_spread: 0.1, ..entry.clone() };
    let earlier = [with(10.0, 10.0), with(10.0, 10.0)];
    assert!(worse(&earlier, &found), "8% below, margin 3%");
    assert!(!worse(&earlier, &noisy(&found)), "its own spread is 10%");
    assert!(!worse(&[noisy(&earlier[0]), earlier[1].clone()], &found), "an earlier one's");
}

#[test]
fn noise_that_would_hide_a_loss_is_said() {
    let earlier = [with(10.0, 10.0), with(10.0, 10.0)];
    let loud = |spread| Entry { over_same_spread: spread, ..with(1.0, 1.0) };
    assert_eq!(judge(&earlier, &loud(0.26)), Verdict::TooNoisy(0.26));
    assert!(worse(&earlier, &loud(0.25)));
}

#[test]
fn only_the_last_five_lines_count() {
    let mut earlier = vec![with(5.0, 5.0)];
    earlier.extend(vec![with(10.0, 10.0); 4]);
    assert!(!worse(&earlier, &with(6.0, 6.0)), "the slow line is the fifth");
    earlier.push(with(10.0, 10.0));
    assert!(worse(&earlier, &with(6.0, 6.0)), "the slow line is the sixth");
}

#[test]
fn too_little_history_is_said() {
    let low = with(1.0, 1.0);
    assert_eq!(judge(&[], &low), Verdict::TooLittle(0));
    assert_eq!(judge(&[with(10.0, 10.0)], &low), Verdict::TooLittle(1));
    assert!(worse(&[with(10.0, 10.0), with(10.0, 10.0)], &low));
}

#[test]
fn another_machine_is_said_and_not_compared() {
    let low = with(1.0, 1.0);
    let fast = with(10.0, 10.0);
    let elsewhere = Entry { processor: "Another".into(), ..fast.clone() };
    let portable = Entry { isa: "portable".into(), ..fast.clone() };
    let others = [elsewhere, portable.clone(), portable];
    assert_eq!(judge(&others, &low), Verdict::OtherMachine);
    let mixed = [&others[..], &[fast]].concat();
    assert_eq!(judge(&mixed, &low), Verdict::TooLittle(1));
}

#[test]
fn other_work_is_not_compared() {
    let fast = with(10.0, 10.0);
    for other in [
        Entry { scene: "corridor".into(), ..fast.clone() },
        Entry { size: "640x360".into(), ..fast.clone() },
        Entry { depth: 6, ..fast.clone() },
        Entry { threads: 1, ..fast.clone() },
        Entry { rays: 1, ..fast.clone() },
    ] {
        let earlier = [other.clone(), other];
        assert_eq!(judge(&earlier, &with(1.0, 1.0)), Verdict::TooLittle(0), "{earlier:?}");
    }
    let dated = Entry { date: "2025".into(), commit: "b".into(), rounds: 9, ..fast };
    assert!(worse(&[dated.clone(), dated], &with(1.0, 1.0)), "none of these is the work");
}

#[test]
fn the_last_line_of_each_scene_is_judged() {
    let other = |min| Entry { scene: "flake".into(), ..with(min, min) };
    let history = [
        with(10.0, 10.0),
        with(10.0, 10.0),
        other(4.0),
        with(1.0, 1.0),
        other(4.0),
        with(10.0, 10.0),
        other(1.0),
    ];
    let verdicts = judge_all(&history);
    let scenes: Vec<&str> = verdicts.iter().map(|(line, _)| line.scene.as_str()).collect();
    assert_eq!(scenes, ["workshop", "flake"]);
    assert!(matches!(verdicts[0].1, Verdict::Fine(_)), "the slow line is not the last");
    assert!(matches!(verdicts[1].1, Verdict::Worse(_)));
    assert!(judge_all(&[]).is_empty());
}
