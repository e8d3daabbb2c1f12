//! The quadrotor M9: its numbers, and its equations derived a second time, by Lagrange.
//!
//! In the second derivation, the Lagrangian and the virtual work of the loads are written in
//! coordinates that include the angles of roll, pitch and yaw. They are differentiated exactly,
//! with numbers that carry derivatives.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};
use newton_euler::{integrate::cf4, prelude::*};
use proptest::prelude::*;

use crate::dual::{Dual, lagrange};
use crate::reference::{attitude, body, distance, number, numbers, vector};

mod m9 {
    newton_euler::rigid_body!(Quadrotor {
        motion: spatial,
        params: [
            arm = 0.18[m],
            z = 0.02[m],
            drag_ratio = 0.016[m],
            rotor = 6e-5[kg * m ^ 2],
            k_t = 7.5e-6[N * s ^ 2],
        ],
        inputs: [t_1[N], t_2[N], t_3[N], t_4[N]],
        mass: 1.3[kg],
        inertia: tensor {
            xx: 0.011,
            yy: 0.013,
            zz: 0.021,
            xy: -0.0002,
            yz: 0.00015,
            zx: 0.0001
        }[kg * m ^ 2],
        points: [
            front = (arm, 0, z),
            left = (0, arm, z),
            back = (-arm, 0, z),
            right = (0, -arm, z),
        ],
        locals: [
            h = rotor * (t_1 / k_t).sqrt() - rotor * (t_2 / k_t).sqrt()
                + rotor * (t_3 / k_t).sqrt()
                - rotor * (t_4 / k_t).sqrt(),
            twist = -t_1 + t_2 - t_3 + t_4,
        ],
        fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
        forces: [
            lift_1 = body(0, 0, t_1).at(front),
            lift_2 = body(0, 0, t_2).at(left),
            lift_3 = body(0, 0, t_3).at(back),
            lift_4 = body(0, 0, t_4).at(right),
        ],
        moments: [
            drag = body(0, 0, drag_ratio * twist),
            stored = -angular_velocity.cross(body(0, 0, h)),
        ],
        outputs: [balance],
    });

    newton_euler::rigid_body!(Stored {
        motion: spatial,
        params: [h],
        inputs: [lift, k = body(_, _, _)],
        mass: 1.3[kg],
        inertia: tensor {
            xx: 0.011,
            yy: 0.013,
            zz: 0.021,
            xy: -0.0002,
            yz: 0.00015,
            zx: 0.0001
        }[kg * m ^ 2],
        fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
        forces: [thrust = body(0, 0, lift)],
        moments: [couple = k, stored = -angular_velocity.cross(body(0, 0, h))],
    });
}

fn start() -> Spatial {
    let given = body("M9")["given"].take();
    let [w, x, y] = [0, 1, 2].map(|i| number(&given["q"][i]));
    Spatial {
        position: Vector3::zeros(),
        // The last component is given as sqrt(.14).
        attitude: UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, 0.14_f64.sqrt())),
        velocity: vector(&given["v"]),
        angular_velocity: vector(&given["w"]),
    }
}

fn thrusts() -> m9::QuadrotorInput {
    let [t_1, t_2, t_3, t_4] = numbers(&body("M9")["given"]["T"]);
    m9::QuadrotorInput { t_1, t_2, t_3, t_4 }
}

/// The moment about G without the stored momentum, body axes, and that momentum.
fn expected_moment() -> (Vector3<f64>, f64) {
    let expected = body("M9")["expect"].take();
    (
        vector(&expected["K body"]),
        number(&expected["rotor momentum z"]),
    )
}

#[test]
fn the_given_numbers_are_those_of_the_description() {
    let given = body("M9")["given"].take();
    let params = *m9::Quadrotor::default().params();
    let stated = ["arm", "z", "drag_ratio", "Jr", "kT"].map(|name| number(&given[name]));
    assert_eq!(
        [
            params.arm,
            params.z,
            params.drag_ratio,
            params.rotor,
            params.k_t
        ],
        stated
    );
    let rows = [0, 1, 2].map(|row| vector(&given["J"][row]));
    assert_eq!(inertia(), Matrix3::from_columns(&rows)); // symmetric
    assert_eq!([number(&given["m"]), number(&given["g"])], [MASS, GRAVITY]);
}

#[test]
fn accelerations() {
    let expected = body("M9")["expect"].take();
    let computed = m9::Quadrotor::default().acceleration(0.0, &start(), &thrusts());
    let (k, h) = expected_moment();
    let lift = 3.6 + 3.1 + 3.4 + 3.3;
    let params = m9::StoredParams { h };
    let stored = m9::Stored::new(params).unwrap();
    let again = stored.acceleration(0.0, &start(), &m9::StoredInput { lift, k });
    for computed in [computed, again] {
        // Terms: 13.4 N over 1.3 kg, moments to 0.65 N m over 0.011 kg m²: 60; some twenty roundings.
        let linear = vector(&expected["accel world"]);
        assert!((computed.linear - linear).amax() <= 1e-12, "{computed:?}");
        let angular = vector(&expected["alpha body"]);
        assert!((computed.angular - angular).amax() <= 1e-12, "{computed:?}");
    }
}

#[test]
fn moments() {
    let (k, h) = expected_moment();
    let wrench = m9::Quadrotor::default().applied(0.0, &start(), &thrusts());
    let state = start();
    let stored = state.angular_velocity.cross(&Vector3::new(0.0, 0.0, h));
    let moment = state.attitude.inverse() * wrench.moment;
    // Terms to 0.18 m · 3.6 N; rotor momenta to 0.04 of which a tenth remains.
    assert!((moment - (k - stored)).amax() <= 1e-15 * 10.0, "{moment}");
}

#[test]
fn state_after_a_second() {
    let expected = body("M9")["expect"].take();
    // Rates to 5 rad/s, steps of 0.25 ms: (1.2e-3)⁴ = 2e-12 and a small factor.
    let end = cf4(
        &m9::Quadrotor::default(),
        &start(),
        &thrusts(),
        0.0..1.0,
        4000,
    );
    for (computed, name) in [
        (end.position, "state(1): x"),
        (end.velocity, "v"),
        (end.angular_velocity, "w"),
    ] {
        let off = (computed - vector(&expected[name])).amax();
        assert!(off <= 1e-10, "{name} is off by {off:e}");
    }
    assert!(distance(&end.attitude, &attitude(&expected["q"])) <= 1e-10);
}

const MASS: f64 = 1.3;
const GRAVITY: f64 = 9.80665;

fn inertia() -> Matrix3<f64> {
    Matrix3::new(
        0.011, -0.0002, 0.0001, -0.0002, 0.013, 0.00015, 0.0001, 0.00015, 0.021,
    )
}

/// Coordinates: G in space; roll, pitch, yaw.
type Coordinates<T> = [T; 6];

/// Components of the angular velocity in body axes.
fn rates(q: &Coordinates<Dual>, dq: &Coordinates<Dual>) -> [Dual; 3] {
    let [_, _, _, roll, pitch, _] = *q;
    let [_, _, _, d_roll, d_pitch, d_yaw] = *dq;
    [
        d_roll - d_yaw * pitch.sin(),
        d_pitch * roll.cos() + d_yaw * roll.sin() * pitch.cos(),
        d_yaw * roll.cos() * pitch.cos() - d_pitch * roll.sin(),
    ]
}

/// Body axes in space: yaw about z, then pitch about the turned y, then roll about the turned x.
fn turned(q: &Coordinates<Dual>, vector: [Dual; 3]) -> [Dual; 3] {
    let about = |angle: Dual, u: Dual, v: Dual| {
        (
            u * angle.cos() - v * angle.sin(),
            u * angle.sin() + v * angle.cos(),
        )
    };
    let [_, _, _, roll, pitch, yaw] = *q;
    let [x, y, z] = vector;
    let (y, z) = about(roll, y, z);
    let (z, x) = about(pitch, z, x);
    let (x, y) = about(yaw, x, y);
    [x, y, z]
}

/// `½ m v² + ½ ω·Jω + h ω_z - m g z`: rotors at constant speed add `h ω_z`.
fn lagrangian(q: &Coordinates<Dual>, dq: &Coordinates<Dual>, h: f64) -> Dual {
    let w = rates(q, dq);
    let mut l = w[2] * h - q[2] * (MASS * GRAVITY);
    for i in 0..3 {
        l = l + dq[i] * dq[i] * (MASS / 2.0);
        for k in 0..3 {
            l = l + w[i] * w[k] * (inertia()[(i, k)] / 2.0);
        }
    }
    l
}

/// The point of the body at `r`, in space.
fn place(q: &Coordinates<Dual>, r: [f64; 3]) -> [Dual; 3] {
    let turned = turned(q, r.map(Dual::from));
    [q[0] + turned[0], q[1] + turned[1], q[2] + turned[2]]
}

/// The generalized forces: virtual work of the lifts and of the drag couple about body z.
fn generalized(q: [f64; 6], lifts: [f64; 4], couple: f64) -> [f64; 6] {
    let points = [
        [0.18, 0.0, 0.02],
        [0.0, 0.18, 0.02],
        [-0.18, 0.0, 0.02],
        [0.0, -0.18, 0.02],
    ];
    let axis = turned(&q.map(Dual::from), [0.0, 0.0, 1.0].map(Dual::from)).map(|c| c.value);
    core::array::from_fn(|i| {
        let mut varied = q.map(Dual::from);
        varied[i].first = 1.0;
        let mut unit = [0.0; 6].map(Dual::from);
        unit[i] = Dual::from(1.0);
        let moved = |r| place(&varied, r).map(|c| c.first);
        let work = |r| (0..3).map(|k| moved(r)[k] * axis[k]).sum::<f64>();
        let of_lifts: f64 = points
            .into_iter()
            .zip(lifts)
            .map(|(r, lift)| lift * work(r))
            .sum();
        of_lifts + couple * rates(&q.map(Dual::from), &unit)[2].value
    })
}

proptest! {
    #[test]
    fn lagrange_agrees(
        place in prop::array::uniform3(-10.0..10.0),
        roll in -3.0..3.0,
        pitch in -1.2..1.2, // away from the poles of these angles
        yaw in -3.0..3.0,
        dq in prop::array::uniform6(-4.0..4.0),
        lifts in prop::array::uniform4(0.5..5.0),
    ) {
        let q = [place[0], place[1], place[2], roll, pitch, yaw];
        let [t_1, t_2, t_3, t_4] = lifts;
        let spins = [1.0, -1.0, 1.0, -1.0];
        let sum = |f: fn(f64) -> f64| lifts.iter().zip(spins).map(|(t, s)| s * f(*t)).sum::<f64>();
        let h = 6e-5 * sum(|t| (t / 7.5e-6).sqrt());
        let couple = -0.016 * sum(|t| t);

        // The state and its acceleration, in the terms of the macro ...
        let w = rates(&q.map(Dual::from), &dq.map(Dual::from)).map(|c| c.value);
        let state = Spatial {
            position: place.into(),
            attitude: UnitQuaternion::from_euler_angles(roll, pitch, yaw),
            velocity: Vector3::new(dq[0], dq[1], dq[2]),
            angular_velocity: w.into(),
        };
        let input = m9::QuadrotorInput { t_1, t_2, t_3, t_4 };
        let computed = m9::Quadrotor::default().acceleration(0.0, &state, &input);

        // ... and in coordinates: ω̇ = E q'' + E' q'.
        let moving: [Dual; 6] = core::array::from_fn(|i| Dual::along(q[i], dq[i]));
        let drift = rates(&moving, &dq.map(Dual::from)).map(|c| c.first);
        let columns = [3, 4, 5].map(|i| {
            let mut unit = [0.0; 6].map(Dual::from);
            unit[i] = Dual::from(1.0);
            Vector3::from(rates(&q.map(Dual::from), &unit).map(|c| c.value))
        });
        let e = Matrix3::from_columns(&columns);
        let ddq = e.try_inverse().unwrap() * (computed.angular - Vector3::from(drift));
        let a = computed.linear;
        let ddq = [a.x, a.y, a.z, ddq.x, ddq.y, ddq.z];

        let left = lagrange(|q, dq| lagrangian(q, dq, h), q, dq, ddq);
        let right = generalized(q, lifts, couple);
        for i in 0..3 {
            // Terms to 20 N, a dozen roundings.
            prop_assert!((left[i] - right[i]).abs() <= 1e-13, "{i}: {left:?}, {right:?}");
        }
        for i in 3..6 {
            // Terms to 0.02 · 12² · 3 = 9 N m, times 3 where angles are worst (1 / cos 1.2), some hundred roundings.
            prop_assert!((left[i] - right[i]).abs() <= 3e-13, "{i}: {left:?}, {right:?}");
        }
    }
}
