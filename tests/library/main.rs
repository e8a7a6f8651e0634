//! What the library promises, held from outside: the equations, the march, the laws, the formats.
//!
//! One program for all of it: linking is what most of a build's time would go into otherwise.

#![allow(clippy::unwrap_used)] // a test may

mod bad_scenes;
mod common;
mod diverged_result;
mod equations_as_printed;
mod equations_corrected;
mod equations_editions;
mod equations_lines;
mod march_balance;
mod march_crossover;
mod march_double_double;
mod march_identities;
mod march_laws;
mod march_laws_ended;
mod march_laws_energy;
mod march_order;
mod march_outcomes;
mod parameter_box;
mod scene_notation;
mod shipped_scenes;
mod trace_file;
