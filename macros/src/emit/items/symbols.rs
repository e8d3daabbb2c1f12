//! The symbols of the equations, with their units and axes.

use std::collections::HashSet;

use crate::emit::code::{joint_symbols, motion_symbols};
use crate::model::{AXES, Declared, Outline, Variable};

/// A quantity with the names of its components.
type Row = (Vec<String>, String);

/// The names and the meaning of each quantity in the equations, such as `wx wy wz` and `angular
/// velocity, rad / s, body axes`.
pub fn symbols(outline: &Outline, text: &[String]) -> Vec<(String, String)> {
    let statements = text.iter().filter(|line| !line.starts_with('#'));
    let words = statements.flat_map(|line| line.split(|letter: char| !is_of_word(letter)));
    let used: HashSet<&str> = words.collect();
    let rows = [of_motion(outline), of_declared(outline)].concat();
    let rows = rows.into_iter().filter_map(|(names, meaning)| {
        let names = names.into_iter().filter(|name| used.contains(&**name));
        let names: Vec<_> = names.collect();
        (!names.is_empty()).then(|| (names.join(" "), meaning))
    });
    rows.collect()
}

fn is_of_word(letter: char) -> bool {
    letter.is_alphanumeric() || letter == '_'
}

/// The coordinates of the motion and their derivatives; those of joints with the same meaning in
/// one row.
fn of_motion(outline: &Outline) -> Vec<Row> {
    if !outline.is_system {
        let symbols = motion_symbols(outline.motion).into_iter();
        let symbols = symbols.map(|(names, variable)| {
            let in_plane = outline.motion.axes() == 2;
            (names, meaning(variable) + axes_of(variable, in_plane))
        });
        return symbols.collect();
    }
    let mut rows: Vec<Row> = Vec::new();
    for (names, variable) in outline.joints.iter().flat_map(joint_symbols) {
        let meaning = meaning(variable);
        match rows.iter_mut().find(|(_, known)| *known == meaning) {
            Some((known, _)) => known.extend(names),
            None => rows.push((names, meaning)),
        }
    }
    rows
}

/// The name of a variable, and its unit.
fn meaning(variable: Variable) -> String {
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
        Variable::Own => "rate of a state",
    };
    meaning.to_owned()
}

/// The axes of a variable of a single body.
fn axes_of(variable: Variable, in_plane: bool) -> &'static str {
    match variable {
        Variable::Quaternion => ", from body to world axes",
        Variable::AngularVelocity | Variable::AngularAcceleration if !in_plane => ", body axes",
        Variable::Angle | Variable::AngularVelocity | Variable::AngularAcceleration => "",
        _ => ", world axes",
    }
}

/// Parameters, inputs and user-defined states.
fn of_declared(outline: &Outline) -> Vec<Row> {
    let axes = outline.motion.axes();
    let [params, inputs, states] = [&outline.params, &outline.inputs, &outline.states];
    let declared = [(params, "parameter"), (inputs, "input"), (states, "state")];
    let rows = declared.into_iter().flat_map(|(all, kind)| {
        all.iter()
            .map(move |one| (components(one, axes), described(one, kind)))
    });
    rows.collect()
}

fn components(declared: &Declared, axes: usize) -> Vec<String> {
    let name = &declared.name;
    if declared.frame.is_none() {
        return vec![name.to_string()];
    }
    let axes = AXES[..axes].iter();
    axes.map(|axis| format!("{name}_{axis}")).collect()
}

fn described(declared: &Declared, kind: &str) -> String {
    let unit = declared.plain_unit();
    let unit = if unit.is_empty() {
        unit
    } else {
        format!(", {unit}")
    };
    let axes = declared
        .frame
        .map(|frame| format!(", {} axes", frame.text()));
    format!("{kind}{unit}{}", axes.unwrap_or_default())
}
