//! The rod by the method of characteristics: no transform, no closed form, the front included.

use std::cmp::max_by;

use super::*;

/// What the characteristics need at a place.
#[derive(Clone)]
struct Node {
    /// ρcv, in the units of stress.
    velocity: f64,
    strain: f64,
    /// Of the spring and of the arms.
    stresses: Vec<f64>,
}

/// The rod in units of E₀: moduli and rates of all branches, the spring's rate being 0.
struct Branches {
    modulus: Vec<f64>,
    rate: Vec<f64>,
}

impl Branches {
    fn relaxing(&self, node: &Node) -> f64 {
        node.stresses.iter().zip(&self.rate).map(|(stress, rate)| stress * rate).sum()
    }

    /// Behind the front, ρcv = σ and ε = σ/E₀.
    fn front(&self, stress: f64) -> Node {
        let stresses = self.modulus.iter().map(|modulus| modulus * stress).collect();
        Node { velocity: stress, strain: stress, stresses }
    }

    /// σ and ρcv at x = i·h, t = j·h for h = `duration`/`steps` and v₀ = 1, j = `steps`; both
    /// lengths in units of time. Every rule is trapezoidal: the error is in even powers of h.
    ///
    /// Along dx = ±c dt, σ ± ρcv falls at the rate r = Σσ_k/τ_k; along dx = 0 each branch obeys
    /// its own law.
    fn march(&self, duration: f64, steps: usize) -> Vec<Node> {
        let h = duration / steps as f64;
        let mut nodes = vec![self.front(1.0); steps + 1];
        let decay: f64 = self.modulus.iter().zip(&self.rate).map(|(f, a)| f * a).sum();
        let mut front = 1.0;
        for j in 1..=steps {
            front *= (1.0 - 0.25 * h * decay) / (1.0 + 0.25 * h * decay);
            // Nodes of even i + j alone: those beside i are one step old, i itself two.
            for i in (j % 2..j).step_by(2) {
                nodes[i] = self.next(&nodes, i, h);
            }
            nodes[j] = self.front(front);
        }
        nodes
    }

    fn next(&self, nodes: &[Node], i: usize, h: f64) -> Node {
        let total = |node: &Node| node.stresses.iter().sum::<f64>();
        let (inward, half) = (&nodes[i + 1], 0.5 * h);
        // σ − ρcv and σ + ρcv, but for the relaxation at the new node.
        let backward = total(inward) - inward.velocity - half * self.relaxing(inward);
        // σ + ½hr at the new node.
        let known = if i == 0 {
            backward + 1.0
        } else {
            let outer = &nodes[i - 1];
            let forward = total(outer) + outer.velocity - half * self.relaxing(outer);
            0.5 * (forward + backward)
        };
        // Each branch over 2h: linear in the growth of the strain.
        let old = &nodes[i];
        let branches = || old.stresses.iter().zip(self.modulus.iter().zip(&self.rate));
        let kept = |stress: f64, a: f64| stress * (1.0 - h * a) / (1.0 + h * a);
        let gained = |f: f64, a: f64| f / (1.0 + h * a);
        let (mut constant, mut slope) = (0.0, 0.0);
        for (&stress, (&f, &a)) in branches() {
            constant += kept(stress, a) * (1.0 + half * a);
            slope += gained(f, a) * (1.0 + half * a);
        }
        let growth = (known - constant) / slope;
        let stresses: Vec<f64> =
            branches().map(|(&stress, (&f, &a))| kept(stress, a) + gained(f, a) * growth).collect();
        let mut node = Node { velocity: 1.0, strain: old.strain + growth, stresses };
        if i > 0 {
            let relaxed = half * self.relaxing(&node);
            node.velocity = total(&node) + relaxed - backward;
        }
        node
    }
}

#[test]
fn states_agree_with_the_method_of_characteristics() {
    for (density, spring, arms) in [
        (1390.0, 3.1e9, vec![arm(5.7e9, 1.3e-5)]),
        (970.0, 1.9e9, vec![arm(23e9, 5.9e-6), arm(11.3e9, 0.71e-4), arm(4.7e9, 3.7e-3)]),
        (970.0, 0.0, vec![arm(23e9, 0.83e-5), arm(11.3e9, 0.71e-4)]),
    ] {
        let rod = PulledRod::new(density, spring, &arms, VELOCITY).unwrap();
        let glassy = spring + arms.iter().map(|arm| arm.modulus).sum::<f64>();
        let branches = Branches {
            modulus: [spring / glassy]
                .into_iter()
                .chain(arms.iter().map(|arm| arm.modulus / glassy))
                .collect(),
            rate: [0.0]
                .into_iter()
                .chain(arms.iter().map(|arm| 1.0 / arm.relaxation_time))
                .collect(),
        };
        let (duration, steps) = (4.3e-5, 240);
        let c = rod.front_speed();
        let levels = [1, 2, 4].map(|fine| (fine, branches.march(duration, fine * steps)));
        let mut errors = [0.0_f64; 3];
        for i in (0..=steps).step_by(8) {
            let state =
                rod.at(i as f64 * duration / steps as f64 * c * (1.0 - 1e-15), duration).unwrap();
            let expected = [
                state.stress / (density * c * VELOCITY),
                state.strain * c / VELOCITY,
                state.velocity / VELOCITY,
            ];
            let [coarse, middle, fine] = levels.each_ref().map(|(fine, nodes)| {
                let node = &nodes[fine * i];
                [node.stresses.iter().sum::<f64>(), node.strain, node.velocity]
            });
            for q in 0..3 {
                let once = (4.0 * middle[q] - coarse[q]) / 3.0;
                let twice = (4.0 * fine[q] - middle[q]) / 3.0;
                let best = (16.0 * twice - once) / 15.0;
                for (error, value) in errors.iter_mut().zip([fine[q], twice, best]) {
                    *error = max_by(*error, (value - expected[q]).abs(), f64::total_cmp);
                }
            }
        }
        // At the finest step, 960 to the duration, the rule is off by (h/τ)²/6 and the like, 3e-6;
        // a fourth-order estimate by the square of that; the sixth-order one would be by its cube,
        // so that the rounding of some 1000 steps is left.
        let [second, fourth, sixth] = errors;
        assert!(second < 5e-6 && fourth < 5e-11 && sixth < 2e-13, "{errors:?}");
    }
}
