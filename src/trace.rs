//! Tracing: a paper that reports every evaluation and delegates it.
//!
//! [`Traced`] wraps any edition. The march is the same; the untraced march never sees this file.

use std::cell::{Cell, RefCell};

use crate::equations::{Equation, Line};
use crate::number::{Number, Vector};
use crate::paper::{
    Cosines, CrossoverPush, Direction, Lengths, Paper, ProjectilePush, StressByLaw,
};
use crate::place::{Fibre, Place};

/// A number or a vector of an equation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value<'a, S> {
    /// One number.
    Scalar(S),
    /// Components in the order x, y, z.
    Vector(&'a [S]),
}

/// One evaluation of one equation.
#[derive(Clone, Copy, Debug)]
pub struct Event<'a, S> {
    /// Step, fibre, node or element.
    pub place: Place,
    /// Number on the page.
    pub equation: u8,
    /// What went in, by the names of [`crate::equations::SYMBOLS`].
    pub inputs: &'a [(&'static str, Value<'a, S>)],
    /// What came out.
    pub output: Value<'a, S>,
}

/// Takes events. Knows nothing of the march.
pub trait Sink<S> {
    /// One evaluation has been made.
    fn event(&mut self, event: &Event<'_, S>);
}

impl<S, F: FnMut(&Event<'_, S>)> Sink<S> for F {
    fn event(&mut self, event: &Event<'_, S>) {
        self(event);
    }
}

/// A paper that reports every evaluation to a sink.
pub struct Traced<'p, P, K> {
    paper: &'p P,
    sink: RefCell<K>,
    place: Cell<Place>,
}

impl<'p, P, K> Traced<'p, P, K> {
    /// Wraps an edition.
    pub fn new(paper: &'p P, sink: K) -> Self {
        let place = Cell::new(Place { step: 0, fibre: Fibre::Primary, index: 0 });
        Self { paper, sink: RefCell::new(sink), place }
    }

    /// The sink, when the march is over.
    pub fn into_sink(self) -> K {
        self.sink.into_inner()
    }

    fn report<S>(&self, equation: u8, inputs: &[(&'static str, Value<'_, S>)], output: Value<'_, S>)
    where
        K: Sink<S>,
    {
        let event = Event { place: self.place.get(), equation, inputs, output };
        self.sink.borrow_mut().event(&event);
    }
}

fn scalar<S>(x: S) -> Value<'static, S> {
    Value::Scalar(x)
}

fn vector<S: Number, const D: usize>(v: &Vector<S, D>) -> Value<'_, S> {
    Value::Vector(v.as_slice())
}

/// Every method: evaluate by the wrapped edition, then report what the equation used.
impl<S: Number, P: Paper<S>, K: Sink<S>> Paper<S> for Traced<'_, P, K> {
    const BLOCK: usize = 1;
    const BLOCK_BY_LAW: usize = 1;

    fn at(&self, place: Place) {
        self.place.set(place);
    }

    fn uses_previous_length(&self) -> bool {
        self.paper.uses_previous_length()
    }

    fn lines(&self, equation: &'static Equation) -> Vec<Line> {
        self.paper.lines(equation)
    }

    fn eqn_1_impulse_residual<const D: usize>(
        &self,
        tension_ahead: Vector<S, D>,
        tension_here: Vector<S, D>,
        mass_over_time_step: S,
        velocity: Vector<S, D>,
        previous_velocity: Vector<S, D>,
    ) -> Vector<S, D> {
        let out = self.paper.eqn_1_impulse_residual(
            tension_ahead,
            tension_here,
            mass_over_time_step,
            velocity,
            previous_velocity,
        );
        let inputs = [
            ("T_ahead", vector(&tension_ahead)),
            ("T_here", vector(&tension_here)),
            ("m_over_dt", scalar(mass_over_time_step)),
            ("v", vector(&velocity)),
            ("v_before", vector(&previous_velocity)),
        ];
        self.report(1, &inputs, vector(&out));
        out
    }

    fn eqn_2_velocity<const D: usize>(
        &self,
        previous_velocity: Vector<S, D>,
        a: S,
        tension_ahead: Vector<S, D>,
        tension_here: Vector<S, D>,
    ) -> Vector<S, D> {
        let out = self.paper.eqn_2_velocity(previous_velocity, a, tension_ahead, tension_here);
        let inputs = [
            ("v_before", vector(&previous_velocity)),
            ("A", scalar(a)),
            ("T_ahead", vector(&tension_ahead)),
            ("T_here", vector(&tension_here)),
        ];
        self.report(2, &inputs, vector(&out));
        out
    }

    fn eqn_3_strain_increment(&self, length: S, previous_length: S) -> S {
        let out = self.paper.eqn_3_strain_increment(length, previous_length);
        self.report(
            3,
            &[("L", scalar(length)), ("L_before", scalar(previous_length))],
            scalar(out),
        );
        out
    }

    fn eqn_4_strain(&self, previous_strain: S, length: Lengths<S>) -> S {
        let out = self.paper.eqn_4_strain(previous_strain, length);
        let now = ("L", scalar(length.now));
        if self.uses_previous_length() {
            let before = ("L_before", scalar(length.previous));
            let inputs = [("strain_before", scalar(previous_strain)), now, before];
            self.report(4, &inputs, scalar(out));
        } else {
            self.report(4, &[now, ("L_0", scalar(length.unstrained))], scalar(out));
        }
        out
    }

    fn eqn_5_previous_length<const D: usize>(
        &self,
        position_ahead: Vector<S, D>,
        position_here: Vector<S, D>,
    ) -> S {
        let out = self.paper.eqn_5_previous_length(position_ahead, position_here);
        let inputs = [("x_ahead", vector(&position_ahead)), ("x_here", vector(&position_here))];
        self.report(5, &inputs, scalar(out));
        out
    }

    fn eqn_6_length<const D: usize>(
        &self,
        position_ahead: Vector<S, D>,
        velocity_ahead: Vector<S, D>,
        position_here: Vector<S, D>,
        velocity_here: Vector<S, D>,
        time_step: S,
    ) -> S {
        let out = self.paper.eqn_6_length(
            position_ahead,
            velocity_ahead,
            position_here,
            velocity_here,
            time_step,
        );
        let inputs = [
            ("x_ahead", vector(&position_ahead)),
            ("v_ahead", vector(&velocity_ahead)),
            ("x_here", vector(&position_here)),
            ("v_here", vector(&velocity_here)),
            ("dt", scalar(time_step)),
        ];
        self.report(6, &inputs, scalar(out));
        out
    }

    fn eqn_7_tension(&self, stiffness: S, strain: S) -> S {
        let out = self.paper.eqn_7_tension(stiffness, strain);
        self.report(7, &[("E", scalar(stiffness)), ("strain", scalar(strain))], scalar(out));
        out
    }

    fn eqn_7_tension_by_law(&self, area: S, by: StressByLaw<'_, S>) -> S {
        let out = self.paper.eqn_7_tension_by_law(area, by);
        let inputs = [
            ("area", scalar(area)),
            ("stress", scalar(by.stress)),
            ("strain_before", scalar(by.strain_before)),
            ("strain", scalar(by.strain)),
            ("memory", Value::Vector(by.memory.numbers())),
        ];
        self.report(7, &inputs, scalar(out));
        out
    }

    fn eqn_8_projectile_velocity(&self, push: ProjectilePush<S>) -> S {
        let out = self.paper.eqn_8_projectile_velocity(push);
        let inputs = [
            ("v_p_before", scalar(push.velocity)),
            ("T_y", scalar(push.tension_y)),
            ("m_p", scalar(push.mass)),
            ("m_node", scalar(push.node_mass)),
            ("dt", scalar(push.time_step)),
            ("t", scalar(push.time)),
        ];
        self.report(8, &inputs, scalar(out));
        out
    }

    fn eqn_9_parallel_velocity(&self, u: S, v: S, theta: Direction<S>) -> S {
        let out = self.paper.eqn_9_parallel_velocity(u, v, theta);
        self.report(9, &velocity_and_angle(u, v, theta), scalar(out));
        out
    }

    fn eqn_10_perpendicular_velocity(&self, u: S, v: S, theta: Direction<S>) -> S {
        let out = self.paper.eqn_10_perpendicular_velocity(u, v, theta);
        self.report(10, &velocity_and_angle(u, v, theta), scalar(out));
        out
    }

    fn eqn_11_direction(&self, here: Vector<S, 2>, behind: Vector<S, 2>) -> Direction<S> {
        let out = self.paper.eqn_11_direction(here, behind);
        let inputs = [
            ("x_here", scalar(here.x)),
            ("y_here", scalar(here.y)),
            ("x_behind", scalar(behind.x)),
            ("y_behind", scalar(behind.y)),
        ];
        self.report(11, &inputs, Value::Vector(&[out.cos, out.sin]));
        out
    }

    fn eqn_12_secondary_u(
        &self,
        slide_factor: S,
        parallel: S,
        perpendicular: S,
        theta: Direction<S>,
    ) -> S {
        let out = self.paper.eqn_12_secondary_u(slide_factor, parallel, perpendicular, theta);
        self.report(12, &imposed(slide_factor, parallel, perpendicular, theta), scalar(out));
        out
    }

    fn eqn_13_secondary_v(
        &self,
        slide_factor: S,
        parallel: S,
        perpendicular: S,
        theta: Direction<S>,
    ) -> S {
        let out = self.paper.eqn_13_secondary_v(slide_factor, parallel, perpendicular, theta);
        self.report(13, &imposed(slide_factor, parallel, perpendicular, theta), scalar(out));
        out
    }

    fn eqn_14_secondary_w(&self) -> S {
        let out = self.paper.eqn_14_secondary_w();
        self.report(14, &[], scalar(out));
        out
    }

    fn eqn_15_parallel_tension(&self, tension: S, secondary: Cosines<S>, primary: Cosines<S>) -> S {
        let out = self.paper.eqn_15_parallel_tension(tension, secondary, primary);
        self.report(15, &tension_and_cosines(tension, secondary, primary), scalar(out));
        out
    }

    fn eqn_16_perpendicular_tension(
        &self,
        tension: S,
        secondary: Cosines<S>,
        primary: Cosines<S>,
    ) -> S {
        let out = self.paper.eqn_16_perpendicular_tension(tension, secondary, primary);
        self.report(16, &tension_and_cosines(tension, secondary, primary), scalar(out));
        out
    }

    fn eqn_17_u_at_crossover(&self, u: S, push: CrossoverPush<S>) -> S {
        let out = self.paper.eqn_17_u_at_crossover(u, push);
        self.report(17, &pushed("u_by_2", u, &push), scalar(out));
        out
    }

    fn eqn_18_v_at_crossover(&self, v: S, push: CrossoverPush<S>) -> S {
        let out = self.paper.eqn_18_v_at_crossover(v, push);
        self.report(18, &pushed("v_by_2", v, &push), scalar(out));
        out
    }

    fn eqn_19_acceleration(&self, wave_speed: S, curvature: S) -> S {
        let out = self.paper.eqn_19_acceleration(wave_speed, curvature);
        let inputs = [("c", scalar(wave_speed)), ("curvature", scalar(curvature))];
        self.report(19, &inputs, scalar(out));
        out
    }

    fn eqn_20_courant(&self, wave_speed: S, time_step: S, spacing: S) -> S {
        let out = self.paper.eqn_20_courant(wave_speed, time_step, spacing);
        let inputs =
            [("c", scalar(wave_speed)), ("dt", scalar(time_step)), ("dx", scalar(spacing))];
        self.report(20, &inputs, scalar(out));
        out
    }
}

type Input<S> = (&'static str, Value<'static, S>);

fn velocity_and_angle<S>(u: S, v: S, theta: Direction<S>) -> [Input<S>; 4] {
    [("u", scalar(u)), ("v", scalar(v)), ("cos", scalar(theta.cos)), ("sin", scalar(theta.sin))]
}

fn imposed<S>(
    slide_factor: S,
    parallel: S,
    perpendicular: S,
    theta: Direction<S>,
) -> [Input<S>; 5] {
    [
        ("alpha_s", scalar(slide_factor)),
        ("v_para", scalar(parallel)),
        ("v_perp", scalar(perpendicular)),
        ("cos", scalar(theta.cos)),
        ("sin", scalar(theta.sin)),
    ]
}

fn tension_and_cosines<S>(tension: S, secondary: Cosines<S>, primary: Cosines<S>) -> [Input<S>; 5] {
    [
        ("T2", scalar(tension)),
        ("cos_phi2_x", scalar(secondary.x)),
        ("cos_phi2_y", scalar(secondary.y)),
        ("cos_phi1_x", scalar(primary.x)),
        ("cos_phi1_y", scalar(primary.y)),
    ]
}

fn pushed<S: Number>(name: &'static str, velocity: S, push: &CrossoverPush<S>) -> [Input<S>; 11] {
    [
        (name, scalar(velocity)),
        ("A", scalar(push.a)),
        ("alpha_s", scalar(push.slide_factor)),
        ("T2_perp", scalar(push.perpendicular)),
        ("T2_para", scalar(push.parallel)),
        ("cos_phi1_x", scalar(push.primary.x)),
        ("cos_phi1_y", scalar(push.primary.y)),
        ("du", scalar(push.change.x)),
        ("dv", scalar(push.change.y)),
        ("m1", scalar(push.mass)),
        ("m2", scalar(push.secondary_mass)),
    ]
}
