//! `compare`: what it accepts, what it counts, how it ends.

use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder};
use serde_json::Value;

use crate::program::{Folder, pfm, ppm};

fn png(width: u32, pixels: &[u8], kind: ExtendedColorType, channel_bytes: u32) -> Vec<u8> {
    let mut bytes = Vec::new();
    let channels = u32::from(kind.channel_count());
    let height = pixels.len() as u32 / (width * channels * channel_bytes);
    PngEncoder::new(&mut bytes).write_image(pixels, width, height, kind).expect("a PNG");
    bytes
}

/// Compares two pictures; the JSON report and the exit code.
fn report(a: &[u8], b: &[u8]) -> (Value, Option<i32>) {
    let folder = Folder::new();
    folder.write("a", a);
    folder.write("b", b);
    let ran = folder.run("compare a b --json");
    assert_eq!(ran.stderr, "");
    (ran.json(), ran.code)
}

const GREY: [f32; 3] = [0.5; 3];

#[test]
fn equal_pictures_are_0() {
    let levels = [[1, 2, 3], [4, 5, 6], [7, 8, 9], [255, 0, 128]];
    let picture = ppm(2, &levels);
    let same = png(2, levels.as_flattened(), ExtendedColorType::Rgb8, 1);
    for (a, b) in [(&picture, &picture), (&picture, &same), (&same, &picture), (&same, &same)] {
        let (found, code) = report(a, b);
        assert_eq!(code, Some(0));
        assert_eq!(found["equal"], true);
        assert_eq!(found["values"], "levels");
        assert_eq!((&found["pixels"], &found["first"]), (&0.into(), &Value::Null));
    }
    let linear = pfm(2, &[GREY, [0.0, -1.0, 3.0], [f32::INFINITY; 3], [f32::NAN; 3]]);
    let (found, code) = report(&linear, &linear);
    assert_eq!(
        (code, &found["equal"], &found["values"]),
        (Some(0), &true.into(), &"linear".into())
    );
}

#[test]
fn levels_that_differ_are_counted() {
    let a = ppm(3, &[[10, 10, 10]; 6]);
    let mut changed = [[10, 10, 10]; 6];
    changed[4] = [10, 11, 10];
    changed[5] = [10, 7, 10];
    let (found, code) = report(&a, &ppm(3, &changed));
    assert_eq!(code, Some(1));
    assert_eq!((&found["equal"], &found["pixels"]), (&false.into(), &2.into()));
    let first = &found["first"];
    assert_eq!((&first["x"], &first["y"]), (&1.into(), &1.into()));
    assert_eq!(first["a"], serde_json::json!([10.0, 10.0, 10.0]));
    assert_eq!(first["b"], serde_json::json!([10.0, 11.0, 10.0]));
    assert_eq!((&first["a_bits"], &first["ulps"]), (&Value::Null, &Value::Null));
    assert_eq!(found["max"], 3.0);
    let rmse = (10.0_f64 / 18.0).sqrt();
    assert!((found["rmse"].as_f64().expect("a number") - rmse).abs() < 1e-12);
    assert_eq!((&found["level_pixels"], &found["level_pixels_over_one"]), (&2.into(), &1.into()));
}

#[test]
fn f32_are_compared_as_bits() {
    let next = f32::from_bits(0.5_f32.to_bits() + 2);
    let a = pfm(2, &[GREY, GREY, [0.0; 3], GREY]);
    let b = pfm(2, &[GREY, [0.5, next, 0.5], [0.0, -0.0, 0.0], GREY]);
    let (found, code) = report(&a, &b);
    assert_eq!(code, Some(1));
    assert_eq!(found["pixels"], 2);
    let first = &found["first"];
    // The bottom row comes first in the file and last in the picture.
    assert_eq!((&first["x"], &first["y"]), (&1.into(), &0.into()));
    assert_eq!(first["a_bits"][1], "0x3f000000");
    assert_eq!(first["b_bits"][1], "0x3f000002");
    assert_eq!(first["ulps"], serde_json::json!([0, 2, 0]));
    assert_eq!(found["max"], f64::from(next) - 0.5);
    assert_eq!((&found["level_pixels"], &found["not_finite"]), (&0.into(), &0.into()));
}

#[test]
fn the_size_of_a_nan_s_payload_is_no_difference() {
    let nan = f32::from_bits(0x7fc0_0001);
    let other = f32::from_bits(0xffc1_2345);
    let a = pfm(1, &[[nan, 1.0, f32::INFINITY]]);
    assert_eq!(report(&a, &pfm(1, &[[other, 1.0, f32::INFINITY]])).1, Some(0));
    let (found, code) = report(&a, &pfm(1, &[[0.25, 1.5, f32::NEG_INFINITY]]));
    assert_eq!(code, Some(1));
    assert_eq!((&found["not_finite"], &found["max"]), (&2.into(), &0.5.into()));
    assert_eq!(found["first"]["a"], serde_json::json!([null, 1.0, null]));
    assert_eq!(found["first"]["ulps"][0], Value::Null);
    assert_eq!(found["first"]["b_bits"][2], "0xff800000");
}

#[test]
fn f32_levels_are_quantised_linearly() {
    let a = pfm(3, &[GREY, GREY, [2.0; 3]]);
    let b = pfm(3, &[[0.502, 0.5, 0.5], [0.51, 0.5, 0.5], [3.0; 3]]);
    let (found, _) = report(&a, &b);
    // 0.5 is level 128, 0.502 rounds to 128, 0.51 to 130; above 1 all is 255.
    assert_eq!(found["pixels"], 3);
    assert_eq!((&found["level_pixels"], &found["level_pixels_over_one"]), (&1.into(), &1.into()));
}

#[test]
fn big_endian_and_comments_are_read() {
    let little = pfm(2, &[[1.0, 2.0, 3.0], GREY]);
    let mut big = b"PF\n# a comment\n2 # another\n1\n1.0\n".to_vec();
    for value in [1.0_f32, 2.0, 3.0, 0.5, 0.5, 0.5] {
        big.extend(value.to_be_bytes());
    }
    assert_eq!(report(&little, &big).1, Some(0));
    let commented = [b"P6 #x\n1 1 255\n".as_slice(), &[1, 2, 3]].concat();
    assert_eq!(report(&commented, &ppm(1, &[[1, 2, 3]])).1, Some(0));
}

#[test]
fn grey_png_is_read_as_rgb() {
    let grey = png(2, &[7, 200], ExtendedColorType::L8, 1);
    assert_eq!(report(&grey, &ppm(2, &[[7; 3], [200; 3]])).1, Some(0));
}

#[test]
fn what_cannot_be_compared_is_2_and_what_cannot_be_read_3() {
    let folder = Folder::new();
    let levels = ppm(2, &[[1, 2, 3]; 2]);
    let linear = pfm(2, &[GREY; 2]);
    let sound = png(2, &[9; 6], ExtendedColorType::Rgb8, 1);
    let scaled = [b"PF 2 1 -2.0\n".as_slice(), &linear[linear.len() - 24..]].concat();
    let endless = [levels.as_slice(), b"x"].concat();
    /// What is wrong, two pictures, the exit code, parts of the message.
    type Case<'a> = (&'a str, &'a [u8], &'a [u8], i32, &'a [&'a str]);
    let cases: &[Case<'_>] = &[
        ("kinds", &levels, &linear, 2, &["a", "b", "8-bit", "f32"]),
        ("kinds", &linear, &sound, 2, &["8-bit", "f32"]),
        ("sizes", &levels, &ppm(1, &[[1, 2, 3]; 2]), 2, &["2x1", "1x2"]),
        ("sizes", &linear, &pfm(1, &[GREY; 2]), 2, &["2x1", "1x2"]),
        ("16 bits", &levels, &png(2, &[9; 12], ExtendedColorType::Rgb16, 2), 2, &["16", "8-bit"]),
        ("alpha", &levels, &png(2, &[9; 8], ExtendedColorType::Rgba8, 1), 2, &["Rgba8"]),
        ("maximum", &levels, b"P6 2 1 127\n123456", 2, &["127", "255"]),
        ("scale", &linear, &scaled, 2, &["-2.0"]),
        ("empty", &levels, b"", 3, &["b is no picture"]),
        ("text", &levels, b"P3 1 1 255 1 2 3", 3, &["PNG, PPM (P6) and PFM (PF)"]),
        ("header", &levels, b"P6 2", 3, &["header"]),
        ("side", &levels, b"P6 0 1 255\n", 3, &["\"0\""]),
        ("side", &levels, b"P6 99999999999 1 255\n", 3, &["99999999999"]),
        ("short", &levels, &levels[..levels.len() - 1], 3, &["5 bytes", "2x1", "6"]),
        ("long", &levels, &endless, 3, &["7 bytes", "6"]),
        ("short", &linear, &linear[..linear.len() - 1], 3, &["23 bytes", "24"]),
        ("huge", &linear, b"PF 4294967295 4294967295 -1\n", 3, &["0 bytes"]),
        ("short", &levels, &sound[..sound.len() - 20], 3, &["PNG"]),
    ];
    for (what, a, b, code, parts) in cases {
        folder.write("a", a);
        folder.write("b", b);
        for (first, second) in [("a", "b"), ("b", "a")] {
            let before = folder.contents();
            let ran = folder.run(&format!("compare {first} {second} --diff d.png"));
            assert_eq!(ran.code, Some(*code), "{what}: {}", ran.stderr);
            for part in *parts {
                assert!(ran.stderr.contains(part), "{what}: {part:?} is not in {}", ran.stderr);
            }
            assert!(ran.stdout.is_empty() && !ran.stderr.contains("panicked"), "{what}");
            assert_eq!(folder.contents(), before, "{what}");
        }
    }
    assert_eq!(folder.run("compare a missing.png").code, Some(3));
    assert_eq!(folder.run("compare a .").code, Some(3));
}

#[test]
fn the_difference_image_shows_what_differs() {
    let folder = Folder::new();
    let mut changed = [[0.5; 3]; 4];
    changed[1] = [0.5, 0.75, 0.5];
    changed[2] = [0.375, 0.5, 0.500_000_06];
    changed[3] = [0.5, f32::NAN, 0.5];
    folder.write("a.pfm", pfm(2, &[GREY; 4]));
    folder.write("b.pfm", pfm(2, &changed));
    let ran = folder.run("compare a.pfm b.pfm --diff d.png --json");
    assert_eq!(ran.code, Some(1), "{}", ran.stderr);
    assert_eq!(ran.json()["diff"], serde_json::json!({ "file": "d.png", "amplification": 1020.0 }));
    let image = image::load_from_memory(&folder.read("d.png")).expect("a PNG").into_rgb8();
    assert_eq!(image.as_raw(), &[0, 0, 0, 0, 255, 0, 128, 0, 1, 0, 255, 0]);

    let before = folder.contents();
    for same in ["a.pfm", "./b.pfm"] {
        let ran = folder.run(&format!("compare a.pfm b.pfm --diff {same}"));
        assert_eq!(ran.code, Some(2), "{same}: {}", ran.stderr);
    }
    assert_eq!(folder.run("compare a.pfm b.pfm --diff missing/d.png").code, Some(4));
    assert_eq!(folder.contents(), before);
}

#[test]
fn the_text_says_the_same_as_the_json() {
    let folder = Folder::new();
    folder.write("a.ppm", ppm(2, &[[1; 3], [2; 3]]));
    folder.write("b.ppm", ppm(2, &[[1; 3], [2, 9, 2]]));
    let ran = folder.run("compare a.ppm b.ppm");
    assert_eq!((ran.code, ran.stderr.as_str()), (Some(1), ""));
    for part in ["a.ppm and b.ppm differ", "2x1", "1 of 2", "(1, 0)", "2 9 2", "7.0", "2.857738"] {
        assert!(ran.text().contains(part), "{part:?} is not in {}", ran.text());
    }
    let ran = folder.done("compare a.ppm a.ppm");
    assert_eq!(ran.text(), "a.ppm and a.ppm are equal (2x1, levels)\n");
}

#[test]
fn one_of_them_may_be_stdin() {
    let folder = Folder::new();
    folder.write("a.ppm", "P6 1 1 255\nxyz");
    assert_eq!(folder.run_with("compare - a.ppm", "P6 1 1 255\nxyz", &[]).code, Some(0));
    assert_eq!(folder.run_with("compare a.ppm -", "P6 1 1 255\nxyy", &[]).code, Some(1));
}
