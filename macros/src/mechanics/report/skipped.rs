//! The terms that the equations of a body do not contain, and the reasons: the text of `SKIPPED`.

use crate::mechanics::balances::{EulerForm, inertia_about_center};
use crate::mechanics::structure::{Structure, Symmetry};
use crate::model::{AXES, Inertia, Model, Pair, Variable, Workspace};

use super::skipped_loads::skip_loads;

pub fn list_skipped(
    model: &Model,
    work: &mut Workspace,
    accelerations: Pair,
    form: Option<EulerForm>,
    structure: &Structure,
) -> Vec<String> {
    let mut skipped = Vec::new();
    skip_equations(model, &mut skipped);
    skip_gyroscopic(model, work, form, &mut skipped);
    skip_spin(model, structure, &mut skipped);
    skip_loads(model, work, accelerations, &mut skipped);
    skip_state(model, work, accelerations, &mut skipped);
    skipped
}

/// Mentions that nothing changes the spin of a symmetric body.
fn skip_spin(model: &Model, structure: &Structure, skipped: &mut Vec<String>) {
    let Symmetry::About(axis) = structure.angular.body else {
        return;
    };
    if !structure.keeps_spin || model.motion.is_planar {
        return;
    }
    let named = AXES.into_iter().zip(axis).filter(|(_, part)| *part != 0.0);
    let name = match named.collect::<Vec<_>>()[..] {
        [(name, _)] => name.to_owned(),
        _ => format!("({}, {}, {})", axis[0], axis[1], axis[2]),
    };
    skipped.push(format!(
        "the angular acceleration about {name}: nothing turns the body about its axis of symmetry"
    ));
}

fn skip_equations(model: &Model, skipped: &mut Vec<String>) {
    skipped.extend(model.motion.missing.map(str::to_owned));
    if model.has_idle_inertia {
        skipped.push("the inertia: the body does not turn".to_owned());
    }
}

/// Mentions entries of the tensor, about G or about the held point, that the balance does not
/// contain.
fn skip_gyroscopic(
    model: &Model,
    work: &mut Workspace,
    form: Option<EulerForm>,
    skipped: &mut Vec<String>,
) {
    if model.motion.is_hinged() {
        return;
    }
    let Inertia::Spatial(rows) = inertia_about_center(model, work) else {
        return;
    };
    let graph = &work.graph;
    let vanishing: Vec<&str> = [("J_xy", 0, 1), ("J_yz", 1, 2), ("J_zx", 2, 0)]
        .into_iter()
        .filter(|(_, i, j)| graph.is_zero(rows[*i][*j]))
        .map(|(name, ..)| name)
        .collect();
    let [x, y, z] = [rows[0][0], rows[1][1], rows[2][2]];
    if vanishing.len() < 3 {
        skipped.extend(
            vanishing
                .into_iter()
                .map(|name| format!("terms of {name}: it is zero")),
        );
        let line = match form {
            Some(EulerForm::TurnedToPrincipal) => {
                "products of inertia: in the principal axes there are none"
            }
            Some(EulerForm::Gauged) => "lambda w of J w: it is along w, and not in w x J w",
            Some(EulerForm::Principal | EulerForm::Symmetric) | None => return,
        };
        skipped.push(line.to_owned());
    } else if x == y && y == z {
        skipped.push("w x J w: all moments of inertia are equal".to_owned());
    } else {
        skipped.push("products of inertia: the axes are principal".to_owned());
        for (axis, equal) in [("x", y == z), ("y", z == x), ("z", x == y)] {
            if equal {
                skipped.push(format!(
                    "(w x J w)_{axis}: the other two moments of inertia are equal"
                ));
            }
        }
    }
}

/// Mentions parts of the state that the accelerations do not depend on.
fn skip_state(model: &Model, work: &Workspace, accelerations: Pair, skipped: &mut Vec<String>) {
    let roots = accelerations.entries();
    let (moves, turns) = (model.motion.translates(), model.motion.has_attitude());
    let is_rod = model.motion.is_line();
    // whether the motion has this part, its name, and its variables
    let parts: [(bool, &str, &[Variable]); 6] = [
        (moves, "position", &[Variable::Position]),
        (moves, "velocity", &[Variable::Velocity]),
        (is_rod, "axis", &[Variable::Axis]),
        (is_rod, "axis rate", &[Variable::AxisRate]),
        (
            turns && !is_rod,
            "attitude",
            &[Variable::Angle, Variable::Quaternion],
        ),
        (
            turns && !is_rod,
            "angular velocity",
            &[Variable::AngularVelocity],
        ),
    ];
    let unread: Vec<&str> = parts
        .into_iter()
        .filter(|(there, _, variables)| *there && !work.depend_on(&roots, variables))
        .map(|(_, name, _)| name)
        .collect();
    if !unread.is_empty() {
        skipped.push(format!(
            "{}: the accelerations do not depend on {}",
            unread.join(", "),
            if unread.len() == 1 { "it" } else { "them" }
        ));
    }
}
