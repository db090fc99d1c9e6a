//! Order statistics of the rounds.

/// The quantile at `share` of the way, between 0 and 1, through the sorted values.
///
/// Linear between neighbours: definition 7 of Hyndman and Fan, Sample Quantiles in
/// Statistical Packages, 1996; at 1/2 it is the usual median.
///
/// # Panics
/// If there is no value.
#[must_use]
pub fn quantile(values: &[f64], share: f64) -> f64 {
    assert!(!values.is_empty(), "a quantile of nothing");
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let place = share * (sorted.len() - 1) as f64;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "an index")]
    let below = place.floor() as usize;
    let above = if below + 1 < sorted.len() { below + 1 } else { below };
    sorted[below] + (place - below as f64) * (sorted[above] - sorted[below])
}

/// The least value; infinity for none.
#[must_use]
pub fn least(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::INFINITY, f64::min)
}

/// The median.
#[must_use]
pub fn median(values: &[f64]) -> f64 {
    quantile(values, 0.5)
}

/// The interquartile range divided by the median.
#[must_use]
pub fn relative_spread(values: &[f64]) -> f64 {
    (quantile(values, 0.75) - quantile(values, 0.25)) / median(values)
}
