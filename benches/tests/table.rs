//! The file of the history.

use std::path::PathBuf;

use catoptric_benches::history::entry::{COLUMNS, Entry, plain};
use catoptric_benches::history::table::{append, read};
use tempfile::TempDir;

use super::line;

/// A folder and a file in it that holds the text.
fn file(text: &str) -> (TempDir, PathBuf) {
    let folder = TempDir::new().expect("a folder");
    let path = folder.path().join("history.csv");
    std::fs::write(&path, text).expect("a file");
    (folder, path)
}

/// What reading a text says after the file's name.
fn fault(text: &str) -> String {
    let (_folder, path) = file(text);
    let message = read(&path).expect_err("a fault").to_string();
    let rest = message.strip_prefix(&path.display().to_string());
    rest.expect("the message names the file").to_owned()
}

fn header() -> String {
    COLUMNS.join(",")
}

#[test]
fn lines_read_back_as_written() {
    let folder = TempDir::new().expect("a folder");
    let path = folder.path().join("history.csv");
    assert_eq!(read(&path).expect("a missing file is no fault"), []);
    let second = Entry { scene: "flake".into(), ..line() };
    append(&path, &[line(), second.clone()]).expect("written");
    append(&path, &[line()]).expect("written");
    assert_eq!(read(&path).expect("read"), [line(), second, line()]);
    let text = std::fs::read_to_string(&path).expect("text");
    assert_eq!(text.matches("commit").count(), 1, "one header");
    assert_eq!(
        text.lines().nth(1),
        Some(
            "2026-01-31T10:20:30Z,abc1234+,A Processor 9000,avx2,2,workshop,1920x1080,5,4000000,\
             25,21.5000,20.2500,10.5000,10.0000,0.0125,3.5000,3.7500"
        )
    );
}

#[test]
fn an_empty_file_gets_its_header() {
    let (_folder, path) = file("");
    append(&path, &[line()]).expect("written");
    assert_eq!(read(&path).expect("read"), [line()]);
}

#[test]
fn a_header_alone_is_a_history_without_lines() {
    let (_folder, path) = file(&(header() + "\n"));
    assert_eq!(read(&path).expect("read"), []);
    append(&path, &[line()]).expect("written");
    assert_eq!(read(&path).expect("read"), [line()]);
}

#[test]
fn a_line_that_is_cut_off_is_named() {
    let whole = format!("{}\n{}\n", header(), line().to_line());
    for length in [whole.len() - 1, whole.len() - 2, whole.len() - 30] {
        assert!(fault(&whole[..length]).starts_with(":2: the line has no end"), "{length}");
    }
    assert!(fault(&header()[..20]).starts_with(":1: the line has no end"));
}

#[test]
fn nothing_is_added_to_a_broken_file() {
    let broken = format!("{}\n2026,abc", header());
    let (_folder, path) = file(&broken);
    append(&path, &[line()]).expect_err("a fault");
    assert_eq!(std::fs::read_to_string(&path).expect("text"), broken);
}

#[test]
fn other_columns_are_named() {
    let text = |columns: &str| format!("{columns}\n{}\n", line().to_line());
    assert_eq!(fault(&text(&(header() + ",colour"))), r#":1: unknown column "colour""#);
    let without = header().replace(",isa", "");
    assert_eq!(fault(&text(&without)), r#":1: column "isa" is missing"#);
    let swapped = header().replace("date,commit", "commit,date");
    assert!(fault(&text(&swapped)).starts_with(":1: columns are not in the order date,commit"));
}

#[test]
fn a_bad_field_is_named() {
    let text = |from: &str, to: &str| {
        let good = line().to_line();
        assert!(good.contains(from), "{from}");
        format!("{}\n{good}\n{}\n", header(), good.replacen(from, to, 1))
    };
    assert_eq!(fault(&text("A Processor 9000", "")), ":3: processor is empty");
    assert_eq!(fault(&text(",avx2", "")), ":3: 16 fields instead of 17");
    assert_eq!(fault(&text("3.7500", "3.75,1")), ":3: 18 fields instead of 17");
    assert!(fault(&text("1920x1080,5,", "1920x1080,-5,")).starts_with(r#":3: depth is "-5": "#));
    for bad in ["0", "-1", "NaN", "inf"] {
        let found = fault(&text("10.5000", bad));
        assert!(found.starts_with(":3: over_same_min is "), "{found}");
    }
    assert!(fault(&text("0.0125", "-0.1")).ends_with("allowed is a number 0 or more"));
    let (_folder, path) = file(&text("0.0125", "0"));
    read(&path).expect("rounds may agree");
}

#[test]
fn texts_become_fields() {
    assert_eq!(plain(" Maker, \"Model\"\n9 "), "Maker   Model  9");
    assert_eq!(plain(" , "), "unknown");
    let awkward = Entry { processor: "Maker, Model".into(), ..line() };
    let found = Entry::from_line(&awkward.to_line()).expect("a line");
    assert_eq!(found.processor, "Maker  Model");
}
