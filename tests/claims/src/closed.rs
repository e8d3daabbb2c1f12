//! Closed forms: what they assume about the moment and about the acceleration of G.

use mounted::mechanics::{Free, Rotation};
use mounted::symbolic::Id;

use crate::answer::{Answer, differs, shown};
use crate::layout::{Layout, translates};
use crate::oracle::law::gyration;
use crate::oracle::number::Number;
use crate::oracle::scene::Scene;
use crate::oracle::vector::Vector;
use crate::samples::Sample;
use crate::structure::{ROUNDED, nothing};
use crate::trials::{Case, Refuted};
use crate::wide::Wide;

pub fn flow(case: &Case<'_>, sample: &Sample, known: &Answer, refuted: &mut Refuted) {
    let Some(flow) = &case.compiled.flow else {
        return;
    };
    let read = |ids: &[Id]| case.compiled.values(case.body, ids, &sample.given);
    let vector = |ids: &[Id]| {
        let values = read(ids);
        Vector::given([values[0], values[1], values[2]])
    };
    if translates(case.body) {
        same(
            "flow: acceleration of G",
            vector(&flow.linear),
            known.linear,
            refuted,
        );
    }
    let scene = Scene::at(case.constants, &sample.given, &sample.instant);
    let layout = Layout::of(&case.body.motion);
    match &flow.rotation {
        Rotation::None => {}
        Rotation::Gyrostat(_) => unreachable!("a body by itself has no rotors"),
        Rotation::GreatCircle => nothing("flow: great circle", known.moment, refuted),
        Rotation::Free(free) => {
            nothing("flow: free rotation", known.moment, refuted);
            inertia(case, free, &read, refuted);
        }
        Rotation::Top(top) => {
            let couple = scene.in_body(vector(&top.couple));
            let axis = vector(&top.axis);
            same(
                "flow: couple of a top",
                couple.cross(axis),
                known.moment,
                refuted,
            );
            symmetric(case, &read(&top.moments), axis, refuted);
        }
        Rotation::Axial(axial) => {
            let axis = vector(&axial.axis);
            let torque = Number::given(read(&[axial.torque])[0]);
            same(
                "flow: axial torque",
                axis.scaled(torque),
                known.moment,
                refuted,
            );
            symmetric(case, &read(&axial.moments), axis, refuted);
        }
        Rotation::Uniform(acceleration) => {
            let value = Vector::given([read(&[*acceleration])[0], 0.0, 0.0]);
            same("flow: uniform rotation", value, known.angular, refuted);
        }
        Rotation::Pendulum { rate, hanging } => {
            let values = read(&[*rate, *hanging]);
            let angle = sample.instant.state[layout.attitude.start] - Wide::from(values[1]);
            let value = angle.sin_cos().0 * -(values[0] * values[0]);
            let value = Vector {
                value: [value, Wide::ZERO, Wide::ZERO],
                size: values[0] * values[0],
            };
            let known = Vector {
                size: known.angular.size.max(value.size),
                ..known.angular
            };
            same("flow: pendulum", value, known, refuted);
        }
    }
}

fn same(name: &str, computed: Vector, known: Vector, refuted: &mut Refuted) {
    let computed = Vector {
        size: known.size,
        ..computed
    };
    if differs(computed, known, ROUNDED) {
        refuted.tell(name, format!("{} for {}", shown(computed), shown(known)));
    }
}

type Rows = [[f64; 3]; 3];

/// The tensor that the closed form stands for.
fn inertia(case: &Case<'_>, free: &Free, read: &impl Fn(&[Id]) -> Vec<f64>, refuted: &mut Refuted) {
    let rows: Rows = match free {
        Free::Steady => {
            let mean = (0..3)
                .map(|i| case.constants.inertia.value[i][i].high)
                .sum::<f64>()
                / 3.0;
            dyads(
                &[mean; 3],
                &[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            )
        }
        Free::Symmetric(moments, axis) => {
            let axis = read(axis);
            return symmetric(
                case,
                &read(moments),
                Vector::given([axis[0], axis[1], axis[2]]),
                refuted,
            );
        }
        Free::Along(moments) => {
            let m = read(moments);
            dyads(
                &[m[0], m[1], m[2]],
                &[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            )
        }
        Free::Principal(moments, axes) => {
            let m = read(moments);
            let axes = axes.map(|axis| {
                let a = read(&axis);
                [a[0], a[1], a[2]]
            });
            dyads(&[m[0], m[1], m[2]], &axes)
        }
        Free::Tensor(entries) => {
            let e = read(entries);
            [[e[0], e[3], e[5]], [e[3], e[1], e[4]], [e[5], e[4], e[2]]]
        }
    };
    tensor(case, &rows, refuted);
}

fn symmetric(case: &Case<'_>, moments: &[f64], axis: Vector, refuted: &mut Refuted) {
    let e = axis.value.map(|x| x.high);
    let rows = [0, 1, 2].map(|i| {
        [0, 1, 2].map(|j| {
            let own = if i == j { moments[0] } else { 0.0 };
            own + (moments[1] - moments[0]) * e[i] * e[j]
        })
    });
    tensor(case, &rows, refuted);
}

fn dyads(moments: &[f64; 3], axes: &Rows) -> Rows {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| (0..3).map(|k| moments[k] * axes[k][i] * axes[k][j]).sum()))
}

fn tensor(case: &Case<'_>, rows: &Rows, refuted: &mut Refuted) {
    let (known, size) = gyration(case.constants);
    let differs = (0..9).any(|n| {
        let (i, j) = (n / 3, n % 3);
        // also where it is not a number
        let apart = (rows[i][j] - known[i][j].high).abs();
        apart.is_nan() || apart > ROUNDED * size
    });
    if differs {
        refuted.tell(
            "flow: inertia",
            format!("{rows:?} for {:?}", known.map(|row| row.map(|x| x.high))),
        );
    }
}
