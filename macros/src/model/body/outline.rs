//! What is known of a description even if it has errors: names, types and signatures.

use std::collections::HashSet;

use proc_macro2::{Ident, TokenStream};

use crate::errors::Extent;
use crate::families::LoadKind;
use crate::model::joints::{Field, Group, Motion, OWN, Shape};
use crate::model::kinematics::Workspace;
use crate::model::words::{AXES, Dimension, Frame, FrameWord, Meaning, Unit, Variable};
use crate::symbolic::{Id, Number};

/// A requested output, and where it is requested.
pub struct Asked {
    pub word: &'static str,
    pub place: Extent,
    /// Whether it has no meaning if nothing moves by itself.
    pub is_of_motion: bool,
}

/// The name, motion, parameters, inputs, outputs and keys of a description, and the number of its
/// loads.
pub struct Outline {
    pub name: Ident,
    /// The scalar over which the body is generic; `None` for a body of `f64`.
    pub scalar: Option<Ident>,
    /// The path of the runtime crate.
    pub runtime: TokenStream,
    pub doc: Vec<String>,
    pub motion: Motion,
    /// Whether it is a system, not a single body.
    pub is_system: bool,
    /// For a system: its bodies.
    pub bodies: Vec<Ident>,
    /// For a system: its moving joints, each a field of its state.
    pub joints: Vec<Jointed>,
    /// For a system: the joints that hold the carried body in some direction, so that they have
    /// reactions.
    pub holding: Vec<Ident>,
    /// For a system: the joints whose reactions are requested, if not all.
    pub held: Option<Vec<Ident>>,
    /// For a system: the names of the loads of written constraints, such as `pin_x` for the first
    /// component of `pin`. If there are errors, all possible names.
    pub kept: Vec<Ident>,
    /// For a system: the points whose Jacobians are requested, each as `body_point`.
    pub points: Vec<Ident>,
    /// For a system: the drives of joints with prescribed motion: the joint, and the name among the
    /// reactions.
    pub driving: Vec<(Ident, Ident)>,
    /// Rust constants and functions of the user. Their values are known once the body is built.
    pub foreign: Vec<Ident>,
    pub params: Vec<Declared>,
    pub inputs: Vec<Declared>,
    /// User-defined states, each a field of the state.
    pub states: Vec<Declared>,
    pub outputs: Vec<Asked>,
    /// Loads with unknown components, by name.
    pub reactions: Vec<(Ident, LoadKind)>,
    /// Drives with unknown components, by name.
    pub drives: Vec<(Ident, LoadKind)>,
    /// Whether a drive has a direction that rotates relative to the body, as far as its form shows.
    pub has_turning_drive: bool,
    /// Whether the motion is under constraints.
    pub is_constrained: bool,
    /// Number of given loads.
    pub loads: usize,
    /// For a system: the names of its open drives, with the numbers of their components.
    pub open: Vec<(Ident, usize)>,
    /// Names that nothing in the description refers to.
    pub unused: Vec<Ident>,
}

/// A moving joint.
pub struct Jointed {
    pub name: Ident,
    pub shape: &'static Shape,
    /// The frame of the carried body, once it is known.
    pub frame: Option<Frame>,
}

impl Outline {
    /// Whether the reactions of a joint are requested.
    pub fn is_held(&self, joint: &Ident) -> bool {
        let held = self.held.as_ref();
        held.is_none_or(|held| held.contains(joint))
    }

    /// Whether there are reactions, requested or not.
    pub fn has_reactions(&self) -> bool {
        let of_system = !self.holding.is_empty() || !self.kept.is_empty();
        of_system || !self.reactions.is_empty()
    }

    /// The names of the parameters and of the user's constants that `roots` are computed from.
    pub fn sources(&self, work: &Workspace, roots: &[Id]) -> Vec<String> {
        let symbols = work.graph.nodes_of(roots).into_iter();
        let names = symbols.filter_map(|symbol| match work.meaning(symbol)? {
            Meaning::Param(index, _) => Some(self.params[index].name.to_string()),
            Meaning::Constant(index) => Some(work.constants[index].name.to_string()),
            _ => None,
        });
        let mut names: Vec<String> = names.collect();
        names.dedup();
        names
    }

    /// For a system: the number of its accelerations.
    pub fn freedoms(&self) -> usize {
        let second = self.joints.iter().flat_map(|joint| joint.shape.second);
        second.map(|field| field.names.len()).sum()
    }

    /// The coordinates of the tangent space of its states: first the coordinates, joint by joint,
    /// then the rates, and last the user-defined states.
    pub fn tangent(&self) -> Vec<Group> {
        let [places, rates] = [Shape::places, Shape::rates].map(|of| self.by_shape(of));
        [places, rates, self.own("")].concat()
    }

    /// Its accelerations, in the order of the rates, followed by the rates of user-defined states.
    pub fn accelerations(&self) -> Vec<Group> {
        [self.by_shape(Shape::accelerations), self.own("_rate")].concat()
    }

    fn own(&self, suffix: &str) -> Vec<Group> {
        let states = self.states.iter().enumerate();
        let groups = states.map(|(number, state)| Group {
            joint: 0,
            name: format!("{}{suffix}", state.name),
            variable: Variable::Own,
            first: number,
            size: 1,
        });
        groups.collect()
    }

    /// Whether its state is a generated struct with a field for each part.
    pub fn has_parts(&self) -> bool {
        self.is_system || !self.states.is_empty()
    }

    /// The parts of such a state.
    pub fn parts(&self) -> Vec<(Ident, &'static Shape)> {
        let joints = self.joints.iter();
        let joints = joints.map(|joint| (joint.name.clone(), joint.shape));
        let alone =
            (!self.is_system).then(|| (Ident::new("motion", self.name.span()), self.motion.shape));
        let states = self.states.iter().map(|state| (state.name.clone(), &OWN));
        // repeated names are reported
        let mut seen = HashSet::new();
        let all = alone.into_iter().chain(joints).chain(states);
        all.filter(|(name, _)| seen.insert(name.clone())).collect()
    }

    fn by_shape(&self, of: fn(&Shape, usize, &str) -> Vec<Group>) -> Vec<Group> {
        if !self.is_system {
            return of(self.motion.shape, 0, "");
        }
        let joints = self.joints.iter().enumerate();
        joints
            .flat_map(|(number, joint)| of(joint.shape, number, &format!("{}_", joint.name)))
            .collect()
    }

    /// The fields of the state that belong to the motion, part by part: the frame, the prefix of
    /// its joint, and the field.
    fn fields(&self) -> Vec<(Option<Frame>, String, &'static Field)> {
        let alone = (!self.is_system).then_some(self.motion.shape.fields);
        let alone = alone.into_iter().flatten();
        let alone = alone.map(|field| (None, String::new(), field));
        let joints = self.joints.iter().flat_map(|joint| {
            let fields = joint.shape.fields.iter();
            fields.map(|field| (joint.frame, format!("{}_", joint.name), field))
        });
        alone.chain(joints).collect()
    }

    /// The names of the numbers of a state, one after the other.
    pub fn numbers_of_state(&self) -> Vec<String> {
        let fields = self.fields().into_iter();
        let motion = fields.flat_map(|(_, joint, field)| {
            let names = field.names.iter();
            names.map(move |name| format!("{joint}{name}"))
        });
        let own = self.states.iter().map(|state| state.name.to_string());
        motion.chain(own).collect()
    }

    /// The index, among these numbers, of the one that a symbol stands for.
    pub fn number_of_state(&self, meaning: Meaning) -> Option<usize> {
        let mut first = 0;
        for (frame, _, field) in self.fields() {
            let is_its = |other: Frame| frame.is_none_or(|frame| frame == other);
            if let Meaning::Of(body, ..) = meaning
                && is_its(body)
                && let Some(part) = field.component(meaning)
            {
                return Some(first + part);
            }
            first += field.names.len();
        }
        match meaning {
            Meaning::Own(number) => Some(first + number),
            _ => None,
        }
    }

    /// The names of the numbers of an input, and their meanings.
    pub fn numbers_of_input(&self) -> Vec<(String, Meaning)> {
        let inputs = self.inputs.iter().enumerate();
        let numbers = inputs.flat_map(|(index, input)| {
            let axes = input.frame.map_or(0, |_| self.motion.axes());
            let parts = (0..axes).map(move |axis| {
                let name = format!("{}_{}", input.name, AXES[axis]);
                (name, Meaning::Input(index, Some(axis)))
            });
            let scalar = (axes == 0).then(|| (input.name.to_string(), Meaning::Input(index, None)));
            parts.chain(scalar)
        });
        numbers.collect()
    }

    /// Whether it is a system in which nothing moves by itself: its state has no coordinates.
    pub fn is_still(&self) -> bool {
        self.is_system && self.joints.is_empty() && self.states.is_empty()
    }

    /// The position of an output in the list of requested outputs.
    pub fn rank(&self, word: &str) -> Option<usize> {
        self.outputs.iter().position(|asked| asked.word == word)
    }

    /// Whether one of these outputs is requested.
    pub fn asks_for(&self, words: &[&str]) -> bool {
        words.iter().any(|word| self.rank(word).is_some())
    }

    /// The place where an output is requested.
    pub fn place(&self, word: &str) -> Option<Extent> {
        Some(self.outputs[self.rank(word)?].place)
    }

    /// Whether something in it is known only once it is built, whatever its parameters are.
    pub fn is_foreign(&self) -> bool {
        !self.foreign.is_empty()
    }

    /// Whether it has parameters or constants to be built from.
    pub fn is_built(&self) -> bool {
        self.is_foreign() || !self.params.is_empty()
    }

    /// Whether the body can be built from the defaults alone, which were checked at expansion.
    pub fn has_default(&self) -> bool {
        !self.is_foreign() && self.has_default_params()
    }

    /// Whether all parameters have defaults.
    pub fn has_default_params(&self) -> bool {
        self.params.iter().all(|param| param.default.is_some())
    }
}

/// A parameter or an input.
pub struct Declared {
    pub name: Ident,
    /// Its documentation in the description.
    pub text: Vec<String>,
    /// The axes of a vector; `None` for a scalar.
    pub frame: Option<FrameWord>,
    pub dimension: Dimension,
    /// The unit as written, if it is an SI unit.
    pub unit: Option<Unit>,
    /// For an input: whether its rate and acceleration are given too, and which derivative it is
    /// itself.
    pub moves: bool,
    pub order: usize,
    /// The default of a parameter, one number for each component.
    pub default: Option<Vec<Number>>,
}

impl Declared {
    /// Its unit, as written in the description if possible; empty for a pure number.
    pub fn plain_unit(&self) -> String {
        let is_number = [Dimension::NONE, Dimension::ANY].contains(&self.dimension);
        match &self.unit {
            Some(unit) => unit.to_string(),
            None if is_number => String::new(),
            None => self.dimension.to_string(),
        }
    }

    /// The same as the end of a sentence: ` in m / s`.
    pub fn in_unit(&self) -> String {
        in_unit(self.unit.as_ref(), self.dimension)
    }

    /// The same for its rate.
    pub fn rate_in_unit(&self) -> String {
        let rate = self.unit.clone().and_then(Unit::per_second);
        let of_dimension = self.dimension.over(Dimension::TIME);
        in_unit(rate.as_ref(), of_dimension.unwrap_or(Dimension::ANY))
    }

    /// The number of given derivatives.
    pub fn derivatives(&self) -> usize {
        if self.moves {
            2
        } else {
            2 * usize::from(self.order > 0) - self.order
        }
    }
}

fn in_unit(unit: Option<&Unit>, dimension: Dimension) -> String {
    match unit {
        Some(unit) => format!(" in {unit}"),
        None if dimension == Dimension::ANY => " without a unit".to_owned(),
        None => format!(" in {dimension}"),
    }
}
