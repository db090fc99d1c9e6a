//! What every case is held to: the one table. Cases that measure the same stand together, with
//! the bound's source and reason; each has its bound for each formula, and the formulas that are
//! known to fail it.
//!
//! Where the unit is the u of the formula's own arithmetic, 2^-24 in f32 and 2^-53 in f64, one
//! number serves all three: constants rounded to f32 would put f64 at 5e8 of its own. Elsewhere
//! f64 has a bound of its own.

use crate::formula::Formula;

/// Cases that measure the same quantity.
#[derive(Debug)]
pub struct Group {
    /// What is measured, with its unit.
    pub quantity: &'static str,
    /// The source of the bound.
    pub source: &'static str,
    /// One sentence: why the bound is this one.
    pub why: &'static str,
    /// The cases.
    pub cases: &'static [Case],
}

/// A case, and what it is held to. Formulas in the order of [`Formula::ALL`].
#[derive(Debug)]
pub struct Case {
    /// The case's name.
    pub name: &'static str,
    /// The largest value that holds, by formula.
    pub most: [f64; 3],
    /// Why a formula fails, if it is known to, by formula.
    pub known: [Option<&'static str>; 3],
}

impl Case {
    /// The bound of a formula, and why it is known to fail. A case that asks no formula has the
    /// bound of robust f32.
    #[must_use]
    pub fn of(&self, formula: Option<Formula>) -> (f64, Option<&'static str>) {
        let which = |formula| Formula::ALL.iter().position(|other| *other == formula);
        match formula.and_then(which) {
            Some(index) => (self.most[index], self.known[index]),
            None => (self.most[1], None),
        }
    }

    /// Textbook f32 fails it.
    const fn textbook(mut self, why: &'static str) -> Self {
        self.known[0] = Some(why);
        self
    }

    /// Robust f32 fails it.
    const fn robust(mut self, why: &'static str) -> Self {
        self.known[1] = Some(why);
        self
    }

    /// Robust f64 fails it.
    const fn double(mut self, why: &'static str) -> Self {
        self.known[2] = Some(why);
        self
    }
}

/// One bound for all formulas, or for robust f64 another.
const fn all(name: &'static str, most: f64) -> Case {
    each(name, most, most)
}

const fn each(name: &'static str, f32: f64, f64: f64) -> Case {
    Case { name, most: [f32, f32, f64], known: [None; 3] }
}

/// All, in the order of the report.
pub const GROUPS: &[Group] = &[
    Group {
        quantity: "pixels off by more than one 8-bit level",
        source: "promised of the robust formulas",
        why: "Nobody can see an error of one level; rounding must cost no more.",
        cases: &[
            all("workshop, levels", 0.0).textbook(OFFSET_OF_ONE),
            all("workshop mirror, levels", 0.0).textbook(OFFSET_OF_ONE),
            all("workshop turned, levels", 0.0).textbook(OFFSET_OF_ONE),
            all("unseen ball, levels", 0.0).textbook(CANCELS),
            all("far things, levels", 0.0).textbook(OFFSET_OF_ONE),
            all("far oblique, levels", 0.0).textbook(CANCELS),
            all("far small, levels", 0.0).textbook(CANCELS),
        ],
    },
    Group {
        quantity: "ratio of error to max(spread, floor), by the eye ray",
        source: "backward.rs",
        why: "The picture is that of eye rays moved by up to 4 u of its own arithmetic.",
        cases: &[
            all("workshop, backward", 4.0).textbook(OFFSET_OF_ONE),
            all("workshop mirror, backward", 4.0).textbook(OFFSET_OF_ONE),
            all("workshop turned, backward", 4.0).textbook(OFFSET_OF_ONE),
            all("pair 2.01, by eye", 4.0).textbook(OFFSET),
            all("pair 2.5, by eye", 4.0).textbook(OFFSET),
            all("pair 6, by eye", 4.0),
            all("pair 10, by eye", 4.0),
            all("three-sphere scatterer, by eye", 4.0).textbook(OFFSET),
            all("kissing spheres, by eye", 4.0).textbook(OFFSET),
            all("closed room, by eye", 4.0).textbook(INSIDE).robust(EDGES).double(EDGES),
            all("corridor 1e6, by eye", 4.0).textbook(CANCELS),
            all("corridor 1e9, by eye", 4.0).textbook(CANCELS),
        ],
    },
    Group {
        quantity: "ratio of error to max(spread, floor), by all input: 64 scenes moved by 4 u",
        source: "backward.rs",
        why: "Mirrors amplify what eye ray and scene were rounded by; the formulas must not add to it.",
        cases: &[
            all("pair 2.01, by input", 4.0).textbook(OFFSET),
            all("pair 2.5, by input", 4.0).textbook(OFFSET),
            all("pair 6, by input", 4.0),
            all("pair 10, by input", 4.0),
            all("three-sphere scatterer, by input", 4.0).textbook(OFFSET),
            all("kissing spheres, by input", 4.0).textbook(OFFSET),
            all("closed room, by input", 4.0).textbook(INSIDE),
            all("corridor 1e6, by input", 4.0).textbook(CANCELS),
            all("corridor 1e9, by input", 4.0).textbook(CANCELS),
            all("unseen ball, by input", 4.0).textbook(CANCELS),
            all("far things, by input", 4.0).textbook(OFFSET_OF_ONE),
            all("far oblique, by input", 4.0).textbook(CANCELS),
            all("far small, by input", 4.0).textbook(CANCELS),
        ],
    },
    Group {
        quantity: "the floor over what 4 u of the eye ray move: the median pixel, among kissing spheres and in the room the 99th percentile",
        source: "so that no case passes for want of anything to amplify",
        why: "Where truth does not move by many floors, a small ratio says nothing of mirrors.",
        cases: &[
            all("pair 2.01, stiff", 0.1),
            all("pair 2.5, stiff", 0.1),
            all("pair 6, stiff", 0.1),
            all("pair 10, stiff", 0.1),
            all("three-sphere scatterer, stiff", 0.1),
            all("kissing spheres, stiff", 0.1),
            all("closed room, stiff", 0.1),
        ],
    },
    Group {
        quantity: "4 over the ratio by all input of a picture of another scene, one thing moved by 1000 u",
        source: "so that the criterion is one",
        why: "A picture of a scene that is not the stated one must not pass.",
        cases: &[
            all("workshop, another", 1.0),
            all("pair 6, another", 1.0),
            all("kissing spheres, another", 1.0),
            all("closed room, another", 1.0),
        ],
    },
    Group {
        quantity: "|t error| times the cosine, in u of the ray's coordinates",
        source: "roundings in reference/src/flat.rs",
        why: "Gradient 2, height 5, product, root, quotient and the length of d: a dozen roundings of numbers of that size.",
        cases: &[
            all("ground, generic origins", 12.0).textbook(CANCELS),
            all("ground, near-surface origins", 12.0).textbook(CANCELS),
        ],
    },
    Group {
        quantity: "distance of the point found from the sphere, relative to how far the ray's start and its hit are from the eye",
        source: "promised of the robust formulas",
        why: "The height function has no number of the radius' size in it: 84 u, in f64 as many.",
        cases: &[each("radii to 1e12", 5e-6, 9.3e-15).textbook(CANCELS)],
    },
    Group {
        quantity: "largest distance from the rim at a wrong decision, in u of the ball's distance",
        source: "roundings of the ray and the centre",
        why: "Direction and centre are themselves rounded by about u of the distance, each in three coordinates.",
        cases: &[
            all("tiny far, r 1e-3", 4.0).textbook(CANCELS),
            all("tiny far, r 1", 4.0).textbook(CANCELS),
            all("grazing, rim", 4.0),
        ],
    },
    Group {
        quantity: "|t error| times the cosine, in u of the ball's distance",
        source: "first-order error of b - s",
        why: "The rim's error over the cosine is what no formula can avoid.",
        cases: &[all("grazing, distance", 4.0).textbook(CANCELS)],
    },
    Group {
        quantity: "rays that miss the second ball, or meet it elsewhere than they must",
        source: "a ray that leaves a convex surface never meets it again",
        why: "With the sphere just left skipped, a contact needs no luck; rays within 8 roundings of the rim are not asked.",
        cases: &[all("pairs, second hit", 0.0).textbook(TUNNELS)],
    },
    Group {
        quantity: "share of pixels lit or dark against truth",
        source: "stability suite: one pixel of 76 800 on an edge",
        why: "Of 1 400 pixels on edges, each decided to 1e-4 of its width, one may fall either way; in f64 none.",
        cases: &[each("contact shadows", 2e-5, 0.0).textbook(OFFSET_OF_ONE)],
    },
    Group {
        quantity: "rays from a sphere, outwards, that meet it or are shadowed by it",
        source: "a ray that leaves a convex surface never meets it again",
        why: "A line that leaves a ball outwards does not meet it again.",
        cases: &[all("own sphere met again", 0.0).textbook(OWN_SPHERE)],
    },
    Group {
        quantity: "largest difference of a channel from the picture at the origin",
        source: "promised of the robust formulas",
        why: "Compilation puts the eye at the origin before it rounds. The moved scene is stated in f64, which at 1e6 rounds by 1e-10, and f64 sees that, amplified: ten times what is measured.",
        cases: &[
            each("moved by 1e2", 5e-4, 1e-9),
            each("moved by 1e4", 5e-4, 1e-7),
            each("moved by 1e6", 5e-4, 1e-5),
        ],
    },
    Group {
        quantity: "pixels with other bits",
        source: "promised of the robust formulas",
        why: "A power of two changes exponents only.",
        cases: &[all("scaled by powers of two", 0.0)],
    },
    Group {
        quantity: "pixels with other bits",
        source: "promised of every formula",
        why: "Compiled in the camera's own axes, a scene has no place and no orientation in the world.",
        cases: &[all("turned, stated exactly", 0.0), all("turned and moved, stated exactly", 0.0)],
    },
    Group {
        quantity: "pixels with other bits than without the thing that no ray meets",
        source: "promised of every formula",
        why: "A primitive's form depends on that primitive and the eye alone.",
        cases: &[all("unseen things", 0.0).textbook(INSIDE)],
    },
    Group {
        quantity: "pixels with other bits than without the second statement",
        source: "scene format: the lowest index is seen",
        why: "The second statement of a surface is never seen.",
        cases: &[all("coincident surfaces", 0.0)],
    },
    Group {
        quantity: "rays that escape from a closed room",
        source: "promised of the robust formulas",
        why: "A ray inside a closed mirror always meets it.",
        cases: &[
            all("leaks, depth 1000", 0.0).textbook(INSIDE),
            all("leaks, depth 100 000", 0.0).textbook(INSIDE),
            all("leaks, depth 1 000 000", 0.0).textbook(INSIDE),
            all("leaks among balls, depth 10 000", 0.0).textbook(INSIDE),
        ],
    },
    Group {
        quantity: "largest distance from the sphere over its radius",
        source: "roundings in reference/src/ball.rs",
        why: "The point is put back on the ball at each reflection, so nothing adds up: 17 u of coordinates up to twice the radius, in f64 as many.",
        cases: &[
            each("drift, eye near the middle", 1e-6, 1.9e-15).textbook(INSIDE),
            each("drift, eye near the wall", 1e-6, 1.9e-15).textbook(INSIDE),
        ],
    },
    Group {
        quantity: "largest relative error of a channel",
        source: "promised of the robust formulas",
        why: "L (d + 1), or L (1 - k^1001)/(1 - k): a sum of 1001 roundings is 1e-5 off, and so is k, rounded to f32; f64 has 2^29 as many digits more.",
        cases: &[
            each("closed form, k 1", 1e-4, 1e-12).textbook(INSIDE),
            each("closed form, k 0.999", 1e-4, 1e-12).textbook(INSIDE),
        ],
    },
    Group {
        quantity: "inputs not refused by an error that names their key",
        source: "scene format",
        why: "What cannot be rendered is refused by name.",
        cases: &[all("refusals", 0.0)],
    },
    Group {
        quantity: "pixels off truth by more than an 8-bit level, in f64 by more than 1e-9, or not finite, or not in [0, B]",
        source: "truth; light.rs",
        why: "The ends of ranges are pictures like any other.",
        cases: &[
            all("eye at the centre", 0.0).textbook(INSIDE),
            all("eye inside", 0.0).textbook(INSIDE),
            all("eye close below the surface", 0.0).textbook(INSIDE),
            all("eye on the surface, outwards", 0.0).textbook(ON_IT),
            all("eye on the surface, inwards", 0.0).textbook(INSIDE),
            all("lamp inside a ball", 0.0),
            all("lamp on a ball", 0.0).textbook(LAMP),
            all("lamp at the hit point", 0.0).textbook(LAMP),
            all("lamp at the eye", 0.0),
            all("depth 0", 0.0),
            all("depth 1", 0.0),
            all("depth 1 000 000", 0.0).textbook(OFFSET_OF_ONE),
            all("no spheres", 0.0),
            all("no lights", 0.0),
            all("no mirrors", 0.0),
            all("k just below 1", 0.0).textbook(INSIDE),
        ],
    },
    Group {
        quantity: "scenes with NaN or an infinity in the picture",
        source: "promised of every input",
        why: "What is accepted gives a finite picture.",
        cases: &[all("extreme, not finite", 0.0)],
    },
    Group {
        quantity: "scenes with a pixel that is not in [0, B]",
        source: "light.rs",
        why: "No light comes from nowhere; 1e-5 above B is left for the rounding of sums.",
        cases: &[all("extreme, not in [0, B]", 0.0)],
    },
    Group {
        quantity: "scenes on which packets and recursion differ in a bit or a count",
        source: "crates/README.md: there is no tolerance",
        why: "The engine's picture is the recursion's.",
        cases: &[all("extreme, engines differ", 0.0)],
    },
    Group {
        quantity: "scenes that panic or are refused without a key",
        source: "promised of every input",
        why: "Every scene is refused by name or rendered.",
        cases: &[all("extreme, panics", 0.0)],
    },
];

// Why formulas are known to fail.
const OFFSET_OF_ONE: &str = "Rays start (p - c)·1e-4 off the surface, which is 1.0 on the ground: shadows and contacts shift.";
const OFFSET: &str = "Rays start (p - c)·1e-4 off the surface, far more than rounding is.";
const CANCELS: &str =
    "b^2 - 4ac cancels: of 24 bits half are left, and |c|^2 - r^2 is formed from rounded squares.";
const TUNNELS: &str = "The offset starts rays inside a ball that touches; they meet its far side.";
const OWN_SPHERE: &str =
    "The offset, 1e-4 of the radius, is less than the rounding of a place three units away.";
const INSIDE: &str = "The normal is not turned to an eye inside a sphere, and rays leave the room.";
const ON_IT: &str = "Whether an eye on a ball meets it is decided by the rounding of |c|^2 - r^2.";
const LAMP: &str = "A lamp on a surface is hidden or not by the rounding of its distance.";
const EDGES: &str = "A few paths meet an edge after dozens of reflections, each of which rounds anew: together they lead to edges that 4 u at the start do not reach.";
