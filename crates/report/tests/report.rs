//! One report in every format.

use catoptric_report::{
    Cell, Column, Occasion, Picture, Plot, Report, Scale, Series, Sum, Table, document, files,
    summary,
};

const COLUMNS: &[Column] = &[
    Column { key: "scene", heading: "scene", meaning: "Its <name>." },
    Column { key: "max_error", heading: "largest error", meaning: "Linear." },
    Column { key: "rays", heading: "rays", meaning: "All of them." },
];

fn sample() -> Report {
    let mut report = Report::new("sample", "Error & <time>");
    report.heading("What was measured");
    report.text("A \"note\" with <tags> & more.");
    let mut table = Table::new("sample", COLUMNS, "Rows.");
    table.push(["a, \"b\" | c".into(), 0.1_f64.into(), 12_u64.into()]);
    table.push(["nan".into(), f64::NAN.into(), Cell::Nothing]);
    report.table(table);
    let mut second = Table::new("second", COLUMNS, "More rows.");
    second.push(["x".into(), 1.25e-9_f64.into(), 0_u64.into()]);
    report.table(second);
    for name in ["one", "two"] {
        let points = vec![(1.0, 1e-3), (10.0, 0.0), (100.0, f64::INFINITY), (1000.0, 1e-6)];
        report.plot(Plot {
            name: name.to_owned(),
            title: "Error against time".to_owned(),
            caption: "It falls.".to_owned(),
            x: "time, ms".to_owned(),
            y: "RMSE".to_owned(),
            x_scale: Scale::Log,
            y_scale: Scale::Log,
            series: vec![
                Series { name: "a < b".to_owned(), points: points.clone(), dashed: false },
                Series { name: "bound".to_owned(), points, dashed: true },
                Series { name: "nothing".to_owned(), points: vec![(0.0, 1.0)], dashed: false },
            ],
        });
    }
    let pixels = vec![[255, 0, 0], [0, 255, 0], [0, 0, 255], [1, 2, 3], [4, 5, 6], [7, 8, 9]];
    report.pictures(vec![Picture {
        name: "crop".to_owned(),
        caption: "Red first".to_owned(),
        width: 3,
        height: 2,
        pixels,
        zoom: 4,
    }]);
    report
}

fn occasion() -> Occasion {
    Occasion::now("portable", 2, "catoptric study sample".to_owned())
}

fn text(name: &str) -> String {
    let files = files(&sample(), &occasion());
    let file = files.into_iter().find(|file| file.name == name).expect("that file");
    String::from_utf8(file.bytes).expect("text")
}

#[test]
fn every_block_has_its_files() {
    let names: Vec<String> =
        files(&sample(), &occasion()).into_iter().map(|file| file.name).collect();
    let expected = [
        "index.html",
        "sample.json",
        "sample.md",
        "sample.csv",
        "sample-second.csv",
        "one.svg",
        "two.svg",
        "crop.png",
    ];
    assert_eq!(names, expected);
}

#[test]
fn json_holds_every_digit_and_null_for_what_is_no_number() {
    let json: serde_json::Value = serde_json::from_str(&text("sample.json")).expect("JSON");
    assert_eq!(json["schema"], "catoptric-study");
    assert_eq!(json["version"], 2);
    assert_eq!(json["study"], "sample");
    assert_eq!(json["complete"], true);
    assert_eq!(json["rows"][0]["scene"], "a, \"b\" | c");
    assert_eq!(json["rows"][0]["max_error"], 0.1);
    assert_eq!(json["rows"][0]["rays"], 12);
    assert!(json["rows"][1]["max_error"].is_null());
    assert!(json["rows"][1]["rays"].is_null());
    assert_eq!(json["tables"][0]["name"], "second");
    assert_eq!(json["tables"][0]["rows"][0]["max_error"], 1.25e-9);
    assert_eq!(json["plots"][1]["series"][0]["points"][0][1], 1e-3);
    assert_eq!(json["plots"][1]["series"][0]["dashed"], false);
    assert_eq!(json["plots"][1]["series"][1]["dashed"], true);
    let columns = json["columns"].as_array().expect("columns");
    assert_eq!(columns.len(), 3);
    assert_eq!(
        (&columns[2]["key"], &columns[2]["meaning"]),
        (&"rays".into(), &"All of them.".into())
    );
    assert_eq!(json["tables"][0]["columns"], json["columns"]);
    // The folder's files, to be known again.
    let all = files(&sample(), &occasion());
    let json: serde_json::Value = serde_json::from_slice(&all[1].bytes).expect("JSON");
    let names: Vec<&str> = all.iter().map(|file| &*file.name).collect();
    assert_eq!(json["files"], serde_json::Value::from(names));
    let sums: Vec<Sum> = serde_json::from_value(json["sums"].clone()).expect("sums");
    let others = all.iter().filter(|file| !file.name.ends_with(".json"));
    let expected: Vec<_> = others.map(|file| Sum::of(&file.name, &file.bytes)).collect();
    assert_eq!(sums, expected);
    assert_eq!(sums[0].bytes, all[0].bytes.len() as u64);
    // The published values of the sum.
    assert_eq!(Sum::of("", b"").fnv1a_64, "cbf29ce484222325");
    assert_eq!(Sum::of("", b"foobar").fnv1a_64, "85944171f73967e8");
    assert_eq!(json["made"]["command"], "catoptric study sample");
}

#[test]
fn csv_quotes_what_must_be_quoted() {
    let expected = "scene,max_error,rays\n\"a, \"\"b\"\" | c\",0.1,12\nnan,NaN,\n";
    assert_eq!(text("sample.csv"), expected);
}

#[test]
fn markdown_rounds_for_people_and_keeps_bars_out_of_cells() {
    let markdown = text("sample.md");
    assert!(markdown.contains("| a, \"b\" \\| c | 0.1000 "), "{markdown}");
    assert!(markdown.contains("| x     | 1.25e-9 "), "{markdown}");
    assert!(markdown.contains("![Error against time](one.svg)"), "{markdown}");
    let alone = summary(&sample(), &occasion(), false);
    assert!(!alone.contains(".svg") && !alone.contains(".png"), "{alone}");
}

#[test]
fn the_page_needs_nothing_beside_it() {
    let page = text("index.html");
    assert_eq!(page.matches("<svg").count(), 2);
    assert!(page.contains("src=\"data:image/png;base64,"));
    // The one address is the name of SVG's vocabulary, which nobody asks for.
    let addresses = page.matches("://").count();
    assert_eq!(addresses, page.matches("http://www.w3.org/2000/svg").count());
    assert!(page.contains("A &quot;note&quot; with &lt;tags&gt; &amp; more."));
    assert!(!page.contains("<tags>") && !page.contains("<time>") && !page.contains("<name>"));
    // Names within drawings are the page's only ones.
    assert!(page.contains("id=\"one-clip-") && page.contains("id=\"two-clip-"));
}

#[test]
fn a_drawing_leaves_out_what_its_axes_cannot_show() {
    let file = text("one.svg");
    assert!(!file.contains("NaN") && !file.contains("inf"), "{file}");
    assert!(file.contains("bound") && !file.contains("nothing"));
    assert!(file.contains("prefers-color-scheme:dark"));
}

#[test]
fn an_interrupted_report_says_so() {
    let mut report = sample();
    report.complete = false;
    for file in files(&report, &occasion()).iter().take(3) {
        let text = String::from_utf8_lossy(&file.bytes);
        let said = text.contains("Interrupted") || text.contains("\"complete\": false");
        assert!(said, "{}", file.name);
    }
}

#[test]
fn yes_and_no_are_words_for_people_and_truths_for_machines() {
    let mut report = Report::new("sample", "Truths");
    let mut table = Table::new("sample", COLUMNS, "Rows.");
    table.push([true.into(), false.into(), Cell::from(None::<bool>)]);
    report.table(table);
    let document = document(&report, &occasion());
    let json: serde_json::Value = serde_json::from_str(&document).expect("JSON");
    assert_eq!(
        (&json["rows"][0]["scene"], &json["rows"][0]["max_error"]),
        (&true.into(), &false.into())
    );
    assert!(json["rows"][0]["rays"].is_null());
    let files = files(&report, &occasion());
    let file = |name: &str| {
        let file = files.iter().find(|file| file.name == name).expect("that file");
        String::from_utf8(file.bytes.clone()).expect("text")
    };
    assert!(file("sample.csv").ends_with("\ntrue,false,\n"));
    assert!(file("sample.md").contains("| yes   | no            | -    |"));
}

/// Depths 0, 1, 3 and 7 stand equally far apart.
#[test]
fn depths_are_drawn_by_doublings() {
    let mut report = Report::new("sample", "Depths");
    let points = [0.0, 1.0, 3.0, 7.0].map(|depth| (depth, 1.0 + depth)).to_vec();
    report.plot(Plot {
        name: "depths".to_owned(),
        title: String::new(),
        caption: String::new(),
        x: "depth".to_owned(),
        y: "ms".to_owned(),
        x_scale: Scale::Doublings,
        y_scale: Scale::Log,
        series: vec![Series { name: "a".to_owned(), points, dashed: false }],
    });
    let files = files(&report, &occasion());
    let drawing = files.iter().find(|file| file.name == "depths.svg").expect("a plot");
    let drawing = String::from_utf8(drawing.bytes.clone()).expect("text");
    // The marks' places: circles in the order of the points; the legend's is the last.
    let places = drawing
        .split("<circle cx=\"")
        .skip(1)
        .map(|rest| rest.split('"').next().and_then(|x| x.parse::<f64>().ok()).expect("a place"));
    let places: Vec<f64> = places.take(4).collect();
    let steps: Vec<f64> = places.windows(2).map(|pair| pair[1] - pair[0]).collect();
    assert!(steps[0] > 20.0 && steps.iter().all(|step| (step - steps[0]).abs() < 0.1), "{steps:?}");
    for label in [">0<", ">1<", ">3<", ">7<"] {
        assert!(drawing.contains(label), "{label}");
    }
}

#[test]
#[should_panic(expected = "one cell a column")]
fn a_row_has_one_cell_a_column() {
    Table::new("t", COLUMNS, "").push(["short".into()]);
}
