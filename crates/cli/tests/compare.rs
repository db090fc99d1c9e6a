//! `compare`: what it accepts, what it counts, how it ends.

use std::io::Read;

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

/// The same picture in every format and kind that is read.
#[test]
fn every_kind_of_8_bit_picture_is_read() {
    let grey = ppm(2, &[[7; 3], [200; 3]]);
    let kinds: [(&str, Vec<u8>); 8] = [
        ("P2", b"P2 2 1 255 7 200".to_vec()),
        ("P2", b"P2\n#c\n2 1\n255\n007#\n#c\n\t200\n\n".to_vec()),
        ("P3", b"P3\n2 1\n255\n7 7 7 200 200 200\n".to_vec()),
        ("P5", b"P5\n2 1\n255\n\x07\xc8".to_vec()),
        ("L8", png(2, &[7, 200], ExtendedColorType::L8, 1)),
        ("La8", png(2, &[7, 255, 200, 255], ExtendedColorType::La8, 1)),
        ("Rgb8", png(2, &[7, 7, 7, 200, 200, 200], ExtendedColorType::Rgb8, 1)),
        ("Rgba8", png(2, &[7, 7, 7, 255, 200, 200, 200, 255], ExtendedColorType::Rgba8, 1)),
    ];
    for (kind, bytes) in &kinds {
        let (found, code) = report(bytes, &grey);
        assert_eq!((code, &found["equal"]), (Some(0), &true.into()), "{kind}");
        let (found, code) = report(&ppm(2, &[[7; 3], [200, 199, 200]]), bytes);
        assert_eq!((code, &found["pixels"]), (Some(1), &1.into()), "{kind}");
    }
    // RGB as text keeps its order.
    let rgb = b"P3 1 2 255 1 2 3 4 5 6";
    assert_eq!(report(rgb, &ppm(1, &[[1, 2, 3], [4, 5, 6]])).1, Some(0));
}

/// A PNG by the `png` crate: palettes, few bits, interlaced pictures of awkward sizes.
fn special_png(width: u32, height: u32, kind: png::ColorType, bits: png::BitDepth) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(kind);
    encoder.set_depth(bits);
    encoder.set_palette([10, 20, 30, 40, 50, 60].as_slice());
    let row = (width as usize * bits as usize).div_ceil(8);
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(&vec![0b0101_0101; row * height as usize]).expect("pixels");
    writer.finish().expect("a PNG");
    bytes
}

#[test]
fn palettes_and_few_bits_are_resolved() {
    let palette = special_png(3, 2, png::ColorType::Indexed, png::BitDepth::One);
    let (even, odd) = ([10, 20, 30], [40, 50, 60]);
    assert_eq!(report(&palette, &ppm(3, &[even, odd, even, even, odd, even])).1, Some(0));
    let grey = special_png(2, 1, png::ColorType::Grayscale, png::BitDepth::Two);
    assert_eq!(report(&grey, &ppm(2, &[[85; 3]; 2])).1, Some(0));
}

/// The passes of an interlaced picture, written as the standard defines them.
#[test]
fn interlaced_pictures_are_read() {
    const PASSES: [[usize; 4]; 7] = [
        [0, 0, 8, 8],
        [4, 0, 8, 8],
        [0, 4, 4, 8],
        [2, 0, 4, 4],
        [0, 2, 2, 4],
        [1, 0, 2, 2],
        [0, 1, 1, 2],
    ];
    for (width, height) in [(1, 1), (2, 3), (4, 9), (5, 1), (8, 8), (13, 11), (3, 17)] {
        let pixel = |x: usize, y: usize| [x as u8, y as u8, (x * y) as u8];
        let mut rows = Vec::new();
        for [x0, y0, dx, dy] in PASSES {
            for y in (y0..height).step_by(dy).filter(|_| x0 < width) {
                rows.push(0);
                (x0..width).step_by(dx).for_each(|x| rows.extend(pixel(x, y)));
            }
        }
        let mut header = vec![0, 0, 0, width as u8, 0, 0, 0, height as u8];
        header.extend([8, 2, 0, 0, 1]);
        let chunks = [("IHDR", header), ("IDAT", stored(&rows)), ("IEND", Vec::new())];
        let flat: Vec<_> = (0..height).flat_map(|y| (0..width).map(move |x| pixel(x, y))).collect();
        let (found, code) = report(&chunked(&chunks), &ppm(width, &flat));
        assert_eq!(code, Some(0), "{width}x{height}: {found}");
    }
}

/// Bytes as a zlib stream without compression.
fn stored(bytes: &[u8]) -> Vec<u8> {
    let length = u16::try_from(bytes.len()).expect("one block");
    let mut stream = vec![0x78, 0x01, 1];
    stream.extend(length.to_le_bytes());
    stream.extend((!length).to_le_bytes());
    stream.extend(bytes);
    let (mut a, mut b) = (1_u32, 0_u32);
    for &byte in bytes {
        a = (a + u32::from(byte)) % 65_521;
        b = (b + a) % 65_521;
    }
    stream.extend((b << 16 | a).to_be_bytes());
    stream
}

/// A PNG of those chunks.
fn chunked(chunks: &[(&str, Vec<u8>)]) -> Vec<u8> {
    let mut file = b"\x89PNG\r\n\x1a\n".to_vec();
    for (name, data) in chunks {
        file.extend((data.len() as u32).to_be_bytes());
        let checked = [name.as_bytes(), data].concat();
        file.extend(&checked);
        file.extend(crc(&checked).to_be_bytes());
    }
    file
}

/// The CRC of a chunk's name and data.
fn crc(bytes: &[u8]) -> u32 {
    let step = |crc: u32| if crc & 1 == 1 { crc >> 1 ^ 0xedb8_8320 } else { crc >> 1 };
    !bytes.iter().fold(!0, |crc, &byte| (0..8).fold(crc ^ u32::from(byte), |crc, _| step(crc)))
}

/// A PNG whose header claims another size.
fn claiming(png: &[u8], width: u32, height: u32) -> Vec<u8> {
    let mut lying = png.to_vec();
    lying[16..20].copy_from_slice(&width.to_be_bytes());
    lying[20..24].copy_from_slice(&height.to_be_bytes());
    let sum = crc(&lying[12..29]);
    lying[29..33].copy_from_slice(&sum.to_be_bytes());
    lying
}

/// Runs `compare` with that much address space, in KiB: whatever takes more ends by a signal or
/// with another code.
fn cramped(folder: &Folder, space: u32, line: &str, code: i32, parts: &[&str]) {
    let ran = folder.shell(&format!("ulimit -v {space}; {line}"));
    assert_eq!(ran.code, Some(code), "{line}: {}", ran.stderr);
    let said = format!("{}{}", ran.text(), ran.stderr);
    for part in parts {
        assert!(said.contains(part), "{line}: {part:?} is not in {said}");
    }
}

/// What is claimed is counted before it is taken, from files, devices and pipes.
#[test]
fn claims_beyond_the_memory_limit_are_refused_before_they_are_taken() {
    let folder = Folder::new();
    let small = png(2, &[9; 6], ExtendedColorType::Rgb8, 1);
    folder.write("huge.png", claiming(&small, 20_000, 20_000));
    folder.write("largest.png", claiming(&small, 0x7fff_ffff, 0x7fff_ffff));
    folder.write("row.png", claiming(&small, 0x7fff_ffff, 1));
    let space = 300_000;
    let cases = [
        ("compare huge.png huge.png", &["need 2.3 GiB", "the limit is 2 GiB"][..]),
        ("compare huge.png huge.png --memory-limit 9G", &["the system does not grant"]),
        ("compare largest.png largest.png", &["the limit is 2 GiB", "--memory-limit"]),
        ("compare row.png row.png", &["the limit is 2 GiB"]),
        ("compare /dev/zero /dev/zero", &["/dev/zero is no picture"]),
    ];
    for (line, parts) in cases {
        cramped(&folder, space, &format!("catoptric {line}"), 3, parts);
    }
    for header in ["P6 60000 60000 255", "PF 60000 60000 -1", "P3 60000 60000 255"] {
        let claim = format!("(echo '{header}'; cat /dev/zero) 2>/dev/null");
        let line =
            format!("rm -f fifo; mkfifo fifo; {claim} > fifo & {claim} | catoptric compare - fifo");
        cramped(&folder, space, &line, 3, &["60000x60000", "the limit is 2 GiB"]);
    }
    // Sizes and kinds are told apart before anything is taken, too.
    folder.write("a.ppm", "P6 1 1 255\nabc");
    let line = "catoptric compare a.ppm huge.png";
    cramped(&folder, space, line, 2, &["one has 1x1 pixels, the other 20000x20000"]);
    // More pixels than claimed are not read to their end.
    let line = "(echo P6 1 1 255; cat /dev/zero) 2>/dev/null | catoptric compare - a.ppm";
    cramped(&folder, space, line, 3, &["has more than 3 bytes of pixels where 1x1 are 3"]);
}

/// What is within the limit takes no more than it and 16 MB, and what is a byte beyond is refused.
#[test]
fn the_memory_limit_is_what_is_taken() {
    let folder = Folder::new();
    for format in ["png", "ppm", "pfm"] {
        folder.done(&format!("render scene.toml -o a.{format} --width 4000 --height 3000"));
    }
    let pixels: u64 = 4000 * 3000;
    let (row, image) = (4000, pixels * 7);
    let cases = [
        ("a.ppm", 2 * pixels * 3 + image),
        ("a.png", 2 * (pixels * 3 + row * 16) + image),
        ("a.pfm", 2 * (pixels * 12 + row * 12) + image),
    ];
    for (file, need) in cases {
        let ran =
            folder.run(&format!("compare {file} {file} --diff d.png --memory-limit {}", need - 1));
        assert_eq!(ran.code, Some(3), "{file}: {}", ran.stderr);
        for part in [format!("({need} bytes)"), "4000x3000".to_owned(), "--memory-limit".to_owned()]
        {
            assert!(ran.stderr.contains(&part), "{file}: {part:?} is not in {}", ran.stderr);
        }
        let peak = peak_while_writing(&folder, file, need);
        assert!(peak <= need + 16_000_000, "{file}: {peak} bytes of {need}");
        // The measure is one: both pictures are there.
        assert!(peak >= need - image, "{file}: {peak} bytes of {need}");
    }
}

/// Peak of resident memory, in bytes, of a comparison of a file with itself that hangs in
/// writing its difference image to a pipe: all that it takes is taken then.
fn peak_while_writing(folder: &Folder, file: &str, limit: u64) -> u64 {
    let pipe = folder.path("pipe");
    let made = std::process::Command::new("mkfifo").arg(&pipe).status().expect("mkfifo");
    assert!(made.success());
    let mut running = std::process::Command::new(crate::program::CATOPTRIC)
        .args(["compare", file, file, "--diff", "pipe", "--memory-limit", &limit.to_string()])
        .current_dir(folder.path("."))
        .stdout(std::process::Stdio::null())
        .spawn()
        .expect("the program runs");
    let mut written = std::fs::File::open(&pipe).expect("the pipe");
    let mut image = Vec::new();
    // More than a pipe holds is to come, so that the program cannot have ended.
    written.by_ref().take(1).read_to_end(&mut image).expect("a byte");
    let status = std::fs::read_to_string(format!("/proc/{}/status", running.id()));
    let status = status.expect("the program's status");
    let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).expect("a peak");
    let kib: u64 = peak.trim().trim_end_matches(" kB").parse().expect("a number");
    written.read_to_end(&mut image).expect("the image");
    assert!(running.wait().expect("an end").success(), "{file}");
    assert!(image.len() > 100_000, "{file}: an image of {} bytes", image.len());
    std::fs::remove_file(pipe).expect("the pipe");
    kib * 1024
}

#[test]
fn graders_let_levels_and_pixels_pass() {
    let folder = Folder::new();
    let mut levels = [[50, 60, 70]; 2000];
    folder.write("a.ppm", ppm(50, &levels));
    levels[3] = [51, 60, 70];
    levels[700] = [50, 57, 70];
    levels[1999] = [0, 255, 71];
    folder.write("b.ppm", ppm(50, &levels));
    // Options, exit code, pixels that count, pixels that are allowed.
    let cases = [
        ("", 1, 3, 0),
        ("--allow 2", 1, 3, 2),
        ("--allow 3", 0, 3, 3),
        ("--allow 0.1%", 1, 3, 2),
        ("--allow 0.15%", 0, 3, 3),
        ("--allow 100%", 0, 3, 2000),
        ("--tolerance 0", 1, 3, 0),
        ("--tolerance 1", 1, 2, 0),
        ("--tolerance 2", 1, 2, 0),
        ("--tolerance 3", 1, 1, 0),
        ("--tolerance 194", 1, 1, 0),
        ("--tolerance 195", 0, 0, 0),
        ("--tolerance 255", 0, 0, 0),
        ("--tolerance 1 --allow 1", 1, 2, 1),
        ("--tolerance 1 --allow 2", 0, 2, 2),
        ("--tolerance 3 --allow 1", 0, 1, 1),
    ];
    for (options, code, counted, allowed) in cases {
        let ran = folder.run(&format!("compare a.ppm b.ppm --json {options}"));
        assert_eq!(ran.code, Some(code), "{options}: {}", ran.stderr);
        let found = ran.json();
        assert_eq!(found["passed"], code == 0, "{options}");
        assert_eq!((&found["equal"], &found["pixels"]), (&false.into(), &3.into()), "{options}");
        assert_eq!(found["pixels_counted"], counted, "{options}");
        assert_eq!(found["pixels_allowed"], allowed, "{options}");

        let ran = folder.run(&format!("compare a.ppm b.ppm {options}"));
        assert_eq!(ran.code, Some(code), "{options}");
        let words =
            format!("{counted}, allowed {allowed}: {}", ["passed", "failed"][code as usize]);
        assert_eq!(ran.text().contains(&words), !options.is_empty(), "{options}: {}", ran.text());
    }
}

/// Without a tolerance every bit counts; with one, levels of the linear transfer.
#[test]
fn graders_take_f32_as_levels() {
    let folder = Folder::new();
    folder.write("a.pfm", pfm(3, &[GREY, GREY, [2.0; 3]]));
    folder.write("b.pfm", pfm(3, &[[0.500_000_06, 0.5, 0.5], [0.51, 0.5, 0.5], [3.0; 3]]));
    let cases = [("--allow 2", 1), ("--allow 3", 0), ("--tolerance 0", 1), ("--tolerance 2", 0)];
    for (options, code) in cases {
        let ran = folder.run(&format!("compare a.pfm b.pfm {options}"));
        assert_eq!(ran.code, Some(code), "{options}: {}", ran.text());
    }
}

#[test]
fn what_cannot_be_compared_is_2_and_what_cannot_be_read_3() {
    let folder = Folder::new();
    let levels = ppm(2, &[[1, 2, 3]; 2]);
    let linear = pfm(2, &[GREY; 2]);
    let sound = png(2, &[9; 6], ExtendedColorType::Rgb8, 1);
    let scaled = [b"PF 2 1 -2.0\n".as_slice(), &linear[linear.len() - 24..]].concat();
    let endless = [levels.as_slice(), b"x"].concat();
    let mut alpha = [255; 8];
    alpha[7] = 254;
    let clear = png(2, &alpha, ExtendedColorType::Rgba8, 1);
    let grey_clear = png(2, &[9, 0, 9, 255], ExtendedColorType::La8, 1);
    let endless_comment = format!("P6 #{}", "x".repeat(70_000)).into_bytes();
    let endless_blanks = format!("P6{}", " ".repeat(70_000)).into_bytes();
    let endless_number = format!("P6 {}", "1".repeat(70_000)).into_bytes();
    let few_rows = claiming(&png(2, &[9; 6], ExtendedColorType::Rgb8, 1), 2, 1000);
    /// What is wrong, two pictures, the exit code, parts of the message.
    type Case<'a> = (&'a str, &'a [u8], &'a [u8], i32, &'a [&'a str]);
    let cases: &[Case<'_>] = &[
        ("kinds", &levels, &linear, 2, &["a", "b", "8-bit", "f32"]),
        ("kinds", &linear, &sound, 2, &["8-bit", "f32"]),
        ("sizes", &levels, &ppm(1, &[[1, 2, 3]; 2]), 2, &["2x1", "1x2"]),
        ("sizes", &linear, &pfm(1, &[GREY; 2]), 2, &["2x1", "1x2"]),
        ("16 bits", &levels, &png(2, &[9; 12], ExtendedColorType::Rgb16, 2), 2, &["16", "8-bit"]),
        ("alpha", &levels, &clear, 2, &["pixel (1, 0)", "alpha 254", "255 everywhere"]),
        ("grey alpha", &levels, &grey_clear, 2, &["pixel (0, 0)", "alpha 0"]),
        ("maximum", &levels, b"P6 2 1 127\n123456", 2, &["127", "255"]),
        ("maximum", &levels, b"P2 2 1 65535\n1 2", 2, &["65535", "255"]),
        ("scale", &linear, &scaled, 2, &["-2.0"]),
        ("empty", &levels, b"", 3, &["b is no picture"]),
        ("one byte", &levels, b"P", 3, &["b is no picture"]),
        ("bits", &levels, b"P1 1 1 1", 3, &["PNG, PPM (P6, P3), PGM (P5, P2) and PFM (PF)"]),
        ("text", &levels, b"P3 2 1 255 1 2 3 4 5 ", 3, &["10 bytes", "2x1", "11"]),
        ("text", &levels, b"P3 2 1 255 1 2 3 4 555", 3, &["above 255"]),
        ("text", &levels, b"P3 2 1 255 1 2 3 4 5 -6", 3, &["'-'"]),
        ("text", &levels, b"P3 2 1 255 11 22 33 44 55", 3, &["has 5 numbers", "6"]),
        ("text", &levels, b"P3 2 1 255 1 2 3 4 5 6 7", 3, &["more than the 6 numbers"]),
        ("grey", &levels, b"P5 2 1 255\n123", 3, &["3 bytes", "2x1", "2"]),
        ("header", &levels, &endless_comment, 3, &["header of more than 65536 bytes"]),
        ("header", &levels, &endless_blanks, 3, &["header of more than 65536 bytes"]),
        ("header", &levels, &endless_number, 3, &["number of more than 64 bytes"]),
        ("rows", &few_rows, &few_rows, 3, &["PNG", "not have enough data"]),
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
