//! Linear elastic scenes of the crossfibre model as fast as one core allows, equal to the reference
//! to the bit.
//!
//! It shares with the reference the scene and how runs end, and no equation. README.md has what it
//! covers, how it gets its bits and what it measures.
//!
//! 1. [`lanes`]: what is asked of a processor's vectors, and three answers; [`division`]: quotients
//!    and roots by multiplication, and why they are right.
//! 2. `mesh`, [`state`]: from a scene to numbers.
//! 3. `block`, `fibre`: a fibre in blocks of vectors, and a step of it; `crossover`: (8)–(18).
//! 4. `march`: the steps of a scene; `literal`: the step that a run diverged in.
//! 5. [`engine`], [`result`], [`batch()`]: what is to be had.

mod batch;
mod block;
mod crossover;
pub mod division;
pub mod engine;
mod fibre;
pub mod lanes;
mod literal;
mod march;
mod mesh;
pub mod result;
pub mod state;

pub use batch::batch;
pub use engine::{Engine, Unsupported, Vectors};
pub use result::{SimdResult, run};
