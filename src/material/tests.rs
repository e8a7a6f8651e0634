//! What holds for every law, and the laws without memory.

use std::cmp::max_by;

use approx::assert_relative_eq;

use super::*;

/// A law, what drives it along a path, and what it remembers.
pub(super) struct Run<'l, S: Number> {
    pub law: &'l dyn Law<S>,
    pub strain: S,
    pub stress: S,
    pub memory: Vec<S>,
    /// Σ mean stress × strain increment, J/m³.
    pub work: S,
}

impl<'l, S: Number> Run<'l, S> {
    pub fn new(law: &'l dyn Law<S>) -> Self {
        let memory = vec![S::zero(); law.memory()];
        Self { law, strain: S::zero(), stress: S::zero(), memory, work: S::zero() }
    }

    /// One step to a strain.
    pub fn to(&mut self, strain: S) -> S {
        let stress = self.law.stress(self.strain, strain, &mut self.memory);
        self.work += S::half() * (self.stress + stress) * (strain - self.strain);
        (self.strain, self.stress) = (strain, stress);
        stress
    }

    /// One step to a stress: creep. The strain by the tangent, as often as it takes.
    pub fn creep_to(&mut self, wanted: S) -> S {
        let mut strain = self.strain;
        for _ in 0..50 {
            let found = self.law.stress(self.strain, strain, &mut self.memory.clone());
            let slope = self.law.tangent_modulus(self.strain, strain, &self.memory);
            strain += (wanted - found) / slope;
        }
        self.to(strain);
        strain
    }

    pub fn dissipated(&self) -> S {
        self.law.dissipated(&self.memory)
    }

    /// Stored and dissipated, J/m³.
    pub fn energy(&self) -> S {
        self.law.stored(self.strain, &self.memory) + self.dissipated()
    }
}

/// Strain at a part 0 ≤ u ≤ 1 of a path that loads, unloads into compression and loads again.
fn path(u: f64) -> f64 {
    0.0123 * u + 0.0217 * pxfm::f_sin(7.9 * u) * u
}

const DURATION: f64 = 3.7e-6;

pub(super) const ARMS: [Arm; 2] = [
    Arm { modulus: 17.3e9, relaxation_time: 0.43e-6 },
    Arm { modulus: 9.7e9, relaxation_time: 7.9e-6 },
];

fn viscoelastic<S: Number>(update: Update) -> Viscoelastic<S> {
    Viscoelastic::new(31.9e9, &ARMS, update).unwrap()
}

/// Flows at 1e6 × sinh(s/50 MPa) per second: stresses of 6 units and, per microsecond, a decay of
/// one half of a small stress.
fn eyring<S: Number>(update: Update) -> Eyring<S> {
    Eyring::new(31.9e9, 17.3e9, 1.7e3, 53.0e6, update).unwrap()
}

const POLYNOMIAL: [f64; 3] = [58.6e9, -7.3e11, 3.1e13];

fn viscous<S: Number, L: Law<S>>(law: L) -> ArtificialViscosity<L, S> {
    let mesh = Mesh { density: 1206.7, spacing: 0.47e-3 };
    let coefficients = Coefficients { linear: 0.13, quadratic: 1.9 };
    ArtificialViscosity::new(law, mesh, coefficients).unwrap()
}

type Named<S> = Vec<(&'static str, Box<dyn Law<S>>)>;

/// Every law, for steps of one length.
fn laws<S: Number>(time_step: f64) -> Named<S> {
    let dt = S::from_f64(time_step);
    let exact = Update::Exact;
    vec![
        ("linear", Box::new(Linear::new(58.6e9).unwrap().prepared(dt))),
        ("polynomial", Box::new(Polynomial::new(&POLYNOMIAL).unwrap().prepared(dt))),
        ("exponential", Box::new(Exponential::new(1.7e9, 23.7).unwrap().prepared(dt))),
        ("viscoelastic", Box::new(viscoelastic(exact).prepared(dt))),
        ("viscoelastic, literal", Box::new(viscoelastic(Update::Literal).prepared(dt))),
        ("Eyring", Box::new(eyring(exact).prepared(dt))),
        ("Eyring, literal", Box::new(eyring(Update::Literal).prepared(dt))),
        ("slack linear", Box::new(TensionOnly::new(Linear::new(58.6e9).unwrap()).prepared(dt))),
        ("slack viscoelastic", Box::new(TensionOnly::new(viscoelastic(exact)).prepared(dt))),
        ("slack Eyring", Box::new(TensionOnly::new(eyring(exact)).prepared(dt))),
        ("viscous linear", Box::new(viscous(Linear::new(58.6e9).unwrap()).prepared(dt))),
        ("viscous slack Eyring", Box::new(viscous(TensionOnly::new(eyring(exact))).prepared(dt))),
    ]
}

fn along<'l, S: Number>(law: &'l dyn Law<S>, steps: u32, part: f64) -> Run<'l, S> {
    let mut run = Run::new(law);
    for k in 1..=(f64::from(steps) * part).round() as u32 {
        run.to(S::from_f64(path(f64::from(k) / f64::from(steps))));
    }
    run
}

#[test]
fn an_element_remembers_and_its_waves_grow_faster_as_its_law_says() {
    // Numbers by the table of the module, with two arms; polynomial, exponential and quadratic terms
    // are what a strain can make stiffer.
    for (name, law) in laws::<f64>(DURATION) {
        let (memory, can_outgrow) = match name {
            "linear" => (0, false),
            "polynomial" | "exponential" => (0, true),
            "viscoelastic" | "viscoelastic, literal" => (3, false),
            "Eyring" | "Eyring, literal" => (2, false),
            "slack linear" => (1, false),
            "slack viscoelastic" => (4, false),
            "slack Eyring" => (3, false),
            "viscous linear" => (1, true),
            "viscous slack Eyring" => (4, true),
            _ => panic!("{name} is missing here"),
        };
        assert_eq!((law.memory(), law.can_outgrow_the_step()), (memory, can_outgrow), "{name}");
        assert_eq!(law.bears_compression(), !name.contains("slack"), "{name}");
    }
    let none = Coefficients { linear: 0.13, quadratic: 0.0 };
    let mesh = Mesh { density: 1206.7, spacing: 0.47e-3 };
    let linear = Linear::<f64>::new(58.6e9).unwrap();
    assert!(!ArtificialViscosity::new(linear, mesh, none).unwrap().can_outgrow_the_step());
    let harder = Exponential::<f64>::new(1.7e9, 23.7).unwrap();
    assert!(ArtificialViscosity::new(harder, mesh, none).unwrap().can_outgrow_the_step());
    let straight = Polynomial::<f64>::new(&[58.6e9, 0.0]).unwrap();
    assert!(!straight.can_outgrow_the_step());
    assert!(TensionOnly::new(harder).can_outgrow_the_step());
    let [exact, literal] = [Update::Exact, Update::Literal].map(|update| update.is_exact());
    assert!(exact && !literal);
}

#[test]
fn a_block_is_its_elements_one_by_one() {
    for (name, law) in laws::<f64>(DURATION / 10.0) {
        let mut runs: Vec<_> = [0.2, 0.5, 0.9].map(|part| along(&*law, 10, part)).into();
        let before: Vec<f64> = runs.iter().map(|run| run.strain).collect();
        let now = [0.0131, 0.0078, -0.0042];
        let mut memory: Vec<f64> = runs.iter().flat_map(|run| run.memory.clone()).collect();
        let mut block = [[f64::NAN; 3]; 3];
        law.stresses(&before, &now, &mut memory, &mut block[0]);
        law.dissipations(&memory, &mut block[1]);
        law.step_moduli(&before, &now, &memory, &mut block[2]);
        for (i, run) in runs.iter_mut().enumerate() {
            let stress = run.to(now[i]);
            let modulus = law.step_modulus(before[i], now[i], &run.memory);
            let alone = [stress, run.dissipated(), modulus];
            assert_eq!(block.map(|numbers| numbers[i]), alone, "{name} {i}");
        }
    }
}

#[test]
fn tangent_is_the_limit_of_difference_quotients() {
    // Loading, unloading, in compression. The quotient errs by h² third derivatives (relative
    // (h/Δε)² ~ 1e-8 at worst) and by rounding, 1e-16 × stress/(h × modulus) ~ 1e-10.
    let mut cases = 0;
    for part in [0.15, 0.37, 0.61, 0.93] {
        for (name, law) in laws::<f64>(DURATION / 100.0) {
            let run = along(&*law, 100, part);
            let now = path(part + 0.01);
            let stress = |now| law.stress(run.strain, now, &mut run.memory.clone());
            let h = 1e-7;
            let quotient = (stress(now + h) - stress(now - h)) / (2.0 * h);
            let found = law.tangent_modulus(run.strain, now, &run.memory);
            if name == "viscous slack Eyring" && quotient == 0.0 {
                continue; // The cut of the viscous stress is left out of the tangent.
            }
            assert_relative_eq!(found, quotient, epsilon = 1.0, max_relative = 1e-7);
            cases += 1;
        }
    }
    assert_eq!(cases, 4 * 12 - 1);
}

#[test]
fn a_step_without_time_feels_the_instantaneous_modulus() {
    // Steps of 1e-16 s: Δt/τ ~ 1e-10 is what the arms may still flow.
    for (name, law) in laws::<f64>(1e-16) {
        let run = along(&*law, 100, 0.15);
        if name.starts_with("viscous") {
            continue; // Its stress grows as the step gets shorter: 1/Δt.
        }
        let tangent = law.tangent_modulus(run.strain, run.strain, &run.memory);
        let instantaneous = law.instantaneous_modulus(run.strain, &run.memory);
        assert_relative_eq!(tangent, instantaneous, epsilon = 0.0, max_relative = 1e-8);
    }
    // And so does a law that has not been prepared, to rounding.
    let unprepared =
        [&viscous(viscoelastic(Update::Exact)) as &dyn Law<f64>, &eyring(Update::Exact)];
    for (law, modulus) in unprepared.into_iter().zip([58.9e9, 49.2e9]) {
        let stress = Run::new(law).to(0.0173);
        assert_relative_eq!(stress, modulus * 0.0173, epsilon = 0.0, max_relative = 1e-15);
        assert_eq!(law.instantaneous_modulus(0.0173, &vec![0.0; law.memory()]), modulus);
    }
}

#[test]
fn stored_and_dissipated_energy_are_the_work_to_the_stated_order() {
    // Against the work of the mean stress, 800 and 1600 steps, as a part of the energy at the end.
    // An Eyring arm accounts for just that work; a smooth curve of stress differs from its chords at
    // order 2, one with a corner where the fibre goes slack within a step hardly less; q of a step
    // is constant, so its mean with that of the step before is late by half a step.
    let error = |name: &str, steps: u32| {
        let mut laws = laws::<f64>(DURATION / f64::from(steps)).into_iter();
        let law = laws.find(|(other, _)| *other == name).unwrap().1;
        let run = along(&*law, steps, 1.0);
        run.work / run.energy() - 1.0
    };
    for (name, tolerance, ratio) in [
        ("linear", 4e-15, None),
        ("polynomial", 2e-6, Some(4.0)),
        ("exponential", 2e-6, Some(4.0)),
        ("viscoelastic", 1e-6, Some(4.0)),
        ("Eyring", 2e-15, None),
        ("slack linear", 2e-6, None),
        ("slack viscoelastic", 1e-6, None),
        ("slack Eyring", 2e-6, None),
        ("viscous linear", 2e-6, None),
        ("viscous slack Eyring", 2e-5, None),
    ] {
        let (coarse, fine) = (error(name, 800), error(name, 1600));
        assert!(fine.abs() < tolerance, "{name}: {fine:e}");
        if let Some(ratio) = ratio {
            assert!((coarse / fine - ratio).abs() < 0.02, "{name}: {coarse:e} {fine:e}");
        }
    }
}

#[test]
fn dissipation_never_decreases() {
    for (name, law) in laws::<f64>(DURATION / 70.0) {
        let mut run = Run::new(&*law);
        let mut before = 0.0;
        for k in 1..=70 {
            run.to(path(f64::from(k) / 70.0));
            assert!(run.dissipated() >= before || name.contains("literal"), "{name} {k}");
            before = run.dissipated();
        }
        let lossless = ["linear", "polynomial", "exponential", "slack linear"].contains(&name);
        assert_eq!(before == 0.0, lossless, "{name}");
    }
}

#[test]
fn single_precision_follows_double() {
    // A few roundings of 6e-8 in each of 90 steps; those of arms and energies add up at random.
    for ((name, double), (_, single)) in
        laws::<f64>(DURATION / 90.0).into_iter().zip(laws::<f32>(DURATION / 90.0))
    {
        let (mut double, mut single) = (Run::new(&*double), Run::new(&*single));
        let (mut error, mut greatest) = (0.0_f64, 0.0_f64);
        for k in 1..=90 {
            let strain = path(f64::from(k) / 90.0);
            let (expected, found) = (double.to(strain), f64::from(single.to(strain as f32)));
            error = max_by(error, (found - expected).abs(), f64::total_cmp);
            greatest = greatest.max(expected.abs());
        }
        assert!(error / greatest < 6e-7, "{name}: {:e}", error / greatest);
        let energy = f64::from(single.energy()) / double.energy() - 1.0;
        assert!(energy.abs() < 6e-7, "{name}: energy {energy:e}");
    }
}

#[test]
fn literal_updates_approach_the_exact_ones_to_first_order() {
    // Errors of stress and of dissipated energy at 400 and 800 steps: twice, within a tenth.
    for (exact, literal) in
        [("viscoelastic", "viscoelastic, literal"), ("Eyring", "Eyring, literal")]
    {
        let end = |name: &str, steps: u32| {
            let mut laws = laws::<f64>(DURATION / f64::from(steps)).into_iter();
            let law = laws.find(|(other, _)| *other == name).unwrap().1;
            let run = along(&*law, steps, 1.0);
            [run.stress, run.dissipated()]
        };
        let (reference, coarse, fine) = (end(exact, 6400), end(literal, 400), end(literal, 800));
        for i in 0..2 {
            let ratio = (coarse[i] - reference[i]) / (fine[i] - reference[i]);
            assert!((ratio - 2.0).abs() < 0.2, "{literal} {i}: {ratio}");
        }
    }
}

#[test]
fn elastic_laws_agree_with_40_digits() {
    // Stress, tangent, energy in another language. Tolerance: some ten roundings; the powers of
    // the polynomial and exp(bε) cancel to no less than a third of their sizes.
    let polynomial = Polynomial::<f64>::new(&POLYNOMIAL).unwrap();
    let (hard, soft) =
        (Exponential::<f64>::new(1.7e9, 23.7).unwrap(), Exponential::new(-2.9e9, -19.3).unwrap());
    let cases: [(&dyn Law<f64>, f64, [f64; 3]); 9] = [
        (&polynomial, 1.3e-9, [76.17999876630007, 58599998102.00016, 4.9516999465396697e-08]),
        (&polynomial, 0.0173, [955807527.0, 61175970000.0, 8203488.270108333]),
        (&polynomial, -0.0291, [-3087338601.0, 179839330000.0, 36365220.224775]),
        (&hard, 1.3e-9, [52.37700080686769, 40290001241.334915, 3.404505034964267e-08]),
        (&hard, 0.0173, [861615850.7222779, 60710295662.11798, 6945099.186594005]),
        (&hard, -0.0691, [-1369464677.32883, 7833687147.3067255, 59686680.28148395]),
        (&soft, 1.3e-9, [72.76099908721326, 55969998595.71272, 4.729464960445909e-08]),
        (&soft, 0.0173, [823215597.8209406, 40081938962.05585, 7516342.081816547]),
        (&soft, -0.0691, [-8104901197.70763, 212394593115.75726, 219553067.2387373]),
    ];
    for (law, strain, [stress, tangent, energy]) in cases {
        let found = [
            (law.stress(0.7, strain, &mut []), stress),
            (law.tangent_modulus(0.7, strain, &[]), tangent),
            (law.instantaneous_modulus(strain, &[]), tangent),
            (law.stored(strain, &[]), energy),
        ];
        for (found, expected) in found {
            assert_relative_eq!(found, expected, epsilon = 0.0, max_relative = 1.5e-15);
        }
    }
}

#[test]
fn equation_7_is_a_product_and_nothing_else() {
    let law = Linear::<f64>::new(58.6e9).unwrap();
    for (before, now) in [(0.3, 0.01453), (-0.7, -0.00291), (0.0, 3.1e-17)] {
        assert_eq!(law.stress(before, now, &mut []).to_bits(), (58.6e9 * now).to_bits());
    }
    // ½ × 58.6e9 × 0.01453²; tolerance: three roundings.
    assert_relative_eq!(law.stored(0.01453, &[]), 6_185_842.37, max_relative = 4e-16);
}

#[test]
fn energy_of_the_exponential_law_is_seamless_where_its_form_changes() {
    // Either side of bε = ±1, against Simpson's rule for ∫ σ dε with 400 panels: error (bε)⁴/2880/400⁴
    // below 1e-12.
    let (a, b) = (1.7e9, 23.7);
    let law = Exponential::<f64>::new(a, b).unwrap();
    for y in [0.98, 1.02, -0.98, -1.02, 2.9, 0.011] {
        let h = y / b / 800.0;
        let sum: f64 = (0..=800)
            .map(|k| {
                let weight = if k == 0 || k == 800 { 1.0 } else { f64::from(2 + 2 * (k % 2)) };
                weight * law.stress(0.0, h * f64::from(k), &mut [])
            })
            .sum();
        assert_relative_eq!(law.stored(y / b, &[]), sum * h / 3.0, max_relative = 2e-12);
    }
}

#[test]
fn numbers_that_make_no_law_are_refused_with_the_name_of_the_parameter() {
    let named = |error: ParameterError, name: &str| assert_eq!(error.parameter, name, "{error}");
    named(Linear::<f64>::new(0.0).unwrap_err(), "modulus");
    named(Polynomial::<f64>::new(&[]).unwrap_err(), "coefficients");
    named(Polynomial::<f64>::new(&[-1.3e9, 2e9]).unwrap_err(), "coefficients[0]");
    named(Polynomial::<f64>::new(&[1.3e9, 2e9, f64::NAN]).unwrap_err(), "coefficients[2]");
    assert!(Polynomial::<f64>::new(&[1.3e9, -2e9]).is_ok());
    named(Exponential::<f64>::new(f64::INFINITY, 19.3).unwrap_err(), "a");
    named(Exponential::<f64>::new(1.3e9, f64::NAN).unwrap_err(), "b");
    // The last: a product that is lost below the least number, where the quotient is not.
    for (a, b) in [(1.3e9, -19.3), (-1.3e9, 19.3), (0.0, 19.3), (1e-200, 1e-200)] {
        named(Exponential::<f64>::new(a, b).unwrap_err(), "a*b");
    }
    let arms = |modulus, relaxation_time| [ARMS[0], Arm { modulus, relaxation_time }];
    let viscoelastic = |equilibrium, arms: &[Arm]| {
        Viscoelastic::<f64>::new(equilibrium, arms, Update::Exact).map(|_| ())
    };
    named(viscoelastic(-1.0, &ARMS).unwrap_err(), "equilibrium_modulus");
    named(viscoelastic(3e9, &[]).unwrap_err(), "arms");
    named(viscoelastic(3e9, &arms(0.0, 1e-6)).unwrap_err(), "arms[1].modulus");
    named(viscoelastic(3e9, &arms(2e9, 0.0)).unwrap_err(), "arms[1].relaxation_time");
    assert_eq!(viscoelastic(0.0, &ARMS), Ok(()));
    let eyring = |e0, e, rate, s| Eyring::<f64>::new(e0, e, rate, s, Update::Exact).map(|_| ());
    named(eyring(-1e9, 2e9, 3e2, 5e7).unwrap_err(), "equilibrium_modulus");
    named(eyring(1e9, 0.0, 3e2, 5e7).unwrap_err(), "modulus");
    named(eyring(1e9, 2e9, 0.0, 5e7).unwrap_err(), "rate");
    named(eyring(1e9, 2e9, 3e2, -5e7).unwrap_err(), "stress");
    assert_eq!(eyring(0.0, 2e9, 3e2, 5e7), Ok(()));
    let viscous = |density, spacing, linear, quadratic| {
        let law = Linear::<f64>::new(58.6e9)?;
        let mesh = Mesh { density, spacing };
        ArtificialViscosity::new(law, mesh, Coefficients { linear, quadratic }).map(|_| ())
    };
    named(viscous(0.0, 1e-3, 0.1, 1.0).unwrap_err(), "density");
    named(viscous(1e3, -1e-3, 0.1, 1.0).unwrap_err(), "spacing");
    named(viscous(1e3, 1e-3, -0.1, 1.0).unwrap_err(), "linear");
    named(viscous(1e3, 1e-3, 0.1, -1.0).unwrap_err(), "quadratic");
    assert_eq!(viscous(1e3, 1e-3, 0.0, 0.0), Ok(()));
}
