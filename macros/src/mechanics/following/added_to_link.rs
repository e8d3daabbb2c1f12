//! The inertia that the loads on one body add: minus their slopes along its acceleration.

use crate::mechanics::tree::{LinkMotion, SpatialInertia, SpatialVector, wrench};
use crate::model::{Defaults, Felt, Load, Member, Property, Workspace};
use crate::symbolic::{Components, Graph, Id, Number};

use super::definite::{is_by_default, is_not_negative, pivots_of_sum, unknown_signs};

/// The inertia that the loads on a link add, in its axes.
pub struct AddedToLink {
    pub about_center: SpatialInertia,
    /// From the origin of the link to G.
    pub center: Components,
    /// The loads of a link that does not accelerate, about G.
    rest: SpatialVector,
    /// What `new` checks for the parameters.
    pub conditions: Vec<Property>,
}

impl AddedToLink {
    pub fn of(
        work: &mut Workspace,
        (body, felt): (&Member, &Felt),
        pin: Components,
        (masses, defaults): (&[Id], &Defaults),
    ) -> Option<Self> {
        let (follow, known): (Vec<&Load>, Vec<&Load>) =
            body.loads.iter().partition(|load| load.follows(work));
        let names = follow.iter().map(|load| &load.name);
        let all: Vec<&Load> = known.into_iter().chain(&felt.loads).collect();
        // no load was added later, or depends on the acceleration of anything else
        if !names.eq(felt.loads.iter().map(|load| &load.name))
            || all.iter().any(|load| load.follows(work))
        {
            return None;
        }
        let zeros = work.graph.zeros();
        let (force, moment) = wrench(work, body, all.iter().copied(), zeros);
        // `signum(a)` has slope zero, and would look constant
        let symbols = felt.acceleration.concat();
        if !work.graph.is_linear(&[force, moment].concat(), &symbols) {
            return None;
        }
        let columns = columns(work, (body, felt), &all, zeros);
        let is_constant = columns
            .iter()
            .flatten()
            .all(|one| work.graph.is_early(*one));
        if !is_constant {
            return None;
        }
        let conditions = conditions(work, (body, felt), &columns, (masses, defaults))?;
        let block = |row: usize, column: usize| {
            [0, 1, 2].map(|i| [0, 1, 2].map(|j| columns[3 * column + j][3 * row + i]))
        };
        let (graph, zero) = (&mut work.graph, zeros[0]);
        let still: Vec<(Id, Id)> = symbols.iter().map(|symbol| (*symbol, zero)).collect();
        Some(Self {
            about_center: SpatialInertia {
                angular: block(0, 0),
                mixed: block(0, 1),
                linear: block(1, 1),
            },
            center: graph.negate_vector(pin),
            rest: SpatialVector {
                angular: graph.replaced(moment, &still),
                linear: graph.replaced(force, &still),
            },
            conditions,
        })
    }

    /// The loads on the link about its origin, in this motion.
    pub fn load(&self, graph: &mut Graph, motion: &LinkMotion) -> SpatialVector {
        let acceleration = SpatialVector {
            linear: motion.at(graph, self.center),
            ..motion.acceleration
        };
        let taken = self.about_center.times(graph, &acceleration);
        let load = self.rest.minus(graph, taken);
        let lever = graph.cross(self.center, load.linear);
        SpatialVector {
            angular: graph.add_vectors(load.angular, lever),
            ..load
        }
    }
}

/// The inertia of a body about its G, column by column: the moment and the force for each component
/// of the angular and the linear acceleration.
fn own_inertia(graph: &mut Graph, body: &Member) -> Vec<Vec<Id>> {
    let (rows, zeros) = (body.inertia.rows(graph), graph.zeros());
    let linear = [0, 1, 2].map(|axis| {
        let mut force = zeros;
        force[axis] = body.mass;
        [zeros, force].concat()
    });
    let angular = rows.map(|moment| [moment, zeros].concat());
    angular.into_iter().chain(linear).collect()
}

/// What `new` checks so that loads add an inertia that is not negative; nothing if it is proved. `None`
/// if they do not with the defaults of parameters, or in another form.
fn conditions(
    work: &mut Workspace,
    (body, felt): (&Member, &Felt),
    columns: &[Vec<Id>],
    (masses, defaults): (&[Id], &Defaults),
) -> Option<Vec<Property>> {
    let whole = moving(&work.graph, felt, columns);
    let whole_signs = unknown_signs(&mut work.graph, &whole, masses);
    let each = felt.loads.iter();
    let each = each.map(|load| signs_of_load(work, (body, felt), load, masses));
    let each: Option<Vec<Vec<Id>>> = each.collect();
    let signs = [each.map(|each| each.concat()), whole_signs];
    let mut signs = signs.into_iter().flatten();
    if signs.clone().any(|signs| signs.is_empty()) {
        return Some(Vec::new());
    }
    let graph = &mut work.graph;
    let own = own_inertia(graph, body);
    let own = moving(graph, felt, &own);
    let is_positive = |number: &Number| number.is_positive() && !number.is_undecided();
    let pivots = pivots_of_sum(graph, &own, &whole);
    let pivots = pivots.filter(|pivots| {
        graph.are_early(pivots) && is_by_default(graph, pivots, defaults, is_positive)
    });
    let is_possible = |signs: &Vec<Id>| is_by_default(graph, signs, defaults, is_not_negative);
    let (word, values, may_vanish) = match pivots {
        Some(pivots) => ("inertia with added mass", pivots, false),
        None => ("added mass", signs.find(is_possible)?, true),
    };
    let mut open: Vec<Id> = Vec::new();
    for value in values {
        if work.graph.as_number(value).is_none() && !open.contains(&value) {
            open.push(value);
        }
    }
    let properties = open.into_iter().map(|value| Property {
        of: body.name.clone(),
        word,
        value,
        may_vanish,
    });
    Some(properties.collect())
}

/// The entries of the inertia of a load that must not be negative, about the point where it acts or
/// about G.
fn signs_of_load(
    work: &mut Workspace,
    (body, felt): (&Member, &Felt),
    load: &Load,
    masses: &[Id],
) -> Option<Vec<Id>> {
    let points = [load.point.offset(body.state.body), Some(work.graph.zeros())];
    let mut found: Vec<Vec<Id>> = Vec::new();
    for point in points.into_iter().flatten() {
        let columns = columns(work, (body, felt), &[load], point);
        let moving = moving(&work.graph, felt, &columns);
        found.extend(unknown_signs(&mut work.graph, &moving, masses));
    }
    found.into_iter().min_by_key(Vec::len)
}

/// The rows and columns of the components along which a body can accelerate. In a system, others are
/// zero.
fn moving(graph: &Graph, felt: &Felt, columns: &[Vec<Id>]) -> Vec<Vec<Id>> {
    let symbols = felt.acceleration.concat();
    let moves = |own: &usize| !graph.is_zero(symbols[*own]);
    let there: Vec<usize> = (0..symbols.len()).filter(moves).collect();
    let column = |own: &usize| there.iter().map(|row| columns[*own][*row]).collect();
    there.iter().map(column).collect()
}

/// The inertia that loads on a body add, about a point at this offset from G, column by column:
/// minus the moment and the force by each component of the angular and the linear acceleration.
fn columns(
    work: &mut Workspace,
    (body, felt): (&Member, &Felt),
    loads: &[&Load],
    point: Components,
) -> Vec<Vec<Id>> {
    let (force, moment) = wrench(work, body, loads.iter().copied(), point);
    let graph = &mut work.graph;
    let [angular, linear] = felt.acceleration;
    // the acceleration of G, from that of the point
    let swept = graph.cross(angular, point);
    let of_center = graph.subtract_vectors(linear, swept);
    let given: Vec<(Id, Id)> = linear.into_iter().zip(of_center).collect();
    let parts = [moment, force]
        .map(|part| graph.replaced(part, &given))
        .concat();
    let one = graph.one();
    // in the plane, some components are zero
    let columns = felt.acceleration.concat().into_iter().map(|symbol| {
        let is_there = !graph.is_zero(symbol);
        let slopes = graph.change(&parts, |id| (is_there && id == symbol).then_some(one));
        let slopes = slopes.into_iter();
        slopes.map(|slope| graph.negate(slope)).collect()
    });
    columns.collect()
}
