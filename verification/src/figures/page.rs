//! The page that shows the pictures. Its numbers are measured here, not typed.

use crossfibre::exact::crossover::Coefficients;
use crossfibre::scene::{Scene, Strain};

use super::fig3::{Plateau, plateaus_of};
use super::points::{
    Abscissa, CONVERGED, Edition, HALVED, PROFILE_MESHES, Snapshot, curve_id, element, profile_id,
};
use super::window::{Family, WIDTHS, exact_extremes, extremes};
use super::{Snapshots, Window, fig3};
use crate::cases::crossover::exact_coefficients;
use crate::cases::support::{measured_by, shipped};
use crate::tables::markdown as table;

/// The page.
pub fn page(snapshots: &Snapshots) -> String {
    [
        head(snapshots),
        fig3_section(snapshots),
        motion_section(),
        fig4_section(snapshots),
        slide_section(snapshots),
        window_section(snapshots),
        files_section(),
    ]
    .join("\n")
}

/// R, T and D in four decimals; dashes where the run did not complete.
fn in_words(ratios: Option<Coefficients>) -> [String; 3] {
    ratios.map_or([(); 3].map(|()| "–".into()), |r| {
        [r.reflection, r.transmission, r.diversion].map(|x| format!("{x:.4}"))
    })
}

fn mm(factor: usize) -> String {
    format!("{} mm", element(factor))
}

fn head(snapshots: &Snapshots) -> String {
    let ended: Vec<&String> = snapshots
        .0
        .iter()
        .filter(|(_, snapshot)| !snapshot.outcome.is_completed())
        .map(|(id, _)| id)
        .collect();
    let all = snapshots.0.len();
    let outcome = if ended.is_empty() {
        format!("All {all} runs completed.")
    } else {
        format!("Of {all} runs these did not complete and have no point: {ended:?}.")
    };
    format!(
        "\
# Figures 3 to 7, redrawn

This page, its pictures and its tables are written by

    crossfibre study figures --out docs/figures

and are the same to the byte wherever that runs: what they say of a run is measured, not typed.
{outcome}

Each curve exists as the page of the paper has it (*as printed*: no correction) and with all
corrections of the ledger (*corrected*), on the paper's mesh of 2 mm and on one of {fine}. Halving
{fine} again moves R, T and D between the fronts by at most {halved:.1e} at 10 and 200 GPa and at slide
factors of 0.5 and 1: a pixel at most. The strain is that of (4), a logarithm; *engineering strain* is
L/L⁰ − 1 in its place. The closed form is [the self-similar solution](../exact/crossover.md), drawn in
the measure of (4); in engineering strain it differs by 1 % at most. The density, 1206.7 kg/m³, is implied
by the paper, not given.

R, T and D are fractions of the exact strain of a single fibre: R = mean behind the crossover − 1,
T = mean beyond it, D = mean on one arm of the secondary. The paper averages \"over a portion of the
fibre length away from the oscillation region\" and does not say which. Two ways are taken here:

- **between fronts**: each mean is over a stretch whose exact strain is uniform. Behind the crossover
  it begins beyond the wavelet that the reflected wave sheds at the kink. 20 % of the way between the
  fronts is left out at both ends there, 25 % elsewhere.
- **fixed**: the middle half of the way from the impact point to the crossover, of as much beyond it,
  and of as much of the secondary: 25–75 mm, 125–175 mm and 25–75 mm. It knows nothing of reflected
  waves; that the paper's window was of this kind is a guess.
",
        fine = mm(CONVERGED),
        halved = moved_by_halving(snapshots)
    )
}

fn apart(a: Coefficients, b: Coefficients) -> f64 {
    [a.reflection - b.reflection, a.transmission - b.transmission, a.diversion - b.diversion]
        .into_iter()
        .fold(0.0, |most, x| most.max(x.abs()))
}

/// The most that a coefficient between the fronts moves when the converged elements are halved.
fn moved_by_halving(snapshots: &Snapshots) -> f64 {
    let between =
        |over, x, edition, factor| snapshots.of(&curve_id(over, x, edition, factor)).between_fronts;
    HALVED
        .into_iter()
        .flat_map(|(over, x)| Edition::ALL.map(|edition| (over, x, edition)))
        .filter_map(|(over, x, edition)| {
            let fine = between(over, x, edition, CONVERGED)?;
            Some(apart(fine, between(over, x, edition, 2 * CONVERGED)?))
        })
        .fold(0.0, f64::max)
}

/// The most that a coefficient of the corrected equations with engineering strain is off the closed
/// form at any slide factor.
fn off_by_sliding(snapshots: &Snapshots) -> f64 {
    Abscissa::Slide
        .values()
        .into_iter()
        .filter_map(|x| {
            let id = curve_id(Abscissa::Slide, x, Edition::Engineering, CONVERGED);
            let exact =
                exact_coefficients(&measured_by(Strain::Engineering, Abscissa::Slide.scene(x)));
            Some(apart(snapshots.of(&id).between_fronts?, exact))
        })
        .fold(0.0, f64::max)
}

/// How many elements behind the exact front the corrected secondary has half of the exact strain.
fn lag(snapshots: &Snapshots, factor: usize, arm: Plateau) -> String {
    let strains = snapshots.strains(Edition::Corrected, factor);
    let last = strains.and_then(|s| s.secondary.iter().rposition(|&e| e > 0.5 * arm.strain));
    let middle = |i: usize| i as f64 + 0.5;
    last.map_or("–".into(), |i| format!("{:.1}", arm.to / (1e-3 * element(factor)) - middle(i)))
}

fn fig3_section(snapshots: &Snapshots) -> String {
    let (scene, motion) = fig3::exact();
    let engineering = measured_by(Strain::Engineering, scene.clone());
    let mut rows = Vec::new();
    for (name, scene) in [("strain of (4)", &scene), ("engineering strain", &engineering)] {
        let exact = in_words(Some(exact_coefficients(scene)));
        rows.push(
            [vec![format!("closed form, {name}"), "–".into()], exact.to_vec(), vec!["–".into()]]
                .concat(),
        );
    }
    for edition in Edition::ALL {
        for factor in PROFILE_MESHES {
            let snapshot = snapshots.of(&profile_id(edition, factor));
            let fixed = in_words(snapshot.fixed)[0].clone();
            let name = vec![edition.label().to_owned(), mm(factor)];
            rows.push([name, in_words(snapshot.between_fronts).to_vec(), vec![fixed]].concat());
        }
    }
    let levels: Vec<String> = plateaus_of(&motion.primary)
        .iter()
        .filter(|plateau| plateau.strain > 0.0)
        .map(|Plateau { from, to, strain }| {
            format!("{:.2} % from {:.1} to {:.1} mm", 100.0 * strain, 1e3 * from, 1e3 * to)
        })
        .collect();
    let arm = plateaus_of(&motion.secondary)[0];
    format!(
        "\
## Fig. 3: strain 28.7 µs after impact

![Strain along both fibres](fig3.svg)

The exact strain of the primary is {};
that of the secondary is {:.3} % as far as {:.1} mm. [Every front is followed](../exact/fronts.md). Just at this
time the wave that the crossover reflects is back at the impact point. The paper sees the rise
behind the crossover, the fall beyond it and the overshoot at the front, and so does the scheme. At 2 mm
neither edition shows a plateau on the secondary: a fibre pulled sideways is strained only in second
order at first, and its first elements spread the start of the wave. Half of the exact strain is reached
{} elements behind the exact front at {}, corrected.

![The plateaus of the primary](fig3-plateaus.svg)

On a finer mesh the corrected equations settle on the exact plateaus. The printed ones do not: their
sideways force at the crossover strains both fibres too much.

{}",
        levels.join(", "),
        100.0 * arm.strain,
        1e3 * arm.to,
        PROFILE_MESHES.map(|factor| lag(snapshots, factor, arm)).join(", "),
        PROFILE_MESHES.map(mm).join(", "),
        table(&["equations", "elements", "R", "T", "D of one arm", "R, fixed window"], &rows)
    )
}

/// Rows of R, T, D and R by the fixed window, at some values of an abscissa.
fn rows(snapshots: &Snapshots, over: Abscissa, values: &[f64]) -> Vec<Vec<String>> {
    let runs = [
        (Edition::Corrected, CONVERGED),
        (Edition::Corrected, 1),
        (Edition::Printed, CONVERGED),
        (Edition::Printed, 1),
    ];
    let mut rows = Vec::new();
    for &x in values {
        let scene: Scene = over.scene(x);
        let row = |name: String, ratios, fixed: Option<Coefficients>| {
            let last = in_words(fixed)[0].clone();
            [vec![format!("{x}"), name], in_words(ratios).to_vec(), vec![last]].concat()
        };
        rows.push(row("closed form".into(), Some(exact_coefficients(&scene)), None));
        for (edition, factor) in runs {
            let snapshot = snapshots.of(&curve_id(over, x, edition, factor));
            let name = format!("{}, {}", edition.label(), mm(factor));
            rows.push(row(name, snapshot.between_fronts, snapshot.fixed));
        }
    }
    rows
}

/// The smallest and the largest of a coefficient over an abscissa.
fn span(
    snapshots: &Snapshots,
    over: Abscissa,
    (edition, factor): (Edition, usize),
    of: impl Fn(&Snapshot) -> Option<f64>,
) -> String {
    let found = over
        .values()
        .into_iter()
        .filter_map(|x| of(snapshots.of(&curve_id(over, x, edition, factor))));
    let (low, high) =
        found.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    format!("{low:.3} to {high:.3}")
}

fn motion_section() -> String {
    format!(
        "\
## The exact motion behind Fig. 3

![Strain at {0:.0} µs, and the ways of all fronts until then](motion.svg)

Every front that is stronger than a thousandth of the strongest, from the impact to {0:.0} µs: through the
crossover at 100 mm, back from both clamps, and split at every kink. The paper calls what comes after
the first meetings \"intractable by closed-form methods\"; [so it is followed](../exact/fronts.md).
`crossfibre exact SCENE --plot FILE` draws this of any scene.
",
        1e6 * fig3::MOTION_UNTIL
    )
}

fn fig4_section(snapshots: &Snapshots) -> String {
    let reflection = |run, window: Window| {
        span(snapshots, Abscissa::Modulus, run, |snapshot| {
            window.of(snapshot).map(|ratios| ratios.reflection)
        })
    };
    let (printed, corrected) = ((Edition::Printed, 1), (Edition::Corrected, 1));
    format!(
        "\
## Fig. 4: the modulus

![T, D and R against the modulus](fig4.svg)

Both fibres have the modulus, the density stays, and the run ends when the longitudinal wave has gone
0.2 m. The range, 10 to 200 GPa, is chosen here. T rises and D falls with the modulus, D more strongly,
as the paper says. R falls too, from {:.3} to {:.3}; the paper gives no figure of it but \"near 1 %\" with
\"considerable scatter\". At 2 mm R is {} as printed and {} corrected between the
fronts, {} and {} by the fixed window: the scatter is there, and values near 1 %
only for the stiffest fibres in that window. On that mesh the oscillations of stiff fibres reach right
through the windows.

{}",
        exact_coefficients(&Abscissa::Modulus.scene(10.0)).reflection,
        exact_coefficients(&Abscissa::Modulus.scene(200.0)).reflection,
        reflection(printed, Window::BetweenFronts),
        reflection(corrected, Window::BetweenFronts),
        reflection(printed, Window::Fixed),
        reflection(corrected, Window::Fixed),
        table(
            &["modulus, GPa", "", "R", "T", "D of one arm", "R, fixed window"],
            &rows(snapshots, Abscissa::Modulus, &[10.0, 58.6, 200.0])
        )
    )
}

fn slide_section(snapshots: &Snapshots) -> String {
    let scene = shipped("fig3");
    let single = snapshots.of(&curve_id(Abscissa::Slide, 0.0, Edition::Corrected, 1));
    let fine = snapshots.of(&curve_id(Abscissa::Slide, 0.0, Edition::Corrected, CONVERGED));
    format!(
        "\
## Figs 5 to 7: the slide factor

![R against the slide factor](fig5.svg)
![D against the slide factor](fig6.svg)
![T against the slide factor](fig7.svg)

As the paper says, R and D fall to zero and T rises to one as the slide factor does: D as its power 4/3,
R as its power 8/3, for small strain. The closed form leaves out that the primary slides through the
crossover, which the scheme follows by moving the crossover's node: with engineering strain the scheme
is within {:.1e} of it everywhere. At α_s = 0 the fibres do not touch, and what is left is the mesh:
T = {} at 2 mm and {} at {}. The printed edition errs the more the less slides; on the fine mesh
its curves bend where the crossover's node begins to move, or to move once more. The fibres are of {} GPa.

{}",
        off_by_sliding(snapshots),
        in_words(single.between_fronts)[1],
        in_words(fine.between_fronts)[1],
        mm(CONVERGED),
        scene.primary.material.instantaneous_modulus() / 1e9,
        table(
            &["α_s", "", "R", "T", "D of one arm", "R, fixed window"],
            &rows(snapshots, Abscissa::Slide, &[0.25, 0.5, 0.75, 1.0])
        )
    )
}

fn window_section(snapshots: &Snapshots) -> String {
    let families = [Family::Uniform, Family::FromKink];
    let words = |(low, high): (f64, f64)| format!("{low:.4} to {high:.4}");
    let mut rows = vec![
        [
            vec!["exact profile".to_owned(), "–".into()],
            families.map(|f| words(exact_extremes(f))).to_vec(),
        ]
        .concat(),
    ];
    for edition in [Edition::Printed, Edition::Corrected] {
        for factor in PROFILE_MESHES {
            let found = families.map(|family| {
                extremes(snapshots, (edition, factor), family).map_or("–".into(), words)
            });
            rows.push([vec![edition.label().to_owned(), mm(factor)], found.to_vec()].concat());
        }
    }
    let [uniform, kink] = families.map(|family| format!("{:.1}", family.begins()));
    let widths = WIDTHS.map(|width| format!("{width}")).join(", ");
    format!(
        "\
## R and the window

![R by the place of the window, corrected](window-corrected.svg)
![R by the place of the window, as printed](window-printed.svg)

R of Fig. 3 is a difference of two strains that are alike, so it takes up every oscillation in its
window. Here are the smallest and the largest R over all windows of {widths} mm that begin at a whole
millimetre and end before the crossover, at 100 mm: those that begin beyond the wavelet, at {uniform} mm,
and those that begin beyond the kink, at {kink} mm, without regard to the wavelet, behind which even the
exact strain is less. At 2 mm the state behind the wavelet is not resolved at all.

{}",
        table(
            &[
                "equations",
                "elements",
                "R, windows beyond the wavelet",
                "R, windows beyond the kink"
            ],
            &rows
        )
    )
}

fn files_section() -> String {
    "\
## Tables

Numbers are the shortest decimals that read back to the same bits; units are in the heads, `[1]` for a
pure number. An empty cell is a quantity that does not apply, or of a run that did not complete.

| file | a row is | columns |
| --- | --- | --- |
| [fig3.csv](fig3.csv) | an element at 28.7 µs | fibre; size of the element; Lagrangian distance of its middle from the impact point (the crossover); its strain by each edition; the exact one there |
| [fig3-exact.csv](fig3-exact.csv) | a stretch of uniform exact strain | fibre; its ends; strain λ − 1 |
| [fig4.csv](fig4.csv), [fig5-7.csv](fig5-7.csv) | a run and a window, or the closed form | modulus or slide factor; equations; measure of strain; size of the element; window; how the run ended; R, T, D |
| [window.csv](window.csv) | a window behind the crossover of Fig. 3 | width; where it begins; R by the exact profile, engineering strain; R by each run |
"
    .into()
}
