//! The lines of `SKIPPED`, as a reader would understand them.

use crate::answer::{Answer, answer, differs, shown};
use crate::description::body::{Body, Param};
use crate::description::expression::Scalar;
use crate::layout::{is_rod, translates};
use crate::oracle::Constants;
use crate::oracle::loads::acting;
use crate::oracle::scene::Scene;
use crate::oracle::vector::Vector;
use crate::samples::{Sample, Source};
use crate::structure::{EXACT, changed, nothing};
use crate::trials::{Case, Refuted};

/// Words for parts of the state, and their places in `QUANTITIES`.
const PARTS: [(&str, usize); 6] = [
    ("position", 1),
    ("velocity", 2),
    ("attitude", 3),
    ("axis", 3),
    ("angular velocity", 4),
    ("axis rate", 4),
];

pub fn skipped(
    case: &Case<'_>,
    sample: &Sample,
    known: &Answer,
    source: &mut Source,
    refuted: &mut Refuted,
) {
    for line in &case.compiled.skipped {
        if let Some((parts, _)) = line.split_once(": the accelerations do not depend on") {
            for part in parts.split(", ") {
                unread(case, sample, known, part, source, refuted);
            }
        } else if let Some((load, why)) = load_of(line, "the moment of `load_") {
            moment(case, sample, line, load, why, refuted);
        } else if let Some((load, _)) = load_of(line, "the force of `load_") {
            let scene = Scene::at(case.constants, &sample.given, &sample.instant);
            if let Some(acting) = acting(&scene, &case.body.loads[load]) {
                nothing(line, acting.wrench.force, refuted);
            }
        } else if line == "the acceleration of G: the sum of the forces is zero" {
            nothing(line, known.linear, refuted);
        } else if line == "the mass: it cancels in the accelerations" {
            mass(case, sample, known, line, source, refuted);
        } else {
            tensor(case, line, refuted);
        }
    }
}

/// The number of a load, and what is said of it.
fn load_of<'a>(line: &'a str, before: &str) -> Option<(usize, &'a str)> {
    let (number, why) = line.strip_prefix(before)?.split_once("`: ")?;
    Some((number.parse().ok()?, why))
}

fn unread(
    case: &Case<'_>,
    sample: &Sample,
    known: &Answer,
    part: &str,
    source: &mut Source,
    refuted: &mut Refuted,
) {
    let (_, quantity) = PARTS
        .iter()
        .find(|(name, _)| *name == part)
        .expect("a part of the state");
    let Some(changed) = changed(case, sample, *quantity, source) else {
        return;
    };
    let Some(other) = answer(case.constants, &changed.given, &changed.instant) else {
        return;
    };
    let linear = translates(case.body) && differs(known.linear, other.linear, EXACT);
    // what a rod keeps of its axis is not an acceleration that is read
    let angular = differs(known.angular, other.angular, EXACT);
    if linear || angular {
        refuted.tell(
            &format!("{part}: the accelerations do not depend on it"),
            format!("with {:?}", changed.instant.high()),
        );
    }
}

fn moment(
    case: &Case<'_>,
    sample: &Sample,
    line: &str,
    load: usize,
    why: &str,
    refuted: &mut Refuted,
) {
    let scene = Scene::at(case.constants, &sample.given, &sample.instant);
    let Some(acting) = acting(&scene, &case.body.loads[load]) else {
        return;
    };
    let is_held = case.body.motion.support().is_some();
    let of_charges = why.starts_with("its potential");
    let moment = if is_held {
        acting.wrench.about_held
    } else {
        acting.wrench.about_center
    };
    // about a hinge, only what is along it
    let moment = if of_charges && case.body.motion.is_planar() {
        Vector::normal(moment.component(2))
    } else if is_rod(case.body) {
        moment.cross(scene.axis)
    } else {
        moment
    };
    if scene.is_near_switch() || !crate::answer::is_finite(&moment) {
        return;
    }
    nothing(line, moment, refuted);
}

/// The parameters that it is made of, changed.
fn mass(
    case: &Case<'_>,
    sample: &Sample,
    known: &Answer,
    line: &str,
    source: &mut Source,
    refuted: &mut Refuted,
) {
    let Some(mass) = &case.body.mass else {
        return;
    };
    let mut given = sample.given.clone();
    let offsets = case.body.param_offsets().0;
    for (i, param) in case.body.params.iter().enumerate() {
        if matches!(param, Param::Scalar(_)) && mentions(mass, i) {
            given.params[offsets[i]] *= 0.5 + source.random.f64();
        }
    }
    let constants = Constants::new(case.body, &given.params);
    let Some(other) = answer(&constants, &given, &sample.instant) else {
        return;
    };
    let linear = translates(case.body) && differs(known.linear, other.linear, EXACT);
    if linear || differs(known.angular, other.angular, EXACT) {
        refuted.tell(
            line,
            format!("{} and {}", shown(known.linear), shown(other.linear)),
        );
    }
}

fn mentions(scalar: &Scalar, param: usize) -> bool {
    format!("{scalar:?}").contains(&format!("Param({param})"))
}

/// Which entries of the tensor are zero, and which moments are equal.
fn tensor(case: &Case<'_>, line: &str, refuted: &mut Refuted) {
    let known = case.constants.inertia.value;
    let size = case.constants.inertia.size;
    let is_zero = |i: usize, j: usize| known[i][j].high.abs() <= EXACT * size;
    let is_equal = |i: usize, j: usize| (known[i][i] - known[j][j]).high.abs() <= EXACT * size;
    let is_diagonal = is_zero(0, 1) && is_zero(1, 2) && is_zero(2, 0);
    let holds = match line {
        "terms of J_xy: it is zero" => is_zero(0, 1),
        "terms of J_yz: it is zero" => is_zero(1, 2),
        "terms of J_zx: it is zero" => is_zero(2, 0),
        "w x J w: all moments of inertia are equal" => {
            is_diagonal && is_equal(0, 1) && is_equal(1, 2)
        }
        "products of inertia: the axes are principal" => is_diagonal,
        "(w x J w)_x: the other two moments of inertia are equal" => is_equal(1, 2),
        "(w x J w)_y: the other two moments of inertia are equal" => is_equal(2, 0),
        "(w x J w)_z: the other two moments of inertia are equal" => is_equal(0, 1),
        _ => return,
    };
    if !holds {
        refuted.tell(line, format!("{:?}", known.map(|row| row.map(|x| x.high))));
    }
}

/// Whether a line says how something is computed, or what was not asked for: nothing that a state could refute.
pub fn is_manner(line: &str) -> bool {
    let ends = [
        "not in `outputs`",
        "over the inertia they are constants",
        "they are one force",
        "one force and one moment",
    ];
    let middles = [
        " of the rotation: ",
        " one by one: ",
        "the motion is planar",
        "the body does not turn",
        "is not modeled",
        "turns about a point of it",
        "no moment about",
        "no inertia about it",
        "in the principal axes there are none",
        "it is along w, and not in",
        "in the potential energy",
    ];
    ends.iter().any(|end| line.ends_with(end)) || middles.iter().any(|middle| line.contains(middle))
}

/// Whether a line is tried.
pub fn is_tried(line: &str, _: &Body) -> bool {
    [
        "the moment of `",
        "the force of `",
        "the acceleration of G: ",
        "the mass: ",
        "terms of J_",
        "w x J w",
        "(w x J w)_",
        "products of inertia: the axes",
        "the angular acceleration about ",
    ]
    .iter()
    .any(|start| line.starts_with(start))
        || line.contains(": the accelerations do not depend on")
}
