//! `crossfibre new`: a commented scene to start from.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use anyhow::{Result, bail};
use clap::ValueEnum;

use crate::exit::Exit;
use crate::output::Destination;

/// Arguments.
#[derive(clap::Args)]
pub struct Args {
    /// What kind of scene
    #[arg(default_value = "crossed")]
    kind: Kind,
    /// Write to FILE, which must not be there yet; `-` for standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Name the kinds and stop
    #[arg(long)]
    list: bool,
}

#[derive(Clone, Copy, ValueEnum)]
enum Kind {
    /// One fibre
    Single,
    /// Two crossed fibres: the paper's problem
    Crossed,
    /// Two crossed fibres that slide on each other
    Sliding,
    /// A fibre that hardens, with a shock and artificial viscosity
    Hardening,
    /// Two crossed fibres of a viscoelastic solid
    Viscoelastic,
    /// One fibre that slows its projectile down
    FiniteProjectile,
}

impl Kind {
    fn scene(self) -> &'static str {
        match self {
            Self::Single => include_str!("../../starting-scenes/single.jsonc"),
            Self::Crossed => include_str!("../../starting-scenes/crossed.jsonc"),
            Self::Sliding => include_str!("../../starting-scenes/sliding.jsonc"),
            Self::Hardening => include_str!("../../starting-scenes/hardening.jsonc"),
            Self::Viscoelastic => include_str!("../../starting-scenes/viscoelastic.jsonc"),
            Self::FiniteProjectile => include_str!("../../starting-scenes/finite-projectile.jsonc"),
        }
    }
}

pub fn run(args: &Args) -> Result<Exit> {
    if args.list {
        let mut out = io::stdout().lock();
        for kind in Kind::value_variants().iter().filter_map(ValueEnum::to_possible_value) {
            let help = kind.get_help().map(ToString::to_string).unwrap_or_default();
            writeln!(out, "{:18} {help}", kind.get_name())?;
        }
        return Ok(Exit::Well);
    }
    let file = args.output.as_deref().filter(|path| *path != Path::new("-"));
    if let Some(file) = file.filter(|file| file.is_file()) {
        bail!("{}: is there already\n  help: name another file, or remove it", file.display());
    }
    let mut out = Destination::of(file)?.open()?;
    out.write_all(args.kind.scene().as_bytes())?;
    out.finish()?;
    if let Some(file) = file {
        let name = file.display();
        writeln!(
            io::stdout().lock(),
            "{name}\nnext: crossfibre plan {name}\n      crossfibre run {name}"
        )?;
    }
    Ok(Exit::Well)
}
