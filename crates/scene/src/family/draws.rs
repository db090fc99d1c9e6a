//! Random numbers by a written rule.
//!
//! The generator is PCG XSL RR 128/64 (O'Neill, "PCG: A Family of Simple Fast
//! Space-Efficient Statistically Good Algorithms for Random Number Generation", 2014), its
//! state begun with the seed, on one fixed stream. Each method says how many numbers it
//! draws and what it makes of them, so that no release of a library changes a scene.

use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

/// The stream: any constant, never to be changed.
const STREAM: u128 = 0x0ca7_0b71c;

/// Bits that decide one [`Draws::log_between`].
const HALVINGS: u32 = 32;

/// A sequence of random numbers.
pub struct Draws(Pcg64);

impl Draws {
    /// The sequence of a seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(Pcg64::new(u128::from(seed), STREAM))
    }

    /// A number in [0, 1): the top 53 bits of one draw, times 2^-53.
    pub fn unit(&mut self) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "53 bits are exact in f64")]
        let integer = (self.0.next_u64() >> 11) as f64;
        integer * (1.0 / (1_u64 << 53) as f64)
    }

    /// A uniform number from `least` to `most`, from one [`Self::unit`]; rounding may step past
    /// `most` by its last bit.
    pub fn between(&mut self, least: f64, most: f64) -> f64 {
        least + (most - least) * self.unit()
    }

    /// A whole number below `n`, from one draw: the high 64 bits of draw times n. Its bias
    /// is below n/2^64.
    pub fn below(&mut self, n: u64) -> u64 {
        let product = u128::from(self.0.next_u64()) * u128::from(n);
        u64::try_from(product >> 64).expect("the high half of a product has 64 bits")
    }

    /// A log-uniform number in [least, most], both positive.
    ///
    /// One draw's highest 32 bits halve the range 32 times at its geometric mean, a set bit keeping
    /// the upper half. No logarithm is taken, since libm's differ between machines. Rounded means
    /// stay in the range, because rounding keeps order and the rounded root of a rounded square is
    /// its number.
    pub fn log_between(&mut self, least: f64, most: f64) -> f64 {
        let bits = self.0.next_u64();
        let (mut low, mut high) = (least, most);
        for halving in 0..HALVINGS {
            let mean = (low * high).sqrt();
            if bits >> (63 - halving) & 1 == 1 { low = mean } else { high = mean }
        }
        (low * high).sqrt()
    }
}
