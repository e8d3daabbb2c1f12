//! Joints that follow others, compared with the same constraints as written, and by hand.

use newton_euler::prelude::*;

rigid_system!(Geared {
    urdf: "tests/urdf/geared.urdf",
    locked: [held = 0.3[rad]],
    inputs: [torque[N * m]],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [motor = torque.on(drive)],
    outputs: [reactions(rack), energy],
});

rigid_system!(ByHand {
    inputs: [torque[N * m]],
    bodies: [
        wheel {
            mass: 0.7[kg],
            inertia: principal(0.0012, 0.0015, 0.0018)[kg * m ^ 2],
            points: [hub = (-0.01, -0.02, 0)[m], arm = (0.29, -0.02, 0.2)[m]],
        },
        pinion {
            mass: 0.2[kg],
            inertia: principal(0.0002, 0.0002, 0.0003)[kg * m ^ 2],
            points: [hub = (-0.03, 0, -0.01)[m]],
        },
        bar {
            mass: 1.5[kg],
            inertia: principal(0.002, 0.02, 0.02)[kg * m ^ 2]
        },
        lever {
            mass: 1[kg],
            inertia: principal(0.01, 0.01, 0.01)[kg * m ^ 2]
        },
        twin {
            mass: 1[kg],
            inertia: principal(0.01, 0.01, 0.01)[kg * m ^ 2]
        },
        nut {
            mass: 0.3[kg],
            inertia: principal(0.001, 0.001, 0.001)[kg * m ^ 2]
        },
        needle {
            mass: 0.1[kg],
            inertia: principal(0.001, 0.002, 0.001)[kg * m ^ 2]
        },
    ],
    joints: [
        drive = revolute(world(0.1, 0, 0.2), wheel.hub, body(0, 0, 1)).turned(body(1, 0, 0), 0.3),
        follow = revolute(wheel.arm, pinion.hub, body(0, 1, 1)),
        rack = prismatic(world(0, 0.1, 0), bar.G, body(1, 0, 0)),
        held = weld(world(0, 0, 0), lever.G).turned(body(0, 1, 0), 0.3),
        copy = revolute(world(0, 0, 0), twin.G, body(0, 1, 0)),
        screw = prismatic(world(0, 0, 0.1), nut.G, body(0, 0, 1)),
        gauge = revolute(world(0, 0, 0), needle.G, body(0, 1, 0)),
    ],
    constraints: [
        first = follow.angle + 2.5 * drive.angle - 0.1[rad],
        second = rack.position - 0.05[m] * follow.angle,
        third = copy.angle - 0.3[rad],
        fourth = screw.position - 1[m] * drive.angle,
        fifth = gauge.angle - rack.position / 1[m] - 0.2,
    ],
    drives: [motor = torque.on(drive)],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    outputs: [reactions(rack), energy],
});

#[test]
fn joints_that_follow_others() {
    let (geared, by_hand) = (Geared::default(), ByHand::default());
    for step in 0..8 {
        let (angle, rate) = (0.7 * f64::from(step) - 2.0, 1.5 - 0.4 * f64::from(step));
        let hinge = |angle, angular_velocity| Hinge {
            angle,
            angular_velocity,
        };
        let (follow, follow_rate) = (0.1 - 2.5 * angle, -2.5 * rate);
        let state = GearedState {
            drive: hinge(angle, rate),
            follow: hinge(follow, follow_rate),
            rack: Slide {
                position: 0.05 * follow,
                velocity: 0.05 * follow_rate,
            },
            copy: hinge(0.3, 0.0),
            screw: Slide {
                position: angle,
                velocity: rate,
            },
            gauge: hinge(0.05 * follow + 0.2, 0.05 * follow_rate),
        };
        let GearedState {
            drive,
            follow,
            rack,
            copy,
            screw,
            gauge,
        } = state;
        let same = ByHandState {
            drive,
            follow,
            rack,
            copy,
            screw,
            gauge,
        };
        let (input, hand) = (GearedInput { torque: 0.6 }, ByHandInput { torque: 0.6 });
        geared.check(0.0, &state, &input).unwrap();
        let (a, b) = (
            geared.acceleration(0.0, &state, &input),
            by_hand.acceleration(0.0, &same, &hand),
        );
        let size = b.drive.abs().max(b.follow.abs()).max(1.0);
        let pairs = [
            (a.drive, b.drive),
            (a.follow, b.follow),
            (a.rack, b.rack),
            (a.copy, b.copy),
            (a.screw, b.screw),
            (a.gauge, b.gauge),
        ];
        for (found, expected) in pairs {
            assert!(
                (found - expected).abs() < 1e-13 * size,
                "{found} and {expected}"
            );
        }
        assert!((a.follow + 2.5 * a.drive).abs() < 1e-13 * size);
        assert!((a.rack - 0.05 * a.follow).abs() < 1e-13 * size);
        assert!((a.screw - a.drive).abs() < 1e-13 * size);
        assert!((a.gauge - a.rack).abs() < 1e-13 * size);
        // what is held so stands in energy, too
        let (one, other) = (geared.kinetic_energy(&state), by_hand.kinetic_energy(&same));
        assert!((one - other).abs() < 1e-14 * other.abs());
    }
}
