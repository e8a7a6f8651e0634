//! Fibres of other laws than (7), and artificial viscosity.

mod arms;
mod elastic;
mod energy;
mod rod;
mod viscosity;
mod viscous_stress;

use super::Case;
pub(crate) use viscosity::of_scene as front_of;

/// The cases of this file.
pub const CASES: &[Case] = &[
    Case {
        id: "material.softening",
        title: "A law that softens: plateau, and fan ahead of it",
        equations: &[2, 6, 7],
        run: elastic::softening,
    },
    Case {
        id: "material.hardening",
        title: "A law that hardens: plateau, and shock ahead of it",
        equations: &[2, 6, 7],
        run: elastic::hardening,
    },
    Case {
        id: "material.inflection",
        title: "A law that hardens, then softens: a shock, and a fan behind it",
        equations: &[2, 6, 7],
        run: elastic::inflection,
    },
    Case {
        id: "material.rod",
        title: "Axial pull on a viscoelastic rod: front, profile and late times",
        equations: &[2, 6, 7],
        run: rod::pulled,
    },
    Case {
        id: "material.arms",
        title: "Relaxation and flow in the march: held fibres, and an Eyring element by Runge-Kutta",
        equations: &[2, 6, 7],
        run: arms::held_and_driven,
    },
    Case {
        id: "material.stiff",
        title: "Relaxation times far below and far above the time step",
        equations: &[2, 4, 5, 6, 7],
        run: arms::stiff,
    },
    Case {
        id: "material.energy",
        title: "Energy with every law: stored, dissipated and kinetic make up the work",
        equations: &[2, 4, 5, 6, 7],
        run: energy::balance,
    },
    Case {
        id: "material.slack",
        title: "A fibre that goes slack when its projectile rebounds",
        equations: &[2, 6, 7, 8],
        run: energy::slack,
    },
    Case {
        id: "material.viscosity",
        title: "Artificial viscosity: oscillations at a front, what they cost, and the step",
        equations: &[2, 4, 5, 6, 7],
        run: viscosity::front,
    },
    Case {
        id: "material.viscosity-stress",
        title: "Artificial viscosity: stress and loss at a steady rate of strain",
        equations: &[2, 6, 7],
        run: viscous_stress::stretched,
    },
];
