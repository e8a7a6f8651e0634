//! Where to look when a case fails: its source, and the page that derives what it is held against.

/// Files that belong to a case, as seen from the root of the project.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Whereabouts {
    /// The source of the case, or the folder of it.
    pub source: &'static str,
    /// Where its oracle is derived.
    pub derivation: &'static str,
}

/// By the beginnings of names.
#[rustfmt::skip] // a table
const WHEREABOUTS: &[(&str, &str, &str)] = &[
    ("smith.", "verification/src/cases/smith.rs", "docs/exact/smith.md"),
    ("axial.", "verification/src/cases/axial.rs", "docs/exact/axial-and-dispersion.md"),
    ("courant.", "verification/src/cases/courant.rs", "docs/exact/axial-and-dispersion.md"),
    ("stability.", "verification/src/cases/stability.rs", "docs/exact/stability.md"),
    ("crossover.", "verification/src/cases/crossover.rs", "docs/exact/crossover.md"),
    ("projectile.", "verification/src/cases/projectile.rs", "docs/exact/fronts.md"),
    ("energy.", "verification/src/cases/conservation.rs", "src/balance.rs"),
    ("momentum.", "verification/src/cases/conservation.rs", "src/balance.rs"),
    ("identity.", "verification/src/cases/identities.rs", "docs/scheme.md"),
    ("invariance.", "verification/src/cases/invariance.rs", "docs/scheme.md"),
    ("motion.", "verification/src/cases/motion.rs", "docs/exact/fronts.md"),
    ("material.rod", "verification/src/cases/materials/rod.rs", "docs/exact/viscoelastic.md"),
    ("material.", "verification/src/cases/materials", "docs/materials.md"),
    ("conformance.", "verification/src/cases/conformance.rs", "docs/conformance.md"),
    ("golden.", "verification/src/cases/golden.rs", "golden/HISTORY.md"),
    ("precision.", "verification/src/cases/precision", "docs/convergence.md"),
    ("extreme.", "verification/src/extremes", "docs/extremes/README.md"),
];

/// Where a case of this name belongs.
pub fn of(id: &str) -> Option<Whereabouts> {
    let (_, source, derivation) = WHEREABOUTS.iter().find(|(start, ..)| id.starts_with(start))?;
    Some(Whereabouts { source, derivation })
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::cases::full;

    #[test]
    fn every_case_has_files_and_they_are_there() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        for case in full() {
            let Whereabouts { source, derivation } =
                of(case.id).unwrap_or_else(|| panic!("{}", case.id));
            for file in [source, derivation] {
                assert!(root.join(file).exists(), "{}: {file}", case.id);
            }
        }
    }
}
