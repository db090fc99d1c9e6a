//! `catoptric explain`: what a scene has and needs and where its rays end; or the whole life of
//! one eye ray.

use std::io::Write;
use std::path::{Path, PathBuf};

use catoptric_core::Isa;
use catoptric_explain::{Account, ExplainError, Life, Picture, Pixel, page};
use catoptric_scene::Scene;
use catoptric_study::tracer::Threads;
use clap::Args;
use serde::Serialize;

use crate::exit::{Exit, Failure, say};
use crate::format::png;
use crate::input::is_stream;
use crate::memory::granted;
use crate::output::{Target, commit};
use crate::size::Size;
use crate::{interrupt, json, machine, scene};

/// Explain a scene, or one pixel's ray from the eye and back
///
/// Without --pixel: what the scene has and needs, how deep its rays go, what capping them costs
/// at most, and which max_depth is enough; the picture is rendered some times for that. With
/// --pixel: every call, hit, fold and return of the recursion beside what the engine's stack
/// does, with the numbers of both; a number that only one of them has is marked.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES, after_long_help = [KEYS, EXAMPLES].join("\n\n"))]
pub(crate) struct Options {
    /// Scene file; `-` reads stdin
    #[arg(value_name = "SCENE|-")]
    scene: PathBuf,

    /// Follow the eye ray of that pixel; 0,0 is the top left
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true, value_parser = pixel)]
    pixel: Option<Pixel>,

    /// Print one JSON document on stdout
    #[arg(long)]
    json: bool,

    /// Write the ray's life as one page for a browser, to be stepped through; needs --pixel
    #[arg(long, value_name = "FILE|-", requires = "pixel")]
    html: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  catoptric explain scenes/workshop.toml
  catoptric explain scenes/workshop.toml --pixel 494,200
  catoptric explain scenes/kissing.toml --pixel 320,240 --html ray.html
  catoptric explain scenes/workshop.toml --json";

const KEYS: &str = "\
Keys of --json, always all there; null where there is no value:
  schema, version        catoptric-explain; grows when a key changes or goes
  has, needs             primitives, mirrors, highlights, lamps; kinds of rays
  plan                   what the engine leaves out, and why that is safe
  rays                   by kind and by depth, as render --stats counts them;
                         deepest, and end: where they end without max_depth
  caps                   for smaller max_depth, the largest error of a channel
  enough                 the smallest max_depth with the same bits, or levels

Keys of --pixel X,Y --json; points are relative to the eye, colours linear:
  schema, version        catoptric-explain-pixel
  rungs                  whose accounts they are: r0 and r5 of the ladder, or,
                         past the recursion's stack, r3 and r5
  engine_forms_weights   false without min_weight: weights are then the first
                         rung's alone
  deepest                reflections behind the last ray
  colour, levels         of the pixel, linear and as 8-bit levels
  steps[].recursion      call, hit, fold or return
  steps[].engine         ray, push, end or fold; null if nothing is done
    of a call            origin, direction, weight
    of a hit             primitive, distance, local, k, followed, and last:
                         no_mirror, max_depth or min_weight, null if it is
                         followed; k of a last hit is the scene's, since
                         the engine keeps none
    of a fold            local, k, back, colour = local + k * back
    of a return          colour";

/// What `render` allows for the picture unless it is told otherwise.
const MEMORY: Size = Size(2 << 30);

fn pixel(text: &str) -> Result<Pixel, &'static str> {
    let number = |part: &str| part.trim().parse().ok();
    let both = text.split_once(',').and_then(|(x, y)| Some((number(x)?, number(y)?)));
    let (x, y) = both.ok_or("allowed are two whole numbers X,Y, such as 320,240")?;
    Ok(Pixel { x, y })
}

/// Explains, in the form that was asked for.
pub(crate) fn run(options: &Options) -> Result<Exit, Failure> {
    interrupt::catch();
    // Refuse wrong use and a closed stdout before the scene is read.
    if options.json || options.html.is_none() {
        Target::stdout()?;
    }
    let isa = machine::instruction_set()?;
    if options.json && options.html.as_deref().is_some_and(is_stream) {
        return Err(Failure::wrong_use("--json and --html - cannot both go to stdout"));
    }
    let scene = scene::read(&options.scene)?;
    // The recursion needs a large stack on every thread.
    let threads = machine::available_threads();
    let threads = Threads::new([threads]).map_err(|error| {
        let stack = catoptric_reference::STACK_BYTES;
        let fewer = |threads| match threads {
            1 => "run it on one processor (taskset -c 0)".to_owned(),
            _ => format!("run it on {threads} processors (taskset -c 0-{})", threads - 1),
        };
        machine::Wanted { threads, stack, fewer, instead: None }.refused(&error)
    })?;
    // Without a pixel the whole scene is explained.
    match options.pixel {
        None => {
            let name = options.scene.to_string_lossy();
            check_memory(&scene)?;
            let account = threads.most().install(|| Account::new(&name, &scene, isa));
            let account = account.map_err(refused)?;
            print(options.json, &account, |to| account.write(to))?;
        }
        Some(pixel) => explain_pixel(options, &scene, pixel, &threads, isa)?,
    }
    Ok(Exit::Done)
}

fn explain_pixel(
    options: &Options,
    scene: &Scene,
    pixel: Pixel,
    threads: &Threads,
    isa: Isa,
) -> Result<(), Failure> {
    pixel.check(scene).map_err(refused)?;
    let target = options.html.as_deref().map(|path| page_target(path, &options.scene));
    let target = target.transpose()?;

    let name = options.scene.to_string_lossy();
    let life = threads.most().install(|| Life::new(&name, scene, pixel, isa)).map_err(refused)?;
    let Some(target) = target else {
        return print(options.json, &life, |to| life.write(to));
    };
    let page = threads.most().install(|| page(&life, isa, png_file)).map_err(refused)?;
    let staged = target.stage(|to| to.write_all(page.as_bytes()))?;
    if options.json {
        print(true, &life, |_| Ok(()))?;
    }
    commit([staged])?;
    say(format_args!(
        "{}: {} steps, to be opened in a browser",
        target.closing_name(),
        life.steps()
    ));
    Ok(())
}

/// Two films are compared with each other.
fn check_memory(scene: &Scene) -> Result<(), Failure> {
    let need = Size(Account::memory(scene));
    if need > MEMORY || !granted(need.0) {
        let (width, height) = (scene.image.width, scene.image.height);
        return Err(Failure::bad_input(format_args!(
            "two films of {width}x{height}, which are compared with each other, need {need} of memory, and the limit is {MEMORY}: lower image.width and image.height in the scene"
        )));
    }
    Ok(())
}

/// The exit code of what cannot be explained.
fn refused(error: ExplainError) -> Failure {
    match error {
        ExplainError::NoPixel { .. } => Failure::wrong_use(error),
        ExplainError::NoSmallerPicture(_) => Failure::bad_input(error),
        ExplainError::PictureTooDeep { .. }
        | ExplainError::LifeTooDeep { .. }
        | ExplainError::Differs { .. }
        | ExplainError::PagePictureTooDeep(_) => Failure::failed(error),
    }
}

/// The page's picture as a file.
fn png_file(picture: &Picture) -> Vec<u8> {
    let Picture { width, height, ref pixels, transfer } = *picture;
    let mut file = Vec::new();
    png::encode(pixels.as_flattened(), width, height, Some(transfer), &mut file)
        .expect("a picture of that size can be written to memory");
    file
}

/// The target of the page; refuses to write over the scene.
fn page_target(path: &Path, scene: &Path) -> Result<Target, Failure> {
    let target = Target::new(path)?;
    if target.replaces(scene) {
        let name = target.name();
        return Err(Failure::wrong_use(format_args!(
            "{name} is the scene itself: name another file"
        )));
    }
    target.probe()?;
    Ok(target)
}

/// One document on stdout, as JSON or as words.
fn print(
    as_json: bool,
    document: &impl Serialize,
    words: impl FnOnce(&mut dyn Write) -> std::io::Result<()>,
) -> Result<(), Failure> {
    let stdout = Target::stdout()?;
    let staged = stdout.stage(|to| if as_json { json::write(to, document) } else { words(to) });
    staged.map(drop)
}
