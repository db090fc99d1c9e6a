//! The part of the picture that is rendered, and where its rays pass through the image plane.

use crate::{Scalar, Scene, Wider};

/// A rectangle of pixels; (0, 0) is the top left of the full image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Crop {
    /// First column.
    pub x: u32,
    /// First row.
    pub y: u32,
    /// Columns, at least 1.
    pub width: u32,
    /// Rows, at least 1.
    pub height: u32,
}

/// The part of the image that is wanted, on the full image's grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct View {
    image_width: u32,
    image_height: u32,
    crop: Crop,
    samples: u32,
}

/// Why a view cannot be had of a scene's image.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ViewError {
    /// The crop is empty or reaches past the image.
    #[error(
        "crop {},{},{},{} is not inside the image of {width}x{height}: allowed are X + W <= {width}, Y + H <= {height}, W and H at least 1",
        .crop.x, .crop.y, .crop.width, .crop.height
    )]
    CropOutside {
        /// The crop that was asked for.
        crop: Crop,
        /// The image's columns.
        width: u32,
        /// The image's rows.
        height: u32,
    },
    /// The samples a side are not in 1 to 256.
    #[error("samples {0} is out of range: allowed are 1 to 256 a side")]
    Samples(u32),
}

impl View {
    /// The whole picture, one ray a pixel.
    #[must_use]
    pub fn whole(scene: &Scene) -> Self {
        let (width, height) = (scene.image.width, scene.image.height);
        Self {
            image_width: width,
            image_height: height,
            crop: Crop { x: 0, y: 0, width, height },
            samples: 1,
        }
    }

    /// A part of the picture, `samples` x `samples` rays a pixel.
    ///
    /// # Errors
    /// A crop that is empty or not inside the image; `samples` not in 1 to 256.
    pub fn new(scene: &Scene, crop: Option<Crop>, samples: u32) -> Result<Self, ViewError> {
        let whole = Self::whole(scene);
        let (width, height) = (whole.image_width, whole.image_height);
        let crop = crop.unwrap_or(whole.crop);
        let fits = |start: u32, len: u32, all: u32| len >= 1 && start < all && len <= all - start;
        if !fits(crop.x, crop.width, width) || !fits(crop.y, crop.height, height) {
            return Err(ViewError::CropOutside { crop, width, height });
        }
        if !(1..=256).contains(&samples) {
            return Err(ViewError::Samples(samples));
        }
        Ok(Self { crop, samples, ..whole })
    }

    /// The rectangle that is rendered.
    #[must_use]
    pub fn crop(&self) -> Crop {
        self.crop
    }

    /// Samples a side: N x N rays a pixel.
    #[must_use]
    pub fn samples(&self) -> u32 {
        self.samples
    }

    /// Position of sub-column `i` of the crop's column `x` on the image plane:
    /// 2(x + (i + 1/2)/N)/W - 1, from -1 at the left edge to 1 at the right.
    #[must_use]
    pub fn column<W: Wider>(&self, x: u32, i: u32) -> W {
        let [first, x, i, n] = [self.crop.x, x, i, self.samples].map(f64::from);
        let at = W::from(first + x) + W::from(i + 0.5) / W::from(n);
        W::from(2.0) * at / W::from(self.image_width.into()) - W::from(1.0)
    }

    /// Position of sub-row `j` of the crop's row `y` on the image plane:
    /// 1 - 2(y + (j + 1/2)/N)/H, from 1 at the top edge to -1 at the bottom.
    #[must_use]
    pub fn row<W: Wider>(&self, y: u32, j: u32) -> W {
        let [first, y, j, n] = [self.crop.y, y, j, self.samples].map(f64::from);
        let at = W::from(first + y) + W::from(j + 0.5) / W::from(n);
        W::from(1.0) - W::from(2.0) * at / W::from(self.image_height.into())
    }
}

/// The positions of a view's rays on the image plane, rounded once.
///
/// Shape: `columns[x * samples + i]` and `rows[y * samples + j]`, x and y within the crop.
#[derive(Clone, Debug)]
pub struct Grid<S: Scalar = f32> {
    /// Pixels of the crop in a row.
    pub width: u32,
    /// Rows of the crop.
    pub height: u32,
    /// Samples a side.
    pub samples: u32,
    /// Horizontal positions, left to right.
    pub columns: Vec<S>,
    /// Vertical positions, top to bottom.
    pub rows: Vec<S>,
}

impl Grid {
    /// The grid of a view in f32.
    #[must_use]
    pub fn new(view: &View) -> Self {
        Self::of(view)
    }
}

impl<S: Scalar> Grid<S> {
    /// The grid of a view.
    #[must_use]
    pub fn of(view: &View) -> Self {
        let Crop { width, height, .. } = view.crop;
        let n = view.samples;
        let columns = (0..width).flat_map(|x| (0..n).map(move |i| (x, i)));
        let rows = (0..height).flat_map(|y| (0..n).map(move |j| (y, j)));
        Self {
            width,
            height,
            samples: n,
            columns: columns
                .map(|(x, i)| S::nearest(view.column::<S::Wider>(x, i).into()))
                .collect(),
            rows: rows.map(|(y, j)| S::nearest(view.row::<S::Wider>(y, j).into())).collect(),
        }
    }
}
