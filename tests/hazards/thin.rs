//! H1: bodies with almost no moment of inertia about one axis.

use dashu_ratio::RBig;
use nalgebra::{Matrix3, Unit, Vector3};
use newton_euler::integrate::{self, Classical4, Fixed};
use newton_euler::prelude::*;
use newton_euler::state::generic;

use crate::exact::{ULP, ULP32, cross, dot, off, to_f32, vector, worse};
use crate::table::Record;
use crate::{runge_kutta, steps};

/// `1 - u u + ε u u`, u along (1, 2, 2).
macro_rules! thin {
    ($($module:ident: $epsilon:tt),+) => {
        $(mod $module {
            newton_euler::rigid_body!(Thin::<T> {
                motion: rotation,
                inputs: [k = body(_, _, _)[N * m]],
                inertia: tensor {
                    xx: 1 - (1 - $epsilon) / 9,
                    yy: 1 - 4 * (1 - $epsilon) / 9,
                    zz: 1 - 4 * (1 - $epsilon) / 9,
                    xy: -2 * (1 - $epsilon) / 9,
                    yz: -4 * (1 - $epsilon) / 9,
                    zx: -2 * (1 - $epsilon) / 9,
                },
                moments: [drive = k],
            });
        })+

        /// ε, and the acceleration under a couple.
        fn thin(k: Vector3<f64>) -> Vec<(f64, Vector3<f64>, Vector3<f64>)> {
            let still = generic::Rotation::default();
            let k32 = k.map(to_f32);
            vec![$((
                $epsilon,
                $module::Thin::<f64>::default().acceleration(0.0, &Rotation::default(), &$module::ThinInput { k }),
                $module::Thin::<f32>::default().acceleration(0.0, &still, &$module::ThinInput { k: k32 }).map(f64::from),
            )),+]
        }
    };
}

thin! { thin_6: 1e-6, thin_8: 1e-8 }

/// Of doubles.
fn tensor(epsilon: f64) -> Matrix3<f64> {
    let u = Vector3::new(1.0, 2.0, 2.0) / 3.0;
    Matrix3::identity() + u * u.transpose() * (epsilon - 1.0)
}

rigid_body!(Arrow {
    motion: rod(body(1, 2, 2)),
    inputs: [pull = world(_, _, _)[N]],
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    points: [end = (1, 2, 2)],
    forces: [pulled = pull.at(end)],
});

rigid_body!(Needle::<T> {
    motion: rotation,
    inputs: [y[N * m], z[N * m]],
    inertia: principal(1e-8, 1, 1),
    moments: [across = body(0, y, z)],
});

/// The error of `J^-1 K`, which is K.
fn by_inverse(epsilon: f64, k: &Vector3<f64>) -> f64 {
    match tensor(epsilon).try_inverse() {
        Some(inverse) => off(&(inverse * k), &vector(k)),
        None => f64::NAN,
    }
}

/// `u'' = r (F - (F.u) u) - |u'|^2 u`, with the end at r = 3 from G.
fn exact_arrow(u: &Vector3<f64>, rate: &Vector3<f64>, pull: &Vector3<f64>) -> [RBig; 3] {
    let [u, rate, pull] = [u, rate, pull].map(vector);
    let moment = cross(&u, &pull).map(|component| component * RBig::from(3));
    let turned = cross(&moment, &u);
    let square = dot(&rate, &rate);
    core::array::from_fn(|i| &turned[i] - &square * &u[i])
}

pub fn rods() -> Vec<Record> {
    // across u
    let couples = [
        [2.0, -1.0, 0.0],
        [2.0, -2.0, 1.0],
        [4.0, -1.0, -1.0],
        [-6.0, 1.0, 2.0],
    ]
    .map(Vector3::from);
    let mut records = Vec::new();
    for case in 0..thin(couples[0]).len() {
        let (mut plain, mut ours, mut ours32, mut least) = (0.0, 0.0, 0.0, 0.0);
        for k in couples {
            let (epsilon, double, single) = thin(k)[case];
            least = epsilon;
            plain = worse(plain, by_inverse(epsilon, &k));
            ours = worse(ours, off(&double, &vector(&k)));
            ours32 = worse(ours32, off(&single, &vector(&k)));
        }
        let case = format!("numbers, J = {least:.0e} along the axis");
        records.push(Record::fails(case.clone(), plain, 1e-18 / least).ours(ours, 4.0 * ULP));
        records.push(Record::alone(format!("{case}, f32")).ours(ours32, 4.0 * ULP32));
    }
    for epsilon in [1e-10, 1e-14] {
        let plain = couples
            .iter()
            .fold(0.0, |plain, k| worse(plain, by_inverse(epsilon, k)));
        let axis = Unit::new_normalize(Vector3::new(1.0, 2.0, 2.0));
        let axis_rate = Vector3::new(0.4, 1.5, -1.7);
        let state = Rod {
            axis,
            axis_rate,
            ..Rod::default()
        };
        let pull = Vector3::new(0.3, -0.7, 1.1);
        let ours = Arrow {}
            .acceleration(0.0, &state, &ArrowInput { pull })
            .axis;
        let ours = off(&ours, &exact_arrow(&axis, &axis_rate, &pull));
        let case = format!("`motion: rod`, beside J = {epsilon:.0e}");
        records.push(Record::fails(case, plain, 1e-18 / epsilon).ours(ours, 1e-14));
    }
    records.push(spin());
    records.push(spin_single());
    records.push(rod_state());
    records
}

/// The largest rate about the axis of what is driven across it, by the inverse of a tensor in other axes.
fn spin_of_tensor(count: u32) -> f64 {
    let (j, u) = (tensor(1e-8), Vector3::new(1.0, 2.0, 2.0) / 3.0);
    let inverse = j.try_inverse().expect("not quite singular");
    let couple = Vector3::new(2.0, -1.0, 0.0);
    let rate = |w: &Vector3<f64>| inverse * (couple - w.cross(&(j * w)));
    let (mut w, mut largest) = (Vector3::zeros(), 0.0);
    for _ in 0..count {
        w = runge_kutta::step(rate, w, 1e-3);
        largest = worse(largest, w.dot(&u).abs());
    }
    largest
}

fn spin() -> Record {
    let count = steps(100_000);
    let plain = spin_of_tensor(count);
    let start = Rotation {
        angular_velocity: Vector3::new(0.0, 0.3, -0.2),
        ..Rotation::default()
    };
    let input = NeedleInput { y: 0.7, z: -0.4 };
    let needle = Needle::<f64>::default();
    let (mut state, mut largest) = (start, 0.0);
    for _ in 0..count {
        state = integrate::cf4_step(&needle, 0.0, &state, &input, 1e-3);
        largest = worse(largest, state.angular_velocity.x.abs());
    }
    let method = Fixed {
        method: Classical4,
        step: 1e-3,
    };
    let motion = needle.integrate(&start).method(method).input(input);
    for state in motion.steps(f64::from(count) * 1e-3) {
        largest = worse(
            largest,
            state.expect("a motion").state.angular_velocity.x.abs(),
        );
    }
    let case = format!("`principal(1e-8, 1, 1)`, {count} steps: rate about the axis");
    Record::fails(case, plain, 1e-10).ours(largest, 0.0)
}

fn spin_single() -> Record {
    let count = steps(100_000);
    let mut state = generic::Rotation {
        angular_velocity: Vector3::new(0.0, 0.3_f32, -0.2),
        ..generic::Rotation::default()
    };
    let (needle, input) = (Needle::<f32>::default(), NeedleInput { y: 0.7, z: -0.4 });
    let mut largest = 0.0;
    for _ in 0..count {
        state = integrate::cf4_step(&needle, 0.0, &state, &input, 1e-3);
        largest = worse(largest, f64::from(state.angular_velocity.x.abs()));
    }
    Record::alone(format!("the same, f32, {count} steps")).ours(largest, 0.0)
}

/// A rod has no rate about its axis: what its state could lose is that u' is across u.
fn rod_state() -> Record {
    let count = steps(100_000);
    let mut state = Rod {
        axis: Unit::new_normalize(Vector3::new(1.0, 2.0, 2.0)),
        axis_rate: Vector3::new(2.0, -1.0, 0.0),
        ..Rod::default()
    };
    let input = ArrowInput {
        pull: Vector3::new(0.3, -0.7, 1.1),
    };
    let mut largest = 0.0;
    for _ in 0..count {
        state = integrate::cf4_step(&Arrow {}, 0.0, &state, &input, 1e-3);
        let along = state.axis.dot(&state.axis_rate) / state.axis_rate.norm();
        largest = worse(largest, along.abs());
    }
    Record::alone(format!(
        "runtime, state of a rod, {count} steps: rate along the axis"
    ))
    .ours(largest, 4.0 * ULP)
}
