//! Regressors: how the loads of a motion depend on inertial parameters.
//!
//! ```text
//! f = m a + ([w']x + w w - w^2 1) h            a: acceleration of a point P of the body, less that
//! n = J w' + w x J w + h x a                      of free fall; h = m c: first moment about P
//! ```
//!
//! Both are linear in m, h and J about P, so the columns are the loads per unit of each parameter
//! (Atkeson, An and Hollerbach, Estimation of inertial parameters of manipulator loads and links,
//! 1986).

use crate::mechanics::tree::{LinkMotion, Properties, SpatialVector};
use crate::model::{Frame, Meaning, Model, Motion, Variable, Vector, Workspace};
use crate::symbolic::Id;

use super::falls::falls;

/// The regressor of one body.
pub struct Regressor {
    /// For each parameter, one entry per balance.
    pub columns: Vec<Vec<Id>>,
    /// The value of each parameter for this body.
    pub parameters: Vec<Id>,
}

impl Regressor {
    pub fn roots(&self) -> Vec<Id> {
        [self.columns.concat(), self.parameters.clone()].concat()
    }
}

/// All parameters, in the order of [`Properties::entries`].
const ALL: [&str; 10] = [
    "m", "m c_x", "m c_y", "m c_z", "J_xx", "J_yy", "J_zz", "J_xy", "J_yz", "J_zx",
];

/// The indices, among all parameters, of those that a motion may reveal. A rod has other
/// parameters.
pub fn told(motion: Motion) -> &'static [usize] {
    const NUMBERS: [usize; 10] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9];
    if !motion.has_attitude() {
        &NUMBERS[..1]
    } else if !motion.knows_position() {
        &NUMBERS[4..]
    } else if motion.is_planar {
        &[0, 1, 2, 6]
    } else {
        &NUMBERS
    }
}

/// The names of the parameters that a motion may reveal.
pub fn inertial_parameters(motion: Motion) -> Vec<&'static str> {
    if motion.is_line() {
        return vec!["m", "m c", "J"];
    }
    told(motion).iter().map(|number| ALL[*number]).collect()
}

/// The regressor about the held point, or about G.
pub fn derive_regressor(model: &Model, work: &mut Workspace) -> Regressor {
    if model.motion.is_line() {
        return of_rod(model, work);
    }
    let state = model.state;
    let mut linear = fall_against(model, work);
    if state.support.is_none() {
        linear = work.add(linear, state.acceleration);
    }
    let linear = work.components(linear, state.body);
    let linear = work.graph.quantities(linear);
    let angular = state.angular_acceleration;
    let graph = &mut work.graph;
    let moving = LinkMotion::new(
        graph,
        state.angular_velocity,
        SpatialVector { angular, linear },
    );
    let units = Properties::units(graph);
    let columns = told(model.motion).iter().map(|number| {
        let taken = moving.taken_by(&mut work.graph, &units[*number]);
        rows(model, work, taken)
    });
    let columns = columns.collect();
    let graph = &mut work.graph;
    let offset = state.support.map_or(graph.zeros(), |held| held.offset);
    let center = graph.negate_vector(offset);
    let inertia = model.inertia.rows(graph);
    let mass = model.mass.unwrap_or(graph.zero());
    let entries = Properties::of_body(graph, mass, center, &inertia).entries();
    let parameters = told(model.motion).iter();
    let parameters = parameters.map(|number| graph.result(entries[*number]));
    Regressor {
        columns,
        parameters: parameters.collect(),
    }
}

/// The regressor of a rod, which has one first moment, along its axis u, and one moment of inertia,
/// across it.
fn of_rod(model: &Model, work: &mut Workspace) -> Regressor {
    let state = model.state;
    let fall = fall_against(model, work);
    let linear = work.add(fall, state.acceleration);
    let linear = work.components(linear, Frame::WORLD);
    let linear = work.graph.quantities(linear);
    let unit = state.axis.map_or(work.graph.zeros(), |axis| axis.unit);
    let rate = [0, 1, 2].map(|part| {
        let meaning = Meaning::Of(state.body, Variable::AxisAcceleration, part);
        work.symbol_of(meaning).unwrap_or(work.graph.zero())
    });
    let zeros = work.graph.zeros();
    let lever = work.graph.cross(unit, linear);
    let columns = [
        (linear, zeros),
        (rate, lever),
        (zeros, state.angular_acceleration),
    ];
    let columns =
        columns.map(|(linear, angular)| rows(model, work, SpatialVector { angular, linear }));
    let zero = work.graph.zero();
    let mass = model.mass.unwrap_or(zero);
    let moments = model.inertia_entries();
    let moment = moments.first().copied().unwrap_or(zero);
    Regressor {
        columns: columns.into(),
        parameters: [mass, zero, moment]
            .map(|one| work.graph.result(one))
            .into(),
    }
}

/// The negative of the acceleration of free fall.
fn fall_against(model: &Model, work: &mut Workspace) -> Vector {
    let falls = falls(work, model.unweighed.as_ref());
    let fall = falls.first().copied().unwrap_or(work.graph.zeros());
    let against = work.graph.negate_vector(fall);
    work.vector(Frame::WORLD, against)
}

/// The components along which the body moves.
fn rows(model: &Model, work: &mut Workspace, taken: SpatialVector) -> Vec<Id> {
    let graph = &mut work.graph;
    if let Some(direction) = model.hinge(graph) {
        let along = graph.dot(direction, taken.angular);
        return vec![graph.result(along)];
    }
    let motion = model.motion;
    let linear = taken.linear[motion.linear_axes()].iter();
    let all = linear.chain(&taken.angular[motion.angular_axes()]);
    all.map(|row| graph.result(*row)).collect()
}
