//! What an actuator does: its gain and its bias.
//!
//! As in `MuJoCo` 4.0, a class has one law for actuators of all kinds. `<general>` changes the
//! parameters that it gives. Every other kind resets all of them. What it does not give, it takes
//! from the nearest class with a law of the same kind, or of `<general>` with the same type of gain.

use roxmltree::Node;

use crate::errors::Extent;
use crate::syntax::xml::decimal::Decimal;
use crate::syntax::xml::reader::Reader;

use super::element::{Element, Steps};

/// The force along a length: the gain times the input, plus the bias.
#[derive(Clone)]
pub struct Law {
    /// The kind of actuator that set it last.
    kind: String,
    gain: Part,
    bias: Part,
    dynamics: String,
    /// The time constant of its dynamics.
    time: Decimal,
    /// The kind that set its parameters, if that kind is not read.
    unread: Option<String>,
}

/// A gain or a bias: `first + second * length + third * rate`, if it is affine.
#[derive(Clone)]
struct Part {
    form: String,
    numbers: [Decimal; 3],
}

const FIXED: &str = "fixed";
const AFFINE: &str = "affine";
const NONE: &str = "none";
/// The dynamics of a `<position>` with a `timeconst`.
const FILTERED: &str = "filterexact";

impl Part {
    fn new(form: &str, numbers: [Decimal; 3]) -> Self {
        let form = form.to_owned();
        Self { form, numbers }
    }

    /// The numbers that count.
    fn terms(&self) -> [Decimal; 3] {
        let zero = Decimal::zero(self.numbers[0].extent);
        match (self.form.as_str(), &self.numbers) {
            (AFFINE, numbers) => numbers.clone(),
            (FIXED, [first, ..]) => [first.clone(), zero.clone(), zero],
            _ => [zero.clone(), zero.clone(), zero],
        }
    }
}

impl Law {
    /// The law of a motor.
    fn motor(kind: &str, extent: Extent) -> Self {
        let zero = || Decimal::zero(extent);
        Self {
            kind: kind.to_owned(),
            gain: Part::new(FIXED, [Decimal::one(extent), zero(), zero()]),
            bias: Part::new(NONE, [zero(), zero(), zero()]),
            dynamics: NONE.to_owned(),
            time: Decimal::one(extent),
            unread: None,
        }
    }

    /// The three numbers of the gain, and those of the bias.
    pub fn terms(&self) -> ([Decimal; 3], [Decimal; 3]) {
        (self.gain.terms(), self.bias.terms())
    }

    /// Whether a kind of actuator takes from this law what it does not give.
    fn serves(&self, kind: &str) -> bool {
        let form = if kind == "damper" { AFFINE } else { FIXED };
        self.kind == kind || (self.kind == "general" && self.gain.form == form)
    }

    /// Whether the last number of the bias is a damping ratio: `MuJoCo` takes it as one if it is
    /// positive, and the gain and the second number are those of a spring.
    fn has_ratio(&self) -> bool {
        let ([gain, ..], [_, spring, damping]) = self.terms();
        gain.is_same(&spring.negated()) && !damping.is_negative() && !damping.is_zero()
    }
}

impl Reader<'_> {
    /// The law of an actuator after all its steps.
    pub fn law(&mut self, node: Node<'_, '_>, steps: &Steps<'_, '_>) -> Option<Law> {
        // the laws of its classes, the outermost first
        let mut laws = vec![Law::motor("general", self.at(node))];
        for step in steps {
            let mut law = laws.last()?.clone();
            for (kind, element) in step {
                law = self.next_law(&law, (kind, element), &laws)?;
            }
            laws.push(law);
        }
        let law = laws.pop()?;
        self.check_law(node, &law)?;
        Some(law)
    }

    /// The law after an element of a kind.
    fn next_law(
        &mut self,
        law: &Law,
        (kind, element): (&str, &Element<'_, '_>),
        around: &[Law],
    ) -> Option<Law> {
        let extent = self.at(element.node);
        let nearest = core::iter::once(law).chain(around.iter().rev());
        let start = Law::motor("general", extent);
        let from = nearest.clone().find(|law| law.serves(kind));
        let from = from.unwrap_or(&start);
        let known = match &from.unread {
            Some(unread) => Err(unread),
            None => Ok(from),
        };
        let law = match (kind, known) {
            ("general", _) => self.general(law.clone(), element),
            ("motor", _) => Law::motor(kind, extent),
            ("position" | "velocity" | "damper", Err(unread)) => {
                return self.not_read(element.node, unread);
            }
            ("position", Ok(from)) => self.position(from, element)?,
            ("velocity", Ok(from)) => self.velocity(from, element),
            ("damper", Ok(from)) => self.damper(from, element)?,
            _ => Law {
                unread: Some(kind.to_owned()),
                ..Law::motor(kind, extent)
            },
        };
        Some(law)
    }

    fn position(&mut self, from: &Law, element: &Element<'_, '_>) -> Option<Law> {
        let stiffness = self.optional(element, "kp");
        let stiffness = stiffness.unwrap_or(from.gain.numbers[0].clone());
        let damping = self.optional(element, "kv");
        self.check_damping(element, damping.as_ref())?;
        let given = damping.map(|damping| damping.negated());
        let given = given.or_else(|| self.optional(element, "dampratio"));
        let last = given.unwrap_or(from.bias.numbers[2].clone());
        let time = self.optional(element, "timeconst");
        let inherited = (from.dynamics == FILTERED).then(|| from.time.clone());
        let mut law = Law::motor("position", stiffness.extent);
        let zero = Decimal::zero(stiffness.extent);
        law.bias = Part::new(AFFINE, [zero, stiffness.negated(), last]);
        law.gain.numbers[0] = stiffness;
        if let Some(time) = time.or(inherited).filter(|time| !time.is_zero()) {
            FILTERED.clone_into(&mut law.dynamics);
            law.time = time;
        }
        Some(law)
    }

    fn velocity(&mut self, from: &Law, element: &Element<'_, '_>) -> Law {
        let damping = self.optional(element, "kv");
        let damping = damping.unwrap_or(from.gain.numbers[0].clone());
        let mut law = Law::motor("velocity", damping.extent);
        let zero = || Decimal::zero(damping.extent);
        law.bias = Part::new(AFFINE, [zero(), zero(), damping.negated()]);
        law.gain.numbers[0] = damping;
        law
    }

    fn damper(&mut self, from: &Law, element: &Element<'_, '_>) -> Option<Law> {
        let damping = self.optional(element, "kv");
        let damping = damping.unwrap_or_else(|| from.gain.numbers[2].negated());
        self.check_damping(element, Some(&damping))?;
        let mut law = Law::motor("damper", damping.extent);
        let zero = || Decimal::zero(damping.extent);
        law.gain = Part::new(AFFINE, [zero(), zero(), damping.negated()]);
        Some(law)
    }

    fn check_damping(
        &mut self,
        element: &Element<'_, '_>,
        damping: Option<&Decimal>,
    ) -> Option<()> {
        if damping.is_some_and(|damping| damping.is_negative() && !damping.is_zero()) {
            return self.report(element.node, "`kv` is at least 0");
        }
        Some(())
    }

    /// A law with what `<general>` gives.
    fn general(&mut self, mut law: Law, element: &Element<'_, '_>) -> Law {
        let parts = [
            (&mut law.gain, "gaintype", "gainprm"),
            (&mut law.bias, "biastype", "biasprm"),
        ];
        for (part, form, numbers) in parts {
            if let Some(word) = element.get(form) {
                word.clone_into(&mut part.form);
            }
            if element.has(numbers) {
                let given = self.list(element, numbers, 1..=10, "");
                let places = part.numbers.iter_mut();
                places
                    .zip(given)
                    .for_each(|(place, number)| *place = number);
            }
        }
        if let Some(word) = element.get("dyntype") {
            word.clone_into(&mut law.dynamics);
        }
        if element.has("dynprm") {
            let given = self.list(element, "dynprm", 1..=10, "");
            law.time = given.into_iter().next().unwrap_or(law.time);
        }
        "general".clone_into(&mut law.kind);
        law
    }

    /// One number, if it is given.
    fn optional(&mut self, element: &Element<'_, '_>, name: &str) -> Option<Decimal> {
        let is_given = element.has(name);
        is_given.then(|| self.single(element, name, "0"))
    }

    /// Reports a law that cannot be described.
    fn check_law(&mut self, node: Node<'_, '_>, law: &Law) -> Option<()> {
        if let Some(unread) = &law.unread {
            return self.not_read(node, unread);
        }
        let is_servo = law.kind == "position";
        if law.dynamics != NONE {
            let word = if is_servo { "timeconst" } else { "dyntype" };
            let message = "actuators with a state of their own are not read";
            return self.report(node, format!("`{word}`: {message}"));
        }
        let parts = [
            (&law.gain, "gaintype", FIXED),
            (&law.bias, "biastype", NONE),
        ];
        for (part, name, simple) in parts {
            let word = part.form.as_str();
            if word != simple && word != AFFINE {
                let message =
                    format!("`{name}`: `{simple}` and `affine` are read, and this is `{word}`");
                return self.report(node, message);
            }
        }
        if law.has_ratio() {
            let message = if is_servo {
                "`dampratio`: damping by a ratio is not read: write `kv`"
            } else {
                "`biasprm`: beside a spring, a third number above 0 is a damping ratio, and this is not read"
            };
            return self.report(node, message);
        }
        Some(())
    }

    fn not_read<T>(&mut self, node: Node<'_, '_>, kind: &str) -> Option<T> {
        let message = format!(
            "it takes what it does not say from `<{kind}>` in its class, which is not read: give it another class"
        );
        self.report(node, message)
    }
}
