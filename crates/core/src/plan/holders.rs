//! Spheres that may hold others, by place.
//!
//! A sphere whose radius is in an octave, [2^e, 2^(e+1)), stands in the cell of its centre in a
//! grid of cells of side 2^(e+2). One that holds a sphere of radius r around c by a gap has its
//! centre within R - r - gap of c, where R is the largest radius of its octave, and that is less
//! than half a cell: it stands in one of at most two cells an axis, eight in all.
//!
//! Cells are found by a hash and not named: those of one hash, of any octave, are one chain. What
//! is in the wrong cell is compared as well, which changes nothing.
//!
//! The bound: a sphere that holds another has a radius above the gap, which is a share m of the
//! scene's extent, and below that extent, so there are at most 1 - log2 m octaves with an edge
//! between; a search looks up eight cells an octave and compares at most [`MOST_COMPARED`] spheres.

use glam::DVec3;

/// Limit on the spheres that are compared in a search. A search that has not found by then what
/// holds its sphere is in a crowd of spheres that overlap it and do not hold it.
pub(crate) const MOST_COMPARED: usize = 64;

/// Cells that a search looks up in an octave, at most.
#[cfg(test)]
pub(crate) const CELLS: usize = 8;

/// A centre and a radius.
pub(crate) type Bound = (DVec3, f64);

/// No sphere.
const NONE: u32 = u32::MAX;

/// Some of a list of spheres.
pub(crate) struct Holders<'a> {
    spheres: &'a [Bound],
    gap: f64,
    /// Falling in size.
    octaves: Vec<Octave>,
    /// The first sphere of each chain, by hash.
    chains: Vec<u32>,
    /// The sphere after each one.
    next: Vec<u32>,
}

/// The spheres whose radii have one exponent.
struct Octave {
    exponent: u64,
    side: f64,
    largest: f64,
}

impl<'a> Holders<'a> {
    /// None of the spheres, yet.
    pub(crate) fn new(spheres: &'a [Bound], gap: f64) -> Self {
        let chains = vec![NONE; spheres.len().next_power_of_two()];
        Self { spheres, gap, octaves: Vec::new(), chains, next: vec![NONE; spheres.len()] }
    }

    /// Adds the sphere of that number, no larger than those before it.
    pub(crate) fn add(&mut self, number: u32) {
        let (center, radius) = self.spheres[number as usize];
        let exponent = radius.to_bits() >> 52;
        if self.octaves.last().is_none_or(|octave| octave.exponent != exponent) {
            let side = 4.0 * f64::from_bits(exponent << 52);
            self.octaves.push(Octave { exponent, side, largest: radius });
        }
        let octave = self.octaves.last().expect("just made");
        let chain = self.chain(octave, (center / octave.side).floor());
        self.next[number as usize] = self.chains[chain];
        self.chains[chain] = number;
    }

    /// Whether one of those added `holds` a sphere. `step` is told of each cell that is looked up
    /// and of each sphere that is compared.
    pub(crate) fn any(
        &self,
        (center, radius): Bound,
        holds: impl Fn(Bound) -> bool,
        step: &mut impl FnMut(),
    ) -> bool {
        let mut compared = 0;
        for octave in &self.octaves {
            let within = octave.largest - radius - self.gap;
            if within <= 0.0 {
                break;
            }
            let first = ((center - within) / octave.side).floor();
            let last = ((center + within) / octave.side).floor();
            for corner in 0..8 {
                let beyond = |axis: usize| corner >> axis & 1 == 1;
                if (0..3).any(|axis| beyond(axis) && first[axis] == last[axis]) {
                    continue;
                }
                let cell: [_; 3] =
                    std::array::from_fn(|i| if beyond(i) { last[i] } else { first[i] });
                step();
                let mut number = self.chains[self.chain(octave, cell.into())];
                while number != NONE {
                    if compared == MOST_COMPARED {
                        return false;
                    }
                    compared += 1;
                    step();
                    if holds(self.spheres[number as usize]) {
                        return true;
                    }
                    number = self.next[number as usize];
                }
            }
        }
        false
    }

    /// The chain of a cell.
    fn chain(&self, octave: &Octave, cell: DVec3) -> usize {
        /// Odd, with bits all over.
        const SPREAD: u64 = 0x9E37_79B9_7F4A_7C15;
        let hash = cell.to_array().into_iter().fold(octave.exponent, |hash, x| {
            // Whole, and below 2^53: S is below 2^18 gaps, a side above two.
            #[expect(clippy::cast_possible_truncation, reason = "whole")]
            let x = (x as i64).cast_unsigned();
            (hash.rotate_left(23) ^ x).wrapping_mul(SPREAD)
        });
        (hash >> 32) as usize & (self.chains.len() - 1)
    }
}
