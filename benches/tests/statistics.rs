//! Order statistics, the date, the processor's name.

use catoptric_benches::history::date::iso8601;
use catoptric_benches::history::processor::named_in;
use catoptric_benches::history::spread::{least, median, quantile, relative_spread};

#[test]
fn quantiles_are_linear_between_neighbours() {
    assert_eq!(median(&[3.0, 1.0, 2.0]), 2.0);
    assert_eq!(median(&[4.0, 1.0, 2.0, 3.0]), 2.5);
    assert_eq!(quantile(&[10.0, 20.0, 30.0, 40.0], 0.25), 17.5);
    assert_eq!(quantile(&[10.0, 20.0], 1.0), 20.0);
    assert_eq!(quantile(&[7.0], 0.75), 7.0);
    assert_eq!(relative_spread(&[1.0, 2.0, 3.0, 4.0, 5.0]), 2.0 / 3.0);
    assert_eq!(relative_spread(&[2.0; 4]), 0.0);
    assert_eq!(least(&[3.0, 1.0, 2.0]), 1.0);
}

#[test]
fn dates_are_those_of_the_calendar() {
    for (seconds, date) in [
        (0, "1970-01-01T00:00:00Z"),
        (86_399, "1970-01-01T23:59:59Z"),
        (951_782_400, "2000-02-29T00:00:00Z"),
        (1_000_000_000, "2001-09-09T01:46:40Z"),
        (1_709_251_199, "2024-02-29T23:59:59Z"),
        (1_735_689_599, "2024-12-31T23:59:59Z"),
        (4_107_542_400, "2100-03-01T00:00:00Z"),
    ] {
        assert_eq!(iso8601(seconds), date);
    }
}

#[test]
fn the_processor_is_the_first_that_is_named() {
    let text = "processor\t: 0\nmodel\t\t: 2\nmodel name\t: Maker(R), M 9 @ 3GHz\n\
                processor\t: 1\nmodel name\t: Another\n";
    assert_eq!(named_in(text).as_deref(), Some("Maker(R)  M 9 @ 3GHz"));
    assert_eq!(named_in("model name\t:\n"), None);
    assert_eq!(named_in("Hardware : board\n"), None);
}
