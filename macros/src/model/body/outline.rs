//! What is known of a description whatever is wrong with it: its names, types and signatures.

use std::collections::HashSet;

use proc_macro2::{Ident, TokenStream};

use crate::errors::Extent;
use crate::families::LoadKind;
use crate::model::joints::{Field, Group, Motion, OWN, Shape};
use crate::model::words::{AXES, Dimension, Frame, FrameWord, Meaning, Unit, Variable};
use crate::symbolic::Number;

/// An output that is asked for, and where.
pub struct Asked {
    pub word: &'static str,
    pub place: Extent,
    /// It has no meaning where nothing moves by itself.
    pub is_of_motion: bool,
}

/// The name, motion, parameters, inputs, outputs and keys of a description, and how many loads it
/// has.
pub struct Outline {
    pub name: Ident,
    /// The scalar that the body is generic over; none of a body of `f64`.
    pub scalar: Option<Ident>,
    /// The path of the runtime crate.
    pub runtime: TokenStream,
    pub doc: Vec<String>,
    pub motion: Motion,
    /// It is a system, and not a body alone.
    pub is_system: bool,
    /// Of a system: its bodies.
    pub bodies: Vec<Ident>,
    /// Of a system: its joints that move, each a field of its state.
    pub joints: Vec<Jointed>,
    /// Of a system: the joints that hold what they carry, in some direction.
    pub holding: Vec<Ident>,
    /// Of a system: the joints whose reactions are asked for, if not all.
    pub held: Option<Vec<Ident>>,
    /// Of a system: the loads of written constraints, `pin_x` of the first component of `pin`; where
    /// something is wrong, all that there may be.
    pub kept: Vec<Ident>,
    /// Of a system: the points whose Jacobians are asked for, each `body_point`.
    pub points: Vec<Ident>,
    /// Of a system: the drives of joints whose motion is prescribed, by joint and as reactions.
    pub driving: Vec<(Ident, Ident)>,
    /// Constants and functions of the Rust of the user, which are known once it is built.
    pub foreign: Vec<Ident>,
    pub params: Vec<Declared>,
    pub inputs: Vec<Declared>,
    /// States of its own, each a field of its state.
    pub states: Vec<Declared>,
    pub outputs: Vec<Asked>,
    /// Loads with unknown components, by name.
    pub reactions: Vec<(Ident, LoadKind)>,
    /// Drives with unknown components, by name.
    pub drives: Vec<(Ident, LoadKind)>,
    /// One of them has a direction that turns against the body, as far as its words say.
    pub has_turning_drive: bool,
    /// Whether the motion is under constraints.
    pub is_constrained: bool,
    /// Number of given loads.
    pub loads: usize,
    pub keys: Vec<Ident>,
    /// Of a system: those in the braces of its bodies.
    pub body_keys: Vec<Ident>,
    /// Of a system: its open drives, by name.
    pub open: Vec<Ident>,
    /// Names that nothing in the description refers to.
    pub unused: Vec<Ident>,
}

/// A joint that moves.
pub struct Jointed {
    pub name: Ident,
    pub shape: &'static Shape,
    /// The frame of the body that it carries, once it is known.
    pub frame: Option<Frame>,
}

impl Outline {
    /// Whether the reactions of a joint are asked for.
    pub fn is_held(&self, joint: &Ident) -> bool {
        let held = self.held.as_ref();
        held.is_none_or(|held| held.contains(joint))
    }

    /// Whether there are reactions at all, asked for or not.
    pub fn has_reactions(&self) -> bool {
        let of_system = !self.holding.is_empty() || !self.kept.is_empty();
        of_system || !self.reactions.is_empty()
    }

    /// Of a system: how many accelerations it has.
    pub fn freedoms(&self) -> usize {
        let second = self.joints.iter().flat_map(|joint| joint.shape.second);
        second.map(|field| field.names.len()).sum()
    }

    /// The coordinates of the tangent space of its states: what comes before the rates, joint by
    /// joint, and then the rates, and states of one's own behind them.
    pub fn tangent(&self) -> Vec<Group> {
        let [places, rates] = [Shape::places, Shape::rates].map(|of| self.by_shape(of));
        [places, rates, self.own("")].concat()
    }

    /// Its accelerations, in the order of the rates; of a state of one's own its rate.
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

    /// Its state is a struct of its own, with a field for each part.
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
        // what is there twice was reported
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

    /// The fields of the state that are the motion's, part by part: of which frame, and of which joint.
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

    /// Which of these a symbol stands for.
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

    /// The names of the numbers of an input, and what each stands for.
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

    /// It is a system in which nothing moves by itself: its state has no coordinates.
    pub fn is_still(&self) -> bool {
        self.is_system && self.joints.is_empty() && self.states.is_empty()
    }

    /// The place of an output among those that are asked for.
    pub fn rank(&self, word: &str) -> Option<usize> {
        self.outputs.iter().position(|asked| asked.word == word)
    }

    /// Where an output is asked for.
    pub fn place(&self, word: &str) -> Option<Extent> {
        Some(self.outputs[self.rank(word)?].place)
    }

    /// Whether anything in it is known only once it is built, whatever its parameters are.
    pub fn is_foreign(&self) -> bool {
        !self.foreign.is_empty()
    }

    /// Whether there is anything to be built from.
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
    /// Whether it is a vector, and in which axes its components are written.
    pub frame: Option<FrameWord>,
    pub dimension: Dimension,
    /// The unit as it was written, if it is one of SI.
    pub unit: Option<Unit>,
    /// Of an input: whether it is given with its rate and acceleration, and which derivative it is
    /// itself.
    pub moves: bool,
    pub order: usize,
    /// Default of a parameter, one number for each component.
    pub default: Option<Vec<Number>>,
}

impl Declared {
    /// Its unit, in the words of the description if it has any.
    pub fn shown_unit(&self) -> String {
        let unit = self.unit.as_ref();
        unit.map_or_else(|| self.dimension.to_string(), Unit::to_string)
    }

    /// The unit of its rate.
    pub fn shown_rate(&self) -> String {
        let rate = self.unit.clone().and_then(Unit::per_second);
        let of_dimension = || self.dimension.over(Dimension::TIME);
        rate.map_or_else(
            || of_dimension().unwrap_or(Dimension::ANY).to_string(),
            |rate| rate.to_string(),
        )
    }

    /// How many derivatives of it are given.
    pub fn derivatives(&self) -> usize {
        if self.moves {
            2
        } else {
            2 * usize::from(self.order > 0) - self.order
        }
    }
}
