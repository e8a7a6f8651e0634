//! The command line. Each subcommand is a file; each returns how the command ends, or an error that
//! is told in a line and ends it with code 1.

mod conform;
mod diagnostic;
mod diff;
mod ended;
mod exact;
mod new;
mod plan;
mod plan_accuracy;
mod plot;
mod report;
mod run;
mod scene;
mod schema;
mod select;
mod sensitivity;
mod shell;
mod study;
mod trace;
mod vectors;
mod verify;
mod verify_shown;

use std::process::ExitCode;

use annotate_snippets::Renderer;
use anyhow::Result;
use clap::{CommandFactory, Parser, Subcommand};

use self::diagnostic::BadScene;
use crate::exit::{self, BAD, Exit};
use crate::interrupt;
use crate::output::is_broken_pipe;

/// A literal, traceable reference of a 1980 model of stress waves in two crossed fibres.
#[derive(Parser)]
#[command(name = "crossfibre", version, after_help = exit::HELP, arg_required_else_help = true)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Write a commented scene to start from.
    New(new::Args),
    /// Run a scene and say what came of it.
    Run(run::Args),
    /// Draw a result: strain, tension and shape of the fibres.
    Plot(plot::Args),
    /// Print every number of every equation that a scene evaluates, or those you choose.
    Trace(trace::Args),
    /// Compare two traces: the first difference, where the fault lies, and all others counted.
    Diff(diff::Args),
    /// Solve a scene without the scheme: every front followed to any time.
    Exact(exact::Args),
    /// Say what a run of a scene will do: mesh, time step, equations that run and that do not.
    Plan(plan::Args),
    /// Run the checks, say what came of them and write the reports.
    Verify(verify::Args),
    /// Write the reports again from a stored record.
    Report(report::Args),
    /// Run a study, a sweep of many runs, and draw what comes of it.
    Study(study::Args),
    /// Judge another program: ask it, and hold its answers against the reference.
    Conform(conform::Args),
    /// Compare the golden vectors with what this program computes, or store them anew.
    Vectors(vectors::Args),
    /// Print the JSON Schema of a file format.
    Schema(schema::Args),
    /// Print the completions of the command line for a shell.
    Completions(shell::Completions),
    /// Print the manual page, or write those of all subcommands.
    Man(shell::Pages),
}

/// The whole command, from arguments to exit code.
pub fn main() -> ExitCode {
    interrupt::prepare();
    exit::guarded(|| match Cli::try_parse() {
        Ok(cli) => told(run(cli.command)),
        Err(usage) => {
            // Help that was asked for is no error. A message that cannot be printed is lost.
            let _ = usage.print();
            if usage.use_stderr() { Exit::BadInput } else { Exit::Well }
        }
    })
    .into()
}

fn run(command: Command) -> Result<Exit> {
    match command {
        Command::New(args) => new::run(&args),
        Command::Run(args) => run::run(&args),
        Command::Plot(args) => plot::run(&args),
        Command::Trace(args) => trace::run(args),
        Command::Diff(args) => diff::run(args),
        Command::Exact(args) => exact::run(&args),
        Command::Plan(args) => plan::run(&args),
        Command::Verify(args) => verify::run(&args),
        Command::Report(args) => report::run(&args),
        Command::Study(args) => study::run(args),
        Command::Conform(args) => conform::run(args),
        Command::Vectors(args) => vectors::run(&args),
        Command::Schema(args) => schema::run(&args),
        Command::Completions(args) => shell::completions(&args, Cli::command()),
        Command::Man(args) => shell::man(&args, Cli::command()),
    }
}

fn told(ended: Result<Exit>) -> Exit {
    match ended {
        Ok(exit) => exit,
        Err(error) if is_broken_pipe(&error) => Exit::Well,
        Err(error) => {
            exit::say(&match error.downcast_ref::<BadScene>() {
                Some(bad) => bad.rendered(&Renderer::styled()),
                None => format!("{BAD}error:{BAD:#} {error:#}"),
            });
            Exit::BadInput
        }
    }
}
