//! What is meant by what, what failed, and what each variant costs.

use std::collections::BTreeMap;

use super::super::VARIANTS;
use super::super::problems::Problem;
use super::super::record::{Entry, Record};
use crate::tables::markdown;

/// How errors are defined.
pub fn quantities() -> String {
    "\
## What is measured

An error is relative to the exact number, at the time that the run has reached. Norms and the energy
residual are relative by their definition.

| quantity | what it is |
| --- | --- |
| plateau strain | mean strain over the middle half of the widest plateau of the primary |
| R, T, D | mean strain over the middle half of the plateau behind the crossover, beyond it, and on one arm of the secondary, over the exact incident strain; R less 1 |
| mean strain | over the whole fibre |
| strain profile, L1 | ∫\\|ε − exact\\| dX over ∫\\|exact\\| dX; strains are uniform within an element, so the integral is a sum |
| strain profile, L2 | √∫(ε − exact)² dX over √∫exact² dX |
| position of the kink | where the inclination of the primary passes half-way across its sharpest kink |
| arrival of the front | when the strain at 0.617 of the way to the crossover, or of the fibre, reaches half of what follows |
| energy residual | what the energy balance is off by, over the energy put in |

The exact answers share nothing with the scheme: [closed forms](../exact/crossover.md) where they hold, else
[exact fronts](../exact/fronts.md), in the strain of the variant's own law; the rod has
[a solution of its own](../exact/viscoelastic.md).
"
    .into()
}

/// How variants differ.
pub fn variants(record: &Record) -> String {
    let ran = |name: &str| {
        let problems = Problem::ALL.into_iter().filter(|&problem| {
            record.entries.iter().any(|e| e.problem == problem && e.variant == name)
        });
        problems.map(Problem::id).collect::<Vec<_>>().join(", ")
    };
    let rows: Vec<Vec<String>> =
        VARIANTS.iter().map(|variant| vec![variant.name.into(), ran(variant.name)]).collect();
    format!(
        "\
## The variants

*eqn (4)* adds up ΔL/L of each step; *engineering* is L/L⁰ − 1 in its place. α is the Courant number. *viscous*
has the artificial viscosity of the shipped scene. All are corrected by the whole ledger but those *printed*,
which have no correction, and *no inertia*, which lacks that of the crossover's inertia alone. Numbers have 53
bits unless another number or *f32*, 24 bits, is said. *no flags* visits all elements, not only those that
the wavefront has reached. What a problem has nothing of is not run: nothing in a single fibre is
corrected.

{}",
        markdown(&["variant", "problems"], &rows)
    )
}

/// Which runs did not complete.
pub fn failures(record: &Record) -> String {
    let mut groups: BTreeMap<(usize, usize, String), Vec<&Entry>> = BTreeMap::new();
    let index = |entry: &Entry| VARIANTS.iter().position(|v| v.name == entry.variant);
    for entry in record.entries.iter().filter(|entry| !entry.found.outcome.is_completed()) {
        let how = entry.found.outcome.to_string();
        let how = how.split([':', ',']).next().unwrap_or_default().to_owned();
        let key = (entry.problem as usize, index(entry).unwrap_or(VARIANTS.len()), how);
        groups.entry(key).or_default().push(entry);
    }
    let rows: Vec<Vec<String>> = groups
        .into_iter()
        .map(|((_, _, how), entries)| {
            let meshes = entries.iter().map(|entry| format!("{:.3}", 1e3 * entry.spacing));
            let first = entries[0];
            vec![
                first.problem.id().into(),
                first.variant.clone(),
                meshes.collect::<Vec<_>>().join(" "),
                how,
                first.found.outcome.to_string().replace('|', "\\|"),
            ]
        })
        .collect();
    format!(
        "\
## What failed

A failed run stays in the pictures: a cross above, in its variant's colour, at the work that it did until it
ended; one that ended at once stands at the left end. At α = 0.95 artificial viscosity leaves no
room below the Courant limit, and the program says so in the first step. With engineering strain the
crossover's node is unstable at α = 1 without the correction of its inertia. 24 bits lose the
small differences of positions that strains are made of, the sooner the finer the mesh.

{}",
        markdown(&["problem", "variant", "elements, mm", "end", "on the first of these"], &rows)
    )
}

/// The refinement at which costs are compared: 0.25 mm.
const REFINEMENT: f64 = 8.0;

/// What a variant costs.
pub fn costs(record: &Record) -> String {
    let of = |name: &str| {
        let mut entries = record.series(Problem::Crossed, name).into_iter();
        let refinement = REFINEMENT;
        entries.find(|e| e.refinement == refinement && e.found.outcome.is_completed())
    };
    let first = of(VARIANTS[0].name);
    let rows: Vec<Vec<String>> = VARIANTS
        .iter()
        .filter_map(|variant| {
            let found = &of(variant.name)?.found;
            let first = &first?.found;
            let ratio = |of: u64, first: u64| format!("{:.3}", of as f64 / first as f64);
            Some(vec![
                variant.name.into(),
                found.steps.to_string(),
                found.element_steps.to_string(),
                ratio(found.evaluations, found.element_steps),
                ratio(found.element_steps, first.element_steps),
                ratio(found.evaluations, first.evaluations),
            ])
        })
        .collect();
    let head = [
        "Fig. 3, elements of 0.25 mm",
        "steps",
        "element-steps",
        "evaluations per element-step",
        "element-steps × first",
        "evaluations × first",
    ];
    format!(
        "\
## What a variant costs

Evaluations are of the numbered equations. Eqn (4) is one that engineering strain does without; the crossover
adds a few in each step, whatever the mesh. So evaluations are element-steps times 4 or 5, and no picture
is drawn against them. A smaller α costs in proportion to 1/α, and more than that as the wavefront by which
elements are visited then runs ahead of the wave.

{}",
        markdown(&head, &rows)
    )
}

/// The files.
pub fn files(timed: bool) -> String {
    let times = if timed {
        "| [times.json](times.json) | measured times, as they were taken |\n"
    } else {
        ""
    };
    format!(
        "\
## Tables

Numbers are the shortest decimals that read back to the same bits; units are in the heads, `[1]` for a
pure number. An empty cell is a quantity that does not apply, or of a run that did not complete.

| file | what it holds |
| --- | --- |
| [record.json](record.json) | every run: how it ended, its work, what was read and what is exact; a run a line |
| [runs.csv](runs.csv) | the same as a table: a row for each quantity of each run; all errors that are drawn |
| [profiles.csv](profiles.csv) | the strains of the profiles: a row for each element that is shown |
{times}"
    )
}
