//! The face of the engine: a scene, how to render it, and where the picture goes.

use std::fmt;

use catoptric_scene::{Compiled, Counts, Film, Grid, Quantiser, Scalar};

use crate::bands::render_bands;
use crate::plan::Plan;
use crate::settings::{Settings, StackFull};
use crate::trace::Linear;

/// The packet engine on a scene. Its picture is that of the recursion in the same scalar.
///
/// ```
/// use catoptric_core::Engine;
/// use catoptric_scene::{Compiled, Document, Film, Grid, SceneFormat, View};
///
/// let text = b"[[lights]]\nposition = [0, 20, 0]\n
///     [[spheres]]\ncenter = [0, 0, -20]\nradius = 4\ncolor = [1.0, 0.3, 0.4]\n";
/// let scene = Document::parse("red.toml", text, SceneFormat::Toml)?.into_scene()?;
/// let grid = Grid::new(&View::whole(&scene));
/// let mut film = Film::new(grid.width, grid.height);
/// let counts = Engine::new(&Compiled::new(&scene)).render(&grid, &mut film)?;
/// assert_eq!(counts.depths[0].rays, 640 * 480);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Threads are rayon's current ones. Memory: half a megabyte a thread (f64: one); 16 bytes a
/// primitive and thread; 64 bytes (f64: 128) a sphere and light, or if that is more a megabyte
/// (f64: two); and 8 bytes an occluder and thread. Where paths go deep, a thread's stack takes 16
/// bytes (f64: 28) a ray of a tile and bounce down to bounce 1024, 9 MB at most, and from there on
/// 168 (f64: 264) a bounce; and up to a quarter more, for it grows by that much.
#[derive(Clone, Copy)]
pub struct Engine<'a, S: PacketScalar = f32> {
    scene: &'a Compiled<S>,
    settings: Settings,
    progress: &'a (dyn Fn(u64) + Sync),
}

impl<'a, S: PacketScalar> Engine<'a, S> {
    /// An engine with default settings.
    #[must_use]
    pub fn new(scene: &'a Compiled<S>) -> Self {
        Self { scene, settings: Settings::default(), progress: &|_| () }
    }

    /// The same with other settings.
    #[must_use]
    pub fn with(self, settings: Settings) -> Self {
        Self { settings, ..self }
    }

    /// The same, telling `progress` after every few rows how many pixels were added.
    #[must_use]
    pub fn reporting(self, progress: &'a (dyn Fn(u64) + Sync)) -> Self {
        Self { progress, ..self }
    }

    /// Renders a view.
    ///
    /// # Errors
    /// [`StackFull`] if paths go too deep for the limit; the pixels are then void.
    ///
    /// # Panics
    /// If the target has not one place for each pixel of the grid.
    pub fn render(&self, grid: &Grid<S>, target: impl Target<S>) -> Result<Counts, StackFull> {
        self.render_planned(&Plan::new(self.scene, grid), target)
    }

    /// Renders by a plan of this engine's scene, which changes how long it takes and nothing else.
    ///
    /// # Errors
    /// The same as [`Engine::render`].
    ///
    /// # Panics
    /// The same as [`Engine::render`], and if the plan is another scene's.
    pub fn render_planned(
        &self,
        plan: &Plan<S>,
        target: impl Target<S>,
    ) -> Result<Counts, StackFull> {
        assert!(std::ptr::eq(plan.scene(), self.scene), "a plan of the engine's scene");
        target.fill(plan, self.settings, self.progress)
    }
}

impl<S: PacketScalar> fmt::Debug for Engine<'_, S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Engine").field("settings", &self.settings).finish_non_exhaustive()
    }
}

/// A place that a picture goes to: a film, a slice of linear light, or [`Levels`]. Pixels stand row
/// by row from the top left.
pub trait Target<S: PacketScalar>: sealed::Sealed {
    /// Renders into it.
    #[doc(hidden)]
    fn fill(
        self,
        plan: &Plan<S>,
        settings: Settings,
        progress: &(dyn Fn(u64) + Sync),
    ) -> Result<Counts, StackFull>;
}

/// 8-bit levels: those that a quantiser gives for the film, which is never made.
#[derive(Debug)]
pub struct Levels<'a> {
    /// What linear light becomes.
    pub quantiser: &'a Quantiser,
    /// One place for each pixel.
    pub pixels: &'a mut [[u8; 3]],
}

/// A scalar that the engine computes in: f32, which it is made for, or f64.
pub trait PacketScalar: Scalar {
    /// Renders into a slice of linear light; compiled once for each scalar, in this crate.
    #[doc(hidden)]
    fn render_linear(
        plan: &Plan<Self>,
        settings: Settings,
        progress: &(dyn Fn(u64) + Sync),
        pixels: &mut [[Self; 3]],
    ) -> Result<Counts, StackFull>;
}

mod sealed {
    pub trait Sealed {}
    impl<S: catoptric_scene::Scalar> Sealed for &mut catoptric_scene::Film<S> {}
    impl<S: catoptric_scene::Scalar> Sealed for &mut [[S; 3]] {}
    impl Sealed for super::Levels<'_> {}
}

impl<S: PacketScalar> Target<S> for &mut Film<S> {
    fn fill(
        self,
        plan: &Plan<S>,
        settings: Settings,
        progress: &(dyn Fn(u64) + Sync),
    ) -> Result<Counts, StackFull> {
        let grid = plan.grid();
        assert_eq!((self.width(), self.height()), (grid.width, grid.height), "the film's size");
        S::render_linear(plan, settings, progress, self.pixels_mut())
    }
}

impl<S: PacketScalar> Target<S> for &mut [[S; 3]] {
    fn fill(
        self,
        plan: &Plan<S>,
        settings: Settings,
        progress: &(dyn Fn(u64) + Sync),
    ) -> Result<Counts, StackFull> {
        assert_a_place_a_pixel(self.len(), plan.grid());
        S::render_linear(plan, settings, progress, self)
    }
}

impl Target<f32> for Levels<'_> {
    fn fill(
        self,
        plan: &Plan,
        settings: Settings,
        progress: &(dyn Fn(u64) + Sync),
    ) -> Result<Counts, StackFull> {
        assert_a_place_a_pixel(self.pixels.len(), plan.grid());
        render_bands(plan, settings, progress, self.quantiser, self.pixels)
    }
}

fn assert_a_place_a_pixel<S: Scalar>(places: usize, grid: &Grid<S>) {
    let pixels = grid.width as usize * grid.height as usize;
    assert_eq!(places, pixels, "a place for each pixel");
}

macro_rules! packet_scalar {
    ($scalar:ty) => {
        impl PacketScalar for $scalar {
            fn render_linear(
                plan: &Plan<Self>,
                settings: Settings,
                progress: &(dyn Fn(u64) + Sync),
                pixels: &mut [[Self; 3]],
            ) -> Result<Counts, StackFull> {
                render_bands(plan, settings, progress, &Linear, pixels)
            }
        }
    };
}

packet_scalar!(f32);
packet_scalar!(f64);
