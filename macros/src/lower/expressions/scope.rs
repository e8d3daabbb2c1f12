//! Values and their names: one namespace for parameters, inputs, points, locals and built-in
//! names, and the order in which definitions must be read.

use std::cell::RefCell;
use std::collections::{HashMap, HashSet};

use proc_macro2::Ident;

use crate::errors::{hint, name_meant};
use crate::model::{Dimension, Frame, Origin, Point, Vector};
use crate::symbolic::{Components, Id};
use crate::syntax::Description;

pub use crate::syntax::BUILT_IN;

/// The value of an expression, with its dimension.
#[derive(Clone, Copy, Debug)]
pub enum Value {
    Scalar(Id, Dimension),
    Vector(Vector, Dimension),
    /// A vector whose components can be read, with the chosen axes.
    Components(Frame, Components, Dimension),
    Condition(Id),
    Point(Point),
    /// A point of a body of a system, by the index of the body: its offset from that body's G.
    Carried(usize, Vector),
    /// The attitude of the body.
    Attitude,
    /// A Rust function of the user, by its index.
    Function(usize),
}

impl Value {
    /// The kind of this value, for messages.
    pub fn kind(self) -> &'static str {
        match self {
            Self::Scalar(..) => "a scalar",
            Self::Vector(..) | Self::Components(..) => "a vector",
            Self::Condition(_) => "a condition",
            Self::Point(_) => "a point",
            Self::Carried(..) => "a point of another body",
            Self::Attitude => "the attitude",
            Self::Function(_) => "a function",
        }
    }
}

/// Names with a meaning under `motion: rod(..)` only.
pub const OF_ROD: [&str; 2] = ["axis", "axis_rate"];

/// Names of accelerations, unless a definition takes them.
pub const FOLLOWED: [&str; 2] = ["acceleration", "angular_acceleration"];

/// Built-in names of quantities that change while the body moves.
const CHANGING: [&str; 9] = [
    "t",
    "position",
    "velocity",
    "attitude",
    "angular_velocity",
    "acceleration",
    "angular_acceleration",
    "axis",
    "axis_rate",
];

/// The meanings of the names of a description.
#[derive(Clone)]
pub struct Scope {
    /// `None` is known, but was reported and has no value.
    values: HashMap<String, Option<Value>>,
    used: HashSet<String>,
    /// All names that the description defines somewhere.
    defined: HashSet<String>,
    /// Names whose definition could not be read.
    lost: HashSet<String>,
}

impl Scope {
    /// `repeated` are ambiguous names.
    pub fn new(description: &Description, repeated: HashSet<String>) -> Self {
        let given = description.params.iter().chain(&description.inputs);
        let declarations = given.chain(&description.states);
        let definitions = description.points.iter().chain(&description.locals);
        let declared = declarations.map(|declaration| declaration.name.to_string());
        let foreign = description.foreign().map(|(name, _)| name.to_string());
        let defined = definitions.map(|definition| definition.name.to_string());
        Self {
            values: HashMap::new(),
            used: HashSet::new(),
            defined: declared.chain(defined).chain(foreign).collect(),
            lost: description.lost.iter().cloned().chain(repeated).collect(),
        }
    }

    pub fn define(&mut self, name: &str, value: Option<Value>) {
        self.values.entry(name.to_owned()).or_insert(value);
    }

    /// Replaces the value of a name.
    pub fn redefine(&mut self, name: &str, value: Option<Value>) {
        self.values.insert(name.to_owned(), value);
    }

    /// Removes the value of a name, which gets one later.
    pub fn forget(&mut self, name: &str) {
        self.values.remove(name);
    }

    /// `None` for an undefined name.
    #[allow(clippy::option_option, reason = "outer: not defined; inner: reported")]
    pub fn look_up(&mut self, name: &str) -> Option<Option<Value>> {
        if self.lost.contains(name.strip_prefix("r#").unwrap_or(name)) {
            return Some(None);
        }
        let value = self.values.get(name)?;
        self.used.insert(name.to_owned());
        Some(*value)
    }

    /// The values of all names, to be restored.
    pub fn values(&self) -> HashMap<String, Option<Value>> {
        self.values.clone()
    }

    pub fn restore(&mut self, values: HashMap<String, Option<Value>>) {
        self.values = values;
    }

    /// Whether the description, or the language, gives this name a value that is no constant.
    pub fn is_open(&self, name: &str) -> bool {
        self.defined.contains(name) || CHANGING.contains(&name) || name == "mass"
    }

    /// Whether a name has a value, or had one that was reported.
    pub fn knows(&self, name: &str) -> bool {
        self.values.contains_key(name)
    }

    /// Whether the definition of a name could not be read.
    pub fn is_lost(&self, name: &str) -> bool {
        self.lost.contains(name)
    }

    /// The value of a name, without marking it as used.
    pub fn peek(&self, name: &str) -> Option<Value> {
        self.values.get(name).copied().flatten()
    }

    /// Whether this is a built-in name of a quantity that changes while the body moves.
    pub fn is_changing(name: &str) -> bool {
        CHANGING.contains(&name)
    }

    /// The names with a meaning.
    pub fn known(&self) -> impl Iterator<Item = &str> {
        let own = self.values.keys().map(String::as_str);
        own.chain(BUILT_IN).chain(FOLLOWED)
    }

    /// Whether it was looked up.
    pub fn has_used(&self, name: &str) -> bool {
        self.used.contains(name)
    }

    pub fn is_used(&self, name: &Ident) -> bool {
        self.used.contains(&name.to_string()) || name.to_string().starts_with('_')
    }
}

/// The bodies and joints of a system, by their names.
#[derive(Default)]
pub struct Members {
    /// The names of all bodies, and then of all joints, whether they are read yet or not.
    pub declared: Vec<String>,
    /// The locals of the system that depend on its motion.
    pub late: Vec<String>,
    pub bodies: Vec<BodyNames>,
    pub joints: Vec<JointNames>,
    /// Whether their motion is known.
    pub are_moving: bool,
    /// Whether joints have loads: in checks.
    pub are_loaded: bool,
    /// The requested points, by the index of the body.
    pub used: RefCell<HashSet<(usize, String)>>,
}

/// A body, as others see it.
pub struct BodyNames {
    pub name: String,
    pub frame: Frame,
    /// The place of its G, if others are drawn in the same frame.
    pub origin: Option<Origin>,
    /// Its points, from its G.
    pub points: Offsets,
    /// Once the joints are known.
    pub motion: Option<BodyMotion>,
    /// `position`, `attitude`, `mass`: its quantities other than those of points.
    pub values: Values,
}

/// The place of a point of a body.
#[derive(Clone, Copy)]
pub enum Offset {
    /// From its G.
    Known(Vector),
    /// It depends on the motion of the body, which is not known yet.
    Late,
    Reported,
}

/// The motion of a body.
#[derive(Clone, Copy)]
pub struct BodyMotion {
    pub position: Vector,
    pub velocity: Vector,
    pub acceleration: Vector,
    /// In its axes.
    pub angular_velocity: Components,
    pub angular_acceleration: Components,
}

/// Words and their meanings.
type Values = Vec<(&'static str, Value)>;

/// Points, by name.
pub type Offsets = Vec<(String, Offset)>;

/// The definitions of bodies and joints that move.
pub struct Told {
    bodies: Vec<(Option<BodyMotion>, Values, Offsets)>,
    joints: Vec<Values>,
}

/// A joint, as others see it.
pub struct JointNames {
    pub name: String,
    /// Its coordinates and their rates; those without a value were reported.
    pub values: Values,
    /// Whether it is known.
    pub is_known: bool,
    /// It closes a loop: the state has no coordinates for it.
    pub closes: bool,
}

impl Members {
    pub fn body(&self, name: &str) -> Option<usize> {
        self.bodies.iter().position(|body| body.name == name)
    }

    pub fn joint(&self, name: &str) -> Option<&JointNames> {
        self.joints.iter().find(|joint| joint.name == name)
    }

    /// Whether this is a body or a joint.
    pub fn has(&self, name: &str) -> bool {
        self.body(name).is_some() || self.joint(name).is_some()
    }

    /// The definitions of bodies and joints that move, to be restored.
    pub fn moving(&self) -> Told {
        let bodies = self.bodies.iter();
        Told {
            bodies: bodies
                .map(|body| (body.motion, body.values.clone(), body.points.clone()))
                .collect(),
            joints: self
                .joints
                .iter()
                .map(|joint| joint.values.clone())
                .collect(),
        }
    }

    pub fn restore(&mut self, told: Told) {
        for (body, told) in self.bodies.iter_mut().zip(told.bodies) {
            (body.motion, body.values, body.points) = told;
        }
        for (joint, values) in self.joints.iter_mut().zip(told.joints) {
            joint.values = values;
        }
    }

    /// Whether there is a system.
    pub fn is_system(&self) -> bool {
        !self.declared.is_empty()
    }

    /// The end of a message about an unknown name: its copies, or a similar one of `others`.
    pub fn hint<'a>(&'a self, name: &str, others: impl Iterator<Item = &'a str>) -> String {
        let copies = self.declared.iter().filter(|known| {
            known
                .strip_prefix(name)
                .is_some_and(|rest| rest.starts_with('_'))
        });
        let copies: Vec<&str> = copies.map(String::as_str).take(3).collect();
        if !copies.is_empty() && !name.is_empty() {
            return format!("; its copies are called `{}`", copies.join("`, `"));
        }
        let mut known: Vec<&str> = self
            .declared
            .iter()
            .map(String::as_str)
            .chain(others)
            .collect();
        known.sort_unstable();
        match name_meant(name) {
            Some(meant) if known.contains(&meant) => format!("; did you mean `{meant}`?"),
            _ => hint(name, known),
        }
    }

    /// `upper.tip`, if the body `upper` has a point `tip`.
    pub fn with_body(&self, point: &str) -> Option<String> {
        let mut bodies = self.bodies.iter();
        let body = bodies.find(|body| body.points.iter().any(|(name, _)| name == point))?;
        Some(format!("{}.{point}", body.name))
    }
}
