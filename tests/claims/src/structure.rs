//! The claims in `STRUCTURE`, and the accelerations themselves.

use mounted::mechanics::{Dependence, QUANTITIES, Symmetry};

use crate::answer::{Answer, answer, differs, shown};
use crate::given::Given;
use crate::layout::{Layout, is_hinged, is_rod, translates};
use crate::oracle::vector::Vector;
use crate::samples::{Sample, Source, across};
use crate::trials::{Case, Refuted};
use crate::turns::{Turn, turned};
use crate::wide::Wide;

/// Of what is exact: far above the rounding of 106 bits, far below any double.
pub const EXACT: f64 = 1e-20;
/// Of what is computed in doubles, or about an axis that is one.
pub const ROUNDED: f64 = 1e-9;

/// The accelerations as they are compiled.
pub fn accelerations(
    case: &Case<'_>,
    sample: &Sample,
    known: &Answer,
    source: &mut Source,
    refuted: &mut Refuted,
) {
    let layout = Layout::of(&case.body.motion);
    let given = &sample.given;
    let is_constrained = !case.body.constraints.is_empty();
    let speed = given
        .state
        .iter()
        .fold(1.0, |most: f64, x| most.max(x.abs()));
    // where a length is zero, so may be a divisor
    let is_at_edge = given.time == 0.0 || given.state.contains(&0.0);
    let parts = [
        (translates(case.body), "the acceleration of G", known.linear),
        (
            !layout.turning.is_empty(),
            "the angular acceleration",
            known.angular,
        ),
    ];
    let computed = compiled(case, given);
    for (index, (exists, name, vector)) in parts.into_iter().enumerate() {
        let (size, found) = (known.sizes[index], computed[index]);
        // of what differences sum up
        let size = if is_constrained {
            size.max(1e-6 * speed * speed)
        } else {
            size
        };
        let known = Vector { size, ..vector };
        let is_number = found.value.iter().all(|x| x.high.is_finite());
        // what doubles do not hold is not compared
        let is_held = if is_constrained {
            size < 1e15 && (is_number || !is_at_edge)
        } else {
            is_number && size < 1e100
        };
        let tolerance = if is_constrained { 1e-6 } else { ROUNDED };
        let found = Vector { size, ..found };
        if exists
            && is_held
            && (!is_number
                || differs(found, known, tolerance)
                    && !is_noise(case, given, index, found, known, source))
        {
            refuted.tell(name, format!("{} for {}", shown(found), shown(known)));
        }
    }
}

/// Linear and angular acceleration in doubles.
fn compiled(case: &Case<'_>, given: &Given) -> [Vector; 2] {
    let roots = case.compiled.accelerations();
    let values = case.compiled.values(case.body, &roots, given);
    let vector = |from: usize| Vector::given([values[from], values[from + 1], values[from + 2]]);
    let angular = if Layout::of(&case.body.motion).turning.len() == 1 {
        Vector::given([values[5], 0.0, 0.0])
    } else {
        vector(3)
    };
    [vector(0), angular]
}

/// Whether the last digits of the state make as much of a difference: what cancels in doubles.
fn is_noise(
    case: &Case<'_>,
    given: &Given,
    index: usize,
    found: Vector,
    known: Vector,
    source: &mut Source,
) -> bool {
    let apart = |a: Vector, b: Vector| (a - b).length().high;
    let mismatch = apart(found, known);
    (0..12).any(|n| {
        // by what cosines near one lose, too
        let size = if n % 2 == 0 { 1e-14 } else { 1e-10 };
        let mut near = given.clone();
        let mut shake = |x: &mut f64| {
            let (relative, absolute) = (source.random.f64() - 0.5, source.random.f64() - 0.5);
            *x += size * (*x * relative + absolute);
        };
        near.state.iter_mut().for_each(&mut shake);
        shake(&mut near.time);
        apart(compiled(case, &near)[index], found) > 0.05 * mismatch
    })
}

/// That of a part that is claimed to be zero.
pub fn nothing(name: &str, vector: Vector, refuted: &mut Refuted) {
    if differs(vector, Vector::ZERO, EXACT) {
        refuted.tell(name, format!("it is {}", shown(vector)));
    }
}

pub fn zeros(case: &Case<'_>, known: &Answer, refuted: &mut Refuted) {
    let structure = &case.compiled.structure;
    if structure.is_force_free && translates(case.body) {
        nothing("is_force_free", known.linear, refuted);
    }
    let turns = !Layout::of(&case.body.motion).turning.is_empty();
    if structure.is_torque_free && turns {
        nothing("is_torque_free", known.moment, refuted);
    }
    if structure.keeps_spin && turns && !is_hinged(case.body) && !is_rod(case.body) {
        let is_planar = case.body.motion.is_planar();
        match structure.angular.body {
            _ if is_planar => nothing("keeps_spin", known.angular, refuted),
            Symmetry::Every => nothing("keeps_spin", known.angular, refuted),
            Symmetry::About(axis) => {
                let (axis, tolerance) = unit(axis);
                let along = Vector::scalar(axis.dot(known.angular));
                if differs(along, Vector::ZERO, tolerance) {
                    refuted.tell(
                        "keeps_spin",
                        format!("about the axis it is {}", shown(along)),
                    );
                }
            }
            // about an axis that has no numbers to say it by
            Symmetry::None => {}
        }
    }
    if let Some(axis) = &structure.spin_axis {
        let axis = axis.clone().map(|part| part.to_f64());
        let is_symmetric = |symmetry: Symmetry| match symmetry {
            Symmetry::Every => true,
            Symmetry::About(other) => (0..3).all(|i| (axis[i] - other[i]).abs() < 1e-15),
            Symmetry::None => false,
        };
        if !structure.keeps_spin
            || !is_symmetric(structure.angular.body)
            || !is_symmetric(structure.linear.body)
        {
            refuted.tell(
                "spin_axis",
                format!("{axis:?} without the claims that it is made of"),
            );
        }
    }
}

/// The axis to 106 bits, and how well it is known.
fn unit(axis: [f64; 3]) -> (Vector, f64) {
    let is_exact = axis.iter().filter(|part| **part != 0.0).count() == 1;
    let axis = Vector::given(axis).normalized();
    (axis, if is_exact { EXACT } else { ROUNDED })
}

/// Each quantity that is not read, changed.
pub fn reads(
    case: &Case<'_>,
    sample: &Sample,
    known: &Answer,
    source: &mut Source,
    refuted: &mut Refuted,
) {
    let structure = &case.compiled.structure;
    let all =
        |which: &dyn Fn(&Dependence) -> bool| which(&structure.linear) && which(&structure.angular);
    for (index, name) in QUANTITIES.iter().enumerate() {
        let is_free = |dependence: &Dependence| !dependence.reads[index];
        if !all(&is_free) && !is_free(&structure.linear) && !is_free(&structure.angular) {
            continue;
        }
        let Some(changed) = changed(case, sample, index, source) else {
            continue;
        };
        let Some(other) = answer(case.constants, &changed.given, &changed.instant) else {
            continue;
        };
        let parts = [
            (
                "linear",
                is_free(&structure.linear) && translates(case.body),
                known.linear,
                other.linear,
            ),
            (
                "angular",
                is_free(&structure.angular),
                known.angular,
                other.angular,
            ),
        ];
        for (part, is_claimed, before, after) in parts {
            if is_claimed && differs(before, after, EXACT) {
                let what = format!(
                    "{} and {} with {:?}",
                    shown(before),
                    shown(after),
                    changed.instant.high()
                );
                refuted.tell(&format!("{part} does not read {name}"), what);
            }
        }
    }
}

/// The same with another value of this quantity; nothing where the motion has it not.
pub fn changed(
    case: &Case<'_>,
    sample: &Sample,
    quantity: usize,
    source: &mut Source,
) -> Option<Sample> {
    let layout = Layout::of(&case.body.motion);
    let mut changed = sample.clone();
    match quantity {
        0 => source.time(&mut changed),
        1 if !layout.position.is_empty() => source.fill(&mut changed, layout.position),
        2 if !layout.velocity.is_empty() => source.fill(&mut changed, layout.velocity),
        // the axis of a rod goes about its rate, which stays perpendicular to it
        3 if is_rod(case.body) => {
            let rate = layout.turning.clone().map(|i| sample.given.state[i]);
            let rate: Vec<f64> = rate.collect();
            if rate.iter().all(|x| *x == 0.0) {
                source.attitude(case.body, &mut changed);
                return Some(changed.rounded());
            }
            // by the exact rate, not that of doubles
            let turn = Turn::exactly(
                std::array::from_fn(|i| sample.instant.state[layout.turning.start + i]),
                source.random.f64() * 6.0,
            );
            turn.part(&mut changed.instant.state, layout.attitude.start);
        }
        3 if !layout.attitude.is_empty() => source.attitude(case.body, &mut changed),
        4 if !layout.turning.is_empty() => {
            source.fill(&mut changed, layout.turning);
            if is_rod(case.body) {
                across(case.body, &mut changed);
            }
        }
        5 if case.body.input_offsets().1 > 0 => source.inputs(case.body, &mut changed),
        _ => return None,
    }
    Some(changed.rounded())
}

/// The world turned, and the axes of the body.
pub fn symmetries(
    case: &Case<'_>,
    sample: &Sample,
    known: &Answer,
    source: &mut Source,
    refuted: &mut Refuted,
) {
    if is_hinged(case.body) {
        return;
    }
    let structure = &case.compiled.structure;
    let parts = [
        ("linear", &structure.linear),
        ("angular", &structure.angular),
    ];
    for (index, (part, dependence)) in parts.into_iter().enumerate() {
        let exists = [translates(case.body), case.body.motion.turns()][index];
        for (is_world, symmetry) in [(true, dependence.world), (false, dependence.body)] {
            // of a rod no axes turn with it
            let is_there = exists && (is_world || case.body.motion.turns() && !is_rod(case.body));
            let axis = match symmetry {
                Symmetry::Every if case.body.motion.is_planar() => [0.0, 0.0, 1.0],
                Symmetry::Every => [(); 3].map(|()| source.random.f64() - 0.5),
                Symmetry::About(axis) => axis,
                Symmetry::None => continue,
            };
            if !is_there {
                continue;
            }
            let tolerance = match symmetry {
                Symmetry::About(axis) => unit(axis).1,
                _ => EXACT,
            };
            let turn = Turn::new(axis, 6.0 * source.random.f64());
            let mut instant = sample.instant.clone();
            if is_world {
                turn.world(case.body, &mut instant);
            } else {
                turn.body(case.body, &mut instant);
            }
            let Some(other) = answer(case.constants, &sample.given, &instant) else {
                continue;
            };
            let expected = turned(case.body, turn, is_world, [known.linear, known.angular]);
            let found = [other.linear, other.angular];
            if differs(expected[index], found[index], tolerance) {
                let whose = if is_world { "world" } else { "body" };
                refuted.tell(
                    &format!("{part}: the {whose} may be turned, {symmetry:?}"),
                    format!("{} for {}", shown(found[index]), shown(expected[index])),
                );
            }
        }
    }
}

/// A motion that begins in a plane stays in it.
pub fn planes(case: &Case<'_>, sample: &Sample, refuted: &mut Refuted) {
    let structure = &case.compiled.structure;
    for axis in (0..3).filter(|axis| structure.planes[*axis]) {
        let layout = Layout::of(&case.body.motion);
        let mut instant = sample.instant.clone();
        let state = &mut instant.state;
        for part in [&layout.position, &layout.velocity] {
            if !part.is_empty() {
                state[part.start + axis] = Wide::ZERO;
            }
        }
        let is_rod = is_rod(case.body);
        for i in 0..3 {
            if (i == axis) == is_rod && !layout.turning.is_empty() {
                state[layout.turning.start + i] = Wide::ZERO;
            }
            if (i == axis) == is_rod && !layout.attitude.is_empty() {
                state[layout.attitude.start + i] = Wide::ZERO;
            }
        }
        let mut flat = sample.clone();
        flat.instant = instant;
        if !flat.is_made_unit(case.body) {
            continue;
        }
        let Some(known) = answer(case.constants, &flat.given, &flat.instant) else {
            continue;
        };
        let mut out = vec![(known.linear, axis, translates(case.body))];
        out.extend((0..3).map(|i| {
            (
                known.angular,
                i,
                case.body.motion.turns() && (i == axis) == is_rod,
            )
        }));
        for (vector, i, exists) in out {
            if exists && vector.value[i].high.abs() > EXACT * vector.size {
                refuted.tell(
                    &format!("planes[{axis}]"),
                    format!("{} in {:?}", shown(vector), flat.instant.high()),
                );
            }
        }
    }
}
