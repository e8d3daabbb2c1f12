//! A gyroscope in gimbals, with a weight on the inner gimbal.

use newton_euler::prelude::*;

rigid_system!(Gyroscope {
    doc: "A rotor in two gimbals: the outer one turns about the vertical, the inner one about its own x.",
    bodies: [
        outer {
            mass: 0.5[kg],
            inertia: principal(1.1e-3, 2e-3, 1.3e-3)[kg * m ^ 2]
        },
        inner {
            mass: 0.3[kg],
            inertia: principal(5e-4, 6e-4, 7e-4)[kg * m ^ 2],
            points: [hook = (0, 0.08, 0)[m]],
            forces: [ballast = world(0, 0, -0.4[N]).at(hook)],
        },
        rotor {
            mass: 0.9[kg],
            inertia: cylinder(0.05[m], 0.01[m]).along(body(0, 1, 0)),
        },
    ],
    joints: [
        turn = revolute(world(0, 0, 0), outer.G, body(0, 0, 1)),
        tilt = revolute(outer.G, inner.G, body(1, 0, 0)),
        spin = revolute(inner.G, rotor.G, body(0, 1, 0)),
    ],
    outputs: [energy],
});

/// Of the rotor, about its axis and across.
const ALONG: f64 = 0.9 * 0.05 * 0.05 / 2.0;
const ACROSS: f64 = 0.9 * (3.0 * 0.05 * 0.05 + 0.01 * 0.01) / 12.0;

fn state(turn: [f64; 2], tilt: [f64; 2], spin: f64) -> GyroscopeState {
    let hinge = |[angle, angular_velocity]: [f64; 2]| Hinge {
        angle,
        angular_velocity,
    };
    GyroscopeState {
        turn: hinge(turn),
        tilt: hinge(tilt),
        spin: hinge([0.7, spin]),
    }
}

/// With the axis level and no tilting, `C s p = r F` is exact: the precession p of a spin s under the moment r F.
#[test]
fn precesses_steadily() {
    let (gyroscope, spin) = (Gyroscope::default(), 900.0);
    // the weight turns about -x, and takes the axis of the spin, y, towards -x: counterclockwise
    let way = 0.08 * 0.4 / (ALONG * spin);
    let found = gyroscope.acceleration(0.0, &state([0.3, way], [0.0, 0.0], spin), &());
    for rate in [found.turn, found.tilt, found.spin] {
        assert!(rate.abs() < 1e-10, "{found:?}");
    }
    let start = state([0.3, way], [0.0, 0.0], spin);
    let end = gyroscope.integrate(&start).tolerance(1e-12).to(10.0);
    let end = end.expect("smooth");
    assert!((end.turn.angle - 0.3 - 10.0 * way).abs() < 1e-8);
    assert!(end.tilt.angle.abs() < 1e-8);
}

/// Let go from rest it nods. What Lagrange's function does not have in it keeps its momentum: the angles of turn and spin.
#[test]
fn keeps_what_is_cyclic() {
    let gyroscope = Gyroscope::default();
    let momenta = |state: &GyroscopeState| {
        let (turn, tilt) = (state.turn.angular_velocity, state.tilt.angle);
        let spin = state.spin.angular_velocity + turn * tilt.sin();
        let (sine, cosine) = tilt.sin_cos();
        let about_vertical = 1.3e-3 + 6e-4 * sine * sine + (7e-4 + ACROSS) * cosine * cosine;
        [
            ALONG * spin,
            about_vertical * turn + ALONG * spin * sine,
            0.08 * 0.4 * sine + gyroscope.kinetic_energy(state),
        ]
    };
    let start = state([0.0, 0.0], [0.2, 0.0], 300.0);
    let known = momenta(&start);
    let mut farthest = 0.0_f64;
    for sample in gyroscope
        .integrate(&start)
        .tolerance(1e-12)
        .samples(5.0, 0.01)
    {
        let state = sample.expect("smooth").state;
        for (found, known) in momenta(&state).iter().zip(known) {
            assert!((found - known).abs() < 1e-10, "{found} {known}");
        }
        farthest = farthest.max((state.tilt.angle - 0.2).abs());
    }
    assert!(farthest > 1e-3, "it nods");
}
