//! `outputs: [constant]`: accelerations in constants. rustc decides each claim, and the same is
//! computed at run time.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

use newton_euler::prelude::*;

rigid_body!(Falling {
    motion: translation,
    params: [drag = 0.5[kg / s]],
    mass: 2[kg],
    inputs: [wind = world(_, _, _)[m / s]],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    forces: [air = drag * (wind - velocity)],
    outputs: [constant],
});

const AT_REST: [f64; 3] = Falling::accelerations(0.0, [0.0; 6], [0.0; 3]);
const _: () = assert!(AT_REST[0] == 0.0 && AT_REST[2] == -9.81);
// terminal velocity: m g / c
const _: () = {
    let terminal = [0.0, 0.0, 50.0, 0.0, 0.0, -39.24];
    let [_, _, down] = Falling::accelerations(0.0, terminal, [0.0; 3]);
    assert!(down.abs() < 1e-14);
};
// carried along by the wind
const _: () = assert!(Falling::accelerations(0.0, [0.0; 6], [4.0, 0.0, 0.0])[0] == 1.0);

rigid_body!(Quadrotor {
    motion: spatial,
    params: [arm = 0.2[m]],
    inputs: [thrust[N], roll[N * m]],
    mass: 1.5[kg],
    inertia: principal(0.02, 0.03, 0.04)[kg * m ^ 2],
    points: [side = (0, arm, 0)],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    forces: [
        rotors = body(0, 0, thrust),
        tip = body(0, 0, if t < 1[s] { 0[N] } else { 1[N] }).at(side)
    ],
    moments: [control = body(roll, 0, 0)],
    outputs: [constant],
});

/// Attitude as `x, y, z, w`.
const LEVEL: [f64; 13] = [
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
];
const HOVER: [f64; 6] = Quadrotor::accelerations(0.0, LEVEL, [1.5 * 9.81, 0.0]);
const _: () = assert!(HOVER[2].abs() < 1e-14 && HOVER[3] == 0.0);
const _: () = assert!((Quadrotor::accelerations(2.0, LEVEL, [0.0, 0.3])[3] - 25.0).abs() < 1e-12);

rigid_system!(Cart::<T> {
    states: [charge[C]],
    rates: [charge = -0.5[1 / s] * charge],
    bodies: [cart { mass: 2[kg] }, load { mass: 1[kg] }],
    joints: [
        rail = prismatic(world(0, 0, 0), cart.G, world(1, 0, 0)),
        slide = prismatic(cart.G, load.G, body(1, 0, 0)),
    ],
    drives: [
        spring = (-8[N / m] * slide.position).on(slide),
        motor = (0.1[N / C] * charge).on(rail)
    ],
    outputs: [constant],
});

// the spring between both, by the reduced mass
const PULLED: [f64; 3] = Cart::accelerations(0.0, [0.0, 0.0, 0.5, 0.0, 0.0], []);
const _: () = assert!((PULLED[0] - 2.0).abs() < 1e-15 && (PULLED[1] + 6.0).abs() < 1e-15);
const _: () = assert!(Cart::accelerations(0.0, [0.0, 0.0, 0.0, 0.0, 3.0], [])[2] == -1.5);

#[test]
fn as_at_run_time() {
    let mut state = Spatial {
        angular_velocity: [0.3, -0.7, 0.2].into(),
        velocity: [1.0, 2.0, 3.0].into(),
        ..Spatial::default()
    };
    state.attitude = nalgebra::UnitQuaternion::from_euler_angles(0.3, -0.8, 1.2);
    let input = QuadrotorInput {
        thrust: 11.0,
        roll: 0.4,
    };
    let found = Quadrotor::default().acceleration(1.5, &state, &input);
    let q = state.attitude.coords;
    let flat = Quadrotor::accelerations(
        1.5,
        [
            0.0, 0.0, 0.0, q.x, q.y, q.z, q.w, 1.0, 2.0, 3.0, 0.3, -0.7, 0.2,
        ],
        [11.0, 0.4],
    );
    for axis in 0..3 {
        assert!((flat[axis] - found.linear[axis]).abs() < 1e-13);
        assert!((flat[3 + axis] - found.angular[axis]).abs() < 1e-13);
    }
    let start = CartState {
        slide: Slide {
            position: 0.5,
            velocity: 0.0,
        },
        ..CartState::default()
    };
    let found = Cart::<f64>::default().acceleration(0.0, &start, &());
    assert!((found.rail - PULLED[0]).abs() < 1e-15 && (found.slide - PULLED[1]).abs() < 1e-15);
}
