//! Sizes that truth can be made in.

use catoptric_scene::Scene;

use crate::subject::Subject;

/// Columns or rows of the picture in which paths are looked for first.
pub(super) const LOOK: u32 = 160;

/// The scene in a size that truth can be made in: at most 640 pixels wide or high, less where
/// paths are long; to full depth, without a weight cut, with robust numerics.
pub(super) fn sized(subject: &Subject, depth: u32) -> Scene {
    const BOUNCES: u32 = 8_000_000;
    subject.with(|draft| {
        let image = &mut draft.image;
        let mut longest = 640;
        let (mut width, mut height) = fit(image.width, image.height, longest);
        while longest > 16 && width * height > BOUNCES / (depth + 1) {
            longest -= 16;
            (width, height) = fit(image.width, image.height, longest);
        }
        (image.width, image.height) = (width, height);
        draft.render.max_depth = depth;
        draft.render.min_weight = 0.0;
        draft.render.numerics = Default::default();
    })
}

/// The scene in a size that many samples can be taken in.
pub(super) fn small(sized: &Subject) -> Scene {
    sized.with(|draft| {
        let image = &mut draft.image;
        (image.width, image.height) = (image.width.div_ceil(4), image.height.div_ceil(4));
    })
}

/// Shrinks to at most `longest` columns and rows, with the same shape.
pub(super) fn fit(width: u32, height: u32, longest: u32) -> (u32, u32) {
    let larger = if width > height { width } else { height };
    if larger <= longest {
        return (width, height);
    }
    let scaled = |side: u32| {
        let scaled = (u64::from(side) * u64::from(longest)).div_ceil(u64::from(larger));
        u32::try_from(scaled).expect("not more than it was")
    };
    (scaled(width), scaled(height))
}
