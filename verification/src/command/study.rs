//! `crossfibre study`: sweeps of many runs, and what is drawn from them.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::{env, fs};

use anyhow::{Context, Result};
use clap::Subcommand;

use crate::cost;
use crate::exit::Exit;
use crate::extremes;
use crate::figures::points::{points, snapshot};
use crate::figures::{STUDY, Snapshots, files};
use crate::output::Destination;
use crate::sweep::{Places, Shard, sweep};

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
    /// Run the extreme cases, and say what happens, whether it is right, and what the program says.
    Extremes(Extremes),
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

/// A folder for each build of the program, so that what another one has computed is not in the way.
const POINTS: &str = concat!("target/study/figures-points/", env!("CROSSFIBRE_SOURCE"));

/// Where a study goes, and which part of it is computed.
#[derive(clap::Args)]
struct Sweep {
    /// Folder for the pictures, tables and the page
    #[arg(long, default_value = "target/study/figures", value_name = "DIR")]
    out: PathBuf,
    /// Folder where each finished run is stored; what is there is not computed again
    #[arg(long, default_value = POINTS, value_name = "DIR")]
    points: PathBuf,
    /// Compute part I of N only, and draw nothing as long as runs are missing
    #[arg(long, value_name = "I/N")]
    shard: Option<Shard>,
    /// Take over the runs stored in another folder (may be repeated)
    #[arg(long, value_name = "DIR")]
    from: Vec<PathBuf>,
}

pub fn run(args: Args) -> Result<Exit> {
    match args.study {
        Study::Figures(sweep) => figures(sweep),
        Study::Extremes(Extremes { out }) => write_extremes(out.as_deref()),
        Study::Cost(page) => write_cost(&page),
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

fn figures(args: Sweep) -> Result<Exit> {
    let Sweep { out, points: folder, shard, from } = args;
    // Before hours of work, not after.
    fs::create_dir_all(&out)
        .with_context(|| format!("{}: cannot be made a folder", out.display()))?;
    let points = points();
    let places = Places { points: folder, from, shard };
    let values = sweep(STUDY, &points, &places, snapshot)?;
    let all = values.len();
    let found: Vec<_> = values.into_iter().flatten().collect();
    let mut to = io::stdout().lock();
    writeln!(to, "runs: {} of {all} in {}", found.len(), places.points.display())?;
    if found.len() < all {
        writeln!(to, "nothing is drawn yet: compute the other parts, and unite them by --from")?;
        return Ok(Exit::Well);
    }
    for (name, text) in files(&Snapshots::new(&points, found)) {
        write(&out.join(name), &text)?;
    }
    writeln!(to, "figures: {}", out.display())?;
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
