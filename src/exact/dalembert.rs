//! Axial pull on a linear fibre that is clamped at its other end, for all times.
//!
//! The fibre lies along x from 0 to L, at rest and unstrained. From t = 0 on its end x = 0 is
//! pulled away from the clamp at velocity V. Strain is ∂/∂x of the displacement, positive in
//! tension; velocities are positive in the direction of the pull. By the method of images, with
//! the step function H,
//!
//! ```text
//! ε(x, t) = V/c Σ_{k ≥ 0} [ H(ct − x − 2kL) + H(ct + x − 2(k+1)L) ]
//! v(x, t) = V   Σ_{k ≥ 0} [ H(ct − x − 2kL) − H(ct + x − 2(k+1)L) ]
//! ```
//!
//! The leapfrog scheme at Courant number 1 gives these values exactly, at the times and places
//! that [`Mesh`] states. Derivation and tests: `docs/exact/axial-and-dispersion.md`.

/// An axial pull, continuous in x and t.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pull {
    /// L, m.
    pub length: f64,
    /// c = √(E/ρ), m/s.
    pub wave_speed: f64,
    /// V, m/s; negative for a push.
    pub velocity: f64,
}

impl Pull {
    /// Strain at 0 ≤ x ≤ L (m) and t ≥ 0 (s). A front counts from the moment of its arrival.
    pub fn strain(&self, x: f64, t: f64) -> f64 {
        let (outward, inward) = self.fronts(x, t);
        (outward + inward) * (self.velocity / self.wave_speed)
    }

    /// Velocity along the pull at 0 ≤ x ≤ L (m) and t ≥ 0 (s).
    pub fn velocity(&self, x: f64, t: f64) -> f64 {
        let (outward, inward) = self.fronts(x, t);
        (outward - inward) * self.velocity
    }

    /// How many fronts have passed x on their way to the clamp, and back from it.
    fn fronts(&self, x: f64, t: f64) -> (f64, f64) {
        let passed = |path: f64| (path / (2.0 * self.length)).floor().max(-1.0) + 1.0;
        let path = self.wave_speed * t;
        (passed(path - x), passed(path + x - 2.0 * self.length))
    }
}

/// The same pull on n equal elements at Courant number 1, cΔt = Δx.
///
/// After `step` steps, t = `step`·Δt, element e is strained as the fibre is at its middle,
/// x = (e + ½)Δx; the velocities used *in* that step are those of the nodes, x = iΔx, at the
/// middle of the step, t − ½Δt. No front is ever at such a point, so nothing is left to
/// convention, and every value is a whole number of fronts: 0 exactly ahead of the first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Mesh {
    /// n ≥ 1.
    pub elements: usize,
}

impl Mesh {
    /// Strain of element 0 ≤ e < n after `step` steps, in units of V/c.
    pub fn strain(&self, element: usize, step: usize) -> usize {
        // H(step − e − ½ − 2kn) and H(step + e + ½ − 2(k+1)n).
        self.outward(step, element) + self.inward(step + element)
    }

    /// Velocity of node 0 ≤ i ≤ n in step `step`, in units of V; 0 everywhere at step 0.
    pub fn velocity(&self, node: usize, step: usize) -> usize {
        // H(step − ½ − i − 2kn) and H(step − ½ + i − 2(k+1)n).
        match step {
            0 => 0,
            _ => self.outward(step, node) - self.inward(step + node - 1),
        }
    }

    /// Number of k ≥ 0 with step − place − ½ > 2kn.
    fn outward(&self, step: usize, place: usize) -> usize {
        if step > place { (step - place - 1) / (2 * self.elements) + 1 } else { 0 }
    }

    /// Number of k ≥ 0 with path + ½ > 2(k + 1)n.
    fn inward(&self, path: usize) -> usize {
        path / (2 * self.elements)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mesh_is_the_continuum_sampled_where_it_says() {
        let elements = 7;
        let dx = 1.37e-3;
        let pull = Pull { length: elements as f64 * dx, wave_speed: 6_371.3, velocity: 17.3 };
        let mesh = Mesh { elements };
        let dt = dx / pull.wave_speed;
        // Nine reflections; samples lie half an element off every front, so only the rounding of
        // one product is left.
        for step in 0..=67 {
            for e in 0..elements {
                let expected = pull.strain((e as f64 + 0.5) * dx, step as f64 * dt);
                let found = mesh.strain(e, step) as f64 * pull.velocity / pull.wave_speed;
                assert!((found - expected).abs() <= 1e-15 * expected, "{e} {step}");
            }
            for i in 0..=elements {
                let middle = (step as f64 - 0.5) * dt;
                let expected = if step == 0 { 0.0 } else { pull.velocity(i as f64 * dx, middle) };
                assert_eq!(mesh.velocity(i, step) as f64 * pull.velocity, expected, "{i} {step}");
            }
        }
    }

    #[test]
    fn mesh_obeys_momentum_and_strain_displacement_in_whole_numbers() {
        // In units of V, V/c and at cΔt = Δx: v⁺ᵢ = vᵢ + eᵢ₋₁ − eᵢ (the pull points towards
        // node 0), e⁺ = e + v⁺ₑ − v⁺ₑ₊₁, v₀ = 1, vₙ = 0. Integers: nothing to tolerate.
        for elements in [1, 2, 5, 11] {
            let mesh = Mesh { elements };
            let (mut v, mut e) = (vec![0_i64; elements + 1], vec![0_i64; elements]);
            for step in 1..=10 * elements {
                v[0] = 1;
                for i in 1..elements {
                    v[i] += e[i - 1] - e[i];
                }
                for i in 0..elements {
                    e[i] += v[i] - v[i + 1];
                }
                let found = |of: &dyn Fn(usize) -> usize, count: usize| -> Vec<i64> {
                    (0..count).map(|place| of(place) as i64).collect()
                };
                assert_eq!(found(&|i| mesh.velocity(i, step), elements + 1), v, "step {step}");
                assert_eq!(found(&|i| mesh.strain(i, step), elements), e, "step {step}");
            }
        }
    }

    #[test]
    fn pull_balances_length_momentum_and_energy() {
        // Over c, ρ and unit area: ∫ε dx = Vt; momentum grows by T(0) − T(L); energy by T(0)V.
        // Sums over cells between fronts: midpoints are exact for steps where the time is a
        // multiple of the cell's transit; 1e-12 is the rounding of 400 additions.
        let pull = Pull { length: 0.271, wave_speed: 5_113.7, velocity: -31.7 };
        let (cells, v, c) = (20, pull.velocity, pull.wave_speed);
        let dx = pull.length / f64::from(cells);
        let dt = dx / c;
        let middle = |cell: i32| (f64::from(cell) + 0.5) * dx;
        let sum = |t: f64, f: &dyn Fn(f64, f64) -> f64| -> f64 {
            (0..cells).map(|i| f(pull.strain(middle(i), t), pull.velocity(middle(i), t)) * dx).sum()
        };
        let (mut momentum, mut work) = (0.0, 0.0);
        for step in 1..=107 {
            // T/(ρc²) over the step is that at its middle: fronts meet the ends at step ends.
            let half_ago = (f64::from(step) - 0.5) * dt;
            let (pulled, clamped) =
                (pull.strain(0.0, half_ago), pull.strain(pull.length, half_ago));
            momentum += (pulled - clamped) * c * c * dt;
            work += pulled * c * c * v * dt;
            assert_eq!(pull.velocity(0.0, half_ago), v);
            assert_eq!(pull.velocity(pull.length, half_ago), 0.0);

            let t = f64::from(step) * dt;
            let length = sum(t, &|strain, _| strain);
            assert!((length / (v * t) - 1.0).abs() < 1e-12, "length at {step}: {length}");
            let found = sum(t, &|_, velocity| velocity);
            assert!((found - momentum).abs() < 1e-12 * (v * pull.length).abs(), "{step}: {found}");
            let energy =
                sum(t, &|strain, velocity| (c * c * strain * strain + velocity * velocity) / 2.0);
            assert!((energy / work - 1.0).abs() < 1e-12, "energy at {step}: {energy} {work}");
        }
    }

    #[test]
    fn fibre_is_exactly_at_rest_ahead_of_the_front() {
        let pull = Pull { length: 0.271, wave_speed: 5_113.7, velocity: 31.7 };
        let t = 0.113 / pull.wave_speed;
        assert_eq!((pull.strain(0.114, t), pull.velocity(0.114, t)), (0.0, 0.0));
        // One front behind it: V/c, a single division.
        assert_eq!(pull.strain(0.112, t), 31.7 / 5_113.7);
    }
}
