//! Crops, samples, and that a crop keeps the whole picture's grid.

use catoptric_scene::{Crop, Draft, Grid, Image, Scene, View, ViewError};
use proptest::prelude::*;

fn scene(width: u32, height: u32) -> Scene {
    let image = Image { width, height, ..Image::default() };
    Scene::new(Draft { image, ..Draft::default() }).expect("only the size is not the default")
}

#[test]
fn crops_may_touch_the_edges_and_not_pass_them() {
    let scene = scene(4, 3);
    let crop = |x, y, width, height| Crop { x, y, width, height };
    for inside in [crop(0, 0, 4, 3), crop(3, 2, 1, 1), crop(0, 2, 4, 1), crop(3, 0, 1, 3)] {
        assert_eq!(View::new(&scene, Some(inside), 1).map(|view| view.crop()), Ok(inside));
    }
    let outside = [
        crop(0, 0, 5, 3),
        crop(0, 0, 4, 4),
        crop(1, 0, 4, 3),
        crop(0, 1, 4, 3),
        crop(4, 0, 1, 1),
        crop(0, 3, 1, 1),
        crop(0, 0, 0, 1),
        crop(0, 0, 1, 0),
        crop(u32::MAX, 0, 1, 1),
        crop(1, 0, u32::MAX, 1),
    ];
    for crop in outside {
        let error = ViewError::CropOutside { crop, width: 4, height: 3 };
        assert_eq!(View::new(&scene, Some(crop), 1), Err(error));
    }
    let message = View::new(&scene, Some(crop(3, 1, 2, 7)), 1).unwrap_err().to_string();
    assert!(message.contains("crop 3,1,2,7 is not inside the image of 4x3"), "{message}");
}

#[test]
fn samples_are_1_to_256() {
    let scene = scene(4, 3);
    for (samples, fine) in [(0, false), (1, true), (256, true), (257, false)] {
        assert_eq!(View::new(&scene, None, samples).is_ok(), fine, "{samples}");
    }
}

#[test]
fn the_plain_grid_goes_through_the_middles_of_pixels() {
    let grid = Grid::new(&View::whole(&scene(4, 2)));
    assert_eq!(grid.columns, [-0.75, -0.25, 0.25, 0.75]);
    assert_eq!(grid.rows, [0.5, -0.5]);
}

#[test]
fn samples_stand_side_by_side_within_a_pixel() {
    let view = View::new(&scene(2, 1), None, 2).expect("2 samples are allowed");
    let grid = Grid::new(&view);
    assert_eq!(grid.columns, [-0.75, -0.25, 0.25, 0.75]);
    assert_eq!(grid.rows, [0.5, -0.5]);
}

proptest! {
    #[test]
    fn the_grid_of_a_crop_is_a_part_of_the_whole_grid(
        (width, x, crop_width) in side(),
        (height, y, crop_height) in side(),
        samples in 1..5_u32,
    ) {
        let scene = scene(width, height);
        let crop = Crop { x, y, width: crop_width, height: crop_height };
        let grid = |crop| Grid::new(&View::new(&scene, crop, samples).expect("inside"));
        let (whole, part) = (grid(None), grid(Some(crop)));
        let range = |start: u32, len: u32| {
            (start * samples) as usize..((start + len) * samples) as usize
        };
        prop_assert_eq!(&whole.columns[range(x, crop_width)], part.columns);
        prop_assert_eq!(&whole.rows[range(y, crop_height)], part.rows);
        prop_assert_eq!((part.width, part.height, part.samples), (crop_width, crop_height, samples));
    }
}

/// All pixels along one side, and the start and length of a part of them.
fn side() -> impl Strategy<Value = (u32, u32, u32)> {
    (1..700_u32)
        .prop_flat_map(|all| (Just(all), 0..all))
        .prop_flat_map(|(all, start)| (Just(all), Just(start), 1..=all - start))
}
