//! The date and the processor's name.

use std::time::{Duration, UNIX_EPOCH};

use catoptric_report::occasion::{iso8601, model_in};

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
        assert_eq!(iso8601(UNIX_EPOCH + Duration::from_secs(seconds)), date);
    }
}

#[test]
fn the_processor_is_the_first_that_is_named() {
    let text = "processor\t: 0\nmodel\t\t: 2\nmodel name\t: Maker(R), M 9 @ 3GHz\n\
                processor\t: 1\nmodel name\t: Another\n";
    assert_eq!(model_in(text).as_deref(), Some("Maker(R), M 9 @ 3GHz"));
    assert_eq!(model_in("model name\t:\n"), None);
    assert_eq!(model_in("Hardware : board\n"), None);
}
