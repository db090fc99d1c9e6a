//! `catoptric generate`: a family, a few numbers and a seed to a scene file.

mod options;
mod recipe;

use std::path::{Path, PathBuf};

use catoptric_scene::{Draft, Scene, SceneFormat};

use crate::exit::{Exit, Failure, say};
use crate::input::is_stream;
use crate::interrupt;
use crate::output::{Target, commit};
pub(crate) use options::Options;
use options::{Common, Format};
use recipe::Recipe;

/// Makes a scene and writes it.
///
/// Wrong use is found before anything is made, and what cannot be written before the text.
pub(crate) fn run(options: &Options) -> Result<Exit, Failure> {
    interrupt::catch();
    let (family, common) = options.family.parts();
    let (path, format) = place(family.name(), common)?;
    let mut draft = family.draft(common.seed).map_err(|refused| {
        let option = refused.parameter.replace('_', "-");
        let (found, allowed) = (refused.found, refused.allowed);
        Failure::wrong_use(format_args!("--{option}: found {found}; allowed: {allowed}"))
    })?;
    common.override_scene(&mut draft);
    let scene = Scene::new(draft).map_err(Failure::wrong_use)?;
    let target = Target::new(&path)?;

    let head = match format {
        SceneFormat::Toml => head(family.name(), common, &family.recipe()),
        // JSON has no comments.
        SceneFormat::Json => String::new(),
    };
    let text = scene.to_text(format);
    let staged = target.stage(|to| {
        to.write_all(head.as_bytes())?;
        to.write_all(text.as_bytes())
    })?;
    commit([staged])?;
    if !common.quiet {
        summarise(&target, &scene);
    }
    Ok(Exit::Done)
}

/// The path and the format that the scene is written with.
fn place(family: &str, common: &Common) -> Result<(PathBuf, SceneFormat), Failure> {
    let format = match (&common.output, common.format) {
        (_, Some(format)) => format,
        (Some(path), None) if !is_stream(path) => of_ending(path)?,
        (_, None) => Format::Toml,
    };
    let path = common.output.clone();
    let path = path.unwrap_or_else(|| PathBuf::from(format!("{family}.{}", format.name())));
    Ok((path, format.of_scene()))
}

fn of_ending(path: &Path) -> Result<Format, Failure> {
    Format::of_path(path).ok_or_else(|| {
        Failure::wrong_use(format_args!(
            "-o {} does not say which format: allowed endings are .toml and .json, or name one with --format",
            path.display()
        ))
    })
}

/// The comment that a TOML file begins with: how to make it again.
fn head(family: &str, common: &Common, recipe: &Recipe) -> String {
    let recipe = common.add_to(recipe.clone());
    let seed = common.seed;
    format!("# Family {family}, seed {seed}. The command that makes this file:\n#   {recipe}\n\n")
}

/// One line for people.
fn summarise(target: &Target, scene: &Draft) {
    let count = |number: usize, noun: &str| match number {
        1 => format!("1 {noun}"),
        _ => format!("{number} {noun}s"),
    };
    say(format_args!(
        "{}: {}, {}, {}",
        target.closing_name(),
        count(scene.spheres.len(), "sphere"),
        count(scene.planes.len(), "plane"),
        count(scene.lights.len(), "light"),
    ));
}
