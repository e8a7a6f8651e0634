//! `crossfibre study`: sweeps of many runs, and what is drawn from them.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::{env, fs};

use anyhow::{Context, Result};
use clap::Subcommand;
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::cost;
use crate::exit::Exit;
use crate::extremes;
use crate::output::Destination;
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
    /// Elements of 0.25 mm and longer only
    #[arg(long)]
    quick: bool,
}

pub fn run(args: Args) -> Result<Exit> {
    match args.study {
        Study::Figures(sweep) => {
            let draw =
                |points: &[_], found| figures::files(&figures::Snapshots::new(points, found));
            study(
                sweep,
                figures::STUDY,
                &figures::points::points(),
                figures::points::snapshot,
                draw,
            )
        }
        Study::WorkPrecision(WorkPrecision { sweep, quick }) => {
            let finest = if quick { precision::QUICK } else { precision::FINEST };
            let draw =
                |_: &[_], found| precision::files(&precision::Record::of(finest, found), None);
            let points = precision::points(finest);
            study(sweep, precision::STUDY, &points, precision::found, draw)
        }
        Study::Extremes(Extremes { out }) => write_extremes(out.as_deref()),
        Study::Cost(page) => write_cost(&page),
        Study::Stability(sweep) => {
            let draw =
                |points: &[_], found| stability::files(&stability::Results::new(points, found));
            let points = stability::tasks::points();
            study(sweep, stability::STUDY, &points, stability::tasks::compute, draw)
        }
    }
}

fn write_extremes(out: Option<&Path>) -> Result<Exit> {
    let Some(folder) = out else {
        write!(io::stdout().lock(), "{}", extremes::page())?;
        return Ok(Exit::Well);
    };
    fs::create_dir_all(folder)
        .with_context(|| format!("{}: cannot be made a folder", folder.display()))?;
    write(&folder.join("README.md"), &extremes::page())?;
    Ok(Exit::Well)
}

/// Computes the points of a study that are not stored, and if none is missing, draws.
fn study<P, V>(
    args: Sweep,
    name: &str,
    points: &[Point<P>],
    compute: impl Fn(&P) -> V + Sync,
    draw: impl Fn(&[Point<P>], Vec<V>) -> Vec<(&'static str, String)>,
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
    fs::create_dir_all(&out)
        .with_context(|| format!("{}: cannot be made a folder", out.display()))?;
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
    for (name, text) in draw(points, found) {
        write(&out.join(name), &text)?;
    }
    writeln!(to, "{short}: {}", out.display())?;
    Ok(Exit::Well)
}

fn write_cost(args: &Page) -> Result<Exit> {
    fs::create_dir_all(&args.out)
        .with_context(|| format!("{}: cannot be made a folder", args.out.display()))?;
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
