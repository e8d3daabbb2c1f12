//! Potentials as loads: `F = -dU/dR` and `K = -dU/dphi` (34.2), (34.6).
//!
//! The derivative along a rotation is not taken through the rotation. As the body turns by phi,
//! given in body axes, a vector fixed in the body changes in the world, and one fixed in the world
//! changes in the body, by
//!
//! ```text
//! d(R v) = R (phi x v)        d(R^T v) = -phi x (R^T v)
//! ```
//!
//! so with the slope g of U along the turned vector r, K is `(R^T g) x v` or `r x g`; and along v
//! itself the slope is g, turned back.

use std::collections::{HashMap, HashSet};

use crate::families::{Family, LoadKind};
use crate::model::{Attitude, Form, Frame, Load, Model, Turn, Vector, Workspace};
use crate::symbolic::{Components, Id};

use super::direction::Direction;
use super::slopes::Slopes;
use super::spring_arm;

/// What a potential amounts to.
struct Derived {
    energy: Id,
    force: Vector,
    /// About G, or about the point that is held; body axes.
    moment: Components,
    /// At the axis of a rod, `-dU/du`; world axes.
    pull: Components,
}

/// The potentials become loads, in the form that makes the fewest operations.
pub fn with_potentials(mut model: Model, work: &mut Workspace) -> Model {
    let mut best: Option<(u32, Vec<Derived>)> = None;
    let body = model.state.body;
    for form in &model.potentials.forms {
        let derived: Vec<Derived> = form
            .energies
            .iter()
            .map(|energy| derive(work, body, form, *energy))
            .collect();
        let derived = expand(&model, work, form, &derived);
        let cost = cost(&model, work, &derived);
        if best.as_ref().is_none_or(|(least, _)| cost < *least) {
            best = Some((cost, derived));
        }
    }
    let derived = best.map_or_else(Vec::new, |(_, derived)| derived);
    for (index, derived) in derived.into_iter().enumerate() {
        let load = load(&model, work, index, &derived);
        let place = model.potentials.list[index].place;
        model.loads.insert(place.min(model.loads.len()), load);
    }
    model
}

fn load(model: &Model, work: &mut Workspace, index: usize, derived: &Derived) -> Load {
    let name = model.potentials.list[index].name.clone();
    let in_world = work.part(derived.force, Frame::WORLD);
    let labels = &mut work.labels;
    labels.vector(&format!("{name}_force"), in_world);
    let moment = format!("{name}_moment");
    if model.motion.is_planar {
        labels.name(derived.moment[2], moment);
    } else {
        labels.vector(&moment, derived.moment);
    }
    let center = model.state.center(work);
    Load {
        moment: work.vector(model.state.axes, derived.moment),
        pull: model.state.axis.map(|_| derived.pull),
        potential: Some(derived.energy),
        ..Load::new(name, Family::Field, LoadKind::Force, derived.force, center)
    }
}

/// Late operations of what enters the accelerations.
fn cost(model: &Model, work: &mut Workspace, derived: &[Derived]) -> u32 {
    let mut roots = Vec::new();
    if model.motion.translates() {
        let force = work.sum(derived.iter().map(|one| one.force));
        for (frame, part) in work.parts(force).to_vec() {
            roots.extend(work.turn(part, frame, Frame::WORLD));
        }
    }
    if model.motion.has_attitude() {
        roots.extend(derived.iter().flat_map(|one| one.moment));
    }
    work.graph.late_cost(&roots).total()
}

/// Force and moment, made of turned vectors that are still kept apart.
fn derive(work: &mut Workspace, body: Frame, form: &Form, energy: Id) -> Derived {
    let place = symbols_of_place(work, body, form);
    let mut slopes = Slopes::along_leaves(work, energy, place.clone());
    let mut moment = work.graph.zeros();
    let mut carrying = Vector::ZERO;
    // each vector is made of those that were turned before it
    for turn in form.turns.iter().rev() {
        let slope = slopes.take(work, turn);
        if work.graph.is_zero_vector(&slope) {
            continue;
        }
        let of_turned = moment_along(work, turn, slope);
        moment = work.graph.add_vectors(moment, of_turned);
        if let Some(slope) = carried(work, form, turn, &place, slope) {
            let slope = work.vector(turn.to, slope);
            carrying = work.add(carrying, slope);
        } else {
            slopes.pass_on(work, turn, slope);
        }
    }
    let (direct, pull) = of_attitude(work, body, &slopes);
    let force = slopes.by(work, form.displacement);
    let force = work.vector(Frame::WORLD, force);
    let slope = work.add(carrying, force);
    Derived {
        energy,
        force: work.negate(slope),
        moment: work.graph.add_vectors(moment, direct),
        pull,
    }
}

/// The slope along the position, in body axes, where what was turned into them is the position, or
/// a distance from it: forces of one body are added before they are turned.
fn carried(
    work: &mut Workspace,
    form: &Form,
    turn: &Turn,
    place: &HashSet<Id>,
    slope: Components,
) -> Option<Components> {
    if turn.to == Frame::WORLD {
        return None;
    }
    let graph = &mut work.graph;
    let factor = spring_arm::common_rate(graph, turn.vector, form.displacement, place)?;
    Some(graph.scale_vector(factor, slope))
}

/// The moment that a slope along a turned vector amounts to.
fn moment_along(work: &mut Workspace, turn: &Turn, slope: Components) -> Components {
    if turn.to == Frame::WORLD {
        let back = work.turn(slope, turn.to, turn.from);
        work.graph.cross(back, turn.vector)
    } else {
        let (factor, moment) = spring_arm::moment(work, turn, slope);
        work.graph.scale_vector(factor, moment)
    }
}

/// The symbols that say where the body is: of the displacement, the attitude and turned vectors.
fn symbols_of_place(work: &Workspace, body: Frame, form: &Form) -> HashSet<Id> {
    let mut symbols: HashSet<Id> = form.displacement.into_iter().collect();
    symbols.extend(form.turns.iter().flat_map(|turn| turn.turned));
    symbols.extend(work.attitude(body).coordinates());
    symbols
}

/// The moment of an energy that was written in terms of the attitude itself, and of a rod the pull
/// at its axis, `-dU/du`.
fn of_attitude(work: &mut Workspace, body: Frame, slopes: &Slopes) -> (Components, Components) {
    if let Attitude::Line { axis, .. } = work.attitude(body) {
        let slope = slopes.by(work, axis);
        let pull = work.graph.negate_vector(slope);
        return (work.graph.cross(axis, pull), pull);
    }
    let moment = work.graph.unit_vectors().map(|e| {
        let back = work.graph.negate_vector(e);
        let back = work.vector(body, back);
        let back = Direction::turn(work, body, back);
        slopes.along(work, &back)
    });
    (moment, work.graph.zeros())
}

/// Puts turned vectors in the place of the symbols that were kept apart, and no displacement where
/// the position is no coordinate. Names go with what they name.
fn expand(model: &Model, work: &mut Workspace, form: &Form, derived: &[Derived]) -> Vec<Derived> {
    let mut values: HashMap<Id, Id> = HashMap::new();
    let zero = work.graph.zero();
    if !model.motion.translates() {
        values.extend(form.displacement.map(|symbol| (symbol, zero)));
    }
    for turn in &form.turns {
        let vector = replace(work, &turn.vector, &values);
        let turned = work.turn([vector[0], vector[1], vector[2]], turn.from, turn.to);
        values.extend(turn.turned.into_iter().zip(turned));
    }
    let roots: Vec<Id> = derived
        .iter()
        .flat_map(|one| {
            let force = work.entries(&[one.force]);
            [&[one.energy], force.as_slice(), &one.moment, &one.pull].concat()
        })
        .collect();
    let mut images = replace(work, &roots, &values).into_iter();
    let mut image = |id: Id| images.next().unwrap_or(id);
    let expanded = derived.iter().map(|one| Derived {
        energy: image(one.energy),
        force: work.map(one.force, |_, part| part.map(&mut image)),
        moment: one.moment.map(&mut image),
        pull: one.pull.map(&mut image),
    });
    expanded.collect()
}

fn replace(work: &mut Workspace, roots: &[Id], values: &HashMap<Id, Id>) -> Vec<Id> {
    let labels = &work.labels;
    let graph = &mut work.graph;
    let named = graph.reachable(roots, |_| true).into_iter();
    let named: Vec<Id> = named.filter(|id| labels.get(*id).is_some()).collect();
    let all: Vec<Id> = roots.iter().copied().chain(named.iter().copied()).collect();
    let mut images = graph.substitute(&all, |id| values.get(&id).copied());
    let named_images = images.split_off(roots.len());
    let labels = &mut work.labels;
    for (id, image) in named.into_iter().zip(named_images) {
        if let Some(name) = labels.get(id).map(str::to_owned) {
            labels.name(image, name);
        }
    }
    images
}
