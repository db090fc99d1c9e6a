//! A ray's life as one page: it needs nothing beside it and no network, and without scripts it
//! still shows the picture, the path and the log.

mod steps;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use catoptric_core::{Isa, Settings, render_levels};
use catoptric_report::escaped;
use catoptric_scene::{Compiled, Grid, Scene, View};
use catoptric_study::tracer::STACK_LIMIT;

use super::Pixel;
use super::drawing::draw;
use super::life::Life;
use super::life::text::{about, rgb};
use crate::exit::Failure;
use crate::format::{Levels, png};
use steps::{Step, steps};

/// What the page may load and run: nothing but what stands in it. A browser refuses the rest.
const POLICY: &str =
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:";

/// Columns or rows of the page's picture, at most.
const SIDE: u32 = 800;

/// Below half of it a picture is shown enlarged.
const SMALL: u32 = 320;

/// The page; its picture is rendered on rayon's current threads.
///
/// # Errors
/// Exit code 1 where some path of the picture is too deep for the engine.
pub(super) fn page(life: &Life, isa: Isa) -> Result<String, Failure> {
    let picture = render(life.scene, isa)?;
    let mut png = Vec::new();
    let transfer = Some(life.scene.image.transfer);
    png::encode(picture.pixels.as_flattened(), picture.width, picture.height, transfer, &mut png)
        .expect("a picture of that size can be written to memory");
    let (steps, hidden) = steps(life);
    let drawing = draw(life);
    let Pixel { x, y } = life.pixel;
    let (width, height) = (life.scene.image.width, life.scene.image.height);
    let place = |at: u32, size: u32| (f64::from(at) + 0.5) / f64::from(size) * 100.0;
    // How many times a tiny picture is enlarged.
    let times = (SMALL / picture.width.max(picture.height)).max(1);
    let scaled = if (picture.width, picture.height) != (width, height) {
        format!(", here in {}x{}", picture.width, picture.height)
    } else if times > 1 {
        format!(", {times} times enlarged")
    } else {
        String::new()
    };
    let ellipsis = match hidden {
        0 => String::new(),
        _ => format!(
            "<p class=\"warning\">{hidden} of the {} steps, in the middle of the path, are not on this page; catoptric explain with --json writes them all.</p>\n",
            life.steps()
        ),
    };
    // Numbers and the words of this program: nothing that could end the element.
    let script_data = serde_json::to_string(&steps).expect("keys are strings");
    let values = [
        ("policy", POLICY.to_owned()),
        ("title", escaped(&about(life)[0])),
        ("style", include_str!("page/page.css").to_owned()),
        ("about", escaped(&about(life)[1..].join("; "))),
        ("drawing", drawing.svg),
        ("drawing-caption", escaped(&drawing.caption)),
        ("enlarged", if times > 1 { " class=\"enlarged\"" } else { "" }.to_owned()),
        ("width", (picture.width * times).to_string()),
        ("height", (picture.height * times).to_string()),
        (
            "picture-alt",
            format!("The picture, {width} pixels wide and {height} high; pixel {x},{y} is marked"),
        ),
        ("picture", STANDARD.encode(png)),
        ("mark-x", place(x, width).to_string()),
        ("mark-y", place(y, height).to_string()),
        (
            "picture-caption",
            format!("The picture of {width}x{height}{scaled}; pixel {x},{y} is marked."),
        ),
        ("ellipsis", ellipsis),
        ("log", steps.iter().map(row).collect()),
        ("pixel-css", css(life, life.colour)),
        ("pixel", rgb(life.colour)),
        ("life", script_data),
        ("script", include_str!("page/page.js").to_owned()),
    ];
    Ok(fill(include_str!("page/page.html"), &values))
}

/// Puts values where a template names them, `{{name}}`.
///
/// # Panics
/// If it names one that is not there.
fn fill(template: &str, values: &[(&str, String)]) -> String {
    let mut page = String::with_capacity(1 << 20);
    let mut pieces = template.split("{{");
    page += pieces.next().unwrap_or_default();
    for piece in pieces {
        let (name, rest) = piece.split_once("}}").expect("a name ends");
        let value = values.iter().find(|(key, _)| *key == name);
        page += &value.unwrap_or_else(|| panic!("no value for {name}")).1;
        page += rest;
    }
    page
}

/// The scene's picture; a large one smaller, so that the page stays small.
fn render(scene: &Scene, isa: Isa) -> Result<Levels, Failure> {
    let mut draft = scene.clone().into_draft();
    let larger = draft.image.width.max(draft.image.height);
    if larger > SIDE {
        let scaled = |side: u32| (side * SIDE / larger).max(1);
        draft.image.width = scaled(draft.image.width);
        draft.image.height = scaled(draft.image.height);
    }
    let scene = Scene::new(draft).map_err(Failure::bad_input)?;
    let (compiled, grid) = (Compiled::new(&scene), Grid::new(&View::whole(&scene)));
    let quantiser = catoptric_scene::Quantiser::new(scene.image.transfer);
    let mut levels = Levels::new(grid.width, grid.height);
    let settings = Settings { isa, stack_limit: STACK_LIMIT };
    render_levels(&compiled, &grid, &quantiser, &mut levels.pixels, settings, &|_| {})
        .map_err(|full| Failure::failed(format_args!("{full}: lower max_depth in the scene")))?;
    Ok(levels)
}

/// A step's line in the log.
fn row(step: &Step) -> String {
    let numbers = step.numbers.iter().map(|(name, value)| {
        format!("<b>{}</b> {}", escaped(name), escaped(value)).trim_start().to_owned()
    });
    let swatch = step.colour.as_ref().map_or(String::new(), |colour| {
        format!("<span class=\"swatch\" style=\"background:{}\"></span> ", colour.css)
    });
    format!(
        "<tr><td>{}</td><td>{}</td><td>{}</td><td>{swatch}{}</td></tr>\n",
        step.number,
        escaped(&step.recursion),
        escaped(&step.engine),
        numbers.collect::<Vec<_>>().join("<br>")
    )
}

/// A colour as it is in the 8-bit picture.
fn css(life: &Life, colour: [f32; 3]) -> String {
    let [r, g, b] = life.levels(colour);
    format!("rgb({r},{g},{b})")
}
