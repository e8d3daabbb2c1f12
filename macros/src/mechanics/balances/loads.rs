//! The sum of the given loads, and of their moments about a point.

use crate::errors::Errors;
use crate::families::{Family, LoadKind};
use crate::model::{Frame, Load, Meaning, Model, Point, Reaction, State, Vector, Workspace};
use crate::symbolic::{Components, Graph, Id};

/// The sum of all forces.
pub fn resultant<'l>(work: &mut Workspace, loads: impl IntoIterator<Item = &'l Load>) -> Vector {
    work.sum(loads.into_iter().map(|load| load.force))
}

/// The moment of each load about `pole`.
pub fn moments_about<'l>(
    state: &State,
    work: &mut Workspace,
    loads: impl IntoIterator<Item = &'l Load>,
    pole: Point,
) -> Vec<Vector> {
    let moment = |load: &Load| {
        if load.force.is_zero() {
            return load.moment;
        }
        let arm = arm(state, work, load.point, pole);
        let moment = work.cross(arm, load.force);
        work.add(moment, load.moment)
    };
    loads.into_iter().map(moment).collect()
}

/// `P - O`: the vector from the pole O to the point P.
pub fn arm(state: &State, work: &mut Workspace, point: Point, pole: Point) -> Vector {
    let from_center = |work: &mut Workspace, point: Point| match point {
        Point::Fixed(Frame::WORLD, _) => None,
        Point::Fixed(body, offset) => Some(work.fixed_in(body, offset)),
        Point::Moving(offset) => Some(offset),
    };
    if let (Some(end), Some(start)) = (from_center(work, point), from_center(work, pole)) {
        let backwards = work.negate(start);
        return work.add(end, backwards);
    }
    let end = state.place(work, point);
    let start = state.place(work, pole);
    let backwards = work.negate(start);
    work.add(end, backwards)
}

/// Reports moments on a body that does not rotate, unless they add up to zero: nothing else can
/// balance them.
pub fn check_moment_free(
    model: &Model,
    work: &mut Workspace,
    loads: &[Load],
    errors: &mut Errors,
) -> Option<()> {
    let center = model.state.center(work);
    let moments = moments_about(&model.state, work, loads, center);
    let total = work.sum(moments.iter().copied());
    if total.is_zero() {
        return Some(());
    }
    let unbalanced: Vec<&Load> = loads
        .iter()
        .zip(&moments)
        .filter(|(_, moment)| !moment.is_zero())
        .map(|(load, _)| load)
        .collect();
    for load in unbalanced {
        let motion = model.motion.word;
        errors.push(load.extent, format!("`{}` has a moment about G that nothing balances, and under `motion: {motion}` the body does not turn: let it act at G, balance it by a reaction, or let the body turn", load.name));
    }
    None
}

/// The force of a load of this kind at its point, and its moment about `pole`.
pub fn about_pole(
    state: &State,
    work: &mut Workspace,
    Reaction { kind, point, .. }: &Reaction,
    vector: Vector,
    pole: Point,
) -> (Vector, Vector) {
    match kind {
        LoadKind::Moment => (Vector::ZERO, vector),
        LoadKind::Force => {
            let arm = arm(state, work, *point, pole);
            (vector, work.cross(arm, vector))
        }
    }
}

/// The known part of each reaction: its force, and its moment about `pole`.
pub fn known_parts(model: &Model, work: &mut Workspace, pole: Point) -> Vec<(Vector, Vector)> {
    let parts = model.reactions.iter().map(|reaction| {
        let known = work.vector(reaction.frame, reaction.known);
        about_pole(&model.state, work, reaction, known, pole)
    });
    parts.collect()
}

/// The point of the body at which a uniform field acts, if the load is one: a field force that is
/// fixed in axes that do not rotate, and does not depend on position, attitude or velocity.
pub fn uniform_field(work: &Workspace, body: Frame, load: &Load) -> Option<Components> {
    let graph: &Graph = &work.graph;
    let of_state = |id: Id| match work.meaning(id) {
        Some(
            Meaning::Time
            | Meaning::Param(..)
            | Meaning::Constant(_)
            | Meaning::Input(..)
            | Meaning::Own(_)
            | Meaning::Mass(_),
        )
        | None => false,
        Some(_) => true,
    };
    let offset = load.point.offset(body)?;
    let force = load.force;
    let is_uniform = load.family == Family::Field
        && load.potential.is_none()
        && load.moment.is_zero()
        && !graph.depends_on(&work.entries(&[force]), of_state)
        && !graph.depends_on(&work.turning(force), of_state);
    is_uniform.then_some(offset)
}
