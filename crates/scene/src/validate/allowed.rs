//! What each key allows. Reading, validation, the command line and messages all use these, so
//! that they say the same; the literals are written once and make both the check and the words.

/// Numbers that a key allows.
#[derive(Debug)]
pub struct Allowed {
    least: f64,
    most: f64,
    /// The range of one number in words, to follow "allowed: ".
    pub text: &'static str,
}

impl Allowed {
    /// Whether a number is allowed; NaN never is.
    #[must_use]
    pub fn holds(&self, x: f64) -> bool {
        self.least <= x && x <= self.most
    }

    /// The greatest number that is allowed.
    pub(super) fn most(&self) -> f64 {
        self.most
    }
}

/// Makes a range of numbers with both ends, and why it ends there.
macro_rules! number {
    ($least:literal to $most:literal $($why:literal)?) => {
        Allowed {
            least: $least as f64,
            most: $most as f64,
            text: concat!(
                "a number from ", stringify!($least), " to ", stringify!($most) $(, $why)?
            ),
        }
    };
}

/// Makes a range of integers with both ends.
macro_rules! integer {
    ($least:literal to $most:literal) => {{
        const ENDS: [u32; 2] = [$least, $most];
        Allowed {
            least: ENDS[0] as f64,
            most: ENDS[1] as f64,
            text: concat!("an integer from ", stringify!($least), " to ", stringify!($most)),
        }
    }};
}

/// Makes a range of numbers from 0 to the largest f32; the literal must be that, read as f32.
macro_rules! largest {
    ($before:literal $most:literal $after:literal) => {{
        const MOST: f32 = $most;
        Allowed {
            least: 0.0,
            most: MOST as f64,
            text: concat!($before, stringify!($most), ", the largest of f32", $after),
        }
    }};
}

/// Columns and rows of the picture.
pub const SIDE: Allowed = integer!(1 to 65535);

/// The greatest depth of reflections: every u32.
pub const DEPTH: Allowed = integer!(0 to 4294967295);

/// Places. Squares of their differences stay far below the largest f32.
pub const COORDINATE: Allowed = number!(-1e15 to 1e15);

/// Radii. Their squares are normal in f32.
pub const RADIUS: Allowed = number!(1e-12 to 1e12);

/// Amounts of light, factors and exponents: what f32 can hold.
pub const AMOUNT: Allowed = largest!("a number from 0 to " 3.4028234e38 "");

/// Light that a pixel can show directly.
pub const LIGHT: Allowed =
    number!(0 to 1e20 ", so that no sum over reflections and samples overflows f32");

/// The part of the light that a mirror sends on.
pub const MIRROR: Allowed = number!(0 to 1);

/// The highlight's factor. Where the mirror's is not stated it is this one, which must then be in
/// [`MIRROR`] too.
pub const SPECULAR: Allowed = largest!(
    "a number from 0 to 1, or more where `reflect` is stated too, up to " 3.4028234e38
    " (without it, `specular` is also the mirror's factor)"
);

/// The vertical field of view: all f64 strictly between 0 and 180.
pub const FIELD_OF_VIEW: Allowed = Allowed {
    least: f64::from_bits(1),
    most: 180.0_f64.next_down(),
    text: "a number of degrees between 0 and 180, both excluded",
};

/// One component of a direction, whose length does not matter.
pub const COMPONENT: Allowed = Allowed { least: f64::MIN, most: f64::MAX, text: "a finite number" };
