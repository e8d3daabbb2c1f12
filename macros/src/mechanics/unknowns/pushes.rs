//! The effect of one unit of each unknown: its own load, the loads that depend on it, and the
//! acceleration that these cause.
//!
//! A load may name an unknown reaction R, as friction does with `-mu R`. It is then linear in R:
//! `F(R) = F(known) + sum of u_j dF/dR . e_j`.

use crate::errors::Extent;
use crate::families::Family;
use crate::mechanics::balances::{free_moment, response};
use crate::mechanics::proofs::all_vanish;
use crate::model::{Frame, Load, Model, Pair, Reaction, Workspace};
use crate::symbolic::{Components, Id, Node};

use super::unit::Unit;

/// One unit of an unknown, and its effect under constraints.
pub struct Push<'m> {
    pub unit: Unit<'m>,
    /// Whether another load depends on it.
    pub is_followed: bool,
    /// Its load, along the free directions of the body.
    pub free: Pair,
    /// Whether it acts at the held point, so that by itself it causes no acceleration.
    pub supports: bool,
    /// The acceleration that it causes.
    pub accelerations: Pair,
}

/// The loads without the unknowns: the given loads and the known parts of reactions, with the
/// unknowns set to zero.
pub fn known_loads(model: &Model, work: &mut Workspace) -> Vec<Load> {
    let mut values = Vec::new();
    let mut loads = Vec::new();
    for reaction in &model.reactions {
        let known = work.vector(reaction.frame, reaction.known);
        let in_world = work.components(known, Frame::WORLD);
        values.extend(symbols(work, reaction).into_iter().zip(in_world));
        let (name, family) = (reaction.name.clone(), Family::Reaction);
        loads.push(Load::new(
            name,
            family,
            reaction.kind,
            known,
            reaction.point,
        ));
    }
    for load in &model.loads {
        let mut without = |vector| work.map(vector, |graph, part| graph.replaced(part, &values));
        loads.push(load.with(without(load.force), without(load.moment)));
    }
    loads
}

/// The symbols of the components of a reaction; zero where it has none.
fn symbols(work: &Workspace, reaction: &Reaction) -> Components {
    work.part(reaction.symbols, Frame::WORLD)
}

/// The effect of each unknown.
pub fn pushes<'m>(model: &'m Model, work: &mut Workspace) -> Vec<Push<'m>> {
    let mut pushes = Vec::new();
    for reaction in &model.reactions {
        for unknown in &reaction.unknown {
            pushes.push(push(model, work, reaction, *unknown));
        }
    }
    pushes
}

fn push<'m>(
    model: &'m Model,
    work: &mut Workspace,
    reaction: &'m Reaction,
    unknown: (usize, Extent),
) -> Push<'m> {
    let followers = followers(model, work, reaction, unknown.0);
    let mut pushed = |followers: &[Load]| {
        let unit = Unit::new(model, work, reaction, reaction.frame, unknown, followers);
        let free = free_load(model, work, &unit);
        (unit, free, response(model, work, free))
    };
    let (unit, free, accelerations) = pushed(&followers);
    let is_followed = !followers.is_empty();
    let alone = if is_followed {
        pushed(&[]).2
    } else {
        accelerations
    };
    Push {
        unit,
        is_followed,
        free,
        supports: model.motion.is_supported() && all_vanish(work, &alone.entries()),
        accelerations,
    }
}

/// The part of a load that moves the body.
pub fn free_load(model: &Model, work: &mut Workspace, unit: &Unit<'_>) -> Pair {
    let force = work.components(unit.force, Frame::WORLD);
    let moment = if model.motion.has_attitude() {
        let moment = work.components(unit.moment, model.state.body);
        free_moment(model, work, moment)
    } else {
        work.graph.zeros()
    };
    Pair {
        linear: force,
        angular: moment,
    }
}

/// What the loads that depend on a reaction become per unit along one of its axes.
fn followers(model: &Model, work: &mut Workspace, reaction: &Reaction, axis: usize) -> Vec<Load> {
    let direction = reaction.direction(work, reaction.frame, axis);
    let unit = work.components(direction, Frame::WORLD);
    let symbols = symbols(work, reaction);
    let mut followers = Vec::new();
    for load in model.loads.iter().filter(|load| load.mention.is_some()) {
        let roots = work.entries(&[load.force, load.moment]);
        let graph = &mut work.graph;
        let mut changes = vec![graph.zero(); roots.len()];
        for (symbol, part) in symbols.into_iter().zip(unit) {
            if matches!(graph.node(symbol), Node::Symbol(_)) && !graph.is_zero(part) {
                let slopes = graph.derivative(&roots, symbol);
                for (change, slope) in changes.iter_mut().zip(slopes) {
                    let term = graph.multiply(slope, part);
                    *change = graph.add(*change, term);
                }
            }
        }
        if changes.iter().any(|change| !graph.is_zero(*change)) {
            let mut changes = changes.into_iter();
            let mut change = |id: Id| changes.next().unwrap_or(id);
            let [force, moment] = [load.force, load.moment]
                .map(|vector| work.map(vector, |_, part| part.map(&mut change)));
            followers.push(load.with(force, moment));
        }
    }
    followers
}
