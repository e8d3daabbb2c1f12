//! The acceleration of free fall of each body: the part of its uniform fields that is proved to be
//! proportional to its mass, per unit of mass.
//!
//! The proof needs the description read with unknown masses. A force `F = m g + r` has such a part
//! if `g = dF/dm` depends on no mass and no moment of inertia, nor on anything that they are
//! computed from. If a mass is computed from parameters, a force written with them is proportional
//! to mass if its ratio to the mass depends on none of them, and so is the part of it that leaves a
//! force without them.

use std::collections::HashSet;

use crate::mechanics::balances::uniform_field;
use crate::mechanics::proofs::all_vanish;
use crate::model::{Frame, Shared, Unweighed, UnweighedBody, Workspace};
use crate::symbolic::{Components, Id, Node};

/// The accelerations, in world axes, body by body.
pub fn falls(work: &mut Workspace, unweighed: Option<&Shared>) -> Vec<Components> {
    let Some(unweighed) = unweighed else {
        return Vec::new();
    };
    let Unweighed {
        work: apart,
        bodies,
    } = &mut *unweighed.borrow_mut();
    let masses = apart.unknown_masses.clone().unwrap_or_default();
    let made_of = masses.iter().map(|(_, written)| *written);
    let made_of = made_of.chain(bodies.iter().flat_map(|body| body.inertia.iter().copied()));
    let mut given: HashSet<Id> = symbols(apart, &made_of.collect::<Vec<Id>>()).collect();
    given.extend(masses.iter().map(|(symbol, _)| *symbol));
    let all = bodies.iter().map(|body| {
        let mass = masses.iter().find(|(symbol, _)| Some(*symbol) == body.mass);
        let fall = mass.map(|mass| fall(apart, body, *mass, &given));
        let known = fall.and_then(|fall| carried_over(apart, fall, work));
        known.unwrap_or(work.graph.zeros())
    });
    all.collect()
}

/// The sum of the accelerations in all fields of a body.
fn fall(
    work: &mut Workspace,
    body: &UnweighedBody,
    (mass, written): (Id, Id),
    given: &HashSet<Id>,
) -> Components {
    let mut sum = work.graph.zeros();
    for field in &body.fields {
        let offset = uniform_field(work, body.frame, field);
        if offset.is_none_or(|offset| !work.graph.is_zero_vector(&offset)) {
            continue;
        }
        let mut force = work.components(field.force, Frame::WORLD);
        // a parameter that is the mass is one word more for it
        if matches!(work.graph.node(written), Node::Symbol(_)) {
            force = work.graph.replaced(force, &[(written, mass)]);
        }
        if let Some(part) = per_mass(work, force, (mass, written), given) {
            sum = work.graph.add_vectors(sum, part);
        }
    }
    sum
}

/// The part of a force that is proportional to mass, per unit of mass. `None` if the force is not
/// linear in the mass.
fn per_mass(
    work: &mut Workspace,
    force: Components,
    (mass, written): (Id, Id),
    given: &HashSet<Id>,
) -> Option<Components> {
    let slope = derivative(work, force, mass).filter(|slope| is_free(work, slope, given))?;
    let zero = work.graph.zero();
    let rest = work.graph.replaced(force, &[(mass, zero)]);
    // conditions and steps have no slope, and the rest may still depend on the mass in them
    let made = work.graph.scale_vector(mass, slope);
    let made = work.graph.add_vectors(made, rest);
    let differences = work.graph.subtract_vectors(force, made);
    if !all_vanish(work, &differences) {
        return None;
    }
    let further = ratio(work, rest, written, given).unwrap_or(work.graph.zeros());
    Some(work.graph.add_vectors(slope, further))
}

/// The ratio of a force to a mass that is computed from parameters, apart from a force that does not
/// depend on them, if it depends on none of them.
fn ratio(
    work: &mut Workspace,
    force: Components,
    mass: Id,
    given: &HashSet<Id>,
) -> Option<Components> {
    if work.graph.is_zero_vector(&force) {
        return None;
    }
    let whole = force.map(|part| work.graph.divide(part, mass));
    let params: Vec<Id> = symbols(work, &[mass]).collect();
    if !params.is_empty() && is_free(work, &whole, given) {
        return Some(whole);
    }
    params.into_iter().find_map(|param| {
        let slope = derivative(work, force, param)?;
        let by_mass = *work.graph.derivative(&[mass], param).first()?;
        let graph = &mut work.graph;
        let ratio = slope.map(|slope| graph.divide(slope, by_mass));
        let made = graph.scale_vector(mass, ratio);
        let rest = graph.subtract_vectors(force, made);
        (is_free(work, &ratio, given) && is_independent(work, rest, given)).then_some(ratio)
    })
}

/// Whether a vector is proved to be the same for all values of these symbols.
fn is_independent(work: &mut Workspace, vector: Components, given: &HashSet<Id>) -> bool {
    let one = work.graph.one();
    let ones: Vec<(Id, Id)> = given.iter().map(|symbol| (*symbol, one)).collect();
    let there = work.graph.replaced(vector, &ones);
    let differences = work.graph.subtract_vectors(vector, there);
    all_vanish(work, &differences)
}

fn derivative(work: &mut Workspace, vector: Components, by: Id) -> Option<Components> {
    work.graph.derivative(&vector, by).try_into().ok()
}

/// Whether expressions have values that depend on none of these symbols.
fn is_free(work: &Workspace, parts: &[Id], given: &HashSet<Id>) -> bool {
    let graph = &work.graph;
    let mut nodes = graph.nodes_of(parts).into_iter();
    !nodes.any(|id| given.contains(&id) || graph.is_undefined(id))
}

fn symbols(work: &Workspace, roots: &[Id]) -> impl Iterator<Item = Id> {
    let nodes = work.graph.nodes_of(roots).into_iter();
    nodes.filter(|id| matches!(work.graph.node(*id), Node::Symbol(_)))
}

/// The same expressions in the workspace of the description, where masses are known. `None` if it
/// lacks a symbol.
fn carried_over(apart: &Workspace, parts: Components, work: &mut Workspace) -> Option<Components> {
    let symbols = symbols(apart, &parts).map(|id| {
        let known = work.symbol_of(apart.meaning(id)?)?;
        Some((id, known))
    });
    let symbols: Option<Vec<(Id, Id)>> = symbols.collect();
    let symbols = symbols?;
    let tape = apart.graph.tape(&parts);
    let values = tape.values(&mut work.graph, |graph, id| {
        let known = symbols.iter().find(|(symbol, _)| *symbol == id);
        known.map_or_else(|| graph.undefined(), |(_, known)| *known)
    });
    Some(parts.map(|part| *tape.of(&values, part)))
}
