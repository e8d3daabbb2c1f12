//! Generic bodies and systems: in doubles the regressor and the parameters are those of the body
//! without a scalar, in single precision they are close, and in dual numbers they carry derivatives.

use newton_euler::private::generic;
use newton_euler::{Dual, prelude::*};

use super::close;

/// The same description twice: in doubles, and in any scalar.
macro_rules! twice {
    ($macro:ident $double:ident $any:ident { $($keys:tt)* }) => {
        $macro!($double { $($keys)* });
        $macro!($any::<T> { $($keys)* });
    };
}

twice!(rigid_body Pendulum AnyPendulum {
    motion: pivot(p),
    mass: 1[kg],
    inertia: 0.1,
    points: [p = (0.1, 0.2)],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    outputs: [regressor],
});

twice!(rigid_body Craft AnyCraft {
    motion: spatial,
    params: [side = body(0.1, 0.2, 0.3)[m], load = 3.2[kg]],
    mass: load,
    inertia: principal(1.3, 1.7, 2.1)[kg * m ^ 2],
    points: [nozzle = side],
    forces: [engine = body(2[N], 0, 0).at(nozzle)],
    outputs: [regressor],
});

// its motion switches at a time that is a number, and it has no inputs
twice!(rigid_body Puff AnyPuff {
    motion: translation,
    mass: 0.7[kg],
    forces: [jet = (if t < 1.5[s] { 1[N] } else { 0[N] }) * world(1, 0, 0)],
    outputs: [regressor],
});

// a switch that is computed from an input
twice!(rigid_body Gust AnyGust {
    motion: translation,
    inputs: [start[s]],
    params: [size = 1[N]],
    mass: 0.7[kg],
    forces: [jet = (if t < 1.5 * start + 0.25[s] { size } else { 0[N] }) * world(1, 0, 0)],
    outputs: [regressor],
});

twice!(rigid_system Arm AnyArm {
    motion: planar,
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: 0.04[kg * m ^ 2],
            points: [pin = (-0.3, 0.02), end = (0.2, 0.02)],
        },
        lower { mass: 0.8[kg], inertia: 0.015[kg * m ^ 2], points: [pin = (-0.22, -0.03)] },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.pin),
        elbow = revolute(upper.end, lower.pin),
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    outputs: [regressor],
});

twice!(rigid_system Crane AnyCrane {
    motion: planar,
    params: [load = 0.8[kg], reach = 0.22[m]],
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: 0.04[kg * m ^ 2],
            points: [pin = (-0.3, 0.02), end = (0.2, 0.02)],
        },
        lower { mass: load, inertia: 0.015[kg * m ^ 2], points: [pin = (-reach, -0.03)] },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.pin).armature(0.02[kg * m ^ 2]),
        elbow = revolute(upper.end, lower.pin),
    ],
    outputs: [regressor],
});

/// The entries of the rows and of the parameters, in doubles and as numbers of a generic body.
type Entries<T> = (Vec<T>, Vec<T>);

fn compare(name: &str, double: &Entries<f64>, same: &Entries<f64>, single: &Entries<f32>) {
    assert_eq!(double, same, "{name}");
    for (single, double) in [(&single.0, &double.0), (&single.1, &double.1)] {
        let single: Vec<f64> = single.iter().map(|one| f64::from(*one)).collect();
        close(&single, double, 1e-5);
    }
}

fn dual(value: f64) -> Dual<f64, 1> {
    Dual::variable(value, 0)
}

macro_rules! entries {
    (body $body:expr, $state:expr, $given:expr, $input:expr) => {{
        let body = $body;
        let rows = body.regressor(Default::default(), &$state, &$given, &$input);
        let own = body.inertial_parameters();
        (rows.as_slice().to_vec(), own.as_slice().to_vec())
    }};
    (system $system:expr, $state:expr, $given:expr) => {{
        let system = $system;
        let rows = system.regressor(Default::default(), &$state, &$given, &());
        let own = system.inertial_parameters();
        let rows = [rows.upper.as_slice(), rows.lower.as_slice()].concat();
        (rows, [own.upper.as_slice(), own.lower.as_slice()].concat())
    }};
}

#[test]
fn a_generic_pendulum() {
    let state = Hinge {
        angle: 0.3,
        angular_velocity: -1.2,
    };
    let one = generic::Hinge {
        angle: 0.3_f32,
        angular_velocity: -1.2,
    };
    let double = entries!(body Pendulum::default(), state, 0.7, ());
    compare(
        "pendulum",
        &double,
        &entries!(body AnyPendulum::<f64>::default(), state, 0.7, ()),
        &entries!(body AnyPendulum::<f32>::default(), one, 0.7, ()),
    );
    close(&double.1, &[1.0, -0.1, -0.2, 0.15], 1e-15);
    // the derivative with respect to the angle
    let state = generic::Hinge {
        angle: dual(0.3),
        angular_velocity: Dual::from(-1.2),
    };
    let (rows, own) =
        entries!(body AnyPendulum::<Dual<f64, 1>>::default(), state, Dual::from(0.7), ());
    let step = 1e-6;
    let at = |angle| {
        let state = Hinge {
            angle,
            angular_velocity: -1.2,
        };
        entries!(body Pendulum::default(), state, 0.7, ()).0
    };
    let (before, after) = (at(0.3 - step), at(0.3 + step));
    for (index, entry) in rows.iter().enumerate() {
        close(&[entry.value], &[double.0[index]], 1e-15);
        let slope = (after[index] - before[index]) / (2.0 * step);
        close(&entry.derivatives, &[slope], 1e-8);
    }
    for (entry, double) in own.iter().zip(&double.1) {
        assert_eq!((entry.value, entry.derivatives), (*double, [0.0]));
    }
}

#[test]
fn generic_bodies_with_params_and_switches() {
    let given = |linear: f64| SpatialAcceleration {
        linear: nalgebra::Vector3::new(linear, 0.2, 0.3),
        angular: nalgebra::Vector3::new(0.4, 0.5, 0.6),
    };
    let one = generic::SpatialAcceleration {
        linear: nalgebra::Vector3::new(0.1_f32, 0.2, 0.3),
        angular: nalgebra::Vector3::new(0.4, 0.5, 0.6),
    };
    compare(
        "craft",
        &entries!(body Craft::default(), Spatial::default(), given(0.1), ()),
        &entries!(body AnyCraft::<f64>::default(), Spatial::default(), given(0.1), ()),
        &entries!(body AnyCraft::<f32>::default(), generic::Spatial::default(), one, ()),
    );
    let (push, one) = (
        nalgebra::Vector3::new(1.0, 2.0, 3.0),
        nalgebra::Vector3::new(1.0, 2.0, 3.0),
    );
    let double = entries!(body Puff::default(), Translation::default(), push, ());
    compare(
        "puff",
        &double,
        &entries!(body AnyPuff::<f64>::default(), Translation::default(), push, ()),
        &entries!(body AnyPuff::<f32>::default(), generic::Translation::default(), one, ()),
    );
    assert_eq!(double.1, [0.7]);
    compare(
        "gust",
        &double,
        &entries!(body AnyGust::<f64>::default(), Translation::default(), push, AnyGustInput { start: 1.0 }),
        &entries!(body AnyGust::<f32>::default(), generic::Translation::default(), one, AnyGustInput { start: 1.0 }),
    );
    assert_eq!(Gust::default().inertial_parameters()[0], 0.7);
}

#[test]
fn the_switches_of_a_generic_body_end_steps() {
    let motion = AnyGust::<f64>::default()
        .integrate(&Translation::default())
        .input(AnyGustInput { start: 0.5 })
        .to(2.0)
        .unwrap();
    close(&[motion.velocity.x], &[1.0 / 0.7], 1e-12);
}

macro_rules! system_entries {
    ($system:ty, $state:ident, $given:ident, $number:expr) => {{
        let number = $number;
        let hinge = |angle, rate| generic::Hinge {
            angle: number(angle),
            angular_velocity: number(rate),
        };
        let state = $state {
            shoulder: hinge(0.3, 1.1),
            elbow: hinge(-0.8, 0.4),
        };
        let given = $given {
            shoulder: number(0.6),
            elbow: number(-0.9),
        };
        entries!(system<$system>::default(), state, given)
    }};
}

#[test]
#[allow(
    clippy::cast_possible_truncation,
    reason = "rounded to single precision"
)]
fn generic_systems() {
    let single = |number: f64| number as f32;
    let plain = |number: f64| number;
    let double = system_entries!(Arm, ArmState, ArmAcceleration, plain);
    compare(
        "arm",
        &double,
        &system_entries!(AnyArm<f64>, AnyArmState, AnyArmAcceleration, plain),
        &system_entries!(AnyArm<f32>, AnyArmState, AnyArmAcceleration, single),
    );
    close(
        &double.1[..4],
        &[1.2, 0.36, -0.024, 0.04 + 1.2 * (0.09 + 0.0004)],
        1e-14,
    );
    let (rows, own) = system_entries!(AnyArm<Dual<f64, 1>>, AnyArmState, AnyArmAcceleration, dual);
    for (found, expected) in [(rows, double.0), (own, double.1)] {
        let found: Vec<f64> = found.iter().map(|entry| entry.value).collect();
        close(&found, &expected, 1e-14);
    }
    let double = system_entries!(Crane, CraneState, CraneAcceleration, plain);
    compare(
        "crane",
        &double,
        &system_entries!(AnyCrane<f64>, AnyCraneState, AnyCraneAcceleration, plain),
        &system_entries!(AnyCrane<f32>, AnyCraneState, AnyCraneAcceleration, single),
    );
    let (_, own) = system_entries!(
        AnyCrane<Dual<f64, 1>>,
        AnyCraneState,
        AnyCraneAcceleration,
        dual
    );
    let found: Vec<f64> = own.iter().map(|entry| entry.value).collect();
    close(&found, &double.1, 1e-14);
}
