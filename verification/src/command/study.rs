//! `crossfibre study`: sweeps of many runs, and what is drawn from them.

use std::env;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use anyhow::Result;
use clap::Subcommand;
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::cost;
use crate::exit::{self, Exit};
use crate::extremes;
use crate::output::{Destination, make_folder};
use crate::precision::measure::{Effort, times};
use crate::sweep::{Places, Point, Shard, sweep};
use crate::{figures, precision, stability};

/// Arguments.
#[derive(clap::Args)]
pub struct Args {
    #[command(subcommand)]
    study: Study,
}

#[derive(Subcommand)]
enum Study {
    /// Redraw Figs 3 to 7 of the paper, from the scheme and from exact solutions.
    Figures(Sweep),
    /// Find the largest stable Courant numbers, and compare them with the linearised step.
    Stability(Sweep),
    /// Run the extreme cases, and say what happens, whether it is right, and what the program says.
    Extremes(Extremes),
    /// Set errors against work and time, on ladders of meshes and in many variants.
    WorkPrecision(WorkPrecision),
    /// Count what each part of a scene costs: evaluations, and instructions where valgrind is there.
    Cost(Page),
}

/// Where the page of the extreme cases goes.
#[derive(clap::Args)]
struct Extremes {
    /// Folder for the page, in place of standard output
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// Where the page of a study goes.
#[derive(clap::Args)]
struct Page {
    /// Folder for the page
    #[arg(long, default_value = "target/study/cost", value_name = "DIR")]
    out: PathBuf,
}

/// Names of files, and what is in them.
type Files = Vec<(&'static str, String)>;

/// Where a study goes, and which part of it is computed.
#[derive(clap::Args)]
struct Sweep {
    /// Folder for the pictures, tables and the page [default: target/study/STUDY]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Folder where each finished run is stored; what is there is not computed again [default: one
    /// in target/study for each study and build]
    #[arg(long, value_name = "DIR")]
    points: Option<PathBuf>,
    /// Compute part I of N only, and draw nothing as long as runs are missing
    #[arg(long, value_name = "I/N")]
    shard: Option<Shard>,
    /// Take over the runs stored in another folder (may be repeated)
    #[arg(long, value_name = "DIR")]
    from: Vec<PathBuf>,
}

/// How far the study of error against work goes.
#[derive(clap::Args)]
struct WorkPrecision {
    #[command(flatten)]
    sweep: Sweep,
    /// Elements of 0.25 mm and longer only, and few rounds of measured time
    #[arg(long, conflicts_with = "full")]
    quick: bool,
    /// Many rounds of measured time, and instructions where valgrind is there: some minutes
    #[arg(long)]
    full: bool,
    /// Measure no time; what is drawn is the same wherever it is drawn
    #[arg(long, conflicts_with = "full")]
    no_times: bool,
    /// Draw the times of an earlier study, its times.json, and measure none
    #[arg(long, conflicts_with_all = ["full", "no_times"], value_name = "FILE")]
    times: Option<PathBuf>,
}

pub fn run(args: Args) -> Result<Exit> {
    match args.study {
        Study::Figures(sweep) => {
            let draw =
                |points: &[_], found| Ok(figures::files(&figures::Snapshots::new(points, found)));
            study(
                sweep,
                figures::STUDY,
                &figures::points::points(),
                figures::points::snapshot,
                draw,
            )
        }
        Study::WorkPrecision(work_precision) => study_precision(work_precision),
        Study::Extremes(Extremes { out }) => write_extremes(out.as_deref()),
        Study::Cost(page) => write_cost(&page),
        Study::Stability(sweep) => {
            let draw =
                |points: &[_], found| Ok(stability::files(&stability::Results::new(points, found)));
            let points = stability::tasks::points();
            study(sweep, stability::STUDY, &points, stability::tasks::compute, draw)
        }
    }
}

fn study_precision(args: WorkPrecision) -> Result<Exit> {
    let WorkPrecision { sweep, quick, full, no_times, times: earlier } = args;
    let finest = if quick { precision::QUICK } else { precision::FINEST };
    let effort = match (quick, full) {
        (true, _) => Effort { rounds: 3, instructions: false },
        (_, true) => Effort { rounds: 9, instructions: true },
        _ => Effort { rounds: 5, instructions: false },
    };
    // Before minutes of work, not after.
    let earlier = earlier.as_deref().map(precision::Times::read).transpose()?;
    let draw = |_: &[_], found| {
        let record = precision::Record::of(finest, found);
        let times = match &earlier {
            Some(earlier) => Some(earlier.clone()),
            None if no_times => None,
            None => {
                let (times, notes) = times(&record, effort)?;
                notes.iter().for_each(|note| exit::say(note));
                Some(times)
            }
        };
        Ok(precision::files(&record, times.as_ref()))
    };
    let points = precision::points(finest);
    study(sweep, precision::STUDY, &points, precision::found, draw)
}

fn write_extremes(out: Option<&Path>) -> Result<Exit> {
    let Some(folder) = out else {
        write!(io::stdout().lock(), "{}", extremes::page())?;
        return Ok(Exit::Well);
    };
    make_folder(folder)?;
    write(&folder.join("README.md"), &extremes::page())?;
    Ok(Exit::Well)
}

/// Computes the points of a study that are not stored, and if none is missing, draws.
fn study<P, V>(
    args: Sweep,
    name: &str,
    points: &[Point<P>],
    compute: impl Fn(&P) -> V + Sync,
    draw: impl Fn(&[Point<P>], Vec<V>) -> Result<Files>,
) -> Result<Exit>
where
    P: Serialize + Sync,
    V: Serialize + DeserializeOwned + Send,
{
    let Sweep { out, points: folder, shard, from } = args;
    let short = name.split('/').next().unwrap_or(name);
    let out = out.unwrap_or_else(|| Path::new("target/study").join(short));
    // A folder for each build of the program, so that what another one has computed is not in the way.
    let folder = folder.unwrap_or_else(|| {
        Path::new("target/study").join(format!("{short}-points")).join(env!("CROSSFIBRE_SOURCE"))
    });
    // Before hours of work, not after.
    make_folder(&out)?;
    let places = Places { points: folder, from, shard };
    let values = sweep(name, points, &places, compute)?;
    let all = values.len();
    let found: Vec<_> = values.into_iter().flatten().collect();
    let mut to = io::stdout().lock();
    writeln!(to, "runs: {} of {all} in {}", found.len(), places.points.display())?;
    if found.len() < all {
        writeln!(to, "nothing is drawn yet: compute the other parts, and unite them by --from")?;
        return Ok(Exit::Well);
    }
    for (name, text) in draw(points, found)? {
        write(&out.join(name), &text)?;
    }
    writeln!(to, "{short}: {}", out.display())?;
    Ok(Exit::Well)
}

fn write_cost(args: &Page) -> Result<Exit> {
    make_folder(&args.out)?;
    let costs = cost::costs(&env::current_exe()?)?;
    let page = cost::page(&costs);
    write(&args.out.join("README.md"), &page)?;
    let mut to = io::stdout().lock();
    write!(to, "{page}")?;
    if costs.iter().any(|cost| cost.instructions.is_none()) {
        writeln!(to, "\nvalgrind is not there: no instructions are counted")?;
    }
    Ok(Exit::Well)
}

fn write(path: &Path, text: &str) -> Result<()> {
    let mut out = Destination::of(Some(path))?.open()?;
    out.write_all(text.as_bytes())?;
    out.finish()
}
