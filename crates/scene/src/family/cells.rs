//! Spheres that cannot meet: each keeps to a cell of its own.

use super::draws::Draws;

/// A cube about the origin, cut into equal cubic cells, as few as give each sphere its own.
pub(super) struct Cells {
    /// Cells along one edge.
    per_edge: u32,
    /// Edge of a cell.
    cell: f64,
}

impl Cells {
    /// Makes cells of edge `cell`, at least `n` in all and at least one.
    pub(super) fn of_edge(n: u32, cell: f64) -> Self {
        Self { per_edge: edge(n), cell }
    }

    /// Cuts a cube of edge `cube` into at least `n` cells.
    pub(super) fn of_cube(n: u32, cube: f64) -> Self {
        let per_edge = edge(n);
        Self { per_edge, cell: cube / f64::from(per_edge) }
    }

    /// Edge of a cell.
    pub(super) fn cell(&self) -> f64 {
        self.cell
    }

    /// Half the edge of the whole cube.
    pub(super) fn half(&self) -> f64 {
        self.cell * f64::from(self.per_edge) / 2.0
    }

    /// Chooses `n` of the cells by chance, all choices alike; gives their lowest corners.
    ///
    /// Order: by z, then y, then x; one draw a cell.
    /// Source: selection sampling (Knuth, The Art of Computer Programming 3.4.2, algorithm S).
    pub(super) fn choose(&self, n: u32, draws: &mut Draws) -> Vec<[f64; 3]> {
        let all = u64::from(self.per_edge).pow(3);
        let mut wanted = u64::from(n);
        let mut chosen = Vec::with_capacity(n as usize);
        for cell in 0..all {
            if draws.below(all - cell) < wanted {
                wanted -= 1;
                chosen.push(self.corner(cell));
            }
        }
        chosen
    }

    /// A place for a sphere's centre in a cell: the sphere stays off the cell's walls by a
    /// share of the edge that no rounding can use up. Three draws.
    ///
    /// `radius` is at most [`Self::MOST_RADIUS`] cells.
    pub(super) fn place(&self, corner: [f64; 3], radius: f64, draws: &mut Draws) -> [f64; 3] {
        let margin = self.cell * (0.5 - Self::MOST_RADIUS);
        let free = self.cell - 2.0 * (radius + margin);
        corner.map(|at| at + margin + radius + free * draws.unit())
    }

    /// Radius of the largest sphere that a cell takes, in cells.
    pub(super) const MOST_RADIUS: f64 = 0.4;

    fn corner(&self, cell: u64) -> [f64; 3] {
        let edge = u64::from(self.per_edge);
        let half = self.half();
        #[expect(clippy::cast_precision_loss, reason = "at most a few hundred")]
        [cell % edge, cell / edge % edge, cell / edge / edge]
            .map(|step| self.cell * step as f64 - half)
    }
}

/// The smallest number, from 1, whose cube is at least `n`.
fn edge(n: u32) -> u32 {
    (1..).find(|m: &u32| u64::from(*m).pow(3) >= u64::from(n)).expect("u32::MAX cubed is more")
}
