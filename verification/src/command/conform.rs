//! `crossfibre conform`: judges another program.

use std::ffi::OsString;
use std::io::{self, Write};
use std::path::PathBuf;
use std::time::Duration;

use anyhow::Result;
use crossfibre::scene::Scene;
use indicatif::ProgressBar;

use crate::conform::interview::conform;
use crate::conform::protocol::{Ask, Depth};
use crate::conform::record::{Report, Verdict};
use crate::conform::session::{Options, Session};
use crate::conform::shrink::shrink;
use crate::conform::text::Text;
use crate::conform::{html, junit, questions};
use crate::exit::{Exit, say};
use crate::output::Destination;

/// Arguments.
#[derive(clap::Args)]
pub struct Args {
    /// Only these depths: equation, step, run
    #[arg(long, value_name = "DEPTHS", value_delimiter = ',')]
    depth: Vec<Depth>,
    /// Only questions whose name has this in it, such as run/fig3
    #[arg(long, value_name = "TEXT")]
    filter: Option<String>,
    /// Draws other fresh questions
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Demand equal bits
    #[arg(long)]
    exact: bool,
    /// The candidate computes in f32: judge it by the rounding of f32
    #[arg(long)]
    single: bool,
    /// The longest wait for an answer, seconds
    #[arg(long, value_name = "SECONDS", default_value = "60", value_parser = seconds)]
    timeout: Duration,
    /// Write JUnit XML to FILE
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// Write a page to FILE
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    /// Write the whole report as JSON to standard output, or with -o to FILE
    #[arg(long)]
    json: bool,
    /// Write the report as JSON to FILE, `-` for standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// If a run is wrong, look for the smallest scene that is, and write it to FILE
    #[arg(long, value_name = "FILE")]
    shrink: Option<PathBuf>,
    /// The program to be judged and its arguments, after `--`
    #[arg(last = true, required = true, value_name = "COMMAND")]
    command: Vec<OsString>,
}

fn seconds(text: &str) -> Result<Duration, String> {
    let wrong = || "a number of seconds, more than 0 and at most 86400".to_owned();
    let seconds: f64 = text.parse().map_err(|_| wrong())?;
    if seconds > 0.0 && seconds <= 86_400.0 {
        Ok(Duration::from_secs_f64(seconds))
    } else {
        Err(wrong())
    }
}

pub fn run(args: Args) -> Result<Exit> {
    let file = |path: &Option<PathBuf>| {
        path.as_deref().map(|path| Destination::of(Some(path))).transpose()
    };
    let [to_junit, to_html, to_json, to_scene] =
        [file(&args.junit)?, file(&args.html)?, file(&args.output)?, file(&args.shrink)?];
    let options = Options {
        depths: args.depth,
        filter: args.filter,
        seed: args.seed,
        exact: args.exact,
        single: args.single,
        timeout: args.timeout,
    };
    // Drawn on standard error, and only if that is a terminal.
    let bar = ProgressBar::new(0);
    let (report, session) = conform(&args.command, &options, |done, all| {
        bar.set_length(all as u64);
        bar.set_position(done as u64);
    })?;
    bar.finish_and_clear();

    write(to_junit, &junit::render(&report)?)?;
    write(to_html, &html::render(&report))?;
    let json = serde_json::to_string_pretty(&report)? + "\n";
    let on_stdout = args.json && to_json.is_none();
    write(to_json, &json)?;
    let mut out = io::stdout().lock();
    if on_stdout {
        out.write_all(json.as_bytes())?;
    } else {
        write!(out, "{}", Text(&report))?;
    }
    drop(out);
    if let Some(to) = to_scene {
        write_smallest(to, &report, session)?;
    } else if report.count(Verdict::Wrong) > 0 {
        say("docs/conformance.md says how to find the equation that is wrong");
    }
    Ok(if report.conforms { Exit::Well } else { Exit::CandidateDisagrees })
}

fn write(to: Option<Destination>, text: &str) -> Result<()> {
    let Some(to) = to else { return Ok(()) };
    let mut out = to.open()?;
    out.write_all(text.as_bytes())?;
    out.finish()
}

/// Scenes that are tried on the way to the smallest.
const TRIES: usize = 400;

fn write_smallest(to: Destination, report: &Report, mut session: Session) -> Result<()> {
    let runs = questions::all(report.seed).into_iter().filter_map(|item| match item.ask {
        Ask::Run { scene } => Some((item.id, *scene)),
        _ => None,
    });
    let is_wrong =
        |id: &str| report.items.iter().any(|i| i.verdict == Verdict::Wrong && i.id == id);
    let Some((id, scene)) = runs.into_iter().find(|(id, _)| is_wrong(id)) else {
        say("no run is wrong: there is no scene to be made smaller");
        return Ok(());
    };
    let smallest = shrink(&scene, TRIES, |scene| session.is_wrong(scene) == Some(true));
    let title = format!("{id} made smaller while {} is wrong", report.candidate.name);
    let smallest = Scene { title, ..smallest };
    write(Some(to), &(serde_json::to_string_pretty(&smallest)? + "\n"))?;
    let elements = |scene: &Scene| {
        scene.primary.elements + scene.secondary.as_ref().map_or(0, |secondary| secondary.elements)
    };
    say(&format!(
        "{id} with {} elements in the place of {}",
        elements(&smallest),
        elements(&scene)
    ));
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wait_is_more_than_nothing_and_at_most_a_day() {
        assert_eq!(seconds("0.7"), Ok(Duration::from_millis(700)));
        assert_eq!(seconds("86400"), Ok(Duration::from_secs(86_400)));
        for bad in ["0", "-0.7", "86400.1", "inf", "NaN", "soon", ""] {
            assert!(seconds(bad).is_err(), "{bad}");
        }
    }
}
