//! Potentials as loads: `F = -dU/dR` and `K = -dU/dphi` (34.2), (34.6).
//!
//! The rotation itself is not differentiated. As the body rotates by phi, given in body axes, a
//! vector fixed in the body changes in the world, and a vector fixed in the world changes in the
//! body, by
//!
//! ```text
//! d(R v) = R (phi x v)        d(R^T v) = -phi x (R^T v)
//! ```
//!
//! So if U has the slope g along the rotated vector r, K is `(R^T g) x v` or `r x g`. The slope
//! along v itself is g, rotated back.

use std::collections::{HashMap, HashSet};

use crate::families::{Family, LoadKind};
use crate::model::{Attitude, Displaced, Form, Frame, Load, Model, Turn, Vector, Workspace};
use crate::symbolic::{Components, Id};

use super::direction::Direction;
use super::slopes::Slopes;
use super::spring_arm;

/// What becomes of a potential.
pub struct Derived {
    pub energy: Id,
    /// The load on each body of the form.
    pub on: Vec<Draw>,
    /// The load along each joint coordinate, `-dU/dq`.
    pub along: Vec<Id>,
}

/// The load of a potential on a body.
#[derive(Clone, Copy)]
pub struct Draw {
    pub force: Vector,
    /// The moment about G or about the held point, in body axes.
    pub moment: Components,
    /// The pull at the axis of a rod, `-dU/du`, in world axes.
    pub pull: Components,
}

/// Turns potentials into loads, in the form with the fewest operations.
pub fn with_potentials(mut model: Model, work: &mut Workspace) -> Model {
    let mut best: Option<(u32, Vec<Draw>, Vec<Id>)> = None;
    for form in &model.potentials.forms {
        let derived = derive_form(work, form);
        let draws: Vec<Draw> = derived.iter().flat_map(|one| one.on.clone()).collect();
        let cost = cost(&model, work, &draws);
        if best.as_ref().is_none_or(|(least, ..)| cost < *least) {
            let energies = derived.iter().map(|one| one.energy).collect();
            best = Some((cost, draws, energies));
        }
    }
    let (_, draws, energies) = best.unwrap_or_default();
    for (index, (draw, energy)) in draws.into_iter().zip(energies).enumerate() {
        let load = load(&model, work, index, &draw, energy);
        let place = model.potentials.list[index].place;
        model.loads.insert(place.min(model.loads.len()), load);
    }
    model
}

/// The loads of the potentials of a form.
pub fn derive_form(work: &mut Workspace, form: &Form) -> Vec<Derived> {
    let energies = form.values.iter();
    let derived: Vec<Derived> = energies.map(|energy| derive(work, form, *energy)).collect();
    expand(work, form, &derived)
}

fn load(model: &Model, work: &mut Workspace, index: usize, derived: &Draw, energy: Id) -> Load {
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
        potential: Some(energy),
        ..Load::new(name, Family::Field, LoadKind::Force, derived.force, center)
    }
}

/// The number of late operations of the expressions that the accelerations contain.
fn cost(model: &Model, work: &mut Workspace, derived: &[Draw]) -> u32 {
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

/// The forces and moments of a potential, in terms of rotated vectors that are still kept apart.
pub fn derive(work: &mut Workspace, form: &Form, energy: Id) -> Derived {
    let place = symbols_of_place(work, form);
    let mut slopes = Slopes::along_leaves(work, energy, place.clone());
    let mut moments = vec![work.graph.zeros(); form.bodies.len()];
    let mut carrying = vec![Vector::ZERO; form.bodies.len()];
    // each vector contains only those that were rotated before it
    for turn in form.turns.iter().rev() {
        let slope = slopes.take(work, turn);
        if work.graph.is_zero_vector(&slope) {
            continue;
        }
        let Some(number) = body_of(form, turn) else {
            // the axes that it was rotated into are held, but the vector may still depend on the
            // place
            slopes.pass_on(work, turn, slope);
            continue;
        };
        let of_turned = moment_along(work, turn, slope);
        moments[number] = work.graph.add_vectors(moments[number], of_turned);
        let displacement = form.bodies[number].displacement;
        if let Some(slope) = carried(work, displacement, turn, &place, slope) {
            let slope = work.vector(turn.to, slope);
            carrying[number] = work.add(carrying[number], slope);
        } else {
            slopes.pass_on(work, turn, slope);
        }
    }
    let mut on = Vec::new();
    for (displaced, (moment, carrying)) in form.bodies.iter().zip(moments.into_iter().zip(carrying))
    {
        let (direct, pull) = of_attitude(work, displaced, &slopes);
        let force = slopes.by(work, displaced.displacement);
        let force = work.vector(Frame::WORLD, force);
        let slope = work.add(carrying, force);
        on.push(Draw {
            force: work.negate(slope),
            moment: work.graph.add_vectors(moment, direct),
            pull,
        });
    }
    let along = form.along.iter().map(|freedom| {
        let slope = freedom.place.map(|place| slopes.by_symbol(work, place));
        let slope = slope.unwrap_or(work.graph.zero());
        work.graph.negate(slope)
    });
    let along = along.collect();
    Derived { energy, on, along }
}

/// The index of the body whose axes a vector was rotated from or into.
fn body_of(form: &Form, turn: &Turn) -> Option<usize> {
    let frame = if turn.to == Frame::WORLD {
        turn.from
    } else {
        turn.to
    };
    form.bodies.iter().position(|known| known.body == frame)
}

/// The slope along the position, in body axes, if the position, or a distance from it, is the
/// vector that was rotated into them. So forces of one body are added before they are rotated.
fn carried(
    work: &mut Workspace,
    displacement: Components,
    turn: &Turn,
    place: &HashSet<Id>,
    slope: Components,
) -> Option<Components> {
    if turn.to == Frame::WORLD {
        return None;
    }
    let graph = &mut work.graph;
    let factor = spring_arm::common_rate(graph, turn.vector, displacement, place)?;
    Some(graph.scale_vector(factor, slope))
}

/// The moment equivalent to a slope along a rotated vector.
fn moment_along(work: &mut Workspace, turn: &Turn, slope: Components) -> Components {
    if turn.to == Frame::WORLD {
        let back = work.turn(slope, turn.to, turn.from);
        work.graph.cross(back, turn.vector)
    } else {
        let (factor, moment) = spring_arm::moment(work, turn, slope);
        work.graph.scale_vector(factor, moment)
    }
}

/// The symbols that determine where the bodies are: those of displacements, attitudes, rotated
/// vectors and joints.
fn symbols_of_place(work: &Workspace, form: &Form) -> HashSet<Id> {
    let places = form.along.iter().filter_map(|freedom| freedom.place);
    let mut symbols: HashSet<Id> = places.collect();
    for displaced in &form.bodies {
        symbols.extend(displaced.displacement);
        symbols.extend(displaced.angle);
        if displaced.has_own_attitude {
            symbols.extend(work.attitude(displaced.body).coordinates());
        }
    }
    // each vector contains only vectors that were rotated before it
    for turn in &form.turns {
        let moves = |id: Id| symbols.contains(&id);
        if body_of(form, turn).is_some() || work.graph.depends_on(&turn.vector, moves) {
            symbols.extend(turn.turned);
        }
    }
    symbols
}

/// The moment of an energy that is written with the attitude itself; for a rod, the pull at its
/// axis, `-dU/du`.
fn of_attitude(
    work: &mut Workspace,
    displaced: &Displaced,
    slopes: &Slopes,
) -> (Components, Components) {
    let (body, zeros) = (displaced.body, work.graph.zeros());
    if let Some(angle) = displaced.angle {
        let slope = slopes.by_symbol(work, angle);
        let moment = work.graph.negate(slope);
        return ([zeros[0], zeros[1], moment], zeros);
    }
    if !displaced.has_own_attitude {
        return (zeros, zeros);
    }
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
    (moment, zeros)
}

/// Replaces symbols that were kept apart by the rotated vectors, and other symbols by the
/// expressions that they stand for. Named expressions keep their names.
pub fn expand(work: &mut Workspace, form: &Form, derived: &[Derived]) -> Vec<Derived> {
    let mut values: HashMap<Id, Id> = form.stands_for.iter().copied().collect();
    for turn in &form.turns {
        let vector = replace(work, &turn.vector, &values);
        let turned = work.turn([vector[0], vector[1], vector[2]], turn.from, turn.to);
        values.extend(turn.turned.into_iter().zip(turned));
    }
    let mut roots = Vec::new();
    for one in derived {
        roots.push(one.energy);
        for draw in &one.on {
            let force = work.entries(&[draw.force]);
            roots.extend([force.as_slice(), &draw.moment, &draw.pull].concat());
        }
        roots.extend(&one.along);
    }
    let mut images = replace(work, &roots, &values).into_iter();
    let mut image = |id: Id| images.next().unwrap_or(id);
    let mut expanded = Vec::new();
    for one in derived {
        let energy = image(one.energy);
        let draws = one.on.iter().map(|draw| Draw {
            force: work.map(draw.force, |_, part| part.map(&mut image)),
            moment: draw.moment.map(&mut image),
            pull: draw.pull.map(&mut image),
        });
        let on = draws.collect();
        let along = one.along.iter().map(|slope| image(*slope)).collect();
        expanded.push(Derived { energy, on, along });
    }
    expanded
}

fn replace(work: &mut Workspace, roots: &[Id], values: &HashMap<Id, Id>) -> Vec<Id> {
    let labels = &work.labels;
    let graph = &mut work.graph;
    let named = graph.nodes_of(roots).into_iter();
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
