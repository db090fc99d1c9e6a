//! How many reflections a cut by weight leaves.
//!
//! A path's weight is a product of mirror factors, rounded each time. Rounding is monotone: no
//! weight is larger than that of as many reflections by the strongest mirror, factor k.
//!
//! The first [`EXACT`] of those are formed as a path forms them. Where none is below the cut, more
//! would take longer than small pictures do, and a bound follows. As long as a weight is not below
//! a cut that is a normal number, no product was subnormal, and each was rounded up by at most
//! 2^-24 of itself: the weight of m reflections is at most (k (1 + 2^-24))^m. Here that power is
//! formed in f64, with 2^-23 in place of 2^-24, by the squares of its base. They and their products
//! round down fewer than 2m times, each time by at most 2^-53 of themselves, which is less than
//! what the base is larger by. A square that falls below the normal numbers is below the cut as it
//! is in the reals.

use catoptric_scene::Scalar;

/// Limit on the weights that are formed.
const EXACT: u32 = 1 << 12;

/// How many reflections by a mirror of factor k keep a weight that is not cut, at most `most`.
/// Exactly, where they are fewer than 4096; otherwise there may be fewer, and are not more.
pub(crate) fn reflections_above<S: Scalar>(min_weight: S, k: S, most: u32) -> u32 {
    reflections_by(|weight| weight * k, min_weight, k, most)
}

/// [`reflections_above`], with the weight after one more reflection.
fn reflections_by<S: Scalar>(
    mut times_k: impl FnMut(S) -> S,
    min_weight: S,
    k: S,
    most: u32,
) -> u32 {
    // Factors are not negative, so without a cut no weight is below it.
    if min_weight <= S::ZERO {
        return most;
    }
    let mut weight = S::rounded(1.0);
    for depth in 0..if most < EXACT { most } else { EXACT } {
        weight = times_k(weight);
        if weight < min_weight {
            return depth;
        }
    }
    let bound = if min_weight < S::MIN_POSITIVE { most } else { bound(min_weight, k) };
    if bound < most { bound } else { most }
}

/// No more reflections than that keep a weight that is not below the cut.
fn bound<S: Scalar>(min_weight: S, k: S) -> u32 {
    let (base, cut) = (k.to_f64() * (1.0 + f64::from(f32::EPSILON)), min_weight.to_f64());
    let mut squares = [base; u32::BITS as usize];
    for bit in 1..squares.len() {
        squares[bit] = squares[bit - 1] * squares[bit - 1];
    }
    // The most reflections whose power is not below the cut, from the highest bit down. With one
    // more it was found to be: at the lowest bit that is not set.
    let (mut power, mut reflections) = (1.0, 0);
    for (bit, square) in squares.into_iter().enumerate().rev() {
        if power * square >= cut {
            power *= square;
            reflections |= 1 << bit;
        }
    }
    reflections
}

#[cfg(test)]
mod tests {
    use catoptric_scene::Scalar;

    use super::{EXACT, reflections_above, reflections_by};

    /// All weights, one after another.
    fn all_weights<S: Scalar>(min_weight: S, k: S, most: u32) -> u32 {
        let mut weight = S::rounded(1.0);
        (0..most)
            .find(|_| {
                weight = weight * k;
                weight < min_weight
            })
            .unwrap_or(most)
    }

    fn check<S: Scalar + std::fmt::Display>() {
        for k in [0.0, 1e-30, 0.3, 0.5, 0.9, 0.99, 0.998, 0.9995, 0.99999, 0.999_999, 1.0] {
            for cut in [0.0, 1e-45, 1e-38, 1e-20, 1e-3, 0.004, 0.5, 0.99, 1.0, 1.5] {
                let (cut, k) = (S::rounded(cut), S::rounded(k));
                for most in [0, 1, 7, 4096, 4097, 30_000, 2_000_000] {
                    let exact = all_weights(cut, k, most);
                    let found = reflections_above(cut, k, most);
                    let most_apart = match exact {
                        _ if exact < EXACT || exact == most => 0,
                        _ if cut < S::MIN_POSITIVE => most,
                        _ => exact / 5,
                    };
                    assert!(
                        exact <= found && found - exact <= most_apart && found <= most,
                        "factor {k}, cut {cut}, most {most}: {found} reflections, {exact} in truth"
                    );
                }
            }
        }
    }

    /// However deep paths may go.
    #[test]
    fn few_weights_are_formed() {
        for (cut, k, most) in [
            (0.0, 0.5, 0),
            (0.0, 1.0, 0),
            (0.25, 0.5, 3),
            (1e-3, 0.999_999, 4096),
            (1.0, 1.0, 4096),
        ] {
            let mut formed = 0;
            let times_k = |weight: f32| {
                formed += 1;
                weight * k
            };
            reflections_by(times_k, cut, k, u32::MAX);
            assert!(formed <= most, "factor {k}, cut {cut}: {formed} weights");
        }
    }

    #[test]
    fn no_path_has_more_reflections() {
        check::<f32>();
        check::<f64>();
    }
}
