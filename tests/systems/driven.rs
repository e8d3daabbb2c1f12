//! Joints whose motion is prescribed. With the drives that are found, the same system without
//! prescriptions moves in the same way.

use newton_euler::prelude::*;

use super::compare::{Jointed, Random, close};

/// Two systems of the same bodies: one with joints that are driven, one with drives from outside.
macro_rules! both {
    ($driven:ident, $free:ident, { $($bodies:tt)* },
     [$($driven_joints:tt)*], [$($free_joints:tt)*], [$($drives:tt)*], [$($inputs:tt)*]) => {
        rigid_system!($driven {
            inputs: [turn[rad].moving, push[N]],
            bodies: [$($bodies)*],
            joints: [$($driven_joints)*],
            locals: [phase = 2[rad / s] * t],
            fields: [weight = mass * world(0.4[m / s ^ 2], 0, -9.81[m / s ^ 2])],
            drives: [along = (-3[N / m] * slide.position).on(slide)],
            outputs: [reactions, energy, momentum, mass_matrix],
        });
        rigid_system!($free {
            inputs: [$($inputs)* push[N]],
            bodies: [$($bodies)*],
            joints: [$($free_joints)*],
            fields: [weight = mass * world(0.4[m / s ^ 2], 0, -9.81[m / s ^ 2])],
            drives: [along = (-3[N / m] * slide.position).on(slide), $($drives)*],
            outputs: [reactions, energy, momentum],
        });
    };
}

both!(
    Prescribed,
    Pushed,
    {
        base {
            mass: 3[kg],
            inertia: principal(0.5, 0.4, 0.6)[kg * m ^ 2],
            points: [p = (0.1, 0.2, 0.3), q = (-0.2, 0.1, 0)],
            forces: [jet = body(push, 0, 0).at(p)],
        },
        boom {
            mass: 0.6[kg],
            inertia: principal(0.05, 0.04, 0.03)[kg * m ^ 2],
            points: [p = (0, 0.1, 0.3), q = (0.1, 0, -0.3)],
        },
        rod {
            mass: 0.3[kg],
            inertia: principal(0.02, 0.03, 0.01)[kg * m ^ 2],
            points: [p = (0.1, 0.1, 0), q = (0, 0, 0.2)],
        },
        cross {
            mass: 0.4[kg],
            inertia: principal(0.02, 0.01, 0.015)[kg * m ^ 2],
            points: [p = (0, 0, 0.2)],
        },
        nut {
            mass: 0.2[kg],
            inertia: principal(0.004, 0.003, 0.002)[kg * m ^ 2],
            points: [p = (0.1, 0, 0)],
        },
        wheel { mass: 0.5[kg], inertia: principal(0.01, 0.01, 0.02)[kg * m ^ 2] },
        slider { mass: 0.8[kg], inertia: principal(0.02, 0.03, 0.04)[kg * m ^ 2] },
    },
    [
        orbit = free(base),
        slide = prismatic(boom.p, slider.G, body(0, 0.6, 0.8)),
        hinge = revolute(base.p, boom.p, body(1, 2, 2)).driven(0.3[rad] * (3[rad / s] * t).sin() + turn),
        rail = cylindrical(boom.q, rod.p, body(0, 0, 1)).driven(0.1[m] * phase.cos(), phase),
        cardan = universal(base.q, cross.p, body(1, 0, 0), body(0, 1, 0)).driven(phase.sin(), 0.2 * turn),
        thread = screw(rod.q, nut.p, body(1, 0, 0), 0.05[m]).driven(turn * phase),
        spin = revolute(base.G, wheel.G, body(0, 0, 1)).driven(40[rad / s] * t),
    ],
    [
        orbit = free(base),
        slide = prismatic(boom.p, slider.G, body(0, 0.6, 0.8)),
        hinge = revolute(base.p, boom.p, body(1, 2, 2)),
        rail = cylindrical(boom.q, rod.p, body(0, 0, 1)),
        cardan = universal(base.q, cross.p, body(1, 0, 0), body(0, 1, 0)),
        thread = screw(rod.q, nut.p, body(1, 0, 0), 0.05[m]),
        spin = revolute(base.G, wheel.G, body(0, 0, 1)),
    ],
    [
        a = hinge_drive.on(hinge),
        b = rail_push.on(rail.position),
        c = rail_turn.on(rail.angle),
        d = cardan_1.on(cardan.angle_1),
        e = cardan_2.on(cardan.angle_2),
        f = thread_drive.on(thread),
        g = spin_drive.on(spin),
    ],
    [
        hinge_drive[N * m],
        rail_push[N],
        rail_turn[N * m],
        cardan_1[N * m],
        cardan_2[N * m],
        thread_drive[N * m],
        spin_drive[N * m],
    ]
);

/// The state of the system without prescriptions, moving as they say.
fn with_prescriptions(t: f64, state: &PrescribedState, input: &PrescribedInput) -> PushedState {
    let (phase, sine, cosine) = (2.0 * t, (2.0 * t).sin(), (2.0 * t).cos());
    let (turn, turn_rate) = (input.turn, input.turn_rate);
    PushedState {
        orbit: state.orbit,
        slide: state.slide,
        hinge: Hinge {
            angle: 0.3 * (3.0 * t).sin() + turn,
            angular_velocity: 0.9 * (3.0 * t).cos() + turn_rate,
        },
        rail: Cylinder {
            position: 0.1 * cosine,
            angle: phase,
            velocity: -0.2 * sine,
            angular_velocity: 2.0,
        },
        cardan: Universal {
            angle_1: sine,
            angle_2: 0.2 * turn,
            angular_velocity_1: 2.0 * cosine,
            angular_velocity_2: 0.2 * turn_rate,
        },
        thread: Hinge {
            angle: turn * phase,
            angular_velocity: turn_rate * phase + 2.0 * turn,
        },
        spin: Hinge {
            angle: 40.0 * t,
            angular_velocity: 40.0,
        },
    }
}

#[test]
fn drives_that_are_found_make_the_motion() {
    let (driven, free) = (Prescribed::default(), Pushed::default());
    let mut numbers = Random::new(91);
    for _ in 0..30 {
        let t = numbers.number();
        let [turn, turn_rate, turn_acceleration, push] = [0; 4].map(|_| numbers.number());
        let input = PrescribedInput {
            turn,
            turn_rate,
            turn_acceleration,
            push,
        };
        let state = PrescribedState {
            orbit: Jointed::random(&mut numbers),
            slide: Jointed::random(&mut numbers),
        };
        let found = driven.reactions(t, &state, &input);
        let whole = with_prescriptions(t, &state, &input);
        let pushed = PushedInput {
            hinge_drive: found.hinge_drive,
            rail_push: found.rail_drive_position,
            rail_turn: found.rail_drive_angle,
            cardan_1: found.cardan_drive_angle_1,
            cardan_2: found.cardan_drive_angle_2,
            thread_drive: found.thread_drive,
            spin_drive: found.spin_drive,
            push,
        };
        let a = driven.acceleration(t, &state, &input);
        let b = free.acceleration(t, &whole, &pushed);
        let (phase, sine, cosine) = (2.0 * t, (2.0 * t).sin(), (2.0 * t).cos());
        let expected = [
            -2.7 * (3.0 * t).sin() + turn_acceleration,
            -0.4 * cosine,
            0.0,
            -4.0 * sine,
            0.2 * turn_acceleration,
            turn_acceleration * phase + 4.0 * turn_rate,
            0.0,
        ];
        let moved = [
            b.hinge,
            b.rail.linear,
            b.rail.angular,
            b.cardan.x,
            b.cardan.y,
            b.thread,
            b.spin,
        ];
        close("prescribed", &moved, &expected, 30.0, 1e-11);
        close("slide", &[a.slide], &[b.slide], 30.0, 1e-12);
        let (x, y) = (a.orbit, b.orbit);
        close(
            "base",
            x.linear.as_slice(),
            y.linear.as_slice(),
            30.0,
            1e-12,
        );
        close(
            "base turns",
            x.angular.as_slice(),
            y.angular.as_slice(),
            30.0,
            1e-12,
        );
        let others = free.reactions(t, &whole, &pushed);
        for (one, other) in [
            (found.hinge, others.hinge),
            (found.rail, others.rail),
            (found.spin, others.spin),
            (found.thread, others.thread),
            (found.cardan, others.cardan),
            (found.slide, others.slide),
        ] {
            close(
                "force",
                one.force.as_slice(),
                other.force.as_slice(),
                30.0,
                1e-12,
            );
            close(
                "moment",
                one.moment.as_slice(),
                other.moment.as_slice(),
                30.0,
                1e-12,
            );
        }
        totals(t, (&state, &input), (&whole, &pushed));
    }
}

/// Energies, momenta and the mass matrix of the freedoms that are open.
fn totals(
    t: f64,
    (state, input): (&PrescribedState, &PrescribedInput),
    (whole, pushed): (&PushedState, &PushedInput),
) {
    let (driven, free) = (Prescribed::default(), Pushed::default());
    let found = driven.acceleration(t, state, input);
    let x = found.orbit;
    let energies = [
        (
            driven.kinetic_energy(t, state, input),
            free.kinetic_energy(whole),
        ),
        (
            driven.potential_energy(t, state, input),
            free.potential_energy(t, whole, pushed),
        ),
    ];
    for (one, other) in energies {
        close("energy", &[one], &[other], 10.0, 1e-13);
    }
    let one = driven.angular_momentum(t, state, input);
    let other = free.angular_momentum(whole);
    close("momentum", one.as_slice(), other.as_slice(), 10.0, 1e-13);
    // the freedoms that are open alone have rows
    let matrix = driven.mass_matrix(t, state, input);
    let forces = driven.generalized_forces(t, state, input);
    let numbers = [x.linear.as_slice(), x.angular.as_slice(), &[found.slide]].concat();
    let product = matrix * nalgebra::SVector::<f64, 7>::from_column_slice(&numbers);
    close("M q''", product.as_slice(), forces.as_slice(), 100.0, 1e-12);
}

// a pendulum on a slide that shakes fast stands upright (P. L. Kapitza)
rigid_system!(Shaken {
    motion: planar,
    params: [rate = 300[rad / s], amplitude = 0.02[m]],
    bodies: [
        slider {
            mass: 1[kg],
            inertia: 0.1[kg * m ^ 2]
        },
        rod {
            mass: 0.2[kg],
            inertia: 6e-4[kg * m ^ 2],
            points: [pin = (0, -0.1)[m]]
        },
    ],
    joints: [
        shaker = prismatic(world(0, 0), slider.G, body(0, 1)).driven(amplitude * (rate * t).cos()),
        pin = revolute(slider.G, rod.pin),
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    drives: [friction = (-2e-4[N * m * s] * pin.angular_velocity).on(pin)],
    outputs: [taylor, reactions(shaker), energy],
});

#[test]
fn a_shaken_pendulum_stands() {
    let start = ShakenState {
        pin: Hinge {
            angle: 0.2,
            angular_velocity: 0.0,
        },
    };
    let shaken = Shaken::default();
    let moves = |body: &Shaken| {
        let mut largest: f64 = 0.0;
        let mut state = start;
        for step in 0..20 {
            let end = f64::from(step + 1) * 0.1;
            let motion = body
                .integrate(&state)
                .starting_at(f64::from(step) * 0.1)
                .tolerance(1e-10);
            state = motion.to(end).unwrap();
            largest = largest.max(state.pin.angle.abs());
        }
        largest
    };
    assert!(moves(&shaken) < 0.3);
    let calm = Shaken::new(ShakenParams {
        amplitude: 0.0,
        ..ShakenParams::default()
    })
    .unwrap();
    assert!(moves(&calm) > 1.0);
    // the shaker carries the weight, and what its motion takes
    let still = ShakenState::default();
    let load: ShakenReactions = calm.reactions(0.0, &still, &());
    close("load", &[load.shaker_drive], &[1.2 * 9.81], 10.0, 1e-14);
}

/// A pendulum on an arm that moves so.
macro_rules! started {
    ($name:ident $motion:expr) => {
        rigid_system!($name {
            motion: planar,
            params: [start[s], slower[s]],
            bodies: [
                arm {
                    mass: 1[kg],
                    inertia: 0.1[kg * m ^ 2],
                    points: [a = (-0.5, 0), b = (0.5, 0)]
                },
                bob {
                    mass: 1[kg],
                    inertia: 0.1[kg * m ^ 2],
                    points: [top = (0, 0.4)]
                },
            ],
            joints: [
                turn = revolute(world(0, 0), arm.a).driven($motion),
                swing = revolute(arm.b, bob.top),
            ],
            fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
        });
    };
}
// it speeds up and slows down, at times that are known only in `new`, and may be in any order
started!(Started
    0.3[rad / s ^ 2] * (t - start).max(0).powi(2)
        - if t < slower { 0 } else { 0.3[rad / s ^ 2] * (t - slower).powi(2) }
        + 0.1[rad / s ^ 2] * t * (t - 2[s]) * table(t, [0, 1, 3][s], [0, 1, 0.5], cubic));
started!(Still
    0[rad] * (start + slower) / 1[s]
        + 0.1[rad / s ^ 2] * t * (t - 2[s]) * table(t, [0, 1, 3][s], [0, 1, 0.5], cubic));
started!(Moving
    0.3[rad / s ^ 2] * (t - start).powi(2) + 0 * slower / 1[s]
        + 0.1[rad / s ^ 2] * t * (t - 2[s]) * table(t, [0, 1, 3][s], [0, 1, 0.5], cubic));

#[test]
fn motions_with_continuous_rates_have_branches() {
    let (start, slower) = (0.7, 1.9);
    let started = Started::new(StartedParams { start, slower }).unwrap();
    let still = Still::new(StillParams { start, slower }).unwrap();
    let moving = Moving::new(MovingParams { start, slower }).unwrap();
    let swing = Hinge {
        angle: 0.4,
        angular_velocity: -0.3,
    };
    let found = |time: f64| {
        started
            .acceleration(time, &StartedState { swing }, &())
            .swing
    };
    let before = still.acceleration(0.5, &StillState { swing }, &()).swing;
    assert!((found(0.5) - before).abs() < 1e-15);
    let after = moving.acceleration(1.5, &MovingState { swing }, &()).swing;
    assert!((found(1.5) - after).abs() < 1e-15);
}
