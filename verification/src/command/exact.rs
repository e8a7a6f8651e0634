//! `crossfibre exact`: the motion of a scene without the scheme.

use std::io::{self, Write};
use std::path::PathBuf;

use anyhow::{Result, bail};

use super::scene;
use crate::closed_form;
use crate::exact_file::ExactFile;
use crate::exact_plot::picture;
use crate::exact_summary::ExactSummary;
use crate::exit::{Exit, say};
use crate::output::Destination;

/// Arguments.
#[derive(clap::Args)]
pub struct Args {
    /// The scene, `-` for standard input; mesh, Courant number and corrections play no part
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Solve to SECONDS after impact instead of the scene's duration
    #[arg(short, long, value_name = "SECONDS", allow_hyphen_values = true)]
    time: Option<f64>,
    /// Write the solution as JSON (crossfibre-exact/1) to FILE, `-` for standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Draw strain along the fibres and the ways of all fronts as SVG to FILE
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Write the solution as JSON instead of the summary
    #[arg(long)]
    json: bool,
}

pub fn run(args: &Args) -> Result<Exit> {
    let destination = Destination::of(args.output.as_deref())?;
    let scene = scene::read(&args.scene)?;
    if let Some(why) = closed_form::beyond(&scene) {
        bail!(
            "no exact motion of this scene: {why}\n  help: `crossfibre run` has Smith's strain for a \
             polynomial or exponential law beside its own"
        );
    }
    let time = args.time.unwrap_or(scene.duration);
    if !(time.is_finite() && time > 0.0) {
        bail!("--time {time}: must be a positive number of seconds after impact, such as 28.7e-6");
    }
    let plot = args.plot.as_deref().map(|path| Destination::of(Some(path))).transpose()?;
    let (file, motion) = ExactFile::of(&scene, time);
    if let Some(plot) = plot {
        let mut out = plot.open()?;
        out.write_all(picture(&scene, &file, &motion).as_bytes())?;
        out.finish()?;
    }
    let to_stdout = matches!(destination, Destination::Stdout);
    if args.json || args.output.is_some() {
        let mut out = destination.open()?;
        serde_json::to_writer(&mut out, &file).map_err(io::Error::from)?;
        writeln!(out)?;
        out.finish()?;
    }
    if !(args.json || args.output.is_some() && to_stdout) {
        write!(io::stdout().lock(), "{}", ExactSummary(&file))?;
    }
    Ok(match file.ended {
        None => Exit::Well,
        Some(ended) => {
            say(&format!(
                "solved to {:.4} µs only: {ended}\n  help: --time {:e} has a solution",
                file.time * 1e6,
                (file.time * 1e9).floor() / 1e9
            ));
            Exit::RunEnded
        }
    })
}
