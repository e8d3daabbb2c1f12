//! The accelerations of a system with loops, and the loads of the joints that close them.

use crate::mechanics::proofs::samples;
use crate::mechanics::tree::link::Tree;
use crate::mechanics::tree::{Built, MassMatrix};
use crate::model::{Closing, Frame, System, Workspace};
use crate::symbolic::{Components, Equation, Graph, Id, Size};

use super::rows::{Ends, Row, rows};
use super::world::{Placed, place_links};

/// What is known of a system with loops.
pub struct Closed {
    /// Of the open freedoms, link by link.
    pub accelerations: Vec<Vec<Id>>,
    pub constraints: Vec<Row>,
    /// Of the mass matrix of the tree: what each freedom has alone.
    pub inertias: Vec<Id>,
    /// Force and moment of each joint that closes a loop on what it carries, at its point there, world
    /// axes.
    pub wrenches: Vec<[Components; 2]>,
    /// The tree with these loads on its links.
    pub loaded: Tree,
    /// The joints whose loads the equations do not determine.
    pub undetermined: Vec<usize>,
}

/// Closes all loops; what the tree is written like does not matter, but the origins of its links are
/// at their joints.
pub fn close(system: &System, work: &mut Workspace, built: &Built) -> Closed {
    let tree = moved_in_world(work, &built.tree);
    let placed = {
        let free: Vec<Option<[Components; 2]>> = free_links(system, work, built);
        place_links(&mut work.graph, &built.tree, |link| free[link])
    };
    let ends: Vec<Ends<'_>> = system
        .closings
        .iter()
        .map(|closing| ends(system, work, built, closing))
        .collect();
    let (mut constraints, mut undetermined) = (Vec::new(), Vec::new());
    for (number, ends) in ends.iter().enumerate() {
        let rows = rows(&mut work.graph, &built.tree, &placed, ends);
        for row in rows {
            // what holds in all states, as parallel axes in space do, says nothing, and has any load
            let parts = [row.slopes.clone(), vec![row.value, row.rate, row.bias]].concat();
            let is_idle = parts.iter().all(|part| work.graph.vanishes(*part));
            if is_idle {
                undetermined.push(number);
            } else {
                constraints.push((number, row));
            }
        }
    }
    let matrix = MassMatrix::derive(&mut work.graph, &mut work.labels, &tree);
    let (count, loads) = (matrix.driving.len(), constraints.len());
    let rows: Vec<&Row> = constraints.iter().map(|(_, row)| row).collect();
    let equations = equations(work, &matrix, &rows);
    let solved = work.graph.solve(equations, count + loads);
    let open = solved.undetermined.iter();
    let open = open.filter_map(|one| Some(constraints.get(one.column.checked_sub(count)?)?.0));
    undetermined.extend(open);
    let mut found = solved.values.into_iter();
    let links = built.tree.links.iter();
    let accelerations = links.map(|link| found.by_ref().take(link.open().count()).collect());
    let accelerations = accelerations.collect();
    let loads: Vec<Id> = found.collect();
    let zeros = work.graph.zeros();
    let mut wrenches = vec![[zeros; 2]; ends.len()];
    for ((number, row), load) in constraints.iter().zip(loads) {
        for (sum, unit) in wrenches[*number].iter_mut().zip([row.force, row.moment]) {
            let part = work.graph.scale_vector(load, unit);
            *sum = work.graph.add_vectors(*sum, part);
        }
    }
    let mut loaded = built.tree.clone();
    for (ends, wrench) in ends.iter().zip(&wrenches) {
        push(&mut work.graph, &mut loaded, &placed, ends, *wrench);
    }
    Closed {
        accelerations,
        constraints: constraints.into_iter().map(|(_, row)| row).collect(),
        inertias: (0..count)
            .map(|freedom| matrix.rows[freedom][freedom])
            .collect(),
        wrenches,
        loaded,
        undetermined,
    }
}

/// `M q'' - A^T l = f` and `A q'' = -b`, for the accelerations and then the loads.
fn equations(work: &mut Workspace, matrix: &MassMatrix, constraints: &[&Row]) -> Vec<Equation> {
    let loads = constraints.len();
    let zero = work.graph.zero();
    let mut sides = Vec::new();
    for (freedom, row) in matrix.rows.iter().enumerate() {
        let slopes = constraints.iter().map(|row| row.slopes[freedom]);
        let of_loads: Vec<Id> = slopes.map(|slope| work.graph.negate(slope)).collect();
        let coefficients = [row.clone(), of_loads].concat();
        sides.push((coefficients, matrix.driving[freedom], Some(freedom)));
    }
    for row in constraints {
        let coefficients = [row.slopes.clone(), vec![zero; loads]].concat();
        sides.push((coefficients, work.graph.negate(row.bias), None));
    }
    let all: Vec<Id> = sides.iter().flat_map(|(row, ..)| row.clone()).collect();
    let mut values = samples(work, &all).into_iter();
    let equations = sides.into_iter().map(|(coefficients, right, positive)| {
        // the matrix is not definite: what closes loops is eliminated last
        let mut sizes = vec![Size::Beside; coefficients.len()];
        if let Some(freedom) = positive {
            sizes[freedom] = Size::Squares;
        }
        Equation {
            sample: values.by_ref().take(coefficients.len()).collect(),
            sizes,
            active: None,
            coefficients,
            right,
        }
    });
    equations.collect()
}

fn ends<'a>(
    system: &'a System,
    work: &mut Workspace,
    built: &Built,
    closing: &'a Closing,
) -> Ends<'a> {
    let offset = |work: &mut Workspace, body: Option<usize>, place: Components| match body {
        None => place,
        Some(body) => work.graph.subtract_vectors(place, system.joints[body].pin),
    };
    Ends {
        closing,
        links: [closing.carrier, Some(closing.carried)].map(|body| Some(built.body(body?))),
        offsets: [
            offset(work, closing.carrier, closing.place),
            offset(work, Some(closing.carried), closing.pin),
        ],
        is_planar: system.is_planar,
    }
}

/// Puts the load of a joint on both of its links, at its point on the carried one.
fn push(
    graph: &mut Graph,
    tree: &mut Tree,
    placed: &[Placed],
    ends: &Ends<'_>,
    [force, moment]: [Components; 2],
) {
    let Some(carried) = ends.links[1] else { return };
    let place = placed[carried].spot(graph, ends.offsets[1]).place;
    for (link, is_carried) in [(ends.links[0], false), (ends.links[1], true)] {
        let Some(link) = link else { continue };
        let arm = graph.subtract_vectors(place, placed[link].origin);
        let lever = graph.cross(arm, force);
        let about = graph.add_vectors(moment, lever);
        let turning = placed[link].turning;
        let both = [force, about].map(|part| {
            let part = turning.to_link(graph, part);
            let part = graph.quantities(part);
            if is_carried {
                part
            } else {
                graph.negate_vector(part)
            }
        });
        let link = &mut tree.links[link];
        link.force = graph.add_vectors(link.force, both[0]);
        link.moment = graph.add_vectors(link.moment, both[1]);
    }
}

/// The tree with the accelerations of free links along world axes.
pub fn moved_in_world(work: &mut Workspace, tree: &Tree) -> Tree {
    let mut tree = tree.clone();
    for link in tree.links.iter_mut().filter(|link| link.is_free) {
        link.is_free = false;
        for freedom in &mut link.freedoms {
            freedom.twist.linear = link.turning.to_link(&mut work.graph, freedom.twist.linear);
        }
    }
    tree
}

/// Place and velocity of the links that are free, world axes.
fn free_links(
    system: &System,
    work: &mut Workspace,
    built: &Built,
) -> Vec<Option<[Components; 2]>> {
    let mut free = vec![None; built.tree.links.len()];
    for (number, body) in system.bodies.iter().enumerate() {
        let link = built.body(number);
        if built.tree.links[link].is_free {
            let state = [body.state.position, body.state.velocity];
            free[link] = Some(state.map(|vector| work.components(vector, Frame::WORLD)));
        }
    }
    free
}
