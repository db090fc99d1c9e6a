//! The program `catoptric`.
//!
//! ```text
//! render.rs     scene to picture: the order of events
//!   render/       its options, its input, its engines, progress, statistics
//! compare.rs    two pictures: what differs
//!   compare/      its options, measuring differences, reporting them
//! generate.rs   families of scenes: options to scene to file
//!   generate/     the families' options, the command that makes a file again
//! explain.rs    what a scene needs, or the life of one eye ray, as words, JSON or a page
//! study.rs      what accuracy and depth cost: options to report to files
//!   study/        its options, its interruption, where the report goes
//! format.rs     png, ppm, pfm: bytes of a picture, both ways
//! scene.rs      a scene's file
//! input.rs      bytes of a file or of stdin
//! output.rs     where bytes go: beside and renamed, or directly
//!   output/       what a path leads to, files beside their names, files that the caller opened
//! json.rs       JSON documents
//! interrupt.rs  signals: remove what is unfinished, exit 130
//! machine.rs    instruction sets
//!   machine/      threads and their stacks, limits of the process and of its memory cgroup
//! arguments.rs  the command line, and what is wrong with it
//! memory.rs     what a rendering will take
//! size.rs       sizes in bytes
//! whole.rs      whole numbers of the command line
//! exit.rs       exit codes and error messages
//! ```

mod arguments;
mod compare;
mod exit;
mod explain;
mod format;
mod generate;
mod input;
mod interrupt;
mod json;
mod machine;
mod memory;
mod output;
mod render;
mod scene;
mod size;
mod study;
mod whole;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

use exit::Exit;

/// Whitted ray tracing of spheres and planes: Phong light, hard shadows, mirrors
#[derive(Parser)]
#[command(name = "catoptric", version, arg_required_else_help = true, after_help = EXIT_CODES)]
// Not what the program was started as, which may be anything.
#[command(bin_name = "catoptric")]
struct Catoptric {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Render(Box<render::Options>),
    Compare(compare::Options),
    Explain(explain::Options),
    Study(study::Options),
    Generate(generate::Options),
}

const EXIT_CODES: &str = "\
Exit codes:
    0  done
    1  the rendering failed, `compare` found a difference, a study found a wrong picture
    2  wrong use, or pictures that cannot be compared
    3  a scene or picture is missing or bad, or needs more memory than the limit
    4  output could not be written
  130  interrupted";

fn main() -> ExitCode {
    machine::on_enough_stack(program)
}

fn program() -> ExitCode {
    let asked = match Catoptric::try_parse() {
        Ok(asked) => asked,
        // Help and version come this way too, with code 0.
        Err(answer) => {
            if !answer.use_stderr()
                && let Err(failure) = output::Target::stdout()
            {
                failure.report();
                return failure.exit.into();
            }
            let answer = arguments::shown(answer);
            let printed = answer.print();
            return match (answer.exit_code(), printed) {
                (0, Ok(())) => Exit::Done.into(),
                (0, Err(_)) => Exit::NotWritten.into(),
                _ => Exit::WrongUse.into(),
            };
        }
    };
    // The exit code is what the command answers, or its failure's.
    let ended = match asked.command {
        Command::Render(options) => render::run(&options),
        Command::Compare(options) => compare::run(&options),
        Command::Explain(options) => explain::run(&options),
        Command::Study(options) => study::run(&options),
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
