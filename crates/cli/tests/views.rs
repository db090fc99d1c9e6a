//! Which pixels are rendered, and how.

use catoptric_scene::Crop;

use crate::program::{ENGINES, Folder, pfm, reference};

#[test]
fn a_crop_is_a_rectangle_of_the_whole_picture() {
    let whole = reference(None, 1);
    for engine in ENGINES {
        for (x, y, w, h) in [(0, 0, 13, 7), (3, 2, 5, 4), (12, 6, 1, 1), (0, 6, 13, 1)] {
            let folder = Folder::new();
            folder.done(&format!(
                "render scene.toml -o c.pfm --crop {x},{y},{w},{h} --engine {engine}"
            ));
            let row = |y: usize| &whole.pixels()[y * 13 + x..][..w];
            let expected: Vec<_> = (y..y + h).flat_map(row).copied().collect();
            assert_eq!(folder.read("c.pfm"), pfm(w, &expected), "{engine} {x},{y},{w},{h}");
        }
    }
}

#[test]
fn samples_are_averaged() {
    let crop = Crop { x: 2, y: 1, width: 6, height: 5 };
    let expected = pfm(6, reference(Some(crop), 3).pixels());
    assert_ne!(expected, pfm(6, reference(Some(crop), 1).pixels()), "edges must be in the crop");
    for engine in ENGINES {
        let folder = Folder::new();
        folder.done(&format!(
            "render scene.toml -o s.pfm --samples 3 --crop 2,1,6,5 --engine {engine}"
        ));
        assert_eq!(folder.read("s.pfm"), expected, "{engine}");
    }
}

#[test]
fn options_stand_above_the_scene() {
    let cases = [
        ("--width 21 --height 9", "width = 13\nheight = 7", "width = 21\nheight = 9"),
        ("--max-depth 1", "max_depth = 4", "max_depth = 1"),
        ("--max-depth 4294967295", "max_depth = 4", "max_depth = 4294967295"),
        ("--min-weight 0.3", "max_depth = 4", "max_depth = 4\nmin_weight = 0.3"),
        ("--numerics textbook", "max_depth = 4", "max_depth = 4\nnumerics = \"textbook\""),
        ("--numerics robust", "max_depth = 4", "max_depth = 4\nnumerics = \"robust\""),
    ];
    for engine in ENGINES {
        for (option, from, to) in cases {
            let folder = Folder::new();
            folder.write("changed.toml", crate::program::SCENE.replace(from, to));
            folder.done(&format!("render scene.toml -o option.pfm --engine {engine} {option}"));
            folder.done(&format!("render changed.toml -o changed.pfm --engine {engine}"));
            folder.done(&format!("render scene.toml -o plain.pfm --engine {engine}"));
            assert_eq!(folder.read("option.pfm"), folder.read("changed.pfm"), "{engine} {option}");
            // Or the option might do nothing. The paths here are shorter than 4 mirrors.
            let same = option.contains("robust") || option.contains("4294967295");
            let differs = folder.read("option.pfm") != folder.read("plain.pfm");
            assert!(differs || same, "{engine} {option}");
        }
    }
}

#[test]
fn truth_is_near_the_f32_picture_and_not_it() {
    let folder = Folder::new();
    folder.done("render scene.toml -o f32.pfm --engine recursive");
    for precision in ["f64", "dd"] {
        folder.done(&format!(
            "render scene.toml -o {precision}.pfm --engine recursive --precision {precision}"
        ));
        let ran = folder.run(&format!("compare f32.pfm {precision}.pfm --json"));
        assert_eq!(ran.code, Some(1), "{precision} has f32's bits: {}", ran.stderr);
        let report = ran.json();
        assert!(report["max"].as_f64().is_some_and(|max| max < 1e-4), "{precision}: {report}");
        // Bands of rows must join to the same picture as a crop of them.
        let crop = "--crop 1,3,7,4 --engine recursive";
        folder.done(&format!("render scene.toml -o crop.pfm {crop} --precision {precision}"));
        let whole = folder.read(&format!("{precision}.pfm"));
        let last = &whole[whole.len() - 12 * (13 * 4 - 1)..][..12 * 7];
        let crop = folder.read("crop.pfm");
        assert_eq!(&crop[crop.len() - 12 * 7..], last, "{precision}: row 3");
    }
}
