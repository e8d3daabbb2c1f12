//! Open drives of joints with several freedoms, and of floating bases.

use nalgebra::Vector3;
use newton_euler::prelude::*;

use super::compare::{Jointed, Listed, Random, close};
use super::counts::counted;

macro_rules! floating {
    ($name:ident, inputs: $inputs:tt, hub: {$($hub:tt)*}, drives: $drives:tt, outputs: $outputs:tt) => {
        rigid_system!($name {
            inputs: $inputs,
            bodies: [
                hub {
                    mass: 3[kg],
                    inertia: principal(0.5, 0.4, 0.6)[kg * m ^ 2],
                    points: [p = (0.1, 0.2, 0.3), q = (-0.2, 0.1, 0)],
                    $($hub)*
                },
                thigh {
                    mass: 0.6[kg],
                    inertia: principal(0.05, 0.04, 0.03)[kg * m ^ 2],
                    points: [p = (0, 0.1, 0.3), q = (0.1, 0, -0.3)],
                },
                plate {
                    mass: 0.3[kg],
                    inertia: principal(0.02, 0.03, 0.015)[kg * m ^ 2],
                    points: [p = (0.1, 0.1, 0)],
                },
                wheel {
                    mass: 0.4[kg],
                    inertia: principal(0.01, 0.01, 0.02)[kg * m ^ 2]
                },
            ],
            joints: [
                base = free(hub),
                hip = spherical(hub.p, thigh.p).turned(body(0, 0, 1), 90[deg]),
                table = planar(thigh.q, plate.p, body(0, 0, 1)),
                spin = revolute(hub.q, wheel.G, body(0, 0, 1)),
            ],
            fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
            drives: $drives,
            outputs: $outputs,
        });
    };
}

floating!(
    Pushed,
    inputs: [
        force = world(_, _, _)[N],
        moment = world(_, _, _)[N * m],
        hip_x[N * m], hip_y[N * m], hip_z[N * m],
        along_1[N], along_2[N], across[N],
        turn[N * m], motor[N * m]
    ],
    hub: { forces: [push = force], moments: [twist = moment] },
    drives: [
        at_hip = thigh.body(hip_x, hip_y, hip_z).on(hip),
        slides = thigh.body(along_1, along_2, across).on(table.position),
        turn_ = turn.on(table.angle),
        motor_ = motor.on(spin),
    ],
    outputs: []
);

floating!(
    Sought,
    inputs: [],
    hub: {},
    drives: [
        push = _.on(base.position),
        twist = _.on(base.attitude),
        at_hip = _.on(hip),
        slides = _.on(table.position),
        turn = _.on(table.angle),
        motor = _.on(spin),
    ],
    outputs: [inverse]
);

#[test]
fn open_drives_of_several_freedoms_are_those_that_act() {
    let mut numbers = Random::new(11);
    for _ in 0..50 {
        let state = PushedState {
            base: Jointed::random(&mut numbers),
            hip: Jointed::random(&mut numbers),
            table: Jointed::random(&mut numbers),
            spin: Jointed::random(&mut numbers),
        };
        let mut next = || 5.0 * numbers.number();
        let input = PushedInput {
            force: Vector3::from_fn(|_, _| next()),
            moment: Vector3::from_fn(|_, _| next()),
            hip_x: next(),
            hip_y: next(),
            hip_z: next(),
            along_1: next(),
            along_2: next(),
            across: next(),
            turn: next(),
            motor: next(),
        };
        let found = Pushed::default().acceleration(0.0, &state, &input);
        let given = SoughtAcceleration {
            base: found.base,
            hip: found.hip,
            table: found.table,
            spin: found.spin,
        };
        let PushedState {
            base,
            hip,
            table,
            spin,
        } = state;
        let state = SoughtState {
            base,
            hip,
            table,
            spin,
        };
        let SoughtDrives {
            push,
            twist,
            at_hip,
            slides,
            turn,
            motor,
        } = Sought::default().inverse(0.0, &state, &given, &());
        // the moment on a free body is in its axes
        let moment = base.attitude.inverse() * input.moment;
        let pairs = [
            (push.list(), input.force.list()),
            (twist.list(), moment.list()),
            (at_hip.list(), vec![input.hip_x, input.hip_y, input.hip_z]),
            (slides.list(), vec![input.along_1, input.along_2]),
            (vec![turn, motor], vec![input.turn, input.motor]),
        ];
        for (found, expected) in pairs {
            close("drives", &found, &expected, 100.0, 1e-12);
        }
    }
}

// a plate that floats in the plane, with a sled in its slot
rigid_system!(Tossed {
    motion: planar,
    inputs: [force = world(_, _)[N], turn[N * m], pull[N]],
    bodies: [
        plate {
            mass: 2[kg],
            inertia: 0.3[kg * m ^ 2],
            points: [p = (0.2, 0.1)],
            forces: [push = force],
            moments: [twist = turn],
        },
        sled {
            mass: 0.5[kg],
            inertia: 0.02[kg * m ^ 2],
            points: [p = (0.1, 0)]
        },
    ],
    joints: [
        flight = free(plate),
        slot = prismatic(plate.p, sled.p, body(3, 4))
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    drives: [slide = pull.on(slot)],
});

rigid_system!(TossedOpen {
    motion: planar,
    bodies: [
        plate {
            mass: 2[kg],
            inertia: 0.3[kg * m ^ 2],
            points: [p = (0.2, 0.1)]
        },
        sled {
            mass: 0.5[kg],
            inertia: 0.02[kg * m ^ 2],
            points: [p = (0.1, 0)]
        },
    ],
    joints: [
        flight = free(plate),
        slot = prismatic(plate.p, sled.p, body(3, 4))
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    drives: [
        twist = _.on(flight.angle),
        slide = _.on(slot),
        push = _.on(flight.position)
    ],
    outputs: [inverse],
});

#[test]
fn open_drives_in_the_plane() {
    let mut numbers = Random::new(12);
    for _ in 0..20 {
        let (flight, slot) = (Planar::random(&mut numbers), Slide::random(&mut numbers));
        let input = TossedInput {
            force: [numbers.number(), numbers.number()].into(),
            turn: numbers.number(),
            pull: numbers.number(),
        };
        let found = Tossed::default().acceleration(0.0, &TossedState { flight, slot }, &input);
        let given = TossedOpenAcceleration {
            flight: found.flight,
            slot: found.slot,
        };
        let state = TossedOpenState { flight, slot };
        let found = TossedOpen::default().inverse(0.0, &state, &given, &());
        close(
            "force",
            &found.push.list(),
            &input.force.list(),
            100.0,
            1e-13,
        );
        let others = ([found.twist, found.slide], [input.turn, input.pull]);
        close("others", &others.0, &others.1, 100.0, 1e-13);
    }
}

rigid_system!(Balls {
    doc: "`BallDouble`, with open drives.",
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: principal(0.04, 0.045, 0.012)[kg * m ^ 2],
            points: [top = (0, 0, 0.3)[m], end = (0, 0, -0.3)[m]],
        },
        lower {
            mass: 0.8[kg],
            inertia: principal(0.02, 0.022, 0.006)[kg * m ^ 2],
            points: [top = (0, 0, 0.25)[m]],
        },
    ],
    joints: [
        first = spherical(world(0, 0, 0), upper.top),
        second = spherical(upper.end, lower.top),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [upper = _.on(first), lower = _.on(second)],
    outputs: [inverse],
});

rigid_system!(Wheels {
    doc: "`Satellite`, with open drives.",
    bodies: [
        hub {
            mass: 120[kg],
            inertia: principal(12, 14, 9)[kg * m ^ 2],
            points: [px = (0.3, 0, 0), py = (0, 0.3, 0), pz = (0, 0, 0.3)],
        },
        wheel_x {
            mass: 4[kg],
            inertia: principal(0.035, 0.02, 0.02)[kg * m ^ 2]
        },
        wheel_y {
            mass: 4[kg],
            inertia: principal(0.02, 0.035, 0.02)[kg * m ^ 2]
        },
        wheel_z {
            mass: 4[kg],
            inertia: principal(0.02, 0.02, 0.035)[kg * m ^ 2]
        },
    ],
    joints: [
        orbit = free(hub),
        spin_x = revolute(hub.px, wheel_x.G, body(1, 0, 0)),
        spin_y = revolute(hub.py, wheel_y.G, body(0, 1, 0)),
        spin_z = revolute(hub.pz, wheel_z.G, body(0, 0, 1)),
    ],
    drives: [
        push = _.on(orbit.position),
        twist = _.on(orbit.attitude),
        motor_x = _.on(spin_x),
        motor_y = _.on(spin_y),
        motor_z = _.on(spin_z),
    ],
    outputs: [inverse],
});

/// Of the satellite 75 in the axes of the hub, and 57 for the turns of its acceleration and force.
#[test]
fn operations_of_inverse_dynamics_stay_few() {
    let bounds = [
        (counted(Balls::OPERATIONS, "inverse"), (181, 0)),
        (counted(Wheels::OPERATIONS, "inverse"), (132, 0)),
    ];
    for (found, bound) in bounds {
        assert!(
            found.0 <= bound.0 && found.1 <= bound.1,
            "{found:?} of {bound:?}"
        );
    }
}
