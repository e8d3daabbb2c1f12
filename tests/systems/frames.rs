//! Joints in series, with frames between them.

use newton_euler::prelude::*;

rigid_system!(Gimbal {
    bodies: [top {
        mass: 2[kg],
        inertia: principal(0.03, 0.04, 0.02),
        points: [foot = (0.01, 0.02, -0.4)]
    }],
    joints: [cross = universal(world(0, 0, 0), top.foot, body(1, 0, 0), body(0, 0.6, 0.8))],
    fields: [weight = mass * world(0, 0, -9.81)],
});

rigid_system!(Hinges {
    bodies: [
        ring { mass: 0[kg] },
        top {
            mass: 2[kg],
            inertia: principal(0.03, 0.04, 0.02),
            points: [foot = (0.01, 0.02, -0.4)]
        },
    ],
    joints: [
        outer = revolute(world(0, 0, 0), ring.G, body(1, 0, 0)),
        inner = revolute(ring.G, top.foot, body(0, 0.6, 0.8)),
    ],
    fields: [weight = mass * world(0, 0, -9.81)],
});

#[test]
fn two_hinges_with_a_frame_between_are_a_universal_joint() {
    let (gimbal, hinges) = (Gimbal::default(), Hinges::default());
    for step in 0..50 {
        let x = 0.37 * f64::from(step);
        let hinge = |angle: f64, angular_velocity: f64| Hinge {
            angle,
            angular_velocity,
        };
        let (outer, inner) = (hinge(x, 1.3 - x), hinge(0.9 * x.sin(), 2.0 * x.cos()));
        let state = HingesState { outer, inner };
        let same = GimbalState {
            cross: Universal {
                angle_1: outer.angle,
                angle_2: inner.angle,
                angular_velocity_1: outer.angular_velocity,
                angular_velocity_2: inner.angular_velocity,
            },
        };
        let found = hinges.acceleration(0.0, &state, &());
        let expected = gimbal.acceleration(0.0, &same, &()).cross;
        let size = 1.0 + expected.norm();
        assert!((found.outer - expected[0]).abs() < 1e-13 * size);
        assert!((found.inner - expected[1]).abs() < 1e-13 * size);
    }
}
