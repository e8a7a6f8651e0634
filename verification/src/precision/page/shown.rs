//! The pictures, with what they show.

use super::super::pictures::{BASES, convergence, floors, work};
use super::super::problems::Problem;
use super::super::reading::Quantity;
use super::super::record::{Entry, Record};
use crate::tables::markdown;

/// A section for each problem.
pub fn work(record: &Record) -> Vec<String> {
    let section = |problem: Problem| {
        let text = match problem {
            Problem::Single => single(record),
            Problem::Crossed => crossed(record),
            Problem::Unequal => unequal(record),
            Problem::Rod => rod(record),
        };
        format!(
            "## {}\n\n![Errors against element-steps]({})\n\n{text}\n{}",
            problem.title(),
            work::file(problem),
            finest(record, problem)
        )
    };
    Problem::ALL.map(section).into()
}

/// The last run of a series that completed.
fn last<'r>(record: &'r Record, problem: Problem, variant: &str) -> Option<&'r Entry> {
    let entries = record.series(problem, variant).into_iter();
    entries.rev().find(|entry| entry.found.outcome.is_completed())
}

/// The size of the error on the finest mesh.
fn size(record: &Record, problem: Problem, variant: &str, quantity: Quantity) -> Option<f64> {
    Some(last(record, problem, variant)?.error(quantity)?.abs())
}

fn number(x: Option<f64>) -> String {
    x.map_or("–".into(), |x| format!("{x:.1e}"))
}

fn percent(x: Option<f64>) -> String {
    x.map_or("–".into(), |x| format!("{:.2} %", 100.0 * x))
}

/// The errors of both measures on the finest mesh, engineering strain first.
fn both(record: &Record, problem: Problem, quantity: Quantity) -> [String; 2] {
    let [eqn, engineering] = BASES.map(|variant| number(size(record, problem, variant, quantity)));
    [engineering, eqn]
}

/// Element-steps from which on L1 keeps a level, at an α over at α = 1, engineering strain.
fn dearer(record: &Record, problem: Problem, level: f64) -> String {
    let cost = |variant: &str| {
        let entries = record.series(problem, variant).into_iter().rev();
        let keeps =
            |entry: &&Entry| entry.error(Quantity::StrainL1).is_some_and(|error| error <= level);
        entries.take_while(keeps).last().map(|entry| entry.found.element_steps as f64)
    };
    let [half, one] = ["engineering, α = 0.5", "engineering, α = 1"].map(cost);
    half.zip(one).map_or("–".into(), |(half, one)| format!("{:.0}", half / one))
}

fn single(record: &Record) -> String {
    let problem = Problem::Single;
    let [plateau, plateau_by_4] = both(record, problem, Quantity::Plateau);
    let [energy, energy_by_4] = both(record, problem, Quantity::Energy);
    format!(
        "\
The plateau and the energy tell the measures of strain apart. With engineering strain their errors fall
with the mesh, to {plateau} and {energy}; by eqn (4) they stay near {plateau_by_4} and {energy_by_4},
since its strain depends on the path. Artificial viscosity smooths the path, and both fall again. The
profile is another matter: its error is the width of the front and of the kink, and α = 1 is the
cheapest way to a narrow front. At α = 0.5 an L1 of 1 % takes {} times the element-steps, and viscosity
makes the front wider still. Errors of the plateau change sign from mesh to mesh: a low point is luck.
",
        dearer(record, problem, 1e-2)
    )
}

fn crossed(record: &Record) -> String {
    let problem = Problem::Crossed;
    let of = |quantity| percent(size(record, problem, "eqn (4), α = 1, printed", quantity));
    let [reflection, reflection_by_4] = both(record, problem, Quantity::Reflection);
    format!(
        "\
The page as printed converges to something else: on the finest mesh R is still off by {} of itself, D by {},
and the energy by {}. Corrected, R falls to {reflection} with engineering strain and to {reflection_by_4} by eqn (4), where
the error of the strain's measure shows in it, multiplied: R is a small difference. R, T and D change
sign, so their sizes are drawn, and only the level that is kept on all finer meshes counts. With
engineering strain the printed coupling does not survive refinement.
",
        of(Quantity::Reflection),
        of(Quantity::Diversion),
        of(Quantity::Energy)
    )
}

fn unequal(record: &Record) -> String {
    let of = |variant| percent(size(record, Problem::Unequal, variant, Quantity::SecondaryL1));
    format!(
        "\
Two fibres of different stiffness, density and mesh, after reflections at both clamps: many fronts, and every
one is spread. The same orders, larger constants. The printed equations are off by {} in the secondary's
profile on the finest mesh, corrected by {}. Under eqn (4) the bound of the exact solution, which replaces
the curved law by chords, comes up to the errors themselves: they are known to that, and no better.
",
        of("eqn (4), α = 1, printed"),
        of("eqn (4), α = 1")
    )
}

fn rod(record: &Record) -> String {
    let problem = Problem::Rod;
    let [own, by_4] = both(record, problem, Quantity::StrainL1);
    format!(
        "\
A viscoelastic law along a straight line, strained by less than a thousandth. At α = 1 with engineering strain the front
stays in one element, and L1 falls to {own}; by eqn (4) it ends at {by_4}, the difference
between the two measures at this strain. In 24 bits the strains of so small a deformation drown in
rounding on all but the coarsest meshes.
"
    )
}

/// The errors of the variants that are drawn, on the finest mesh that completed.
fn finest(record: &Record, problem: Problem) -> String {
    let quantities = work::quantities(problem);
    let mut head = vec!["on the finest mesh that completed", "element, mm", "element-steps"];
    head.extend(quantities.iter().map(|quantity| quantity.label()));
    let rows: Vec<Vec<String>> = work::VARIANTS
        .iter()
        .filter_map(|variant| {
            let entry = last(record, problem, variant)?;
            let mut row = vec![
                (*variant).to_owned(),
                format!("{:.3}", 1e3 * entry.spacing),
                format!("{:.1e}", entry.found.element_steps as f64),
            ];
            row.extend(quantities.iter().map(|&q| number(entry.error(q).map(f64::abs))));
            Some(row)
        })
        .collect();
    markdown(&head, &rows)
}

/// Orders.
pub fn convergence(record: &Record) -> String {
    let mut head = vec!["Fig. 3"];
    head.extend(convergence::VARIANTS);
    let rows: Vec<Vec<String>> = convergence::QUANTITIES
        .iter()
        .map(|&quantity| {
            let mut row = vec![quantity.label().to_owned()];
            let order = |variant: &&str| convergence::order(record, variant, quantity);
            row.extend(convergence::VARIANTS.iter().map(order));
            row
        })
        .collect();
    format!(
        "\
## Convergence

![Errors of Fig. 3 against the length of an element](convergence.svg)

The same errors against the mesh. The table has the order fitted to the asymptotic range, which ends with the
finest mesh, the half-width of an interval of {:.0} % that measures scatter, and the mesh from which the range
begins; or why there is none: the orders of each two meshes must agree to {} and the sign must stay.
[What this means](../convergence.md), and which orders fronts have.

{}",
        100.0 * convergence::LEVEL,
        convergence::BAND,
        markdown(&head, &rows)
    )
}

/// What errors cannot fall below.
pub fn floors(record: &Record) -> String {
    format!(
        "\
## What errors cannot fall below

![Errors of the profile, rounding, and the bound of the exact solution](floors.svg)

The error of the strain profile, what of it is rounding, and what the exact solution admits itself. Rounding
is the difference of the same run in 53 (or 24) bits from the one in 106. In 53 bits it is {:.1e} at the most
and of no account on any of these meshes; in 24 it becomes the whole error as the mesh is refined, and
then ends the run. An exact solution of the engineering law needs no approximation: its bound is
rounding, or the fronts that it merges, or zero, which has no place here. Under eqn (4) the law is
replaced by chords, and the bound, drawn also in the pictures above, is the most that their difference
can make.
",
        floors::greatest_rounding(record)
    )
}

/// Times.
pub fn time() -> String {
    "\
## Time

![Errors of the profile against measured time and instructions](time.svg)

The error of the strain profile, L1, against measured time: the least of all rounds, with a bar to the
greatest. Every contestant computes its problem on the same meshes. The exact fronts stand at the error
that they admit; where that is far below all others, at the lower end. Ratios, the machine and the
numbers are [on a page of their own](times.md), for they differ from machine to machine.
"
    .into()
}

/// Profiles.
pub fn profiles() -> String {
    "\
## The profiles themselves

![Strain along both fibres of Fig. 3 on four meshes](profiles.svg)

Strain along both fibres of Fig. 3 at 28.7 µs, by eqn (4) and with engineering strain, and the exact
profile of each law. Elements of 10 mm show no plateau; those of 2 mm, the paper's mesh, show the primary's
and not the secondary's; from 0.5 mm on all are there.

![The front and the kink](close-ups.svg)

The front overshoots by the same share on all meshes but the coarsest: refinement makes it narrower, not
lower. Under
eqn (4) the front is a fan that widens with time, which a fine mesh resolves; with engineering strain it is
a jump for ever. A kink leaves no trace in the exact strain, so its inclination is shown: it lags, and its
width falls more slowly than an element's.
"
    .into()
}

/// Place and time.
pub fn space_time() -> String {
    "\
## Place and time

![Strain of the primary over place and time, marched](xt.svg)
![The same by exact fronts](xt-exact.svg)

Strain of the primary of Fig. 3 with engineering strain for some twice the paper's time: marched, and by
the exact fronts. The front runs out, loses a little at the crossover, doubles at the clamp and turns back; the
reflected wave returns from the crossover to the impact point at the paper's 28.7 µs. What the march adds
are stripes behind the fronts, its overshoot and ringing.
"
    .into()
}
