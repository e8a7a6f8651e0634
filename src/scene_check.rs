//! What the types of a scene cannot express: ranges, and values that contradict each other.

use std::fmt;
use std::ops::RangeInclusive;

use crate::discretisation::{Crossing, Discretisation, Properties};
use crate::errata::Erratum;
use crate::material::{Mesh, ParameterFault, of_scene};
use crate::plan::memory_of_run;
use crate::scene::{FORMAT, Law, Material, Primary, Scene, Secondary};

/// Memory that a run may take, bytes: state and result of some 48 million elements. The limit is the
/// same everywhere, so that a scene is; beyond it ordinary machines end a program without a word.
pub const MAX_MEMORY: f64 = 8e9;

/// Steps that a run may have, 2⁵³: a double counts no further, and the time is steps × Δt.
pub const MAX_STEPS: u64 = 1 << 53;

/// Where the quantities must lie that a run multiplies with each other. Beyond, some product is too
/// large for a double, or so small that it loses digits without a trace.
///
/// Within, other units give the same bits, if they differ by powers of two (case
/// `extreme.scaling`).
const SAFE: RangeInclusive<f64> = 1e-200..=1e200;

/// What is wrong with a scene, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// The field, such as `secondary.slide_factor`; empty for the scene as a whole.
    pub path: String,
    /// What is wrong with it.
    pub message: String,
    /// What to do.
    pub help: Option<String>,
}

impl Problem {
    fn new(path: impl Into<String>, message: impl Into<String>) -> Self {
        Self { path: path.into(), message: message.into(), help: None }
    }

    fn help(self, help: impl Into<String>) -> Self {
        Self { help: Some(help.into()), ..self }
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, to: &mut fmt::Formatter) -> fmt::Result {
        write!(to, "{}: {}", self.path, self.message)?;
        self.help.iter().try_for_each(|help| write!(to, "\n  help: {help}"))
    }
}

impl std::error::Error for Problem {}

impl Scene {
    /// Whether the scene can be run: the first problem found, if any.
    ///
    /// A Courant number above 1 passes: that such a run diverges is worth showing.
    pub fn check(&self) -> Result<(), Problem> {
        check_format(&self.format)?;
        let Primary { length, elements, density, area, ref material } = self.primary;
        check_fibre("primary", length, elements, density, area, material)?;
        if let Some(secondary) = &self.secondary {
            let Secondary { length, elements, density, area, ref material, .. } = *secondary;
            check_fibre("secondary", length, elements, density, area, material)?;
            check_slide_factor(secondary.slide_factor)?;
        }
        self.check_memory()?;
        self.check_projectile()?;
        positive("courant", self.courant)?;
        positive("duration", self.duration)?;

        let mesh = Discretisation::<f64>::of(self);
        check_properties("primary", &mesh.primary)?;
        if let Some(crossing) = &mesh.secondary {
            check_properties("secondary", &crossing.fibre)?;
            self.check_crossover(&mesh.primary, crossing)?;
        }
        in_range("courant", "the time step Δt = courant × Δx/c", mesh.time_step)?;
        in_range("primary", "A = Δt/Δm", mesh.primary.a)?;
        let velocity = self.projectile.velocity;
        let energy = mesh.primary.mass * velocity * velocity;
        in_range("projectile.velocity", "node mass × velocity²", energy)?;
        if let Some(crossing) = &mesh.secondary {
            in_range("secondary", "A = Δt/Δm", crossing.fibre.a)?;
        }
        self.check_steps(&mesh)
    }

    fn check_memory(&self) -> Result<(), Problem> {
        let primary = memory_of_run::<2>(self.primary.elements, &self.primary.material);
        let secondary = self
            .secondary
            .as_ref()
            .map_or(0.0, |fibre| memory_of_run::<3>(fibre.elements, &fibre.material));
        let memory = primary + secondary;
        if memory <= MAX_MEMORY {
            return Ok(());
        }
        let path = if primary >= secondary { "primary.elements" } else { "secondary.elements" };
        let [needed, most] = [memory, MAX_MEMORY].map(|bytes| bytes / 1e9);
        let message = format!("a run would take {needed:.1} GB of memory, more than {most} GB");
        Err(Problem::new(path, message).help("coarsen the mesh, or shorten the fibre with it"))
    }

    fn check_crossover(
        &self,
        primary: &Properties<f64>,
        crossing: &Crossing<f64>,
    ) -> Result<(), Problem> {
        let path = "secondary.at";
        let (at, node) = (crossing.at, crossing.node);
        let (spacing, length) = (primary.spacing, self.primary.length);
        finite(path, at)?;
        if at < 0.0 {
            return Err(Problem::new(path, format!("must not be negative, is {at:?}")).help(
                "it is the distance from the impact point; the other half follows from symmetry",
            ));
        }
        if at >= length {
            return Err(Problem::new(
                path,
                format!("the crossover at {at:?} m is at or beyond the clamp at {length:?} m"),
            )
            .help("place it nearer to the impact point, or lengthen the primary fibre"));
        }
        if node == primary.elements {
            return Err(Problem::new(
                path,
                format!("the node nearest to {at:?} m is the clamp's, which cannot move"),
            )
            .help(format!("nodes are {spacing:?} m apart: move the crossover inward, or refine")));
        }
        if node == 0 && at != 0.0 {
            return Err(Problem::new(
                path,
                format!("the node nearest to {at:?} m is the impact point, 0 m"),
            )
            .help(format!("say 0 for that node, or {spacing:?} for the one after it")));
        }
        if node == 0 && !self.corrections.has(Erratum::ThetaAtOrigin) {
            return Err(Problem::new(
                path,
                "a crossover at the impact point leaves eqn (11) undefined: it needs node ix-1, \
                 and there is none before the first",
            )
            .help(format!(
                "choose the correction \"{}\", or place the crossover at {spacing:?} m or beyond",
                Erratum::ThetaAtOrigin.entry().id
            )));
        }
        Ok(())
    }

    fn check_projectile(&self) -> Result<(), Problem> {
        let (path, velocity) = ("projectile.velocity", self.projectile.velocity);
        positive(path, velocity).map_err(|problem| {
            problem.help(if velocity == 0.0 {
                "nothing would ever move: give the velocity at impact, m/s"
            } else {
                "give the speed at impact, m/s: the projectile travels along +y"
            })
        })?;
        in_range(path, "the square of the velocity", velocity * velocity)?;
        if let Some(mass) = self.projectile.mass {
            let path = "projectile.mass";
            positive(path, mass).map_err(|problem| {
                problem.help("leave it out for a projectile whose velocity stays constant")
            })?;
            in_range(path, "mass × velocity²", mass * velocity * velocity)?;
        }
        Ok(())
    }

    fn check_steps(&self, mesh: &Discretisation<f64>) -> Result<(), Problem> {
        let (duration, time_step) = (self.duration, mesh.time_step);
        let steps = mesh.steps(duration);
        if steps < 1 {
            return Err(Problem::new(
                "duration",
                format!("{duration:?} s is less than half a time step, {time_step:?} s"),
            )
            .help("no step would be taken: lengthen the duration or refine the mesh"));
        }
        if steps > MAX_STEPS {
            return Err(Problem::new(
                "duration",
                format!("{duration:?} s takes more than 2^53 steps of {time_step:?} s"),
            ));
        }
        Ok(())
    }
}

fn check_fibre(
    path: &str,
    length: f64,
    elements: usize,
    density: f64,
    area: f64,
    material: &Material,
) -> Result<(), Problem> {
    let field = |name: &str| format!("{path}.{name}");
    positive(&field("length"), length)?;
    if elements < 2 {
        return Err(Problem::new(field("elements"), format!("must be at least 2, is {elements}")));
    }
    positive(&field("density"), density)?;
    positive(&field("area"), area)?;
    check_material(&field("material"), material, Mesh { density, spacing: length })
}

/// The march builds the same law, of which the mesh is no matter here.
fn check_material(path: &str, material: &Material, mesh: Mesh) -> Result<(), Problem> {
    if let Law::Linear { modulus } = material.law {
        positive(&format!("{path}.modulus"), modulus)?;
    }
    of_scene(material, mesh, 1.0).map(|_| ()).map_err(|error| {
        let path = match error.parameter.as_str() {
            "a*b" => format!("{path}.b"),
            "linear" | "quadratic" => format!("{path}.artificial_viscosity.{}", error.parameter),
            parameter => format!("{path}.{parameter}"),
        };
        match error.fault {
            ParameterFault::NotFinite(x) => Problem::new(path, finite_wanted(x)),
            ParameterFault::NotPositive(x) if error.parameter == "a*b" => {
                Problem::new(path, format!("a times b must be greater than 0, is {x:?}"))
                    .help("a and b are of one sign: both positive harden, both negative soften")
            }
            ParameterFault::NotPositive(x) => Problem::new(path, positive_wanted(x)),
            ParameterFault::Negative(x) => {
                Problem::new(path, format!("must not be negative, is {x:?}"))
            }
            ParameterFault::OutOfRange(x) => {
                Problem::new(path, format!("{x:?} is outside the range of a double"))
            }
            ParameterFault::Empty => Problem::new(path, "must have at least one entry"),
        }
    })
}

fn check_slide_factor(slide_factor: f64) -> Result<(), Problem> {
    if (0.0..=1.0).contains(&slide_factor) {
        return Ok(());
    }
    let message = format!("must lie in 0..1, is {slide_factor:?}");
    Err(Problem::new("secondary.slide_factor", message)
        .help("1 lets nothing slide, 0 lets the fibre slide freely"))
}

fn check_properties(path: &str, fibre: &Properties<f64>) -> Result<(), Problem> {
    in_range(path, "Δx², which (5) and (6) take the root of,", fibre.spacing * fibre.spacing)?;
    in_range(path, "the wave speed c = √(modulus/density)", fibre.wave_speed)?;
    in_range(path, "the node mass Δm = density × area × Δx", fibre.mass)?;
    in_range(path, "the stiffness modulus × area", fibre.stiffness)?;
    in_range(
        path,
        "modulus × area/Δx, by which (7) makes tension of a stretch,",
        fibre.stiffness / fibre.spacing,
    )
}

/// Fails for a scene of another format.
pub(crate) fn check_format(format: &str) -> Result<(), Problem> {
    if format == FORMAT {
        return Ok(());
    }
    Err(Problem::new("format", format!("must be \"{FORMAT}\", is {format:?}")))
}

fn finite(path: &str, value: f64) -> Result<(), Problem> {
    if value.is_finite() {
        return Ok(());
    }
    Err(Problem::new(path, finite_wanted(value)))
}

fn positive(path: &str, value: f64) -> Result<(), Problem> {
    finite(path, value)?;
    if value.is_subnormal() {
        let message = format!("is {value:?}, so small that a double keeps few digits of it");
        return Err(Problem::new(path, message).help(UNITS));
    }
    if value > 0.0 {
        return Ok(());
    }
    Err(Problem::new(path, positive_wanted(value)))
}

fn finite_wanted(value: f64) -> String {
    format!("must be a finite number, is {value:?}")
}

fn positive_wanted(value: f64) -> String {
    format!("must be greater than 0, is {value:?}")
}

const UNITS: &str = "the values are too large or too small; are they in SI units?";

/// A derived quantity that overflows or underflows would spoil the run without a trace.
fn in_range(path: &str, quantity: &str, value: f64) -> Result<(), Problem> {
    if SAFE.contains(&value) {
        return Ok(());
    }
    let (least, most) = (SAFE.start(), SAFE.end());
    let message = format!("{quantity} is {value:?}, not within {least:e} to {most:e}");
    Err(Problem::new(path, message).help(UNITS))
}
