//! crossfibre: a literal, traceable reference implementation of a 1980 direct numerical model of
//! stress waves in two crossed fibres, one of them struck by a projectile.
//!
//! Read it in this order:
//!
//! 1. [`paper`]: the twenty numbered equations as the methods of one trait, as printed;
//!    [`equations`] is their register, [`number`] what they are written over: `f64`, `f32`, or 32
//!    digits ([`double_double`]).
//! 2. [`errata`]: the ledger of what cannot stand as printed; [`corrected`] the edition without it.
//! 3. [`march`]: one time step in the paper's order, on the [`state`] that a [`scene`] starts with
//!    ([`discretisation`]).
//! 4. [`mod@trace`]: the same march with every evaluation reported; [`trace_file`] writes them down.
//! 5. [`balance`]: energy and momentum; [`outcome`] and [`result`]: how a run ends and what it gives.
//! 6. [`exact`]: closed forms, which share nothing with the above.
//! 7. [`material`]: constitutive laws beyond (7); [`constitution`]: a fibre that has one.
//!
//! ```
//! let text = include_str!("../verification/scenes/single-400.json");
//! let scene = crossfibre::scene_file::read(text)?;
//! let result = crossfibre::result::run(&scene, |_state| {});
//! assert!(result.outcome.is_completed());
//! // Between the kink and the front the strain is Smith's for eqns (4) and (7), 1.443 %; single
//! // elements oscillate around it by a per cent of that.
//! let plateau = result.primary.strain[30..50].iter().sum::<f64>() / 20.0;
//! assert!((plateau - 0.01443).abs() < 2e-5);
//! # Ok::<(), crossfibre::scene_file::Fault>(())
//! ```

pub mod balance;
pub mod constitution;
pub mod corrected;
pub mod discretisation;
pub mod double_double;
pub mod equations;
pub mod errata;
pub mod exact;
mod json_locate;
pub mod march;
pub mod material;
pub mod nearest;
pub mod number;
pub mod outcome;
pub mod paper;
pub mod place;
pub mod plan;
pub mod result;
pub mod result_file;
pub mod scene;
pub mod scene_check;
pub mod scene_file;
mod scene_material;
mod scene_misfit;
#[cfg(feature = "schema")]
mod scene_schema;
mod scene_syntax;
mod scene_text;
pub mod state;
pub mod trace;
pub mod trace_file;
