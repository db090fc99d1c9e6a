//! How full eights of rays are, depth by depth.
//!
//! Both from the lengths of all paths alone. The engine packs the rays that go on from a depth
//! anew, so that in each of its tiles only the last packet of a depth is not full (`wave` in
//! catoptric-core); a test holds the tile's size that is stated here.

/// Rays of a packet.
const LANES: usize = 8;

/// Columns and rows of the engine's tiles.
const TILE: [usize; 2] = [32, 16];

/// Below that depth the engine's packets go on one by one, and lengths do not tell how full.
const BREADTH: usize = 1024;

/// How many rays each path of a picture has, row by row.
pub(super) struct Lengths {
    pub(super) width: usize,
    /// None is 0: there is an eye ray.
    pub(super) rays: Vec<usize>,
}

/// Rays, and the eights that hold them.
#[derive(Clone, Copy, Default)]
struct Held {
    rays: usize,
    eights: usize,
}

impl Lengths {
    /// Mean number of rays alive among eight neighbours in a row, by depth. Neighbours of
    /// which none is alive do not count.
    pub(super) fn among_neighbours(&self) -> Vec<f64> {
        let mut held = Vec::new();
        for row in self.rays.chunks(self.width) {
            for neighbours in row.chunks(LANES) {
                add(&mut held, alive(neighbours.iter().copied()), |_, _| 1);
            }
        }
        means(&held)
    }

    /// Mean number of rays in the engine's packets, by depth, down to depth 1024. Eye rays of
    /// tiles that show nothing count as if the engine traced them.
    pub(super) fn in_packets(&self) -> Vec<f64> {
        let [columns, rows] = TILE;
        let mut held = Vec::new();
        for band in self.rays.chunks(self.width * rows) {
            for left in (0..self.width).step_by(columns) {
                let row = |row: &'_ [usize]| row[left..self.width.min(left + columns)].to_vec();
                let tile: Vec<Vec<usize>> = band.chunks(self.width).map(row).collect();
                let eye = tile.iter().map(|row| row.len().div_ceil(LANES)).sum();
                let alive = alive(tile.into_iter().flatten());
                add(
                    &mut held,
                    alive,
                    |depth, rays| {
                        if depth == 0 { eye } else { rays.div_ceil(LANES) }
                    },
                );
            }
        }
        held.truncate(BREADTH + 1);
        means(&held)
    }
}

/// How many of these paths have a ray at each depth.
fn alive(lengths: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut alive = Vec::new();
    for length in lengths {
        if alive.len() < length {
            alive.resize(length, 0);
        }
        alive[length - 1] += 1;
    }
    for depth in (1..alive.len()).rev() {
        alive[depth - 1] += alive[depth];
    }
    alive
}

fn add(held: &mut Vec<Held>, alive: Vec<usize>, eights: impl Fn(usize, usize) -> usize) {
    if held.len() < alive.len() {
        held.resize(alive.len(), Held::default());
    }
    for (depth, rays) in alive.into_iter().enumerate() {
        held[depth].rays += rays;
        held[depth].eights += eights(depth, rays);
    }
}

fn means(held: &[Held]) -> Vec<f64> {
    held.iter().map(|held| held.rays as f64 / held.eights as f64).collect()
}
