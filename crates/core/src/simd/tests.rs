//! Every operation of the lanes, on every instruction set, beside the same on scalars.

mod bytes;
mod lanes;
mod masks;
mod power;
mod vec3;

use super::lanes::LANES;
use super::numbers::{Numbers, TestScalar};

/// Eight pairs of numbers, and a mask.
struct Operands<S> {
    a: [S; LANES],
    b: [S; LANES],
    mask: [S; LANES],
}

/// Every pair of edges, and as many pairs of any numbers.
fn operands<S: TestScalar>() -> Vec<Operands<S>> {
    let mut numbers = Numbers::new(1);
    let edges = S::edges();
    let pairs = edges.len() * edges.len();
    let mut all = Vec::new();
    for start in (0..pairs).step_by(LANES) {
        let pair = |lane| (start + lane) % pairs;
        let a = std::array::from_fn(|lane| edges[pair(lane) / edges.len()]);
        let b = std::array::from_fn(|lane| edges[pair(lane) % edges.len()]);
        all.push(Operands { a, b, mask: numbers.mask() });
        let (a, b, mask) = (numbers.eight(), numbers.eight(), numbers.mask());
        all.push(Operands { a, b, mask });
    }
    all
}

/// What one operation gives in eight lanes, by its name.
type Named<S> = (&'static str, [S; LANES]);

/// Compares the results of lanes with those of a lane's scalars. `exact`: NaN too has to have the
/// same bits, as where bits are only chosen or moved.
fn compare<S: TestScalar, const N: usize>(
    found: [Named<S>; N],
    plain: impl Fn(usize) -> [(&'static str, S); N],
    exact: bool,
    context: &dyn Fn(usize) -> String,
) {
    for lane in 0..LANES {
        for ((operation, found), (name, expected)) in found.iter().zip(plain(lane)) {
            assert_eq!(*operation, name, "the tables have one order");
            let found = found[lane];
            let same = found.pattern() == expected.pattern() || !exact && found.is(expected);
            assert!(
                same,
                "{operation}, lane {lane}, {}: {found:?} ({:#x}), not {expected:?} ({:#x})",
                context(lane),
                found.pattern(),
                expected.pattern()
            );
        }
    }
}
