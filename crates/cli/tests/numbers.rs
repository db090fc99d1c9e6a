//! Every number of a scene, in both formats, at values that nobody means.

use crate::program::Folder;
use crate::refusals::refused;

/// A key that holds numbers: where it stands, its text around one of them, that number, its
/// path in messages, and which of [`STRANGE`] are allowed there.
struct Key {
    table: &'static str,
    key: &'static str,
    text: &'static str,
    sane: &'static str,
    path: &'static str,
    allowed: &'static [&'static str],
}

const fn key(
    [table, key, text, sane, path]: [&'static str; 5],
    allowed: &'static [&'static str],
) -> Key {
    Key { table, key, text, sane, path, allowed }
}

/// Not finite, zero, negative, huge and tiny.
const STRANGE: [&str; 11] =
    ["nan", "inf", "-inf", "0", "-0.0", "-1", "1e300", "-1e300", "5e-324", "1e400", "-1e400"];

const NONE: &[&str] = &[];
const AMOUNT: &[&str] = &["0", "-0.0", "5e-324"];
const PLACE: &[&str] = &["0", "-0.0", "-1", "5e-324"];
const FINITE: &[&str] = &["0", "-0.0", "-1", "1e300", "-1e300", "5e-324"];

/// A scene of one of everything; the keys of a table stand together.
const KEYS: [Key; 21] = [
    key(["image", "width", "{}", "2", "image.width"], NONE),
    key(["image", "height", "{}", "1", "image.height"], NONE),
    key(["camera", "position", "[0, {}, 0]", "1", "camera.position[1]"], PLACE),
    key(["camera", "look_at", "[0, {}, -9]", "1", "camera.look_at[1]"], PLACE),
    key(["camera", "up", "[0.5, {}, 0.2]", "1", "camera.up[1]"], FINITE),
    key(["camera", "fov", "{}", "40", "camera.fov"], NONE),
    key(["render", "max_depth", "{}", "2", "render.max_depth"], &["0"]),
    key(["render", "min_weight", "{}", "0", "render.min_weight"], AMOUNT),
    key(["render", "background", "[0, {}, 0]", "1", "render.background[1]"], AMOUNT),
    key(["render", "ambient", "{}", "0.1", "render.ambient"], AMOUNT),
    key(["lights", "position", "[0, {}, 0]", "8", "lights[0].position[1]"], PLACE),
    key(["lights", "intensity", "[1, {}, 1]", "1", "lights[0].intensity[1]"], AMOUNT),
    key(["spheres", "center", "[0, {}, -9]", "0", "spheres[0].center[1]"], PLACE),
    key(["spheres", "radius", "{}", "2", "spheres[0].radius"], NONE),
    key(["spheres", "color", "[1, {}, 1]", "1", "spheres[0].color[1]"], AMOUNT),
    key(["spheres", "diffuse", "{}", "0.5", "spheres[0].diffuse"], AMOUNT),
    key(["spheres", "specular", "{}", "0.5", "spheres[0].specular"], AMOUNT),
    key(["spheres", "shininess", "{}", "20", "spheres[0].shininess"], AMOUNT),
    key(["spheres", "reflect", "{}", "0.5", "spheres[0].reflect"], AMOUNT),
    key(["planes", "point", "[0, {}, 0]", "-3", "planes[0].point[1]"], PLACE),
    key(["planes", "normal", "[0.1, {}, 0.2]", "1", "planes[0].normal[1]"], FINITE),
];

const TABLES: [&str; 6] = ["image", "camera", "render", "lights", "spheres", "planes"];

/// A value for each key: the sane one, but `value` for the key of that path.
fn entries(table: &str, path: &str, value: &str) -> Vec<(&'static str, String)> {
    let entry = |key: &Key| {
        let number = if key.path == path { value } else { key.sane };
        (key.key, key.text.replace("{}", number))
    };
    let mut entries: Vec<_> = KEYS.iter().filter(|key| key.table == table).map(entry).collect();
    if table == "planes" {
        entries.push(("color", "[1, 1, 1]".to_owned()));
    }
    entries
}

fn listed(table: &str) -> bool {
    ["lights", "spheres", "planes"].contains(&table)
}

fn toml(path: &str, value: &str) -> String {
    let table = |table: &str| {
        let lines = entries(table, path, value).into_iter().map(|(k, v)| format!("{k} = {v}\n"));
        let head = if listed(table) { format!("[[{table}]]\n") } else { format!("[{table}]\n") };
        head + &lines.collect::<String>()
    };
    TABLES.map(table).concat()
}

/// The same; numbers that are not finite as most programs write them, since JSON has none.
fn json(path: &str, value: &str) -> String {
    let value = value.replace("nan", "NaN").replace("inf", "Infinity");
    let table = |table: &str| {
        let entries = entries(table, path, &value).into_iter();
        let inside: Vec<_> = entries.map(|(k, v)| format!("\"{k}\": {v}")).collect();
        let inside = inside.join(", ");
        if listed(table) {
            format!("\"{table}\": [{{{inside}}}]")
        } else {
            format!("\"{table}\": {{{inside}}}")
        }
    };
    format!("{{{}}}", TABLES.map(table).join(",\n"))
}

#[test]
fn every_key_takes_what_it_allows_and_names_what_it_does_not() {
    let folder = Folder::new();
    for Key { path, allowed, .. } in &KEYS {
        for value in STRANGE {
            for (file, text) in [("n.toml", toml(path, value)), ("n.json", json(path, value))] {
                folder.write(file, &text);
                let command = format!("render {file} -o out.pfm");
                if allowed.contains(&value) {
                    folder.done(&command);
                    std::fs::remove_file(folder.path("out.pfm")).expect("a picture");
                } else {
                    // What JSON cannot say is broken syntax, which has a place and no key.
                    let unsayable = value.contains('n') || value.contains("400");
                    let named = if file == "n.json" && unsayable { "; at line " } else { *path };
                    refused(&folder, &command, 3, &[file, named, "; allowed: "]);
                }
            }
        }
    }
}

#[test]
fn the_scene_without_a_strange_number_is_a_scene() {
    let folder = Folder::new();
    folder.write("sane.toml", toml("", ""));
    folder.write("sane.json", json("", ""));
    folder.done("render sane.toml -o a.pfm");
    folder.done("render sane.json -o b.pfm --engine recursive");
    assert_eq!(folder.read("a.pfm"), folder.read("b.pfm"));
}
