//! The pictures that studies have stored in `docs/`.

use super::{Picture, Section};

/// A stored picture.
pub struct Stored {
    id: &'static str,
    section: Section,
    title: &'static str,
    caption: &'static str,
    alt: &'static str,
    svg: &'static str,
}

impl Stored {
    /// The picture.
    pub fn picture(&self) -> Picture {
        let Self { id, section, title, caption, alt, svg } = *self;
        let [id, title, caption, alt, svg] = [id, title, caption, alt, svg].map(str::to_owned);
        Picture { id, section, title, caption, alt, svg }
    }
}

macro_rules! pictures {
    ($($id:literal, $section:ident, $file:literal, $title:literal, $caption:literal, $alt:literal;)*) => {
        /// All of them, in the order of the report.
        pub const PICTURES: &[Stored] = &[$(Stored {
            id: $id,
            section: Section::$section,
            title: $title,
            caption: $caption,
            alt: $alt,
            svg: include_str!(concat!("../../../docs/", $file)),
        }),*];
    };
}

pictures! {
    "fig3", Figures, "figures/fig3.svg",
    "Fig. 3: strain 28.7 µs after impact",
    "As printed and corrected, on the paper's mesh, over the exact strain. The wave that the crossover \
     reflects is just back at the impact point.",
    "Two panels of strain over distance. On the primary fibre the corrected curve follows the exact \
     plateaus, 1.51 % before the crossover and 1.38 % beyond it, with overshoot at the front; the printed \
     one lies higher. On the secondary both rise slowly to the exact plateau.";
    "fig3-plateaus", Figures, "figures/fig3-plateaus.svg",
    "Fig. 3: the plateaus, on a finer mesh",
    "The corrected equations settle on the exact plateaus; the printed ones do not, on any mesh.",
    "Strain between 1.3 and 1.7 % over distance with elements of 0.5 mm: corrected curves lie on the exact \
     steps, the printed curve stays above them on both sides of the crossover.";
    "fig4", Figures, "figures/fig4.svg",
    "Fig. 4: transmission and diversion against the modulus",
    "Closed form, printed and corrected equations. Reflection, of which the page gives no figure, is \
     beside them.",
    "Three panels over the modulus from 10 to 200 GPa: transmission rises, diversion and reflection fall. \
     The corrected points lie on the closed form, the printed ones beside it.";
    "fig5", Figures, "figures/fig5.svg",
    "Fig. 5: reflection against the slide factor",
    "From no coupling to full coupling. Fixed windows give smaller values: they average over a stretch that \
     the reflected wave has not filled.",
    "Reflection rises from 0 to 0.044 as the slide factor goes from 0 to 1; corrected fine meshes are on the \
     closed form, printed equations end at 0.058.";
    "fig6", Figures, "figures/fig6.svg",
    "Fig. 6: diversion against the slide factor",
    "Of one arm of the secondary.",
    "Diversion rises from 0 to 0.147 as the slide factor goes from 0 to 1 by the closed form and the \
     corrected equations, to 0.164 by the printed ones.";
    "fig7", Figures, "figures/fig7.svg",
    "Fig. 7: transmission against the slide factor",
    "What is neither reflected nor diverted.",
    "Transmission falls from 1 to 0.956 as the slide factor goes from 0 to 1 by the closed form and the \
     corrected equations, to 0.963 by the printed ones.";
    "xt", Figures, "work-precision/xt.svg",
    "Place and time: strain of the primary, marched",
    "Fig. 3 carried on to 60 µs. Every slope is a wave: out at the speed of sound, back from the crossover, \
     out again, and back from the clamp.",
    "Map of strain over distance from the impact point and time, in 32 colours: a front runs out from the \
     origin to the clamp at 43 microseconds and comes back, with reflections from the crossover at 100 mm.";
    "xt-exact", Figures, "work-precision/xt-exact.svg",
    "The same by exact fronts",
    "No mesh and no scheme: fronts followed from meeting to meeting.",
    "The same map from the exact solution, with sharp borders between uniform strains; it shows the same \
     fronts at the same places and times.";
    "motion", Figures, "figures/motion.svg",
    "Every front until 90 µs, exact",
    "Above, strain along both fibres at 90 µs; below, the ways of all fronts until then.",
    "Four panels: piecewise constant strain of primary and secondary at 90 microseconds, and below, straight \
     lines over place and time, longitudinal fronts flat and kinks steep.";
    "window", Figures, "figures/window-printed.svg",
    "Where R near 1 % comes from",
    "As printed: the reflection that a window sees, by where it lies and how wide it is.",
    "Reflection by the place of the averaging window at several widths, printed equations: values between 0 \
     and over 6 %, so a value near 1 % is a matter of the window.";
    "work-single", Cost, "work-precision/work-single.svg",
    "Error against work: one fibre",
    "Every error against element-steps, in every variant. Crosses are runs that ended early.",
    "Panels on logarithmic axes: errors of plateau strain, mean strain, profiles, kink and energy fall with \
     element-steps; engineering strain falls fastest, single precision rises again.";
    "work-crossed", Cost, "work-precision/work-crossed.svg",
    "Error against work: Fig. 3",
    "Two crossed fibres. The printed equations stay where they are on any mesh.",
    "Panels on logarithmic axes of errors of the strain profile, R, T, D, kink and energy of Fig. 3 against \
     element-steps; curves of corrected variants fall, that of the printed equations is flat.";
    "work-unequal", Cost, "work-precision/work-unequal.svg",
    "Error against work: unequal fibres",
    "Two different fibres, after reflections at both clamps.",
    "Panels on logarithmic axes of errors of two unequal fibres against element-steps; all corrected \
     variants fall at about the order of their fronts, printed equations do not.";
    "work-rod", Cost, "work-precision/work-rod.svg",
    "Error against work: a viscoelastic rod",
    "Pulled along its axis for 4.2 relaxation times, by a thousandth: there (4) and engineering strain differ.",
    "Panels on logarithmic axes of errors of a viscoelastic rod against element-steps: engineering strain at a \
     Courant number of 1 falls fastest, the strain of (4) levels off, single precision rises again.";
    "time", Cost, "work-precision/time.svg",
    "Error against measured time and instructions",
    "The same errors against the clock of one machine and against counted instructions.",
    "Panels on logarithmic axes of the error of the profile against seconds and against instructions for \
     each variant and for an engine in vectors, which takes half the time for the same bits.";
    "stability-slide", Stability, "stability/slide.svg",
    "Stability of the crossover",
    "Largest stable Courant number over the slide factor, tilted: with the primary's mass alone, as printed, \
     and with both masses on the node.",
    "Two maps over slide factor and Courant number: without inertia the stable region shrinks as the slide \
     factor grows; corrected it reaches up to a Courant number of 1 everywhere.";
    "stability-modulus", Stability, "stability/modulus.svg",
    "Stability over the modulus of the secondary",
    "A node without the secondary's mass leaves least room where both fibres are alike: a softer secondary \
     pulls less, a stiffer one has shortened the step of both.",
    "Two maps over the ratio of moduli and Courant number: without inertia the limit falls to 0.964 where the \
     moduli are equal, and is above 1 where one is far greater; corrected it is above 1 everywhere.";
    "stability-mass", Stability, "stability/mass.svg",
    "Stability of a light projectile",
    "Largest stable Courant number over the mass of the projectile.",
    "Maps over projectile mass and Courant number: without the mass of its node a light projectile \
     is unstable at any step that is used; with it the limit is 1.";
    "stability-velocity", Stability, "stability/velocity.svg",
    "Stability at finite strain",
    "Impacts from slow to faster than sound, by both measures of strain.",
    "Maps over impact velocity and Courant number that show stable and unstable impacts, with the limit of \
     the linearised scheme as a line between them.";
}
