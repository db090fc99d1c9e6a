//! Bytes of each format, and that all of them show the same picture.

use catoptric_scene::{Quantiser, Transfer};

use crate::program::{ENGINES, Folder, JSON_SCENE, SCENE, pfm, ppm, reference};

#[test]
fn pfm_is_the_exact_result_bottom_row_first() {
    let expected = pfm(13, reference(None, 1).pixels());
    for engine in ENGINES {
        let folder = Folder::new();
        folder.done(&format!("render scene.toml -o out.pfm --engine {engine}"));
        assert_eq!(folder.read("out.pfm"), expected, "{engine}");
    }
}

#[test]
fn ppm_and_png_hold_the_quantised_levels() {
    for (name, transfer) in [("linear", Transfer::Linear), ("srgb", Transfer::Srgb)] {
        let scene = SCENE.replace("[image]", &format!("[image]\ntransfer = \"{name}\""));
        let folder = Folder::with(&scene);
        folder.done("render scene.toml -o out.ppm --engine recursive");
        folder.done("render scene.toml -o out.png --engine recursive");
        folder.done("render scene.toml -o out.pfm --engine recursive");

        let quantiser = Quantiser::new(transfer);
        let film = reference(None, 1);
        let level = |pixel: &[f32; 3]| pixel.map(|channel| quantiser.level(channel));
        let levels: Vec<[u8; 3]> = film.pixels().iter().map(level).collect();
        assert_eq!(folder.read("out.ppm"), ppm(13, &levels), "{name}");

        let png = image::load_from_memory(&folder.read("out.png")).expect("a PNG").into_rgb8();
        assert_eq!(png.dimensions(), (13, 7));
        assert_eq!(png.as_raw(), levels.as_flattened(), "{name}");
        // The transfer is no part of the exact result.
        assert_eq!(folder.read("out.pfm"), pfm(13, film.pixels()), "{name}");
    }
}

#[test]
fn bands_of_a_larger_picture_join() {
    // More than one band of the PPM writer, and the last one not full.
    let folder = Folder::new();
    let size = "--width 1000 --height 300 --engine recursive";
    folder.done(&format!("render scene.toml -o out.ppm {size}"));
    folder.done(&format!("render scene.toml -o out.pfm {size}"));
    let ppm = folder.read("out.ppm");
    let pfm = folder.read("out.pfm");
    let (ppm, pfm) = (&ppm[b"P6\n1000 300\n255\n".len()..], &pfm[b"PF\n1000 300\n-1.0\n".len()..]);
    assert_eq!((ppm.len(), pfm.len()), (900_000, 3_600_000));
    let quantiser = Quantiser::new(Transfer::Linear);
    for (i, level) in ppm.iter().enumerate() {
        let (y, x) = (i / 3000, i % 3000);
        let at = 4 * ((299 - y) * 3000 + x);
        let value = f32::from_le_bytes([pfm[at], pfm[at + 1], pfm[at + 2], pfm[at + 3]]);
        assert_eq!(*level, quantiser.level(value), "channel {x} of row {y}");
    }
}

#[test]
fn equal_pixels_are_equal_files() {
    let folder = Folder::new();
    let size = "--width 200 --height 150 --engine recursive";
    for (name, threads) in [("a", 1), ("b", 1), ("c", 2), ("d", 7)] {
        folder.done(&format!("render scene.toml -o {name}.png --threads {threads} {size}"));
    }
    for name in ["b.png", "c.png", "d.png"] {
        assert_eq!(folder.read("a.png"), folder.read(name), "{name}");
    }
    // No chunk but those that make the picture: a time stamp would be tIME or tEXt.
    let names: Vec<_> = chunks(&folder.read("a.png")).into_iter().map(|(name, _)| name).collect();
    assert_eq!(names, ["IHDR", "gAMA", "IDAT", "IEND"]);
}

/// Names and data of a PNG's chunks.
fn chunks(png: &[u8]) -> Vec<(String, Vec<u8>)> {
    let (mut at, mut chunks) = (8, Vec::new());
    while at < png.len() {
        let length = u32::from_be_bytes([png[at], png[at + 1], png[at + 2], png[at + 3]]) as usize;
        let name = String::from_utf8_lossy(&png[at + 4..at + 8]).into_owned();
        chunks.push((name, png[at + 8..at + 8 + length].to_vec()));
        at += 12 + length;
    }
    chunks
}

/// A viewer that heeds gAMA and sRGB shows both transfers as the same light.
#[test]
fn png_says_what_its_levels_are() {
    for engine in ENGINES {
        let folder = Folder::new();
        for transfer in ["linear", "srgb"] {
            let line = format!("--transfer {transfer} --engine {engine}");
            folder.done(&format!("render scene.toml -o {transfer}.png {line}"));
            folder.done(&format!("render scene.toml -o {transfer}.ppm {line}"));
            folder.done(&format!("compare {transfer}.png {transfer}.ppm"));
        }
        let second = |name: &str| chunks(&folder.read(name)).swap_remove(1);
        assert_eq!(second("linear.png"), ("gAMA".to_owned(), 100_000_u32.to_be_bytes().to_vec()));
        assert_eq!(second("srgb.png"), ("sRGB".to_owned(), vec![0]));
        assert_eq!(folder.run("compare linear.png srgb.png --diff d.png").code, Some(1));
        // A difference is no light.
        assert_eq!(second("d.png").0, "IDAT");
    }
}

#[test]
fn transfer_stands_above_the_scene() {
    let folder = Folder::new();
    let stated = SCENE.replace("[image]", "[image]\ntransfer = \"srgb\"");
    folder.write("stated.toml", stated);
    folder.done("render stated.toml -o srgb.png");
    folder.done("render scene.toml -o linear.png");
    folder.done("render scene.toml -o option.png --transfer srgb");
    assert_eq!(folder.read("option.png"), folder.read("srgb.png"));
    folder.done("render stated.toml -o option.png --transfer linear");
    assert_eq!(folder.read("option.png"), folder.read("linear.png"));
    // The exact result has no levels.
    folder.done("render scene.toml -o a.pfm");
    folder.done("render scene.toml -o b.pfm --transfer srgb");
    assert_eq!(folder.read("a.pfm"), folder.read("b.pfm"));
}

#[test]
fn the_format_follows_the_ending_unless_named() {
    let starts = [
        ("-o a.png", "a.png", "\u{89}PNG"),
        ("-o a.PPM", "a.PPM", "P6"),
        ("-o a.pfm", "a.pfm", "PF"),
        ("-o b.png --format pfm", "b.png", "PF"),
        ("-o noending --format ppm", "noending", "P6"),
        ("", "scene.png", "\u{89}PNG"),
        ("--format pfm", "scene.pfm", "PF"),
    ];
    for (options, file, start) in starts {
        let folder = Folder::new();
        folder.done(&format!("render scene.toml {options}"));
        let start: Vec<u8> = start.chars().map(|c| c as u8).collect();
        assert!(folder.read(file).starts_with(&start), "{options}");
        assert_eq!(folder.contents().len(), 2, "{options}");
    }
}

#[test]
fn stdout_gets_the_file_s_bytes_and_nothing_else() {
    let folder = Folder::new();
    for format in ["png", "ppm", "pfm"] {
        folder.done(&format!("render scene.toml -o out.{format} --engine recursive"));
        for stdout in ["-", "/dev/stdout"] {
            let ran = folder.done(&format!(
                "render scene.toml -o {stdout} --format {format} --engine recursive"
            ));
            assert_eq!(ran.stdout, folder.read(&format!("out.{format}")), "{format} to {stdout}");
        }
    }
}

#[test]
fn stdin_holds_toml_or_json() {
    let folder = Folder::new();
    folder.done("render scene.toml -o file.pfm --engine recursive");
    let ran = folder.run_with("render - -o - --format pfm --engine recursive", SCENE, &[]);
    assert_eq!((ran.code, &ran.stdout), (Some(0), &folder.read("file.pfm")), "{}", ran.stderr);

    folder.write("scene.json", JSON_SCENE);
    folder.done("render scene.json -o file.pfm --engine recursive");
    let ran = folder.run_with("render - -o - --format pfm --engine recursive", JSON_SCENE, &[]);
    assert_eq!((ran.code, &ran.stdout), (Some(0), &folder.read("file.pfm")), "{}", ran.stderr);

    // Without -o a scene from stdin is called scene.
    assert_eq!(folder.run_with("render -", JSON_SCENE, &[]).code, Some(0));
    assert!(folder.path("scene.png").exists());
}
