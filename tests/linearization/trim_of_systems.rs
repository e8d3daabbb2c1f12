//! Equilibria of systems and their modes, compared with those found by hand.

use newton_euler::nalgebra::UnitQuaternion;
use newton_euler::prelude::*;

const G: f64 = 9.80665;

rigid_system!(DoublePendulum {
    motion: planar,
    bodies: [
        upper {
            mass: 1.3[kg],
            inertia: 0.02[kg * m ^ 2],
            points: [top = (0, 0.3), end = (0, -0.4)]
        },
        lower {
            mass: 0.7[kg],
            inertia: 0.01[kg * m ^ 2],
            points: [top = (0, 0.25)]
        },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.top),
        elbow = revolute(upper.end, lower.top),
    ],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    outputs: [linearization],
});

#[test]
fn a_double_pendulum_has_the_frequencies_of_the_closed_form() {
    let hinge = |angle| Hinge {
        angle,
        angular_velocity: 0.0,
    };
    let start = DoublePendulumState {
        shoulder: hinge(0.3),
        elbow: hinge(-0.5),
    };
    let body = DoublePendulum::default();
    let search = body.trim(&start).free(["shoulder_angle", "elbow_angle"]);
    let hanging = search.solve().expect("it hangs");
    assert!(hanging.state.shoulder.angle.abs() < 1e-15);
    assert!(hanging.state.elbow.angle.abs() < 1e-15);
    // of the angles against the vertical: M q'' + K q = 0, both by hand
    let (first, second, long) = (0.02 + 1.3 * 0.09, 0.01 + 0.7 * 0.0625, 0.7);
    let m = [first + 0.7 * long * long, 0.7 * long * 0.25, second];
    let k = [(1.3 * 0.3 + 0.7 * long) * G, 0.7 * 0.25 * G];
    // det(K - w^2 M) = 0
    let a = m[0] * m[2] - m[1] * m[1];
    let b = m[0] * k[1] + m[2] * k[0];
    let root = (b * b - 4.0 * a * k[0] * k[1]).sqrt();
    let modes = hanging.modes().expect("A is finite");
    assert_eq!(modes.len(), 2);
    for (mode, square) in modes
        .iter()
        .zip([(b + root) / (2.0 * a), (b - root) / (2.0 * a)])
    {
        let frequency: f64 = square.sqrt();
        assert!((mode.natural_frequency() / frequency - 1.0).abs() < 1e-13);
        assert!(mode.damping_ratio().abs() < 1e-13);
        let period = mode.period().expect("it swings");
        assert!((period * frequency / core::f64::consts::TAU - 1.0).abs() < 1e-13);
    }
}

rigid_system!(FourBar {
    motion: planar,
    inputs: [torque[N * m]],
    bodies: [
        crank {
            mass: 0.4[kg],
            inertia: 4e-4[kg * m ^ 2],
            points: [o = (-0.04, 0), a = (0.06, 0)]
        },
        coupler {
            mass: 1.1[kg],
            inertia: 0.012[kg * m ^ 2],
            points: [a = (-0.16, 0), b = (0.19, 0)]
        },
        rocker {
            mass: 0.8[kg],
            inertia: 4.5e-3[kg * m ^ 2],
            points: [c = (-0.11, 0), b = (0.14, 0)]
        },
    ],
    joints: [
        o = revolute(world(0, 0), crank.o),
        a = revolute(crank.a, coupler.a),
        b = revolute(coupler.b, rocker.b),
        c = revolute(world(0.3, 0), rocker.c),
    ],
    drives: [motor = torque.on(o)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    outputs: [linearization, energy],
});

#[test]
fn a_linkage_rests_where_its_energy_has_no_slope() {
    let hinge = |angle| Hinge {
        angle,
        angular_velocity: 0.0,
    };
    let body = FourBar::default();
    let input = FourBarInput { torque: 0.0 };
    let near = FourBarState {
        o: hinge(-2.0),
        a: hinge(0.513_679 + 2.0),
        b: hinge(1.239_513_4 - 0.513_679),
    };
    let mut state = near;
    body.project(0.0, &mut state, &input).expect("it closes");
    let search = body.trim(&state).free(["o_angle", "a_angle", "b_angle"]);
    let rest = search.solve().expect("it rests");
    assert_eq!(rest.undetermined, 0);
    body.check(0.0, &rest.state, &input).expect("it is closed");
    // the one way of moving, by differences along the loop
    let energy = |angle: f64| {
        let mut state = rest.state;
        let turn = angle - state.o.angle;
        state.o.angle += turn;
        state.a.angle -= turn;
        body.project(0.0, &mut state, &input).expect("it closes");
        (state.o.angle, body.potential_energy(0.0, &state, &input))
    };
    let [(first, before), (second, after)] =
        [-1e-4, 1e-4].map(|turn| energy(rest.state.o.angle + turn));
    let slope = (after - before) / (second - first);
    assert!(slope.abs() < 1e-7, "{slope}");
    let modes = rest.modes().expect("A is finite");
    let count: usize = modes
        .iter()
        .map(|mode| 1 + usize::from(mode.eigenvalue.im > 0.0))
        .sum();
    assert_eq!((count, modes.neutral()), (2, 0), "{modes:?}");
    // frequency: a motion from near by
    if modes.len() == 1 {
        let mut start = rest.state;
        start.o.angle += 1e-4;
        start.a.angle -= 1e-4;
        body.project(0.0, &mut start, &input).expect("it closes");
        let half = modes[0].period().expect("it swings") / 2.0;
        let later = body
            .integrate(&start)
            .input(input)
            .to(half)
            .expect("it moves");
        let (before, after) = (
            start.o.angle - rest.state.o.angle,
            later.o.angle - rest.state.o.angle,
        );
        assert!((after / before + 1.0).abs() < 1e-3, "{before} {after}");
    }
}

rigid_system!(Unicycle {
    doc: "A wheel that rolls without slip, on the axle of a fork.",
    params: [r = 0.35[m]],
    bodies: [
        fork {
            mass: 1.5[kg],
            inertia: principal(0.02, 0.02, 0.02)[kg * m ^ 2]
        },
        wheel {
            mass: 2.5[kg],
            inertia: disc(r).along(body(0, 1, 0)),
            locals: [
                n = body(0, 1, 0),
                up = world(0, 0, 1),
                low = (up.dot(n) * n - up).normalize(),
            ],
            points: [contact = G + r * low],
            constraints: [rolling = contact.velocity()],
        },
    ],
    joints: [
        base = free(fork),
        axle = revolute(fork.G, wheel.G, body(0, 1, 0))
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    outputs: [linearization],
});

/// Nine ways to move on steadily: six coordinates that nothing depends on, spin, pitch rate and rate
/// of turn. Constraints are derived so accurately that none of these appears to grow.
#[test]
fn a_wheel_in_a_turn() {
    let unicycle = Unicycle::default();
    for turn in [0.1, 0.3, 0.8, 1.5, 2.0, 3.0] {
        for spin in [5.0, 9.0, 15.0, 40.0] {
            let mut start = UnicycleState::default();
            start.axle.angular_velocity = spin;
            start.base.velocity = [0.35 * spin, 0.0, 0.0].into();
            start.base.position.z = 0.35;
            start.base.attitude = UnitQuaternion::from_euler_angles(-0.1, 0.0, 0.0);
            let trim = unicycle.trim(&start).turning([0.0, 0.0, turn]);
            let Ok(steady) = trim.free(["base_attitude_x", "base_velocity"]).solve() else {
                assert!(spin * turn > 100.0 || spin < 9.0, "{turn} {spin}");
                continue;
            };
            let modes = steady.modes().unwrap();
            assert_eq!(modes.neutral(), 9, "{turn} {spin}: {modes:?}");
        }
    }
}
