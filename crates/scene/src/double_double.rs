//! Double-double arithmetic: an unevaluated sum of two f64, about 106 bits.
//!
//! Built from error-free transforms (Knuth 1969 for the sum, Dekker 1971 for the split and
//! the product); the composed operations follow Joldes, Muller and Popescu, "Tight and
//! rigorous error bounds for basic building blocks of double-word arithmetic", ACM TOMS
//! 44(2), 2017, whose algorithm numbers stand at each operation. With u = 2^-53 the
//! relative errors are at most: sum 3u^2 + 13u^3, product 7u^2 (with split in place of a
//! fused product, barring underflow), quotient 15u^2 + 56u^3. The root is within 4u^2.
//!
//! Edge: an overflow or a NaN in any operand gives a result whose high part is infinite or
//! NaN; products whose low part falls below 1e-290 lose it.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number held as `hi + lo` with |lo| at most half an ulp of `hi`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DoubleDouble {
    hi: f64,
    lo: f64,
}

/// Sum and error: a + b = s + e exactly (Knuth; any order of magnitude).
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let from_b = s - a;
    let from_a = s - from_b;
    (s, (a - from_a) + (b - from_b))
}

/// Sum and error: a + b = s + e exactly where |a| >= |b| (Dekker).
fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    (s, b - (s - a))
}

/// Product and error: a · b = p + e exactly, barring overflow and underflow (Dekker's product).
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let p = a * b;
    let (ah, al) = split(a);
    let (bh, bl) = split(b);
    (p, ((ah * bh - p) + ah * bl + al * bh) + al * bl)
}

/// Splits a number into its upper 26 and lower 27 bits (Veltkamp).
fn split(a: f64) -> (f64, f64) {
    const SPLITTER: f64 = 134_217_729.0; // 2^27 + 1
    let c = SPLITTER * a;
    let hi = c - (c - a);
    (hi, a - hi)
}

impl DoubleDouble {
    /// The nearest f64.
    #[must_use]
    pub fn to_f64(self) -> f64 {
        self.hi
    }

    /// The low part, which `to_f64` leaves out.
    #[must_use]
    pub fn low(self) -> f64 {
        self.lo
    }

    /// The nearest f32, for numbers in f32's range. Rounded once: where the high part lies in the
    /// middle between two f32, the low part decides.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "this is the rounding")]
    pub fn to_f32(self) -> f32 {
        let nearest = self.hi as f32;
        let rest = self.hi - f64::from(nearest);
        // The low part can change the answer only where the high part is a tie.
        let neighbour = if rest > 0.0 { nearest.next_up() } else { nearest.next_down() };
        let half = (f64::from(neighbour) - f64::from(nearest)) / 2.0;
        let tie = rest != 0.0 && rest == half;
        // The cast took the even neighbour; the low part may point to the other one.
        if tie && self.lo != 0.0 && (self.lo > 0.0) == (rest > 0.0) { neighbour } else { nearest }
    }

    /// The difference a - b, exact.
    #[must_use]
    pub fn difference(a: f64, b: f64) -> Self {
        let (hi, lo) = two_sum(a, -b);
        Self { hi, lo }
    }

    /// Rounds to a grid of 2^-96 times the largest power of two that is at most |length|.
    ///
    /// Error: less than one step of the grid; numbers far below a step become 0. A high part in the
    /// middle between two f64 becomes the even one.
    #[must_use]
    pub fn on_grid_of(self, length: f64) -> Self {
        const STEP: f64 = 1.0 / (1_u128 << 96) as f64;
        const NO_ROOM: f64 = 1.5 * (1_u64 << 52) as f64;
        let power = f64::from_bits(length.to_bits() & f64::INFINITY.to_bits());
        // Adding this number leaves no bits for parts of a step, so the sum is on the grid. A high
        // part that is not far below it is on the grid as it is.
        let beside = power * STEP * NO_ROOM;
        let rounded = |x: f64| if x.abs() < beside / 3.0 { (x + beside) - beside } else { x };
        let (hi, lo) = fast_two_sum(rounded(self.hi), rounded(self.lo));
        Self { hi, lo }
    }

    /// The square root; NaN for a negative number, 0 for 0.
    ///
    /// Takes one Newton step on the f64 root, whose residual is formed exactly.
    #[must_use]
    pub fn sqrt(self) -> Self {
        if self.hi <= 0.0 || !self.hi.is_finite() {
            return Self::from(self.hi.sqrt());
        }
        let root = self.hi.sqrt();
        let (square, error) = two_product(root, root);
        let residual = ((self.hi - square) - error) + self.lo;
        let (hi, lo) = fast_two_sum(root, residual / (2.0 * root));
        Self { hi, lo }
    }
}

impl From<f64> for DoubleDouble {
    fn from(hi: f64) -> Self {
        Self { hi, lo: 0.0 }
    }
}

impl Neg for DoubleDouble {
    type Output = Self;

    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    /// Sum: algorithm 6 (AccurateDWPlusDW).
    fn add(self, other: Self) -> Self {
        let (sh, sl) = two_sum(self.hi, other.hi);
        let (th, tl) = two_sum(self.lo, other.lo);
        let (vh, vl) = fast_two_sum(sh, sl + th);
        let (hi, lo) = fast_two_sum(vh, tl + vl);
        Self { hi, lo }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    /// Product: algorithm 10 (DWTimesDW1).
    fn mul(self, other: Self) -> Self {
        let (ph, pl) = two_product(self.hi, other.hi);
        let (hi, lo) = fast_two_sum(ph, pl + (self.hi * other.lo + self.lo * other.hi));
        Self { hi, lo }
    }
}

impl Div for DoubleDouble {
    type Output = Self;

    /// Quotient: algorithm 17 (DWDivDW2).
    fn div(self, other: Self) -> Self {
        let quotient = self.hi / other.hi;
        let back = other * Self::from(quotient);
        let rest = (self.hi - back.hi) + (self.lo - back.lo);
        let (hi, lo) = fast_two_sum(quotient, rest / other.hi);
        Self { hi, lo }
    }
}

impl PartialOrd for DoubleDouble {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        match self.hi.partial_cmp(&other.hi) {
            Some(Ordering::Equal) => self.lo.partial_cmp(&other.lo),
            order => order,
        }
    }
}
