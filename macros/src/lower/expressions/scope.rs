//! Values and their names: one namespace for parameters, inputs, points, locals and built-in
//! names, and the order in which definitions must be read.

use std::cell::RefCell;
use std::collections::{HashMap, HashSet};

use proc_macro2::Ident;

use crate::errors::{hint, name_meant};
use crate::model::{Constraint, Dimension, Frame, Level, Origin, Point, Vector};
use crate::symbolic::{Components, Id};
use crate::syntax::Description;

pub use crate::syntax::BUILT_IN;

/// The value of an expression, with its dimension.
#[derive(Clone, Copy, Debug)]
pub enum Value {
    Scalar(Id, Dimension),
    Vector(Vector, Dimension),
    /// A vector whose components can be read, because its axes are known.
    Components(Frame, Components, Dimension),
    Condition(Id),
    Point(Point),
    /// A point of a body of a system: the index of the body, and the offset from the G of that
    /// body.
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
            Self::Carried(..) => "a point of a body",
            Self::Attitude => "the attitude",
            Self::Function(_) => "a function",
        }
    }
}

/// Names that have a meaning only under `motion: rod(..)`.
pub const OF_ROD: [&str; 2] = ["axis", "axis_rate"];

/// Names of accelerations, unless the description defines them otherwise.
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

/// What the names of a description mean.
#[derive(Clone)]
pub struct Scope {
    /// The name of the description.
    pub name: String,
    /// `None` stands for a known name without a value, which is reported.
    values: HashMap<String, Option<Value>>,
    used: HashSet<String>,
    /// All names that the description defines somewhere.
    defined: HashSet<String>,
    /// Names whose definition could not be read.
    lost: HashSet<String>,
    locals: HashSet<String>,
    constraints: HashMap<String, Kept>,
}

/// What a constraint keeps at zero.
#[derive(Clone, Copy)]
pub enum Kept {
    Unread,
    Reported,
    Scalar(Id, Level),
    /// A vector, whose components are constraints.
    Vector,
}

impl Scope {
    /// `repeated` are names that are ambiguous.
    pub fn new(description: &Description, repeated: HashSet<String>) -> Self {
        let given = description.params.iter().chain(&description.inputs);
        let declarations = given.chain(&description.states);
        let kept = description.constraints.iter();
        let definitions = description.points.iter().chain(&description.locals);
        let declared = declarations.map(|declaration| declaration.name.to_string());
        let foreign = description.foreign().map(|(name, _)| name.to_string());
        let defined = definitions.map(|definition| definition.name.to_string());
        let locals = description.locals.iter();
        let defined: HashSet<String> = declared.chain(defined).chain(foreign).collect();
        // a rate that belongs to no state is reported
        let rates = description.rates.iter().map(|rate| rate.name.to_string());
        let stateless = rates.filter(|name| !defined.contains(name));
        Self {
            name: description.name.to_string(),
            values: stateless.map(|name| (name, None)).collect(),
            used: HashSet::new(),
            defined,
            lost: description.lost.iter().cloned().chain(repeated).collect(),
            constraints: kept
                .map(|one| (one.name.to_string(), Kept::Unread))
                .collect(),
            locals: locals.map(|local| local.name.to_string()).collect(),
        }
    }

    pub fn define(&mut self, name: &str, value: Option<Value>) {
        self.values.entry(name.to_owned()).or_insert(value);
    }

    /// Replaces the value of a name.
    pub fn redefine(&mut self, name: &str, value: Option<Value>) {
        self.values.insert(name.to_owned(), value);
    }

    /// The constraints that one entry makes; `None` if it is reported.
    pub fn define_constraints(&mut self, name: &str, constraints: Option<&[Constraint]>) {
        let whole = constraints.map_or(Kept::Reported, |_| Kept::Vector);
        self.constraints.insert(name.to_owned(), whole);
        for one in constraints.into_iter().flatten() {
            let kept = Kept::Scalar(one.value, one.level);
            self.constraints.insert(one.name.clone(), kept);
        }
    }

    /// What a constraint keeps at zero; `None` if there is no such constraint.
    pub fn constraint(&self, name: &str) -> Option<Kept> {
        self.constraints.get(name).copied()
    }

    /// Removes the value of a name. The name gets a value later.
    pub fn forget(&mut self, name: &str) {
        self.values.remove(name);
    }

    /// `None` for an undefined name.
    #[allow(clippy::option_option, reason = "outer: not defined; inner: reported")]
    pub fn look_up(&mut self, name: &str) -> Option<Option<Value>> {
        if self.is_lost(name) {
            return Some(None);
        }
        let value = self.values.get(name)?;
        self.used.insert(name.to_owned());
        Some(*value)
    }

    /// The values of all names, so that they can be restored.
    pub fn values(&self) -> HashMap<String, Option<Value>> {
        self.values.clone()
    }

    pub fn restore(&mut self, values: HashMap<String, Option<Value>>) {
        self.values = values;
    }

    /// Whether the description or the language may give this name a value that is not constant.
    pub fn is_open(&self, name: &str) -> bool {
        self.defined.contains(name) || CHANGING.contains(&name) || name == "mass"
    }

    /// Whether a name has a value, or would have one but for a reported error.
    pub fn knows(&self, name: &str) -> bool {
        self.values.contains_key(name)
    }

    /// Whether this is the name of a local.
    pub fn is_local(&self, name: &str) -> bool {
        self.locals.contains(name)
    }

    /// Whether the definition of a name could not be read, or the name is ambiguous.
    pub fn is_lost(&self, name: &str) -> bool {
        self.lost.contains(name.strip_prefix("r#").unwrap_or(name))
    }

    /// The value of a name, without marking it as used.
    pub fn peek(&self, name: &str) -> Option<Value> {
        let value = self.values.get(name).filter(|_| !self.is_lost(name));
        value.copied().flatten()
    }

    /// Whether this is a built-in name of a quantity that changes while the body moves.
    pub fn is_changing(name: &str) -> bool {
        CHANGING.contains(&name)
    }

    /// The names that the description gives a meaning.
    pub fn own(&self) -> impl Iterator<Item = &str> {
        self.values.keys().map(String::as_str)
    }

    /// The names that have a meaning.
    pub fn known(&self) -> impl Iterator<Item = &str> {
        self.own().chain(BUILT_IN).chain(FOLLOWED)
    }

    /// Whether a name was looked up.
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
    /// The names of all bodies, followed by those of all joints, whether they are read yet or not.
    pub declared: Vec<String>,
    /// The locals of the system that depend on its motion.
    pub late: Vec<String>,
    pub bodies: Vec<BodyNames>,
    pub joints: Vec<JointNames>,
    /// Whether their motion is known.
    pub are_moving: bool,
    /// Whether the loads of joints can be used, as in checks.
    pub are_loaded: bool,
    /// Points that were used: the index of the body, and the name.
    pub used: RefCell<HashSet<(usize, String)>>,
}

/// What others can use of a body.
pub struct BodyNames {
    pub name: String,
    pub frame: Frame,
    /// The place of its G, if all bodies are drawn in one frame.
    pub origin: Option<Origin>,
    /// Its points, measured from its G.
    pub points: Offsets,
    /// Its motion, once the joints are known.
    pub motion: Option<BodyMotion>,
    /// Its quantities other than those of points: `position`, `attitude`, `mass`.
    pub values: Values,
}

/// Where a point of a body is.
#[derive(Clone, Copy)]
pub enum Offset {
    /// Its offset from the body's G.
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
    /// In the axes of the body.
    pub angular_velocity: Components,
    pub angular_acceleration: Components,
}

/// Words and their meanings.
type Values = Vec<(&'static str, Value)>;

/// Points, by name.
pub type Offsets = Vec<(String, Offset)>;

/// What is known of moving bodies and joints.
pub struct Told {
    bodies: Vec<(Option<BodyMotion>, Values, Offsets)>,
    joints: Vec<Values>,
}

/// What others can use of a joint.
pub struct JointNames {
    pub name: String,
    /// Its coordinates and their rates, unless an error in them is reported.
    pub values: Values,
    /// Whether it is read.
    pub is_known: bool,
    /// Whether it closes a loop: then the state has no coordinates for it.
    pub closes: bool,
}

impl Members {
    pub fn body(&self, name: &str) -> Option<usize> {
        self.bodies.iter().position(|body| body.name == name)
    }

    pub fn joint(&self, name: &str) -> Option<&JointNames> {
        self.joints.iter().find(|joint| joint.name == name)
    }

    /// Whether this is the name of a body or a joint.
    pub fn has(&self, name: &str) -> bool {
        self.body(name).is_some() || self.joint(name).is_some()
    }

    /// What is known of moving bodies and joints, so that it can be restored.
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

    /// Whether this is a system, not a single body.
    pub fn is_system(&self) -> bool {
        !self.declared.is_empty()
    }

    /// The end of a message about an unknown name. It suggests copies of the name, or a similar
    /// name, also from `others`.
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

    /// `elbow.angle`, if the joint `elbow` has a coordinate `angle`.
    pub fn with_joint(&self, coordinate: &str) -> Option<String> {
        let mut joints = self.joints.iter();
        let joint =
            joints.find(|joint| joint.values.iter().any(|(name, _)| *name == coordinate))?;
        Some(format!("{}.{coordinate}", joint.name))
    }

    /// The coordinate of a joint that a word means, such as `elbow.angle`.
    pub fn coordinate_meant(&self, word: &str) -> Option<String> {
        let meant = name_meant(word);
        let all = [Some(word), meant, meant.and(Some("angle"))];
        let mut found = all.into_iter().flatten();
        found.find_map(|coordinate| self.with_joint(coordinate))
    }

    /// `upper.tip`, if the body `upper` has a point `tip`.
    pub fn with_body(&self, point: &str) -> Option<String> {
        let mut bodies = self.bodies.iter();
        let body = bodies.find(|body| body.points.iter().any(|(name, _)| name == point))?;
        Some(format!("{}.{point}", body.name))
    }
}
