//! Parameters and inputs: their symbols, shapes, dimensions and defaults.

use crate::lower::expressions::{
    Lowering, UNTURNED, Value, dimension, has_placeholder, in_radians, lower_unit, strip_unit,
    written_unit,
};
use crate::model::{Declared, Defaults, Dimension, FrameWord, Meaning, Point, Unit};
use crate::symbolic::{Id, Number, Stage};
use crate::syntax::{Declaration, Expression, Kind};

impl Lowering<'_> {
    /// A parameter: `arm`, `arm[m]`, `arm = 0.2[m]`, `tip = body(0.1, 0, 0)[m]`.
    pub fn param(
        &mut self,
        index: usize,
        written: &Declaration,
        declared: &mut Declared,
        defaults: &mut Defaults,
    ) -> Option<Value> {
        let scalar = Meaning::Param(index, None);
        let Some(value) = &written.value else {
            self.declared_unit(written, declared)?;
            let symbol = self.work.symbol(Stage::Parameter, scalar);
            return Some(Value::Scalar(symbol, declared.dimension));
        };
        let value = value.as_ref()?;
        self.check_axes(declared.frame, value)?;
        if has_placeholder(value) {
            return self.open_vector(value, declared, Stage::Parameter, |axis| {
                Meaning::Param(index, Some(axis))
            });
        }
        let default = self.default_value(value, declared.frame)?;
        let Some(found) = dimension(default) else {
            let kind = default.kind();
            return self.report(
                value.extent,
                format!("a default is a scalar or a vector, and this is {kind}"),
            );
        };
        declared.dimension = found;
        declared.unit = self.unit_of_default(value);
        if let Value::Scalar(id, _) = default {
            declared.default = Some(vec![self.constant(id, value)?]);
            let symbol = self.work.symbol(Stage::Parameter, scalar);
            defaults.insert(symbol, id);
            return Some(Value::Scalar(symbol, declared.dimension));
        }
        let Some(frame) = declared.frame.map(|word| self.state.frame(word)) else {
            return self.report(
                value.extent,
                "write a vector parameter with its components: `body(..)` or `world(..)`",
            );
        };
        let vector = self.as_vector(default)?;
        let components = self.work.part(vector, frame);
        let axes = self.motion.axes();
        let numbers: Option<Vec<Number>> = components[..axes]
            .iter()
            .map(|id| self.constant(*id, value))
            .collect();
        declared.default = Some(numbers?);
        let symbols = self.work.symbols(Stage::Parameter, 0..axes, |axis| {
            Meaning::Param(index, Some(axis))
        });
        defaults.extend(symbols.into_iter().zip(components));
        let vector = self.work.vector(frame, symbols);
        Some(Value::Vector(vector, declared.dimension))
    }

    /// The components of a written default, for a vector in these axes.
    fn default_value(&mut self, value: &Expression, frame: Option<FrameWord>) -> Option<Value> {
        let mut names = value.names().into_iter();
        if let Some(open) = names.find(|name| self.scope.is_open(&name.to_string())) {
            return self.report(
                open.span(),
                format!(
                    "a default is a constant, and `{open}` is not: write what follows from other \
                     names as a local"
                ),
            );
        }
        if frame.is_none() || !matches!(strip_unit(value).kind, Kind::Tuple(_)) {
            return self.value(value);
        }
        let Point::Fixed(frame, components) = self.point(value)? else {
            return None;
        };
        Some(Value::Components(frame, components, Dimension::LENGTH))
    }

    /// An input: `thrust`, `thrust[N]`, `wind = world(_, _, _)[m / s]`.
    pub fn input(
        &mut self,
        index: usize,
        written: &Declaration,
        declared: &mut Declared,
    ) -> Option<Value> {
        let Some(value) = &written.value else {
            self.declared_unit(written, declared)?;
            self.differentiate(written, declared)?;
            let symbol = self.work.symbol(Stage::State, Meaning::Input(index, None));
            return Some(Value::Scalar(symbol, declared.dimension));
        };
        let value = value.as_ref()?;
        self.check_axes(declared.frame, value)?;
        if !has_placeholder(value) {
            let name = &written.name;
            return self.report(
                value.extent,
                format!(
                    "an input is given at each evaluation and has no value here: write \
                     `{name}[unit]`, or make it a param"
                ),
            );
        }
        let vector = self.open_vector(value, declared, Stage::State, |axis| {
            Meaning::Input(index, Some(axis))
        })?;
        self.differentiate(written, declared)?;
        match vector {
            Value::Vector(vector, _) => Some(Value::Vector(vector, declared.dimension)),
            other => Some(other),
        }
    }

    /// Differentiates the unit of a moving quantity, for its rate or its acceleration.
    fn differentiate(&mut self, written: &Declaration, declared: &mut Declared) -> Option<()> {
        for _ in 0..written.order {
            let Some(rate) = declared.dimension.over(Dimension::TIME) else {
                let name = &written.name;
                return self.report(
                    name.span(),
                    format!("the unit of `{name}` has powers beyond measure"),
                );
            };
            declared.dimension = rate;
            declared.unit = declared.unit.take().and_then(Unit::per_second);
        }
        Some(())
    }

    /// Reports vectors in body axes that are given from outside. For a rod, the vector would have
    /// to be along the axis; for a system, the body is missing.
    fn check_axes(&mut self, frame: Option<FrameWord>, value: &Expression) -> Option<()> {
        if frame == Some(FrameWord::Body)
            && self.is_whole
            && let Kind::Call(word, _) = &strip_unit(value).kind
        {
            let message = "in the axes of which body? what is given to a system is a scalar, or a vector in \
                           world axes, `world(_, _, _)`: build it of scalars in the braces of the body, as \
                           `body(x, y, z)`";
            return self.report(word.span(), message);
        }
        if frame == Some(FrameWord::Body) && self.motion.is_line() {
            return self.report(
                value.extent,
                format!(
                    "{UNTURNED}: what is given from outside is a scalar, for a multiple of `axis`, or a \
                     vector in world axes"
                ),
            );
        }
        Some(())
    }

    pub fn declared_unit(&mut self, written: &Declaration, declared: &mut Declared) -> Option<()> {
        let Some(unit) = &written.unit else {
            return Some(());
        };
        let (factor, dimension) = lower_unit(unit, self.errors)?;
        if factor != Number::one() {
            let name = &written.name;
            let unit_to_write = dimension.unit();
            return self.report(
                unit.extent,
                format!(
                    "`{name}` is given in SI units: write `{name}{unit_to_write}`, and convert \
                     where you build the value"
                ),
            );
        }
        declared.dimension = dimension;
        declared.unit = Some(written_unit(unit));
        Some(())
    }

    /// The unit of a default, as written, with angles in radians. A unit that is not SI is not the
    /// unit of the field.
    fn unit_of_default(&mut self, value: &Expression) -> Option<Unit> {
        match &value.kind {
            Kind::Prefix(_, inner) => self.unit_of_default(inner),
            Kind::Unit(_, unit) => {
                let unit = in_radians(unit);
                let (factor, _) = lower_unit(&unit, self.errors)?;
                (factor == Number::one()).then(|| written_unit(&unit))
            }
            _ => None,
        }
    }

    /// `world(_, _, _)[unit]`: a vector given from outside.
    fn open_vector(
        &mut self,
        value: &Expression,
        declared: &mut Declared,
        stage: Stage,
        meaning: impl Fn(usize) -> Meaning,
    ) -> Option<Value> {
        if let Kind::Unit(_, unit) = &value.kind {
            let (factor, dimension) = lower_unit(unit, self.errors)?;
            if factor != Number::one() {
                return self.report(
                    unit.extent,
                    format!(
                        "what is given from outside is in SI units: write `{}`",
                        dimension.unit()
                    ),
                );
            }
            declared.dimension = dimension;
            declared.unit = Some(written_unit(unit));
        }
        let frame = declared.frame.map(|word| self.state.frame(word));
        let (Some(frame), Kind::Call(_, parts)) = (frame, &strip_unit(value).kind) else {
            let name = &declared.name;
            return self.report(
                value.extent,
                format!(
                    "what is given from outside is a scalar, `{name}` or `{name}[unit]`, or a vector, \
                     `{name} = body(_, _, _)` or `world(_, _, _)`"
                ),
            );
        };
        self.check_count(parts, value.extent)?;
        if let Some(fixed) = parts
            .iter()
            .find(|part| !matches!(part.kind, Kind::Placeholder))
        {
            return self.report(
                fixed.extent,
                "if one component of an open vector is `_`, all are: write `_`",
            );
        }
        let symbols = self.work.symbols(stage, 0..self.motion.axes(), meaning);
        let vector = self.work.vector(frame, symbols);
        Some(Value::Vector(vector, declared.dimension))
    }

    fn constant(&mut self, id: Id, place: &Expression) -> Option<Number> {
        match self.work.graph.as_number(id) {
            Some(number) if number.fits_f64() => Some(number.clone()),
            Some(_) => self.report(
                place.extent,
                "this is out of the range of `f64`, which is about 5e-324 to 1.8e308",
            ),
            None => self.report(
                place.extent,
                "a default is a constant: write what follows from other names as a local",
            ),
        }
    }
}
