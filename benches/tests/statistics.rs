//! Order statistics.

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
