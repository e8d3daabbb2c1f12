//! Names: those that a description defines, and those built into every description.

use proc_macro2::Ident;

use crate::errors::{declaration_meant, function_meant, hint, name_meant, similar, unit_of};
use crate::model::{Attitude, Dimension, Frame, Meaning, Point, Variable, Vector};
use crate::symbolic::{Components, Number, Stage};
use crate::syntax::{Expression, key_meant};
use crate::units::is_unit;

use super::along_axis::UNTURNED;
use super::lowering::Lowering;
use super::scope::Value;
use super::scope::{BUILT_IN, FOLLOWED};
use super::written::short;

/// The error for `ground` used as a point.
const POINT_OF_GROUND: &str = "a point of the ground is written by its coordinates: `world(..)`";

impl Lowering<'_> {
    /// The value of a name. If it is unknown, the error says how to declare one of this dimension.
    pub fn name(&mut self, name: &Ident, expected: Dimension) -> Option<Value> {
        let word = name.to_string();
        if let Some(value) = self.scope.look_up(&word) {
            return value;
        }
        self.check_has_body(name)?;
        let graph = &mut self.work.graph;
        match word.as_str() {
            "t" => Some(Value::Scalar(self.state.time, Dimension::TIME)),
            "PI" => Some(Value::Scalar(graph.number(Number::pi()), Dimension::ANY)),
            "TAU" => Some(Value::Scalar(
                graph.number(Number::pi() * Number::integer(2)),
                Dimension::ANY,
            )),
            "G" => Some(Value::Point(self.state.mass_center(self.work))),
            "position" | "velocity" | "acceleration" => self.motion_of_center(name),
            "axis" | "axis_rate" if self.motion.is_line() => {
                let axis = self.state.axis?;
                let (components, dimension) = if word == "axis" {
                    (axis.unit, Dimension::NONE)
                } else {
                    (axis.rate, Dimension::FREQUENCY)
                };
                let vector = self.work.vector(Frame::WORLD, components);
                Some(Value::Vector(vector, dimension))
            }
            "attitude" if self.motion.is_line() => self.report(
                name.span(),
                format!("{UNTURNED}: write `axis`, the unit vector along it"),
            ),
            "attitude" if !self.motion.has_attitude() => self.absent(name, "attitude"),
            "attitude" => match self.work.attitude(self.state.body) {
                Attitude::Axis { angle, .. } => Some(Value::Scalar(angle, Dimension::NONE)),
                Attitude::Fixed => {
                    self.work.met_still = true;
                    Some(Value::Attitude)
                }
                _ => Some(Value::Attitude),
            },
            "angular_velocity" | "angular_acceleration" if !self.motion.has_attitude() => {
                self.absent(name, &word.replace('_', " "))
            }
            "angular_velocity" => {
                let w = self.state.angular_velocity;
                Some(self.turning(w, Dimension::FREQUENCY))
            }
            "angular_acceleration" => {
                let rate = self.state.angular_acceleration;
                Some(self.turning(rate, Dimension::ANGULAR_ACCELERATION))
            }
            _ => self.unknown_name(name, expected),
        }
    }

    /// Outside the bodies of a system, the quantities of a body need its name in front. Reports one
    /// without.
    pub fn check_has_body(&mut self, name: &Ident) -> Option<()> {
        let word = name.to_string();
        let is_built_in = [&BUILT_IN[..], &FOLLOWED].concat().contains(&word.as_str());
        let of_body = is_built_in && !["t", "world", "PI", "TAU"].contains(&word.as_str());
        if !self.is_whole || !of_body {
            return Some(());
        }
        let body = self.members.declared.first();
        let body = body.map_or("arm", String::as_str);
        let call = if word == "body" { "(..)" } else { "" };
        let message = match self.members.with_joint(&word) {
            Some(of_joint) => {
                format!("of which body or joint? write for example `{body}.{word}` or `{of_joint}`")
            }
            None => format!("of which body? write for example `{body}.{word}{call}`"),
        };
        self.report(name.span(), message)
    }

    /// Reports a name that has no value, or none here.
    fn unknown_name(&mut self, name: &Ident, expected: Dimension) -> Option<Value> {
        let word = name.to_string();
        let message = match word.as_str() {
            "mass" => "this body has no mass: write `mass: ..`".to_owned(),
            keyword if keyword.starts_with("r#") => return self.errors.undefined(name, ""),
            "ground" if !self.members.bodies.is_empty() => POINT_OF_GROUND.to_owned(),
            key if key_meant(key) == Some(key) => {
                format!(
                    "`{key}` is a key and no name: a value that is used twice belongs in `params`"
                )
            }
            _ if self.scope.constraint(&word).is_some() => {
                format!("`{word}` is a constraint: write its gradient, `{word}.gradient()`")
            }
            "body" | "world" => {
                format!("`{word}` makes a vector: write `{word}(..)` with components")
            }
            _ if self.reactions.contains(&word) && self.is_constrained => format!(
                "`{word}` is an unknown reaction, and only given loads can depend on it: write \
                 this out in the load"
            ),
            _ if self.reactions.contains(&word) => format!(
                "`{word}` is an unknown reaction, and only given loads of a body with `constraints` \
                 can depend on one"
            ),
            _ if self.members.declared.contains(&word) || self.members.late.contains(&word) => {
                format!(
                    "this is fixed, and `{word}` moves: it cannot depend on how the system moves"
                )
            }
            _ => {
                let of_body = self.members.with_body(&word).filter(|_| self.is_whole);
                let of_joint = self
                    .members
                    .coordinate_meant(&word)
                    .filter(|_| self.is_whole);
                match (of_body, of_joint) {
                    (Some(named), _) => format!("of which body? write for example `{named}`"),
                    (_, Some(named)) => format!("of which joint? write for example `{named}`"),
                    _ => {
                        let advice = self.advice(&word, expected);
                        if !advice.contains("did you mean") {
                            return self.errors.undefined(name, &advice);
                        }
                        format!("nothing here is called `{word}`{advice}")
                    }
                }
            }
        };
        self.report(name.span(), message)
    }

    /// What to write instead of a call of a name that has another meaning. The outer `None` stands
    /// for a reported error.
    #[allow(clippy::option_option, reason = "outer: reported; inner: no such name")]
    fn not_called(&mut self, name: &Ident, arguments: &[Expression]) -> Option<Option<String>> {
        let word = name.to_string();
        if self.members.body(&word).is_some() {
            return Some(Some(format!(
                "`{word}` is a body: a vector in its axes is `{word}.body(..)`"
            )));
        }
        let is_built_in = BUILT_IN.contains(&&*word) || FOLLOWED.contains(&&*word);
        if !is_built_in && !self.scope.knows(&word) && !self.members.has(&word) {
            return Some(None);
        }
        self.check_has_body(name)?;
        let is_of_point = ["position", "velocity", "acceleration"].contains(&&*word);
        Some(Some(match arguments {
            [] => format!("`{word}` is no function: write it without parentheses"),
            [point] if is_of_point => {
                let point = short(point).unwrap_or_else(|| "P".to_owned());
                format!("`{word}` is a method of points: write `{point}.{word}()`")
            }
            _ => format!(
                "`{word}` is no function: a product is written with `*`, as in `{word} * (..)`"
            ),
        }))
    }

    /// Reports a call of something that is no function.
    pub fn unknown_function(
        &mut self,
        function: &Ident,
        arguments: &[Expression],
    ) -> Option<Value> {
        self.visit(arguments);
        let word = function.to_string();
        if word == "ground" && self.members.is_system() {
            return self.report(function.span(), POINT_OF_GROUND);
        }
        if let Some(message) = self.not_called(function, arguments)? {
            return self.report(function.span(), message);
        }
        let functions = self.work.functions.iter();
        let own: Vec<String> = functions.map(|one| one.name.to_string()).collect();
        let known = own
            .iter()
            .map(String::as_str)
            .chain(["body", "world", "table"]);
        let mut advice = hint(&word, known);
        if let Some(meant) = function_meant(&word) {
            advice = format!("; did you mean `x.{meant}(..)`?");
        } else if advice.is_empty() {
            let form = format!("functions: [{word}(x[m]) = {word}[N]]");
            advice = format!("; a function of Rust is declared with its units, as in `{form}`");
        }
        let message = format!("there is no function `{word}` here{advice}");
        self.report(function.span(), message)
    }

    /// What was probably meant by an unknown name.
    fn advice(&self, word: &str, expected: Dimension) -> String {
        let known = self.scope.known().filter(|known| self.has_quantity(known));
        let mut hint = self.members.hint(word, known);
        if let (Some(meant), Some(body)) = (name_meant(word), self.members.declared.first())
            && self.is_whole
            && BUILT_IN.contains(&meant)
            && meant != "t"
        {
            hint = format!("; write for example `{body}.{meant}`");
        }
        let is_similar = |known| is_constant(known) && similar(word, [known]).is_some();
        let is_meant = |known| similar(word, [known]).is_some();
        if let Some(quantity) = self.quantity(word)
            && !self.scope.own().any(is_meant)
        {
            return format!("; write `{quantity}`");
        }
        if hint.is_empty() && (is_letter(word) || declaration_meant(word).is_some()) {
            return format!("; declare it, as in `{}`", declaration(word, expected));
        }
        if is_unit(word) && hint.is_empty() {
            format!("; a unit goes in brackets, as in `2[{word}]`")
        } else if is_constant(word) && !self.scope.known().any(is_similar) {
            self.of_rust(word)
        } else {
            hint
        }
    }

    /// Whether this motion has the quantity of a built-in name.
    fn has_quantity(&self, name: &str) -> bool {
        match name {
            "attitude" | "angular_velocity" | "angular_acceleration" => self.motion.has_attitude(),
            "position" | "velocity" | "acceleration" => self.motion.knows_position(),
            "mass" => self.scope.peek(name).is_some(),
            _ => true,
        }
    }

    /// The quantity of the motion of G that a word means.
    fn quantity(&self, word: &str) -> Option<String> {
        let (axis, up) = if self.motion.is_planar {
            ("xy", "y")
        } else {
            ("xyz", "z")
        };
        let quantity = match word {
            "altitude" | "height" => format!("position.in_world().{up}"),
            "speed" => "velocity.norm()".to_owned(),
            _ if word.len() == 1 && axis.contains(word) => format!("position.in_world().{word}"),
            _ => return None,
        };
        let body = self.members.declared.first().filter(|_| self.is_whole);
        let body = body.map_or(String::new(), |body| format!("{body}."));
        self.motion
            .knows_position()
            .then(|| format!("{body}{quantity}"))
    }

    /// For messages: how a name in capitals can be declared.
    fn of_rust(&self, word: &str) -> String {
        let mut name = word.to_lowercase();
        if self.scope.known().any(|known| known == name) {
            name.push_str("_given");
        }
        let unit = unit_of(&word.to_lowercase()).unwrap_or("m");
        let form = format!("constants: [{name} = {word}[{unit}]]");
        format!("; a constant of Rust is declared with its unit, as in `{form}`")
    }

    fn absent(&mut self, name: &Ident, what: &str) -> Option<Value> {
        self.report(
            name.span(),
            format!("under `motion: {}` a body has no {what}", self.motion.word),
        )
    }

    fn motion_of_center(&mut self, name: &Ident) -> Option<Value> {
        if !self.motion.knows_position() {
            return self.report(
                name.span(),
                format!(
                    "`{name}` is not known under `motion: rotation`: the motion of G is not \
                     modeled"
                ),
            );
        }
        self.check_support_is_read(name)?;
        Some(match name.to_string().as_str() {
            "position" => Value::Vector(self.state.position, Dimension::LENGTH),
            "velocity" => Value::Vector(self.state.velocity, Dimension::VELOCITY),
            _ => Value::Vector(self.acceleration_of_center(), Dimension::ACCELERATION),
        })
    }

    /// An angular quantity: a vector in space, a scalar in the plane.
    fn turning(&mut self, components: Components, dimension: Dimension) -> Value {
        if self.motion.is_planar {
            return Value::Scalar(components[2], dimension);
        }
        Value::Vector(self.work.vector(self.state.axes, components), dimension)
    }

    /// The acceleration of G, as symbols. For a body that moves and rotates freely, they are
    /// components in body axes: there, the factors of loads that depend on the acceleration are
    /// known early.
    fn acceleration_of_center(&mut self) -> Vector {
        let (motion, body) = (self.motion, self.state.body);
        let turns = motion.has_attitude() && !motion.is_line();
        // in systems and under constraints, it is solved for together with all other unknowns, in
        // world axes
        if !motion.translates() || !turns || self.is_constrained {
            return self.state.acceleration;
        }
        let mut symbols = self.work.graph.zeros();
        for axis in motion.linear_axes() {
            let meaning = Meaning::Of(body, Variable::AccelerationInBody, axis);
            let known = self.work.symbol_of(meaning);
            symbols[axis] = known.unwrap_or_else(|| self.work.symbol(Stage::State, meaning));
        }
        self.work.vector(body, symbols)
    }

    /// The acceleration of the material point of the body at a point.
    pub fn acceleration_of(&mut self, point: Point) -> Vector {
        let offset = match point {
            Point::Fixed(body, offset) => self.work.fixed_in(body, offset),
            Point::Moving(offset) => offset,
        };
        let turning = (self.state.angular_velocity, self.state.angular_acceleration);
        let thrown = self.thrown(offset, turning, self.state.axes);
        let of_center = self.acceleration_of_center();
        self.work.add(of_center, thrown)
    }

    /// `w' x r + w x (w x r)`, with w and w' in these axes.
    pub fn thrown(
        &mut self,
        offset: Vector,
        (w, rate): (Components, Components),
        axes: Frame,
    ) -> Vector {
        let driven = self.swept(offset, rate, axes);
        let swept = self.swept(offset, w, axes);
        let drawn = self.swept(swept, w, axes);
        self.work.add(driven, drawn)
    }

    /// Reports quantities of the motion in the definition of a support, which comes before the
    /// motion.
    pub fn check_support_is_read(&mut self, place: &Ident) -> Option<()> {
        if self.motion.is_supported() && self.state.support.is_none() {
            return self.report(
                place.span(),
                "a support is fixed: it cannot depend on the motion of the body",
            );
        }
        Some(())
    }
}

/// Whether a name is one letter, as of a symbol of a textbook. A small one may be a unit.
fn is_letter(word: &str) -> bool {
    let is_unit = is_unit(word) && !word.chars().all(char::is_uppercase);
    word.len() == 1 && word.chars().all(char::is_alphabetic) && !is_unit
}

/// The declaration of an unknown name: in the unit that is expected, if it is known, or else in
/// that of what the name says.
fn declaration(word: &str, expected: Dimension) -> String {
    let meant = declaration_meant(word);
    let is_input = meant
        .as_ref()
        .is_some_and(|meant| meant.starts_with("inputs"));
    match meant {
        _ if expected == Dimension::NONE => format!("params: [{word} = 1]"),
        _ if expected.is_known() && is_input => format!("inputs: [{word}{}]", expected.unit()),
        _ if expected.is_known() => format!("params: [{word} = 1{}]", expected.unit()),
        Some(meant) => meant,
        None => format!("params: [{word}]"),
    }
}

/// Whether a name looks like that of a constant of Rust.
fn is_constant(word: &str) -> bool {
    word.len() > 1 && word.chars().all(|letter| !letter.is_lowercase())
}
