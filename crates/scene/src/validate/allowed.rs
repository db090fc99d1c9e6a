//! What each key allows, as numbers and as words: reading, validation and messages all use
//! these, so that they say the same.

/// Numbers that a key allows.
#[derive(Debug)]
pub(crate) struct Allowed {
    least: f64,
    most: f64,
    /// Follows "allowed: ", for one number.
    pub(crate) text: &'static str,
}

impl Allowed {
    /// Whether that number is allowed; NaN never is.
    pub(crate) fn holds(&self, x: f64) -> bool {
        self.least <= x && x <= self.most
    }
}

/// Columns and rows of the picture.
pub(crate) const SIDE: Allowed =
    Allowed { least: 1.0, most: 65_535.0, text: "an integer from 1 to 65535" };

/// The greatest depth of reflections: every u32.
pub(crate) const DEPTH: Allowed =
    Allowed { least: 0.0, most: 4_294_967_295.0, text: "an integer from 0 to 4294967295" };

/// Places. Squares of their differences stay far below the largest f32.
pub(crate) const COORDINATE: Allowed =
    Allowed { least: -1e15, most: 1e15, text: "a number from -1e15 to 1e15" };

/// Radii. Their squares are normal in f32.
pub(crate) const RADIUS: Allowed =
    Allowed { least: 1e-12, most: 1e12, text: "a number from 1e-12 to 1e12" };

/// Amounts of light, factors and exponents: what f32 can hold.
pub(crate) const AMOUNT: Allowed = Allowed {
    least: 0.0,
    most: f32::MAX as f64,
    text: "a number from 0 to 3.4028234e38, the largest of f32",
};

/// Light that is seen as it is.
pub(crate) const LIGHT: Allowed = Allowed {
    least: 0.0,
    most: 1e20,
    text: "a number from 0 to 1e20, so that no sum over reflections and samples overflows f32",
};

/// The part of the light that a mirror sends on.
pub(crate) const MIRROR: Allowed = Allowed { least: 0.0, most: 1.0, text: "a number from 0 to 1" };

/// The vertical field of view: all f64 strictly between 0 and 180.
pub(crate) const FIELD_OF_VIEW: Allowed = Allowed {
    least: f64::from_bits(1),
    most: 180.0_f64.next_down(),
    text: "a number of degrees between 0 and 180, both excluded",
};

/// One component of a direction, whose length does not matter.
pub(crate) const COMPONENT: Allowed =
    Allowed { least: f64::MIN, most: f64::MAX, text: "a finite number" };
