//! Ray counts by kind and depth.

/// What happened at one depth.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DepthCount {
    /// Rays traced at this depth (0: eye rays; deeper: reflection rays).
    pub rays: u64,
    /// Rays at this depth that met a primitive.
    pub hits: u64,
    /// Shadow rays, logical: one per hit and light with n·l > 0.
    pub shadow: u64,
}

impl DepthCount {
    /// Adds the counts of another part of the rendering at the same depth.
    #[inline]
    pub fn add(&mut self, other: Self) {
        self.rays += other.rays;
        self.hits += other.hits;
        self.shadow += other.shadow;
    }
}

/// Ray counts of a rendering, by depth. Logical: a ray that the picture needs is counted
/// whether or not the engine had to trace it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Entry d is depth d; no trailing entries without rays.
    pub depths: Vec<DepthCount>,
}

impl Counts {
    /// Eye rays.
    #[must_use]
    pub fn primary(&self) -> u64 {
        self.depths.first().map_or(0, |d| d.rays)
    }

    /// Reflection rays of all depths.
    #[must_use]
    pub fn reflection(&self) -> u64 {
        self.depths.iter().skip(1).map(|d| d.rays).sum()
    }

    /// Shadow rays of all depths.
    #[must_use]
    pub fn shadow(&self) -> u64 {
        self.depths.iter().map(|d| d.shadow).sum()
    }

    /// Rays of all kinds.
    #[must_use]
    pub fn total(&self) -> u64 {
        self.primary() + self.reflection() + self.shadow()
    }

    /// The entry of a depth; adds entries up to it if there are none.
    pub fn at(&mut self, depth: u32) -> &mut DepthCount {
        let depth = depth as usize;
        if self.depths.len() <= depth {
            self.depths.resize(depth + 1, DepthCount::default());
        }
        &mut self.depths[depth]
    }

    /// Adds another part of the same rendering.
    pub fn add(&mut self, other: &Counts) {
        if self.depths.len() < other.depths.len() {
            self.depths.resize(other.depths.len(), DepthCount::default());
        }
        for (sum, part) in self.depths.iter_mut().zip(&other.depths) {
            sum.add(*part);
        }
    }
}
