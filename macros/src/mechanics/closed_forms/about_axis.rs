//! Motions about an axis that have a closed form: with constant acceleration, or as a pendulum,
//! `w' = a sin theta + b cos theta`.

use crate::mechanics::proofs::all_vanish;
use crate::model::{Model, Workspace};
use crate::symbolic::{Function, Id};

use super::constants::at_rest;
use super::forms::{Contribution, Rotation, dependence};

/// How a load acts on the motion about an axis.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Constant,
    /// `a sin theta + b cos theta`
    Swinging,
    Other,
}

/// The motion about an axis, or what prevents a closed form.
pub fn about_axis(
    model: &Model,
    work: &mut Workspace,
    acceleration: Id,
    contributions: &[Contribution],
    obstacles: &mut Vec<String>,
) -> Option<Rotation> {
    if work.graph.is_early(acceleration) {
        return Some(Rotation::Uniform(acceleration));
    }
    if let Some((angle, _)) = model.state.angle
        && let Some(rotation) = swing(angle, work, acceleration)
    {
        return Some(rotation);
    }
    let kinds = kinds(model, work, contributions);
    let of = |wanted: Kind| kinds.iter().filter(move |(_, _, kind)| *kind == wanted);
    let others = of(Kind::Other).map(|(load, moment, _)| {
        format!(
            "the moment of `{}` depends on {}, and is neither constant nor that of forces that are constant in \
             world axes",
            load.name,
            dependence(work, &[*moment])
        )
    });
    let before = obstacles.len();
    obstacles.extend(others);
    if let (true, Some((steady, ..)), Some((weight, ..))) = (
        obstacles.len() == before,
        of(Kind::Constant).next(),
        of(Kind::Swinging).next(),
    ) {
        obstacles.push(format!(
            "the moment of `{}` is constant and that of `{}` makes a pendulum: each alone has a closed \
             form, but both together have none",
            steady.name, weight.name
        ));
    }
    None
}

/// The pendulum that an acceleration makes of the angle, if it does.
pub fn swing(angle: Id, work: &mut Workspace, acceleration: Id) -> Option<Rotation> {
    let wave = swinging(angle, work, acceleration)?;
    Some(pendulum(work, wave))
}

/// The pendulum of `w' = a sin theta + b cos theta`.
fn pendulum(work: &mut Workspace, (sine, cosine): (Id, Id)) -> Rotation {
    let graph = &mut work.graph;
    let square = graph.apply(Function::Hypot, &[sine, cosine]);
    let rate = graph.apply(Function::Sqrt, &[square]);
    let opposite = graph.negate(sine);
    let hanging = graph.apply(Function::Atan2, &[cosine, opposite]);
    let labels = &mut work.labels;
    labels.name(rate, "swing_rate");
    labels.name(hanging, "hanging");
    Rotation::Pendulum { rate, hanging }
}

/// The loads with a moment about the axis, each with this moment and its kind.
fn kinds<'a>(
    model: &Model,
    work: &mut Workspace,
    contributions: &'a [Contribution],
) -> Vec<(&'a Contribution, Id, Kind)> {
    let axis = match model.hinge(&mut work.graph) {
        Some(axis) => axis,
        None => [0, 0, 1].map(|component| work.graph.integer(component)),
    };
    let angle = model.state.angle.map(|(angle, _)| angle);
    let acting = contributions.iter().filter_map(|load| {
        let moment = work.graph.dot(axis, load.moment);
        if work.graph.is_zero(moment) {
            return None;
        }
        let kind = if work.graph.is_early(moment) {
            Kind::Constant
        } else if angle.is_some_and(|angle| swinging(angle, work, moment).is_some()) {
            Kind::Swinging
        } else {
            Kind::Other
        };
        Some((load, moment, kind))
    });
    acting.collect()
}

/// `(a, b)` of `a sin theta + b cos theta`. The expression may be written with other parts of the
/// state.
fn swinging(angle: Id, work: &mut Workspace, expression: Id) -> Option<(Id, Id)> {
    let of_late = |id: Id| !work.graph.is_early(id) && id != angle;
    let still = if work.graph.depends_on(&[expression], of_late) {
        at_rest(work, &[expression], |id| id == angle)[0]
    } else {
        expression
    };
    let graph = &mut work.graph;
    let slope = graph.derivative(&[still], angle)[0];
    let zero = graph.zero();
    let at_zero = graph.substitute(&[slope, still], |id| (id == angle).then_some(zero));
    let (a, b) = (at_zero[0], at_zero[1]);
    if !graph.are_early(&at_zero) {
        return None;
    }
    let sine = graph.apply(Function::Sin, &[angle]);
    let cosine = graph.apply(Function::Cos, &[angle]);
    let (first, second) = (graph.multiply(a, sine), graph.multiply(b, cosine));
    let harmonic = graph.add(first, second);
    let rest = graph.subtract(expression, harmonic);
    all_vanish(work, &[rest]).then_some((a, b))
}
