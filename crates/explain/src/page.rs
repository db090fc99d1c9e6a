//! A ray's life as one page: it needs nothing beside it and no network, and without scripts it
//! still shows the picture, the path and the log.

mod steps;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use catoptric_core::{Engine, Isa, Levels, Settings};
use catoptric_report::escaped;
use catoptric_scene::{Compiled, Grid, Quantiser, Scene, Transfer, View};
use catoptric_study::tracer::STACK_LIMIT;

use crate::drawing::draw;
use crate::error::ExplainError;
use crate::life::Life;
use crate::life::text::{about, rgb};
use crate::pixel::Pixel;
use steps::{Step, css, steps};

/// What the page may load and run: nothing but what stands in it. A browser refuses the rest.
const POLICY: &str =
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:";

/// Columns or rows of the page's picture, at most.
const SIDE: u32 = 800;

/// Below half of it a picture is shown enlarged.
const SMALL: u32 = 320;

/// An 8-bit picture of the scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Levels, row by row from the top left.
    pub pixels: Vec<[u8; 3]>,
    /// How the levels come from light.
    pub transfer: Transfer,
}

/// The page; its picture is rendered on rayon's current threads, and `png` makes it a file.
///
/// # Errors
/// [`ExplainError::PagePictureTooDeep`], and [`ExplainError::NoSmallerPicture`] for a scene whose
/// image is too large for a page and cannot be made smaller.
pub fn page(
    life: &Life,
    isa: Isa,
    png: impl FnOnce(&Picture) -> Vec<u8>,
) -> Result<String, ExplainError> {
    // Make the parts: the picture, the steps and the drawing.
    let picture = render(life.scene, isa)?;
    let png = png(&picture);
    let (steps, hidden) = steps(life);
    let drawing = draw(life);
    let Pixel { x, y } = life.pixel;
    let (width, height) = (life.scene.image.width, life.scene.image.height);
    let place = |at: u32, size: u32| (f64::from(at) + 0.5) / f64::from(size) * 100.0;
    // How many times a tiny picture is enlarged.
    let times = (SMALL / picture.width.max(picture.height)).max(1);
    // Say what is enlarged, made smaller or left out.
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
    // Fill the template; texts from the scene are escaped.
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
fn render(scene: &Scene, isa: Isa) -> Result<Picture, ExplainError> {
    let mut draft = scene.clone().into_draft();
    let larger = draft.image.width.max(draft.image.height);
    if larger > SIDE {
        let scaled = |side: u32| (side * SIDE / larger).max(1);
        draft.image.width = scaled(draft.image.width);
        draft.image.height = scaled(draft.image.height);
    }
    let scene = Scene::new(draft).map_err(ExplainError::NoSmallerPicture)?;
    let (compiled, grid) = (Compiled::new(&scene), Grid::new(&View::whole(&scene)));
    let (width, height, transfer) = (grid.width, grid.height, scene.image.transfer);
    let mut pixels = vec![[0; 3]; width as usize * height as usize];
    let settings = Settings { isa, stack_limit: STACK_LIMIT };
    let target = Levels { quantiser: &Quantiser::new(transfer), pixels: &mut pixels };
    Engine::new(&compiled)
        .with(settings)
        .render(&grid, target)
        .map_err(ExplainError::PagePictureTooDeep)?;
    Ok(Picture { width, height, pixels, transfer })
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
