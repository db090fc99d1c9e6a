//! The program `catoptric`.
//!
//! ```text
//! render.rs     scene to picture: the order of events
//!   render/       its options, its input, its engines, progress, statistics
//! compare.rs    two pictures: what differs
//!   compare/      measuring differences, reporting them
//! generate.rs   families of scenes: options to scene to file
//!   generate/     the families' options, the command that makes a file again
//! format.rs     png, ppm, pfm: bytes of a picture, both ways
//! input.rs      bytes of a file or of stdin
//! output.rs     where bytes go: beside and renamed, or directly
//! interrupt.rs  signals: remove what is unfinished, exit 130
//! memory.rs     sizes, and what a rendering will take
//! whole.rs      whole numbers of the command line
//! exit.rs       exit codes and error messages
//! ```

mod compare;
mod exit;
mod format;
mod generate;
mod input;
mod interrupt;
mod memory;
mod output;
mod render;
mod whole;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

use exit::Exit;

/// Whitted ray tracing of spheres and planes: Phong light, hard shadows, mirrors
#[derive(Parser)]
#[command(name = "catoptric", version, arg_required_else_help = true, after_help = EXIT_CODES)]
struct Catoptric {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Render(Box<render::Options>),
    Compare(compare::Options),
    Generate(generate::Options),
}

const EXIT_CODES: &str = "\
Exit codes:
    0  done
    1  the rendering failed, or `compare` found a difference
    2  wrong use, or pictures that cannot be compared
    3  a scene or picture is missing or bad, or needs more memory than the limit
    4  output could not be written
  130  interrupted";

fn main() -> ExitCode {
    let asked = match Catoptric::try_parse() {
        Ok(asked) => asked,
        // Help and version come this way too, with code 0.
        Err(answer) => {
            let printed = answer.print();
            return match (answer.exit_code(), printed) {
                (0, Ok(())) => Exit::Done.into(),
                (0, Err(_)) => Exit::NotWritten.into(),
                _ => Exit::WrongUse.into(),
            };
        }
    };
    let ended = match asked.command {
        Command::Render(options) => render::run(&options),
        Command::Compare(options) => compare::run(&options),
        Command::Generate(options) => generate::run(&options),
    };
    match ended {
        Ok(exit) => exit.into(),
        Err(failure) => {
            failure.report();
            failure.exit.into()
        }
    }
}
