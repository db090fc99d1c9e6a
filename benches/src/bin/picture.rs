//! One picture by a plan, for tools that count what a process does: `picture SCENE WIDTH HEIGHT
//! DEPTH [WITHOUT]`, on one thread and to nowhere.
//!
//! SCENE is a scene's file. WITHOUT names an omission that the plan does not make, or is `plan`
//! (the default) or `everything`, a plan that makes none. Exit code 2: wrong use.

use std::env;
use std::path::Path;
use std::process::ExitCode;

use catoptric_core::{Engine, Isa, Omission, Plan, Settings};
use catoptric_scene::{Compiled, Document, Film, Grid, Scene, SceneFormat, View};
use catoptric_tests::identity::pool;
use catoptric_tests::scenes::sized;

const USAGE: &str = "usage: picture SCENE WIDTH HEIGHT DEPTH [plan|everything|OMISSION]";

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match run(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("picture: {message}");
            ExitCode::from(2)
        }
    }
}

fn run(arguments: &[&str]) -> Result<(), String> {
    let (scene, width, height, depth, without) = match *arguments {
        [scene, width, height, depth] => (scene, width, height, depth, "plan"),
        [scene, width, height, depth, without] => (scene, width, height, depth, without),
        _ => return Err(USAGE.to_owned()),
    };
    let number = |text: &str| text.parse().map_err(|_| format!("no number: {text}\n{USAGE}"));
    let scene = read(scene, number(width)?, number(height)?, number(depth)?)?;
    let (compiled, grid) = (Compiled::new(&scene), Grid::new(&View::whole(&scene)));
    let plan = match without {
        "plan" => Plan::new(&compiled, &grid),
        "everything" => Plan::new(&compiled, &grid).everything(),
        name => {
            let omission = Omission::ALL.into_iter().find(|omission| omission.name() == name);
            let omission = omission.ok_or(format!("no omission: {name}\n{USAGE}"))?;
            Plan::new(&compiled, &grid).without(omission)
        }
    };
    let mut film = Film::new(grid.width, grid.height);
    let settings = Settings { isa: Isa::detected(), stack_limit: 1 << 30 };
    pool(1)
        .install(|| Engine::new(&compiled).with(settings).render_planned(&plan, &mut film))
        .map_err(|full| full.to_string())?;
    Ok(())
}

fn read(path: &str, width: u32, height: u32, depth: u32) -> Result<Scene, String> {
    let text = std::fs::read(path).map_err(|error| format!("{path}: {error}"))?;
    let document = Document::parse(path, &text, SceneFormat::of_path(Path::new(path)));
    let document = document.map_err(|error| error.to_string())?;
    Ok(sized(document.draft(), width, height, depth))
}
