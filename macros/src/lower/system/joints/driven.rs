//! Joints whose motion is prescribed: `.driven(speed * t)`.

use proc_macro2::Ident;

use crate::errors::{Errors, Extent, silently};
use crate::model::{Coordinate, Dimension, JointKind, Meaning, Rates, Variable, shown};
use crate::symbolic::{Graph, Id};
use crate::syntax::Expression;

use crate::lower::expressions::written_unit;
use crate::lower::system::reading::names::moving_locals;
use crate::lower::system::reading::reader::Reader;

/// The coordinates of a joint, with the variables of their rates and accelerations.
pub fn coordinates(kind: &JointKind) -> Vec<(&'static str, [Variable; 3], usize)> {
    let fields = kind.shape.into_iter().flat_map(|shape| shape.fields);
    let fields = fields.filter_map(|field| {
        let variables = match field.variable {
            Variable::Position => [
                Variable::Position,
                Variable::Velocity,
                Variable::LinearAcceleration,
            ],
            Variable::Angle => [
                Variable::Angle,
                Variable::AngularVelocity,
                Variable::AngularAcceleration,
            ],
            _ => return None,
        };
        Some((field, variables))
    });
    fields
        .flat_map(|(field, variables)| {
            let names = field.names.iter().enumerate();
            names.map(move |(part, name)| (*name, variables, field.first + part))
        })
        .collect()
}

/// Whether the coordinates of a joint are numbers, each with a rate.
fn has_numbers(kind: &JointKind) -> bool {
    let fields = kind.shape.into_iter().flat_map(|shape| shape.fields);
    let mut turning = fields.filter(|field| field.variable == Variable::Quaternion);
    turning.next().is_none() && !coordinates(kind).is_empty() && !kind.is_free()
}

impl Reader<'_> {
    /// `.driven(f)`: the coordinates as functions of time, with their rates and accelerations. The
    /// inner `None` means that it is not written.
    #[allow(clippy::option_option, reason = "outer: reported; inner: not written")]
    pub fn driven(
        &mut self,
        kind: &JointKind,
        methods: &[(&Ident, &[Expression])],
        errors: &mut Errors,
    ) -> Option<Option<Rates>> {
        let mut written = methods.iter().filter(|(method, _)| *method == "driven");
        let Some((word, functions)) = written.next() else {
            return Some(None);
        };
        if let Some((again, _)) = written.next() {
            errors.push(again.span(), "`.driven(..)` is written twice");
            return None;
        }
        let all = coordinates(kind);
        if !has_numbers(kind) {
            let message = format!("`{}` has no scalar coordinates to prescribe", kind.word);
            errors.push(word.span(), message);
            return None;
        }
        let names: Vec<&str> = all.iter().map(|(name, ..)| *name).collect();
        if functions.len() != all.len() {
            errors.push(
                word.span(),
                format!(
                    "`.driven(..)` gives the coordinates as functions of time: `{}`",
                    names.join("`, `")
                ),
            );
            return None;
        }
        let mut list = Some(Vec::new());
        let form = format!("`.driven({})`", names.join(", "));
        for (function, (name, variables, part)) in functions.iter().zip(all) {
            let dimension = match variables[0] {
                Variable::Position => Dimension::LENGTH,
                _ => Dimension::NONE,
            };
            let what = match names.len() {
                1 => "the coordinate of a driven joint".to_owned(),
                _ => format!("`{name}` in {form}"),
            };
            let motion = self.prescribed(function, (dimension, &what), errors);
            match (motion, &mut list) {
                (Some(motion), Some(list)) => {
                    let both = variables.into_iter().zip(motion);
                    list.extend(both.map(|(variable, id)| Coordinate { variable, part, id }));
                }
                _ => list = None,
            }
        }
        Some(Some(Rates(list?)))
    }

    /// A function of time, its rate and its acceleration.
    fn prescribed(
        &mut self,
        written: &Expression,
        (dimension, what): (Dimension, &str),
        errors: &mut Errors,
    ) -> Option<[Id; 3]> {
        let value = self.at_top(errors, |lowering| lowering.scalar(written, dimension, what))?;
        let rate = self.rate(value, (value, written), errors)?;
        let acceleration = self.rate(rate, (value, written), errors)?;
        self.check_jumps([value, rate], (written, what), errors)?;
        Some([value, rate, acceleration])
    }

    /// Reports a value, or a rate, that jumps at a number of seconds after zero, where most motions
    /// begin.
    fn check_jumps(
        &mut self,
        motion: [Id; 2],
        (written, what): (&Expression, &str),
        errors: &mut Errors,
    ) -> Option<()> {
        let graph = &mut self.work.graph;
        for jump in graph.jumps(&motion, self.time) {
            for (which, [before, after]) in ["", "the rate of "].into_iter().zip(jump.sides) {
                let by = graph.subtract(after, before);
                if !is_certain(graph, [before, after], by) {
                    continue;
                }
                let at = shown(&jump.at);
                let by = graph.as_number(by).map(shown);
                let by = by.map_or(String::new(), |by| format!(" by {by}"));
                let message = format!(
                    "{which}{what} jumps{by} at t = {at} s, and the equations describe no shock: let the rate be \
                     continuous, as in `0.5 * a * (t - 1[s]).max(0).powi(2)` or a `cubic` table"
                );
                errors.push(written.extent, message);
                return None;
            }
        }
        Some(())
    }

    /// The rate of a function of time, of inputs with given rates, and of user-defined states.
    /// `written` is the value and the text of that function in the description.
    fn rate(
        &mut self,
        function: Id,
        written: (Id, &Expression),
        errors: &mut Errors,
    ) -> Option<Id> {
        let symbols = self.at_top(errors, |lowering| lowering.late_symbols(&[function]));
        let mut terms = Vec::new();
        for symbol in symbols {
            let rate = match self.work.meaning(symbol) {
                Some(Meaning::Time) => Some(self.work.graph.one()),
                Some(Meaning::Input(input, part)) if self.derivatives[input] > 0 => {
                    self.work.symbol_of(Meaning::Input(input + 1, part))
                }
                Some(Meaning::Own(_)) => Some(self.rate_of_state(symbol, written, errors)?),
                _ => None,
            };
            let Some(rate) = rate else {
                self.report_held(symbol, written, errors);
                return None;
            };
            let slope = self.work.graph.derivative(&[function], symbol)[0];
            terms.push(self.work.graph.multiply(slope, rate));
        }
        Some(self.work.graph.sum(&terms))
    }

    /// The rate of a state. It must be known before the bodies move.
    fn rate_of_state(
        &mut self,
        symbol: Id,
        (value, written): (Id, &Expression),
        errors: &mut Errors,
    ) -> Option<Id> {
        let top = &self.system.top;
        let moving = moving_locals(self.system);
        let (name, rate) = self.at_top(errors, |lowering| lowering.state_of(top, symbol))?;
        let names = rate.value.iter().flat_map(Expression::names);
        let follows = names
            .into_iter()
            .find(|name| moving.contains(&name.to_string()));
        if let Some(follows) = follows {
            let place = self.place_of_states(value, written, errors);
            let message = format!(
                "the motion of a driven joint is known before the bodies move, and `{name}` follows from `{follows}`: \
                 leave out `.driven(..)`, and let a drive move the joint"
            );
            errors.push(place, message);
            return None;
        }
        // errors in it are reported with those of the other rates
        silently(|errors| self.at_top(errors, |lowering| lowering.rate_of(top, symbol)))
    }

    /// Reports an input whose rate is not given, in the motion of a joint or in the rate of a state
    /// there.
    fn report_held(
        &mut self,
        symbol: Id,
        (value, written): (Id, &Expression),
        errors: &mut Errors,
    ) {
        let is_direct = self.work.graph.depends_on(&[value], |id| id == symbol);
        if is_direct {
            let place = self.at_top(errors, |lowering| {
                lowering.dependent_name(written, &[symbol], &[])
            });
            let input = match self.work.meaning(symbol) {
                Some(Meaning::Input(input, _)) => self.system.top.inputs.get(input),
                _ => None,
            };
            let form = input.map_or("crank[rad]".to_owned(), |input| match &input.unit {
                Some(unit) => format!("{}[{}]", input.name, written_unit(unit)),
                None => input.name.to_string(),
            });
            let message = format!(
                "the motion of a driven joint needs its rate and its acceleration: write a function of `t`, or \
                 declare an input with both, `{form}.moving`"
            );
            errors.push(place, message);
            return;
        }
        let place = self.place_of_states(value, written, errors);
        let message = "the motion of a driven joint needs its rate and its acceleration, and this state follows an \
                       input at once: let its rate be a state too, as `rates: [angle = speed, speed = (command - \
                       speed) / lag]`, or declare the input as `.moving`";
        errors.push(place, message);
    }

    /// The first name in the motion of a joint that depends on user-defined states.
    fn place_of_states(&mut self, value: Id, written: &Expression, errors: &mut Errors) -> Extent {
        self.at_top(errors, |lowering| {
            let own = lowering.own_states(&[value]);
            lowering.dependent_name(written, &own, &[])
        })
    }
}

/// Whether a jump is a number that no rounding of constants explains, or a product of parameters,
/// such as a speed. Anything else may be zero for the parameters that are meant.
fn is_certain(graph: &Graph, sides: [Id; 2], by: Id) -> bool {
    match graph.as_number(by) {
        Some(by) => {
            let sizes = sides.iter().filter_map(|side| graph.as_number(*side));
            let size = sizes.fold(0.0, |size, side| size + side.to_f64().abs());
            by.to_f64().abs() > 1e-6 * size
        }
        None => graph.is_early(by) && graph.is_product(by),
    }
}
