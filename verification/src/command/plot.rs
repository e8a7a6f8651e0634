//! `crossfibre plot`: a result as a picture.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use anyhow::{Result, anyhow, bail};
use crossfibre::result_file;

use crate::exit::Exit;
use crate::input;
use crate::output::Destination;
use crate::result_plot::picture;

/// Arguments.
#[derive(clap::Args)]
pub struct Args {
    /// A result (crossfibre-result/1), written by `run -o FILE.json`; `-` for standard input
    #[arg(value_name = "RESULT")]
    result: PathBuf,
    /// Write the picture, SVG, to FILE, `-` for standard output [default: RESULT with the ending .svg]
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

pub fn run(args: &Args) -> Result<Exit> {
    let piped = args.result == Path::new("-");
    let beside = args.result.with_extension("svg");
    let output = args.output.as_deref().or((!piped).then_some(&beside));
    if output == Some(&args.result) {
        bail!("{}: is the result itself\n  help: name another file by -o", args.result.display());
    }
    let destination = Destination::of(output)?;
    let to_stdout = matches!(destination, Destination::Stdout);
    let (name, text) =
        input::text(&args.result, "`crossfibre run SCENE -o FILE.json` writes a result")?;
    let result = result_file::read(&text).map_err(|problem| {
        let path =
            if problem.path.is_empty() { String::new() } else { format!("{}: ", problem.path) };
        let help = problem.help.map_or(String::new(), |help| format!("\n  help: {help}"));
        anyhow!("{name}: {path}{}{help}", problem.message)
    })?;
    let mut out = destination.open()?;
    out.write_all(picture(&result).as_bytes())?;
    out.finish()?;
    if let Some(output) = output.filter(|_| !to_stdout) {
        writeln!(io::stdout().lock(), "{}", output.display())?;
    }
    Ok(Exit::Well)
}
