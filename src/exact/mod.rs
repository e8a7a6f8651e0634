//! Closed forms, each derived apart from the scheme.
//!
//! An oracle that shares code with what it judges judges nothing: nothing below this folder
//! imports `paper`, `march` or `material`. The derivations are in `docs/exact/`.
//!
//! | module | problem | domain of the solution |
//! |---|---|---|
//! | [`hyperelastic`] | the tension laws and their stored energy | stretch > 0 |
//! | [`elastic`] | what a wave must know of the fibre that it runs on | |
//! | [`polynomial`], [`exponential`] | laws that harden or soften, with their waves | strain from 0 to where T′ > 0 ends |
//! | [`wave`] | fans and shocks of one longitudinal wave, its profile and what it dissipates | the same |
//! | [`smith`] | transverse impact on one long fibre of any of these laws | until the first reflection comes back |
//! | [`crossover`] | what a crossing fibre reflects, lets through and diverts | until a wave from the kink returns |
//! | [`riemann`] | what leaves a joint at which uniform pieces meet | until the next meeting |
//! | [`fronts`] | the crossed fibres, every front followed | until a fibre goes slack |
//! | [`motion`] | the same for a curved law or a projectile with mass | the same |
//! | [`dalembert`] | axial pull on a clamped linear fibre | all times |
//! | [`viscoelastic`] | axial pull on a long rod of a spring and Maxwell arms, small strain | all times to 10⁷ of the shortest relaxation time |
//! | [`dispersion`] | waves and growth of the leapfrog scheme | uniform linear fibre |

pub mod crossover;
pub mod dalembert;
pub mod dispersion;
pub mod elastic;
pub mod exponential;
pub mod fronts;
pub mod hyperelastic;
pub mod motion;
pub mod polynomial;
pub mod riemann;
pub mod smith;
pub mod viscoelastic;
pub mod wave;

mod gauss;
mod hull;
#[cfg(test)]
mod quadrature;
mod root;
#[cfg(test)]
mod samples;
