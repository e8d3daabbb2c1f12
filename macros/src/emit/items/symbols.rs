//! The symbols of the equations, with their units and axes.

use std::collections::{BTreeMap, HashSet};

use crate::emit::code::{joint_symbols, motion_symbols};
use crate::model::{Declared, Meaning, Outline, Variable};

/// The place of a quantity in the list; then whether it is a vector.
type Place = (Kind, usize, bool);

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Motion,
    Result,
    Time,
    Param,
    Input,
    State,
}

/// The names and the meaning of each quantity in the equations, such as `wx wy wz` and `angular
/// velocity, rad / s, body axes`.
pub fn symbols(
    outline: &Outline,
    named: &[(String, Meaning)],
    text: &[String],
) -> Vec<(String, String)> {
    let mut rows: BTreeMap<Place, Row> = BTreeMap::new();
    for (name, meaning) in named {
        if let Some((place, order, described)) = describe(outline, *meaning) {
            let row = rows.entry(place).or_insert_with(|| Row::of(described));
            row.names.insert(order, name.clone());
        }
    }
    let lefts: HashSet<&str> = text
        .iter()
        .filter_map(|line| line.split(" = ").next())
        .collect();
    for (number, (names, variable)) in results(outline).into_iter().enumerate() {
        let is_vector = names.len() > 1;
        let place = (Kind::Result, variable as usize, is_vector);
        for (part, name) in names.into_iter().enumerate() {
            if lefts.contains(&*name) {
                let described = of_motion(outline, variable, is_vector);
                let row = rows.entry(place).or_insert_with(|| Row::of(described));
                row.names.insert((number, part), name);
            }
        }
    }
    let rows = rows.into_values();
    rows.map(|row| {
        let names: Vec<String> = row.names.into_values().collect();
        (names.join(" "), row.meaning)
    })
    .collect()
}

/// The names of the components of a quantity, in order, and its meaning.
struct Row {
    names: BTreeMap<(usize, usize), String>,
    meaning: String,
}

impl Row {
    fn of(meaning: String) -> Self {
        Self {
            names: BTreeMap::new(),
            meaning,
        }
    }
}

/// The place of a symbol, its order among the components of its quantity, and its meaning.
fn describe(outline: &Outline, meaning: Meaning) -> Option<(Place, (usize, usize), String)> {
    let of_declared = |kind: Kind, index: usize, part: Option<usize>, all: &[Declared], word| {
        let place = (kind, index, part.is_some());
        Some((place, (0, part.unwrap_or(0)), declared(&all[index], word)))
    };
    match meaning {
        Meaning::Of(frame, variable, part) => {
            let mut joints = outline.joints.iter();
            let joint = joints.position(|joint| joint.frame == Some(frame));
            let shape = joint.map(|joint| outline.joints[joint].shape);
            let mut fields = shape.into_iter().flat_map(|shape| shape.fields);
            let field = fields.find(|field| field.component(meaning).is_some());
            let is_vector = match field {
                Some(field) => field.names.len() > 1,
                None => variable != Variable::Angle && !is_angular_scalar(outline, variable),
            };
            let place = (Kind::Motion, variable as usize, is_vector);
            let order = (joint.unwrap_or(0), variable.place(part));
            Some((place, order, of_motion(outline, variable, is_vector)))
        }
        Meaning::Time => Some(((Kind::Time, 0, false), (0, 0), "time, s".to_owned())),
        Meaning::Param(index, part) => {
            of_declared(Kind::Param, index, part, &outline.params, "parameter")
        }
        Meaning::Input(index, part) => {
            of_declared(Kind::Input, index, part, &outline.inputs, "input")
        }
        Meaning::Own(index) => of_declared(Kind::State, index, None, &outline.states, "state"),
        Meaning::Constant(_) | Meaning::Reaction(..) | Meaning::Mass(_) | Meaning::Virtual => None,
    }
}

/// A rate of an angle, of a single body.
fn is_angular_scalar(outline: &Outline, variable: Variable) -> bool {
    outline.motion.has_angle()
        && matches!(
            variable,
            Variable::AngularVelocity | Variable::AngularAcceleration
        )
}

/// The names of the accelerations that the equations give.
fn results(outline: &Outline) -> Vec<(Vec<String>, Variable)> {
    if outline.is_system {
        let symbols = outline.joints.iter().flat_map(joint_symbols);
        return symbols
            .filter(|(_, variable)| variable.is_acceleration())
            .collect();
    }
    let motion = outline.motion;
    let symbols = motion_symbols(motion).into_iter();
    let has = |variable: Variable| match variable {
        Variable::LinearAcceleration => motion.translates(),
        Variable::AxisAcceleration => motion.is_line(),
        Variable::AngularAcceleration => motion.has_attitude() && !motion.is_line(),
        _ => false,
    };
    symbols.filter(|(_, variable)| has(*variable)).collect()
}

/// The name of a variable, its unit and its axes.
fn of_motion(outline: &Outline, variable: Variable, is_vector: bool) -> String {
    let meaning = match variable {
        Variable::Position => "position, m",
        Variable::Velocity => "velocity, m / s",
        Variable::LinearAcceleration | Variable::AccelerationInBody => "acceleration, m / s ^ 2",
        Variable::Angle => "angle, rad",
        Variable::Quaternion => "attitude, a unit quaternion",
        Variable::AngularVelocity => "angular velocity, rad / s",
        Variable::AngularAcceleration => "angular acceleration, rad / s ^ 2",
        Variable::Axis => "axis of the rod, a unit vector",
        Variable::AxisRate => "rate of the axis, 1 / s",
        Variable::AxisAcceleration => "second derivative of the axis, 1 / s ^ 2",
        Variable::Own => "state",
    };
    let [quaternion, linear, angular] = if outline.is_system {
        [
            ", from the carried body to the carrier",
            ", axes of the carrier",
            ", axes of the carried body",
        ]
    } else {
        [", from body to world axes", ", world axes", ", body axes"]
    };
    let axes = match variable {
        _ if !is_vector => "",
        Variable::Quaternion => quaternion,
        Variable::AngularVelocity | Variable::AngularAcceleration => angular,
        Variable::AccelerationInBody => ", body axes",
        Variable::Axis | Variable::AxisRate | Variable::AxisAcceleration => ", world axes",
        _ => linear,
    };
    format!("{meaning}{axes}")
}

/// The meaning of a parameter, an input or a user-defined state.
fn declared(declared: &Declared, word: &str) -> String {
    let unit = declared.plain_unit();
    let unit = if unit.is_empty() {
        unit
    } else {
        format!(", {unit}")
    };
    let axes = declared
        .frame
        .map(|frame| format!(", {} axes", frame.text()));
    format!("{word}{unit}{}", axes.unwrap_or_default())
}
