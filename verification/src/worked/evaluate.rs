//! Working out the lines of an equation, by an evaluator that shares nothing with the scheme.

use std::collections::BTreeMap;

use crossfibre::equations::Line;
use exmex::{BinOp, ExResult, Express, FlatEx, FloatOpsFactory, MakeOperators, Operator};

/// A number or a vector, in components x, y, z.
#[derive(Clone, Debug, PartialEq)]
pub enum Quantity {
    Scalar(f64),
    Vector(Vec<f64>),
}

/// What symbols stand for.
pub type Known = BTreeMap<&'static str, Quantity>;

/// One number worked out: for a vector line there is one for each component.
#[derive(Debug, PartialEq)]
pub struct Step {
    /// The name of the line, with the component for a vector.
    pub name: String,
    /// The expression with its numbers put in.
    pub numbers: String,
    /// What it gives.
    pub value: f64,
}

/// The axes of a vector's components.
pub const AXES: [&str; 3] = ["x", "y", "z"];

/// Works out a line; what it gives is then known.
pub fn work_out(line: &Line, known: &mut Known) -> ExResult<Vec<Step>> {
    let written_out = lengths_written_out(line.expression, known);
    let names: Vec<_> = names(line.expression).collect();
    let is_length = written_out != line.expression;
    let components = names.iter().filter_map(|name| match known.get(name) {
        Some(Quantity::Vector(v)) if !is_length => Some(v.len()),
        _ => None,
    });
    let Some(components) = components.max() else {
        let value = evaluate(&written_out, |name| component_of(known, name))?;
        let numbers = put_in(&written_out, |name| component_of(known, name));
        known.insert(line.name, Quantity::Scalar(value));
        return Ok(vec![Step { name: line.name.into(), numbers, value }]);
    };
    let steps: Vec<_> = AXES[..components]
        .iter()
        .enumerate()
        .map(|(k, axis)| {
            let of = |name: &str| component(known.get(name), k);
            Ok(Step {
                name: format!("{}_{axis}", line.name),
                numbers: put_in(line.expression, of),
                value: evaluate(line.expression, of)?,
            })
        })
        .collect::<ExResult<_>>()?;
    known.insert(line.name, Quantity::Vector(steps.iter().map(|step| step.value).collect()));
    Ok(steps)
}

/// `|{d}|` as the root of the sum of squares of d's components.
fn lengths_written_out(expression: &str, known: &Known) -> String {
    let Some((before, rest)) = expression.split_once("|{") else {
        return expression.into();
    };
    let Some((name, after)) = rest.split_once("}|") else {
        return expression.into();
    };
    let Some(Quantity::Vector(v)) = known.get(name) else {
        return expression.into();
    };
    let squares: Vec<_> = AXES[..v.len()]
        .iter()
        .map(|axis| format!("{{{name}_{axis}}} * {{{name}_{axis}}}"))
        .collect();
    format!("{before}sqrt({}){after}", squares.join(" + "))
}

/// The names in braces, in order.
fn names(expression: &str) -> impl Iterator<Item = &str> {
    expression.split('{').skip(1).filter_map(|part| part.split('}').next())
}

/// A component of a vector, or a number that holds for all.
fn component(quantity: Option<&Quantity>, k: usize) -> f64 {
    match quantity {
        Some(Quantity::Scalar(x)) => *x,
        Some(Quantity::Vector(v)) => v[k],
        None => f64::NAN,
    }
}

/// A number by its name, which may name a component: `d_x`.
fn component_of(known: &Known, name: &str) -> f64 {
    if let Some(Quantity::Scalar(x)) = known.get(name) {
        return *x;
    }
    let parts = name.rsplit_once('_');
    let k = parts.and_then(|(_, axis)| AXES.iter().position(|a| *a == axis));
    match (parts, k) {
        (Some((vector, _)), Some(k)) => component(known.get(vector), k),
        _ => f64::NAN,
    }
}

/// The expression with numbers in place of names.
fn put_in(expression: &str, of: impl Fn(&str) -> f64) -> String {
    names(expression).fold(expression.to_owned(), |text, name| {
        let x = of(name);
        let number = if x.is_sign_negative() { format!("({x:?})") } else { format!("{x:?}") };
        text.replacen(&format!("{{{name}}}"), &number, 1)
    })
}

fn evaluate(expression: &str, of: impl Fn(&str) -> f64) -> ExResult<f64> {
    let expression = FlatEx::<f64, LeftToRight>::parse_wo_compile(expression)?;
    let values: Vec<_> = expression.var_names().iter().map(|name| of(name)).collect();
    expression.eval(&values)
}

/// The evaluator's operators in the order of the equations: × and ÷ before + and −, and each pair
/// from left to right. Its own order divides before it multiplies and subtracts before it adds,
/// which rounds differently.
#[derive(Clone, Debug)]
struct LeftToRight;

impl MakeOperators<f64> for LeftToRight {
    fn make<'a>() -> Vec<Operator<'a, f64>> {
        let binary = |apply, prio| BinOp { apply, prio, is_commutative: false };
        let functions = FloatOpsFactory::<f64>::make().into_iter().filter(|op| !op.has_bin());
        let mut operators: Vec<_> = functions.collect();
        operators.push(Operator::make_bin_unary("+", binary(|a, b| a + b, 0), |a| a));
        operators.push(Operator::make_bin_unary("-", binary(|a, b| a - b, 0), |a| -a));
        operators.push(Operator::make_bin("*", binary(|a, b| a * b, 1)));
        operators.push(Operator::make_bin("/", binary(|a, b| a / b, 1)));
        operators
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crossfibre::equations::line;

    fn worked(line: &Line, known: &[(&'static str, Quantity)]) -> Vec<Step> {
        work_out(line, &mut known.iter().cloned().collect()).unwrap()
    }

    /// The values are chosen so that another order gives another last bit, and that is asserted:
    /// the same operations in the order of the text must give the same bits.
    #[test]
    fn operations_go_from_left_to_right() {
        use Quantity::Scalar;
        let (a, b, c) = (0.1, 0.7, 0.3);
        let known = [("a", Scalar(a)), ("b", Scalar(b)), ("c", Scalar(c))];
        let value = |expression| worked(&line("y", expression), &known)[0].value;
        assert_eq!(value("{a} * {b} / {c}"), a * b / c);
        assert_ne!(a * b / c, a * (b / c));
        assert_eq!(value("{a} + {b} - {c}"), a + b - c);
        assert_ne!(a + b - c, a + (b - c));
        assert_eq!(value("{a} - {b} * {c} + {b}"), a - b * c + b);
        assert_eq!(value("-{a} * ({b} - {c})"), -a * (b - c));
        assert_eq!(value("sqrt({a}) + 2 * {b}"), a.sqrt() + 2.0 * b);
    }

    #[test]
    fn a_line_of_vectors_is_worked_out_for_each_component() {
        let known = [
            ("x_ahead", Quantity::Vector(vec![0.3, -0.4, 1.7])),
            ("x_here", Quantity::Vector(vec![0.1, 0.2, 1.1])),
            ("dt", Quantity::Scalar(0.5)),
        ];
        let steps = worked(&line("d", "{x_ahead} - {x_here} * {dt}"), &known);
        assert_eq!(steps[1].name, "d_y");
        assert_eq!(steps[1].numbers, "(-0.4) - 0.2 * 0.5");
        assert_eq!(steps.iter().map(|s| s.value).collect::<Vec<_>>(), [0.25, -0.5, 1.15]);
    }

    #[test]
    fn bars_are_the_length_of_a_vector() {
        let known = [("d", Quantity::Vector(vec![-0.3, 0.4]))];
        let steps = worked(&line("L", "|{d}|"), &known);
        assert_eq!(steps[0].numbers, "sqrt((-0.3) * (-0.3) + 0.4 * 0.4)");
        // 0.09 + 0.16 rounds to 0.25 exactly.
        assert_eq!((steps[0].name.as_str(), steps[0].value), ("L", 0.5));
    }
}
