//! `crossfibre completions` and `crossfibre man`: the command line told to a shell and to `man`.

use std::io::Write;
use std::path::PathBuf;

use anyhow::Result;
use clap_complete::Shell;
use clap_mangen::Man;

use crate::exit::Exit;
use crate::output::{Destination, Output, make_folder};

/// Arguments of `completions`.
#[derive(clap::Args)]
pub struct Completions {
    /// The shell
    shell: Shell,
}

/// Arguments of `man`.
#[derive(clap::Args)]
pub struct Pages {
    /// Folder for a page of each subcommand as well, crossfibre-run.1 and so on, in place of standard
    /// output
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

pub fn completions(args: &Completions, mut cli: clap::Command) -> Result<Exit> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut cli, "crossfibre", &mut script);
    let mut out = Destination::Stdout.open()?;
    out.write_all(&script)?;
    out.finish()?;
    Ok(Exit::Well)
}

pub fn man(args: &Pages, cli: clap::Command) -> Result<Exit> {
    // `help` has no page of its own: the pages are it.
    let mut cli = cli.disable_help_subcommand(true);
    let Some(folder) = &args.out else {
        page(cli, Destination::Stdout.open()?)?;
        return Ok(Exit::Well);
    };
    make_folder(folder)?;
    // Gives the subcommands their full names.
    cli.build();
    let mut waiting = vec![cli];
    while let Some(command) = waiting.pop() {
        waiting.extend(command.get_subcommands().cloned());
        let name = command.get_display_name().unwrap_or_else(|| command.get_name()).to_owned();
        page(command, Destination::of(Some(&folder.join(format!("{name}.1"))))?.open()?)?;
    }
    Ok(Exit::Well)
}

fn page(command: clap::Command, mut out: Output) -> Result<()> {
    let program = concat!("crossfibre ", env!("CARGO_PKG_VERSION"));
    // Blank, not empty: an empty date is no argument, and the program would stand in its place.
    Man::new(command).date(" ").source(program).manual("crossfibre").render(&mut out)?;
    out.finish()
}
