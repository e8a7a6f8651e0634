//! `crossfibre plot`: a result as a picture.

use std::fs;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, anyhow, bail};
use crossfibre::result_file;

use crate::exit::Exit;
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
    let name = if piped { "<stdin>".into() } else { args.result.display().to_string() };
    let bytes = if piped {
        let mut bytes = Vec::new();
        io::stdin().read_to_end(&mut bytes).context("<stdin>")?;
        bytes
    } else {
        fs::read(&args.result).with_context(|| name.clone())?
    };
    let text = String::from_utf8(bytes).map_err(|_| {
        anyhow!("{name}: is no text\n  help: `crossfibre run SCENE -o FILE.json` writes a result")
    })?;
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
