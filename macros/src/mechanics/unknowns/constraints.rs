//! Constraints, and the unknown reactions that keep them.
//!
//! ```text
//! g(q, t) = 0         h = g' = A v + ..      position
//!                     h' = A q'' + b = 0     position and velocity
//! q'' = q''_0 + sum of u_j D_j               D_j: the acceleration by one unit of the unknown j
//! sum of (A_i . D_j) u_j = -(A_i . q''_0 + b_i)
//! ```
//!
//! If the reactions point along the gradients of their constraints, `A_i . D_j` is symmetric and
//! positive: each diagonal entry is a sum of squares divided by masses.

use crate::errors::{Errors, Extent};
use crate::mechanics::balances::{EulerForm, check_moment_free, response, rod, solve_balances};
use crate::mechanics::proofs::samples;
use crate::mechanics::variation::Rates;
use crate::model::{Frame, Load, Model, Pair, Vector, Workspace};
use crate::symbolic::{Components, Function, Id, Residue, Sample, Size};

use super::constrained::{Constrained, activity, differentiate};
use super::constraint_checks::{
    check_independent, check_kept, check_misplaced, check_smooth, lost, smooth_support, trivial,
    turned,
};
use super::inertial::{balances_of, inertial_change};
use super::left_over::balances_left;
use super::pushes::{Push, known_loads, pushes};
use super::rows::{Sides, equations};
use super::solvability::{Advice, OF_REACTIONS, check_across, check_determined};
use super::unit::{assemble, name_values, named_result, names};

/// The motion under constraints.
pub struct ConstrainedMotion {
    pub accelerations: Pair,
    pub form: Option<EulerForm>,
    pub constraints: Vec<Constrained>,
    pub reactions: Vec<Components>,
}

/// Accelerations and reactions of a body with constraints.
pub fn derive_constrained(
    model: &Model,
    work: &mut Workspace,
    errors: &mut Errors,
) -> Option<ConstrainedMotion> {
    let constraints = differentiate(model, work);
    check_independent(work, &constraints, errors)?;
    let pushes = pushes(model, work);
    check_smooth(model, work, &constraints, &pushes, errors)?;
    if let Some(axis) = model.state.axis {
        let units = pushes.iter().map(|push| &push.unit);
        check_across(model, work, axis, units, errors)?;
    }
    let loads = known_loads(model, work);
    if let Some(axis) = model.state.axis {
        rod::check_loads(model, work, &loads, axis, errors)?;
    }
    let names_of_free = Some(["free", "free_angular"]);
    let (free, form) = solve_balances(model, work, &loads, Vec::new(), names_of_free);
    let names = names(model, pushes.iter().map(|push| &push.unit));
    let mut rows = Vec::new();
    for constraint in &constraints {
        let row = constraint_row(work, constraint, &pushes, free);
        name_row(work, constraint, &names, &row);
        rows.push(row);
    }
    let left = rows_left(model, work, &pushes, &loads, free, errors)?;
    rows.extend(left.iter().map(|(_, row)| row.clone()));
    let mut system = equations(work, rows);
    let mut all_act = Some(());
    for (equation, constraint) in system.iter_mut().zip(&constraints) {
        let Rates { rate, factors } = &constraint.rates;
        let (level, changes) = (constraint.level(), [constraint.velocity, *rate]);
        let activity = activity(work, &factors.entries(), level, changes);
        if activity.is_lost {
            errors.push(constraint.place.span(), lost(&constraint.name, level));
        } else if activity.is_nowhere(&work.graph) {
            errors.push(constraint.place.span(), trivial(&constraint.name, level));
            all_act = None;
        }
        equation.active = activity.condition;
        equation.sizes = sizes(model, work, constraint, &pushes);
    }
    all_act?;
    let mut elimination = work.graph.solve(system, pushes.len());
    let misplaced = match turned(model, &pushes) {
        Some(_) => Some(()),
        None => check_misplaced(work, &constraints, &names, &mut elimination, errors),
    };
    let left: Vec<&str> = left.iter().map(|(name, _)| *name).collect();
    let mut smooth = constraints.iter().map(|one| smooth_support(work, one));
    let smooth = smooth.find(|advice| !advice.is_empty());
    let zero = format!("{}{}", OF_REACTIONS.zero, smooth.unwrap_or_default());
    let advice = Advice {
        zero: &zero,
        ..OF_REACTIONS
    };
    let determined = check_determined(work, &names, &elimination, |_| advice, errors);
    check_kept(
        model,
        work,
        &constraints,
        &left,
        &pushes,
        &elimination,
        errors,
    )?;
    determined.and(misplaced)?;
    name_values(work, &names, &elimination);
    let Pair { linear, angular } = pushed(work, free, &pushes, &elimination.values);
    let angular = match model.state.axis {
        Some(axis) => rod::of_angular(work, axis, angular),
        None => angular,
    };
    name_accelerations(model, work, linear, angular);
    let reactions = model.reactions.iter().map(|reaction| {
        let units = pushes.iter().map(|push| &push.unit);
        let solved = units.zip(elimination.values.iter().copied());
        let whole = assemble(work, reaction, solved);
        named_result(work, reaction, whole, Frame::WORLD)
    });
    Some(ConstrainedMotion {
        accelerations: Pair { linear, angular },
        form,
        reactions: reactions.collect(),
        constraints,
    })
}

/// `sum of (A . D_j) u_j = -(A . q''_0 + b)`
fn constraint_row(
    work: &mut Workspace,
    constraint: &Constrained,
    pushes: &[Push<'_>],
    free: Pair,
) -> Sides {
    let (graph, factors) = (&mut work.graph, constraint.rates.factors);
    let along = pushes.iter();
    let coefficients = along
        .map(|push| factors.dot(graph, push.accelerations))
        .collect();
    let rest = factors.dot(graph, free);
    let known = graph.add(rest, constraint.rates.rate);
    (coefficients, graph.negate(known))
}

/// Names the parts of the equation of a constraint: its derivatives, the effect of each unknown,
/// and the remainder that the unknowns have to balance.
fn name_row(
    work: &mut Workspace,
    constraint: &Constrained,
    unknowns: &[(String, Extent)],
    (coefficients, right): &Sides,
) {
    let of = constraint.name.replace('.', "_");
    let Pair { linear, angular } = constraint.rates.factors;
    let labels = &mut work.labels;
    labels.name(constraint.velocity, format!("{of}_rate"));
    labels.name(constraint.rates.rate, format!("{of}_drift"));
    labels.vector(&format!("{of}_gradient"), linear);
    labels.vector_or_one(&of, "turning", angular);
    for ((unknown, _), coefficient) in unknowns.iter().zip(coefficients) {
        labels.name(
            *coefficient,
            format!("{of}_by_{}", unknown.replace('.', "_")),
        );
    }
    labels.name(*right, format!("{of}_to_balance"));
}

/// The balances that the free accelerations do not satisfy: the moments about G, for a body that
/// does not rotate; those of a support, if its reactions are requested.
fn rows_left(
    model: &Model,
    work: &mut Workspace,
    pushes: &[Push<'_>],
    loads: &[Load],
    free: Pair,
    errors: &mut Errors,
) -> Option<Vec<(&'static str, Sides)>> {
    let balances = balances_left(model, work);
    let supporting: Vec<&Push<'_>> = pushes.iter().filter(|push| push.supports).collect();
    let is_asked = !model.motion.is_supported() || !supporting.is_empty();
    if balances.is_empty() || !is_asked {
        return Some(Vec::new());
    }
    let in_body = |push: &&Push<'_>| push.unit.load.frame == model.state.body;
    let frame = if model.motion.is_supported() && supporting.iter().all(in_body) {
        model.state.body
    } else {
        Frame::WORLD
    };
    let in_frame = |work: &mut Workspace, (force, moment): (Vector, Vector)| {
        let mut turned = |vector| {
            let components = work.components(vector, frame);
            work.vector(frame, components)
        };
        (turned(force), turned(moment))
    };
    let known = balances_of(model, work, loads, Vec::new(), free);
    let known = in_frame(work, known);
    let mut changes = Vec::new();
    for push in pushes {
        let (force, moment) = inertial_change(model, work, push.accelerations);
        let force = work.add(push.unit.force, force);
        let moment = work.add(push.unit.moment, moment);
        changes.push(in_frame(work, (force, moment)));
    }
    let mut rows = Vec::new();
    for row in balances {
        let (coefficients, known) = row.sides(work, changes.clone(), known, (frame, frame));
        let graph = &work.graph;
        let remains = !graph.is_zero(known);
        let moves = coefficients.iter().any(|id| !graph.is_zero(*id));
        if moves || (remains && model.motion.is_supported()) {
            rows.push((row.name, (coefficients, known)));
        } else if remains {
            check_moment_free(model, work, &model.loads, errors)?;
        }
    }
    Some(rows)
}

fn sizes(
    model: &Model,
    work: &mut Workspace,
    constraint: &Constrained,
    pushes: &[Push<'_>],
) -> Vec<Size> {
    let pushes = pushes.iter();
    pushes
        .map(|push| size(model, work, constraint, push))
        .collect()
}

/// The size of `A . D`, the product of a gradient and a load in the metric of the kinetic energy.
/// If the load is along the gradient, it is a sum of squares. Otherwise, it is at most the product
/// of their lengths, and vanishes where they are perpendicular.
fn size(model: &Model, work: &mut Workspace, constraint: &Constrained, push: &Push<'_>) -> Size {
    let gradient = constraint.rates.factors;
    let values = samples(work, &[gradient.entries(), push.free.entries()].concat());
    let (a, b) = values.split_at(values.len() / 2);
    if !push.is_followed && are_parallel(a, b) {
        return Size::Squares;
    }
    let by_gradient = response(model, work, gradient);
    let graph = &mut work.graph;
    let of_gradient = gradient.dot(graph, by_gradient);
    let of_load = push.free.dot(graph, push.accelerations);
    let square = graph.multiply(of_gradient, of_load);
    Size::Product(graph.apply(Function::Sqrt, &[square]))
}

/// Whether two vectors are proved to be parallel, on all branches on which the first is nonzero.
fn are_parallel(a: &[Sample], b: &[Sample]) -> bool {
    let branches = a.first().map_or(0, |first| first.0.len());
    let on_branch = |branch: usize| {
        let values = |vector: &[Sample]| -> Option<Vec<Residue>> {
            vector.iter().map(|entry| entry.0[branch]).collect()
        };
        let (a, b) = (values(a)?, values(b)?);
        let Some(lead) = a.iter().position(|entry| !entry.is_zero()) else {
            return Some(true);
        };
        let crossed = |i: usize| a[i] * b[lead] + -(a[lead] * b[i]);
        Some(!b[lead].is_zero() && (0..a.len()).all(|i| crossed(i).is_zero()))
    };
    !a.iter().all(Sample::is_zero) && (0..branches).all(|branch| on_branch(branch) == Some(true))
}

/// `q''_0 + sum of u_j D_j`
fn pushed(work: &mut Workspace, free: Pair, pushes: &[Push<'_>], values: &[Id]) -> Pair {
    let graph = &mut work.graph;
    let mut sum = |of: fn(Pair) -> Components| {
        let pushes = pushes.iter().zip(values);
        let sum = pushes.fold(of(free), |sum, (push, value)| {
            let change = graph.scale_vector(*value, of(push.accelerations));
            graph.add_vectors(sum, change)
        });
        graph.results(sum)
    };
    Pair {
        linear: sum(|pair| pair.linear),
        angular: sum(|pair| pair.angular),
    }
}

fn name_accelerations(
    model: &Model,
    work: &mut Workspace,
    linear: Components,
    angular: Components,
) {
    let labels = &mut work.labels;
    labels.describe("linear", "(1.3) with the reactions, world axes");
    labels.vector("linear", linear);
    labels.describe("angular", "(1.4) with the reactions, body axes");
    if model.motion.has_angle() {
        labels.name(angular[2], "angular");
    }
    labels.vector("angular", angular);
}
