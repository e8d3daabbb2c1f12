//! Linearizations of bodies of every kind, compared with dual numbers.

use nalgebra::{Unit, UnitQuaternion, Vector2, Vector3};
use newton_euler::prelude::*;
use newton_euler::state::generic;

use crate::oracle::{Derived, by, derived, hold, unmoved};

rigid_body!(Crazyflie::<T> {
    doc: "The Crazyflie 2.0; rotors 1 and 3 spin about +z.",
    motion: spatial,
    params: [torque_per_thrust = 0.005964552[m]],
    inputs: [thrust_1[N], thrust_2[N], thrust_3[N], thrust_4[N]],
    mass: 0.028[kg],
    inertia: tensor {
        xx: 1.657171e-5[kg * m ^ 2],
        yy: 1.6655602e-5[kg * m ^ 2],
        zz: 2.9261652e-5[kg * m ^ 2],
        xy: 8.30806e-7[kg * m ^ 2],
        yz: 1.800197e-6[kg * m ^ 2],
        zx: 7.18277e-7[kg * m ^ 2],
    },
    points: [
        front_right = (28.243, -28.325, 0)[mm],
        back_right = (-28.243, -28.325, 0)[mm],
        back_left = (-28.243, 28.325, 0)[mm],
        front_left = (28.243, 28.325, 0)[mm],
    ],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [
        lift_1 = body(0, 0, thrust_1).at(front_right),
        lift_2 = body(0, 0, thrust_2).at(back_right),
        lift_3 = body(0, 0, thrust_3).at(back_left),
        lift_4 = body(0, 0, thrust_4).at(front_left),
    ],
    locals: [twist = thrust_2 + thrust_4 - thrust_1 - thrust_3],
    moments: [drag = body(0, 0, torque_per_thrust * twist)],
    outputs: [linearization],
});

rigid_body!(Glider::<T> {
    motion: spatial,
    params: [stiffness = 40[N / m], drag = 0.3[kg / m]],
    inputs: [
        wind = world(_, _, _)[m / s],
        flap[rad],
        tilt = body(_, _, _)[N * m]
    ],
    mass: 2.5[kg],
    inertia: tensor {
        xx: 0.3,
        yy: 0.5,
        zz: 0.7,
        xy: 0.02,
        yz: -0.03,
        zx: 0.01
    }[kg * m ^ 2],
    points: [nose = (0.4, 0.1, -0.05), tail = (-0.7, 0, 0.1)],
    locals: [air = tail.velocity() - wind],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [
        pull = (-drag * air.norm() * air).at(tail),
        lift = body(0, 0, 3[N] * flap.sin() * (t / 1[s]).cos()).at(nose),
    ],
    moments: [control = tilt],
    potentials: [rope = 0.5 * stiffness * (nose.position() - world(1, 2, 3)).norm_squared()],
    outputs: [linearization],
});

rigid_body!(Board::<T> {
    motion: planar,
    inputs: [push = body(_, _)[N], turn[N * m]],
    mass: 1.7[kg],
    inertia: 0.21[kg * m ^ 2],
    points: [corner = (0.3, -0.2)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    forces: [
        jet = push.at(corner),
        brake = (-0.4[kg / s] * corner.velocity()).at(corner)
    ],
    moments: [motor = turn],
    outputs: [linearization],
});

rigid_body!(Door::<T> {
    motion: fixed_axis(hinge, world(1, 2, 2)),
    inputs: [push[N]],
    mass: 12[kg],
    inertia: cuboid(0.8, 0.04, 2),
    points: [hinge = (-0.4, 0, 0), handle = (0.35, 0.02, 0)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [hand = (push * body(0, 1, 0)).at(handle)],
    moments: [damping = -0.5[N * m * s] * angular_velocity],
    outputs: [linearization],
});

rigid_body!(Top::<T> {
    motion: fixed_point(foot),
    inputs: [gust = world(_, _, _)[N]],
    mass: 0.3[kg],
    inertia: principal(0.002, 0.003, 0.001)[kg * m ^ 2],
    points: [foot = (0.01, 0, -0.1)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [blow = gust],
    outputs: [linearization],
});

rigid_body!(Javelin::<T> {
    motion: rod(body(1, 0, 0)),
    inputs: [gust = world(_, _, _)[m / s]],
    mass: 0.8[kg],
    inertia: 0.42[kg * m ^ 2],
    points: [tail = (-0.6, 0, 0)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [drag = (-0.1[kg / s] * (tail.velocity() - gust)).at(tail)],
    outputs: [linearization],
});

rigid_body!(Bead::<T> {
    motion: planar_translation,
    mass: 0.5[kg],
    constraints: [wire = position.norm_squared() - 4[m ^ 2]],
    reactions: [normal = _ * (position / 1[m])],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    outputs: [linearization],
});

fn attitude() -> UnitQuaternion<f64> {
    UnitQuaternion::from_euler_angles(0.3, -0.9, 1.4)
}

fn spatial() -> Spatial {
    Spatial {
        position: Vector3::new(0.4, -0.7, 1.1),
        attitude: attitude(),
        velocity: Vector3::new(1.3, 2.1, -0.6),
        angular_velocity: Vector3::new(0.5, -1.4, 0.8),
    }
}

#[test]
fn a_free_body_with_constant_loads() {
    let state = spatial();
    let thrust = [0.05, 0.07, 0.08, 0.06];
    let input = |j: usize| {
        let [thrust_1, thrust_2, thrust_3, thrust_4] =
            core::array::from_fn(|i| by(thrust[i], i == j));
        CrazyflieInput {
            thrust_1,
            thrust_2,
            thrust_3,
            thrust_4,
        }
    };
    let [thrust_1, thrust_2, thrust_3, thrust_4] = thrust;
    let own = CrazyflieInput {
        thrust_1,
        thrust_2,
        thrust_3,
        thrust_4,
    };
    let found = Crazyflie::<f64>::default().linearize(0.3, &state, &own);
    let body = Crazyflie::<Derived>::default();
    let at = unmoved(&state);
    hold::<_, _, generic::Spatial<Derived>, 12, 4>(
        &found,
        &state,
        1e-14,
        |state| body.acceleration(derived(0.3), state, &input(9)),
        |j| body.acceleration(derived(0.3), &at, &input(j)),
    );
    let operations = Crazyflie::<f64>::OPERATIONS.iter();
    let mut operations = operations.filter(|one| one.function == "linearize");
    let counted = operations.next().expect("it was asked for");
    let count = counted.mul + counted.add;
    assert!(
        count <= 141 && counted.div + counted.sqrt + counted.trig == 0,
        "{counted:?}"
    );
}

#[test]
fn a_free_body_with_potentials_drag_and_vector_inputs() {
    let state = spatial();
    let [wind, tilt] = [[3.0, -1.0, 0.5], [0.1, 0.2, -0.4]];
    let input = |j: usize| GliderInput {
        wind: Vector3::from_fn(|i, _| by(wind[i], i == j)),
        flap: by(0.2, j == 3),
        tilt: Vector3::from_fn(|i, _| by(tilt[i], 4 + i == j)),
    };
    let own = GliderInput {
        wind: wind.into(),
        flap: 0.2,
        tilt: tilt.into(),
    };
    let found = Glider::<f64>::default().linearize(0.3, &state, &own);
    let body = Glider::<Derived>::default();
    let at = unmoved(&state);
    hold::<_, _, generic::Spatial<Derived>, 12, 7>(
        &found,
        &state,
        1e-14,
        |state| body.acceleration(derived(0.3), state, &input(9)),
        |j| body.acceleration(derived(0.3), &at, &input(j)),
    );
}

#[test]
fn a_body_in_the_plane() {
    let state = Planar {
        position: Vector2::new(0.3, 0.8),
        angle: 0.7,
        velocity: Vector2::new(-1.2, 0.4),
        angular_velocity: 2.1,
    };
    let input = |j: usize| BoardInput {
        push: Vector2::new(by(3.0, j == 0), by(-2.0, j == 1)),
        turn: by(0.4, j == 2),
    };
    let own = BoardInput {
        push: Vector2::new(3.0, -2.0),
        turn: 0.4,
    };
    let found = Board::<f64>::default().linearize(0.0, &state, &own);
    let body = Board::<Derived>::default();
    let at = unmoved(&state);
    hold::<_, _, generic::Planar<Derived>, 6, 3>(
        &found,
        &state,
        1e-14,
        |state| body.acceleration(derived(0.0), state, &input(9)),
        |j| body.acceleration(derived(0.0), &at, &input(j)),
    );
}

#[test]
fn a_body_on_a_hinge() {
    let state = Hinge {
        angle: 0.7,
        angular_velocity: 2.1,
    };
    let input = |j: usize| DoorInput {
        push: by(3.0, j == 0),
    };
    let found = Door::<f64>::default().linearize(0.0, &state, &DoorInput { push: 3.0 });
    let body = Door::<Derived>::default();
    let at = unmoved(&state);
    hold::<_, _, generic::Hinge<Derived>, 2, 1>(
        &found,
        &state,
        1e-14,
        |state| body.acceleration(derived(0.0), state, &input(9)),
        |j| body.acceleration(derived(0.0), &at, &input(j)),
    );
}

#[test]
fn a_body_on_a_ball_joint() {
    let state = Rotation {
        attitude: attitude(),
        angular_velocity: Vector3::new(2.0, -1.0, 5.0),
    };
    let gust = [0.3, 0.2, -0.1];
    let input = |j: usize| TopInput {
        gust: Vector3::from_fn(|i, _| by(gust[i], i == j)),
    };
    let found = Top::<f64>::default().linearize(0.0, &state, &TopInput { gust: gust.into() });
    let body = Top::<Derived>::default();
    let at = unmoved(&state);
    hold::<_, _, generic::Rotation<Derived>, 6, 3>(
        &found,
        &state,
        1e-14,
        |state| body.acceleration(derived(0.0), state, &input(9)),
        |j| body.acceleration(derived(0.0), &at, &input(j)),
    );
}

#[test]
fn a_rod() {
    let axis = Unit::new_normalize(Vector3::new(1.0, 2.0, -0.5));
    let state = Rod {
        position: Vector3::new(0.3, 0.8, 0.1),
        velocity: Vector3::new(10.0, 3.0, 4.0),
        axis,
        axis_rate: axis.cross(&Vector3::new(0.3, -0.8, 0.9)),
    };
    let gust = [0.3, 0.2, -0.1];
    let input = |j: usize| JavelinInput {
        gust: Vector3::from_fn(|i, _| by(gust[i], i == j)),
    };
    let found =
        Javelin::<f64>::default().linearize(0.0, &state, &JavelinInput { gust: gust.into() });
    let body = Javelin::<Derived>::default();
    let at = unmoved(&state);
    hold::<_, _, generic::Rod<Derived>, 12, 3>(
        &found,
        &state,
        1e-14,
        |state| body.acceleration(derived(0.0), state, &input(9)),
        |j| body.acceleration(derived(0.0), &at, &input(j)),
    );
}

#[test]
fn a_body_under_a_constraint() {
    let (sin, cos) = 0.4_f64.sin_cos();
    let state = PlanarTranslation {
        position: Vector2::new(2.0 * cos, 2.0 * sin),
        velocity: Vector2::new(-sin, cos) * 3.0,
    };
    let found = Bead::<f64>::default().linearize(0.0, &state, &());
    let body = Bead::<Derived>::default();
    hold::<_, _, generic::PlanarTranslation<Derived>, 4, 0>(
        &found,
        &state,
        1e-14,
        |state| body.acceleration(derived(0.0), state, &()),
        |_| unreachable!("it has no input"),
    );
}

#[test]
fn steps_are_those_of_the_exponential() {
    // a spring and a damper: x'' = u - 4 x - 0.4 x', as a matrix exponential in closed form
    rigid_body!(Mass {
        motion: translation,
        inputs: [push = world(_, _, _)[N]],
        mass: 1[kg],
        forces: [
            spring = -4[N / m] * position,
            damper = -0.4[kg / s] * velocity,
            hand = push,
        ],
        outputs: [linearization],
    });
    let input = MassInput {
        push: Vector3::zeros(),
    };
    let found = Mass::default().linearize(0.0, &Translation::default(), &input);
    for h in [1e-6_f64, 0.1, 3.0, -2.0, 40.0] {
        let (step, push) = found.discretized(h);
        let rate = (4.0_f64 - 0.04).sqrt();
        let (sin, cos) = (rate * h).sin_cos();
        let decay = (-0.2 * h).exp();
        let expected = [
            decay * (cos + 0.2 / rate * sin),
            decay * sin / rate,
            -4.0 * decay * sin / rate,
            decay * (cos - 0.2 / rate * sin),
        ];
        let entries = [step[(0, 0)], step[(0, 3)], step[(3, 0)], step[(3, 3)]];
        for (entry, expected) in entries.into_iter().zip(expected) {
            assert!(
                (entry - expected).abs() < 1e-13 * decay.max(1.0),
                "{h}: {entry} is {expected}"
            );
        }
        // a constant push ends in its deflection
        let deflection = (1.0 - expected[0]) / 4.0;
        assert!(
            (push[(0, 0)] - deflection).abs() < 1e-13 * decay.max(1.0),
            "{h}"
        );
        assert!(
            (push[(3, 0)] - expected[1]).abs() < 1e-13 * decay.max(1.0),
            "{h}"
        );
    }
}

rigid_body!(Diver::<T> {
    motion: spatial,
    inputs: [thrust[N], turn = body(_, _, _)[N * m]],
    mass: 2.5[kg],
    inertia: tensor {
        xx: 0.3,
        yy: 0.5,
        zz: 0.7,
        xy: 0.02,
        yz: -0.03,
        zx: 0.01
    }[kg * m ^ 2],
    points: [tail = (-0.7, 0, 0.1)],
    locals: [a = acceleration.in_body(), v = velocity.in_body()],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [
        propeller = body(thrust, 0, 0),
        added = -body(
            0.4[kg] * a.x,
            2[kg] * a.y + 0.1[kg * s / m] * v.x * a.x,
            2[kg] * a.z
        ),
        towed = (-0.3[kg] * tail.acceleration()).at(tail),
    ],
    moments: [
        steered = turn,
        turned = -0.2[kg * m ^ 2] * angular_acceleration
    ],
    outputs: [linearization],
});

#[test]
fn loads_that_follow_the_acceleration() {
    let state = spatial();
    let input = |j: usize| DiverInput {
        thrust: by(3.0, j == 0),
        turn: Vector3::from_fn(|i, _| by([0.1, -0.2, 0.3][i], 1 + i == j)),
    };
    let own = DiverInput {
        thrust: 3.0,
        turn: [0.1, -0.2, 0.3].into(),
    };
    let found = Diver::<f64>::default().linearize(0.3, &state, &own);
    let body = Diver::<Derived>::default();
    let at = unmoved(&state);
    hold::<_, _, generic::Spatial<Derived>, 12, 4>(
        &found,
        &state,
        1e-13,
        |state| body.acceleration(derived(0.3), state, &input(9)),
        |j| body.acceleration(derived(0.3), &at, &input(j)),
    );
}
