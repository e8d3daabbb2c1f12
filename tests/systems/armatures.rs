//! Armatures, compared with rotors on the ground that gears turn with the coordinates.

use newton_euler::prelude::*;

use super::compare::{Jointed, Random, close};

/// An arm on a free base, its drives, and what stands on the ground beside it.
macro_rules! arm {
    ($name:ident, [$($slew:tt)*], [$($lift:tt)*], [$($slide:tt)*], [$($thread:tt)*], [$($rotors:tt)*], [$($axles:tt)*], $constraints:tt, $drives:tt, $outputs:tt) => {
        rigid_system!($name {
            inputs: [push[N]],
            bodies: [
                base {
                    mass: 3[kg],
                    inertia: principal(0.5, 0.4, 0.6)[kg * m ^ 2],
                    points: [p = (0.1, 0.2, 0.3)[m]],
                    forces: [jet = body(push, 0, 0).at(p)],
                },
                turret {
                    mass: 1[kg],
                    inertia: principal(0.1, 0.1, 0.15)[kg * m ^ 2],
                    points: [p = (0.1, 0, 0.3)[m]],
                },
                boom {
                    mass: 0.6[kg],
                    inertia: principal(0.05, 0.04, 0.03)[kg * m ^ 2],
                    points: [p = (0, 0.1, 0.3)[m], q = (0.1, 0, -0.3)[m]],
                },
                slider {
                    mass: 0.8[kg],
                    inertia: principal(0.02, 0.03, 0.04)[kg * m ^ 2],
                    points: [q = (0, 0, 0.1)[m]],
                },
                nut { mass: 0.2[kg], inertia: principal(0.004, 0.003, 0.002)[kg * m ^ 2] },
                $($rotors)*
            ],
            joints: [
                orbit = free(base),
                slew = revolute(base.p, turret.G, body(0, 0, 1))$($slew)*,
                lift = revolute(turret.p, boom.p, body(1, 2, 2))$($lift)*,
                slide = prismatic(boom.q, slider.G, body(0, 0.6, 0.8))$($slide)*,
                thread = screw(slider.q, nut.G, body(1, 0, 0), 0.05[m])$($thread)*,
                $($axles)*
            ],
            constraints: $constraints,
            drives: $drives,
            fields: [weight = mass * world(0.4[m / s ^ 2], 0, -9.81[m / s ^ 2])],
            outputs: $outputs,
        });
    };
}
arm!(
    Own,
    [.armature(0.03[kg * m ^ 2])],
    [.armature(0.2[kg * m ^ 2])],
    [.armature(0.7[kg])],
    [.armature(0.004[kg * m ^ 2])],
    [], [], [],
    [damper = (-0.3[N * s / m] * slide.velocity).on(slide)],
    [energy, reactions, mass_matrix]
);
// J n^2 of each
arm!(
    Geared,
    [],
    [],
    [],
    [],
    [
        first {
            mass: 1[kg],
            inertia: principal(0.03, 1, 1)[kg * m ^ 2]
        },
        second {
            mass: 1[kg],
            inertia: principal(0.05, 1, 1)[kg * m ^ 2]
        },
        third {
            mass: 1[kg],
            inertia: principal(0.007, 1, 1)[kg * m ^ 2]
        },
        fourth {
            mass: 1[kg],
            inertia: principal(0.001, 1, 1)[kg * m ^ 2]
        },
    ],
    [
        one = revolute(world(0, 0, 0), first.G, body(1, 0, 0)),
        two = revolute(world(0, 0, 0), second.G, body(1, 0, 0)),
        three = revolute(world(0, 0, 0), third.G, body(1, 0, 0)),
        four = revolute(world(0, 0, 0), fourth.G, body(1, 0, 0)),
    ],
    [
        on_slew = one.angle - slew.angle,
        on_lift = two.angle + 2 * lift.angle,
        on_slide = 0.1[m] * three.angle - slide.position,
        on_thread = four.angle - 2 * thread.angle,
    ],
    [damper = (-0.3[N * s / m] * slide.velocity).on(slide)],
    [energy, reactions(slew, lift)]
);
arm!(
    Asked,
    [.armature(0.03[kg * m ^ 2])],
    [.armature(0.2[kg * m ^ 2])],
    [.armature(0.7[kg]).driven(0.2[m] * (3[rad / s] * t).sin())],
    [.armature(0.004[kg * m ^ 2])],
    [], [], [],
    [],
    [reactions(slide), energy]
);

fn hinge(angle: f64, angular_velocity: f64) -> Hinge {
    Hinge {
        angle,
        angular_velocity,
    }
}

#[test]
fn an_armature_is_a_rotor_behind_gears() {
    let (own, geared, mut numbers) = (Own::default(), Geared::default(), Random::new(12));
    for _ in 0..10 {
        let state = OwnState {
            orbit: Jointed::random(&mut numbers),
            slew: Jointed::random(&mut numbers),
            lift: Jointed::random(&mut numbers),
            slide: Jointed::random(&mut numbers),
            thread: Jointed::random(&mut numbers),
        };
        let OwnState {
            orbit,
            slew,
            lift,
            slide,
            thread,
        } = state;
        let push = numbers.number();
        let whole = GearedState {
            orbit,
            slew,
            lift,
            slide,
            thread,
            one: slew,
            two: hinge(-2.0 * lift.angle, -2.0 * lift.angular_velocity),
            three: hinge(10.0 * slide.position, 10.0 * slide.velocity),
            four: hinge(2.0 * thread.angle, 2.0 * thread.angular_velocity),
        };
        let (input, same) = (OwnInput { push }, GearedInput { push });
        geared.check(0.0, &whole, &same).unwrap();
        let (a, b) = (
            own.acceleration(0.0, &state, &input),
            geared.acceleration(0.0, &whole, &same),
        );
        close(
            "joints",
            &[a.slew, a.lift, a.slide, a.thread],
            &[b.slew, b.lift, b.slide, b.thread],
            30.0,
            1e-12,
        );
        close(
            "base",
            a.orbit.linear.as_slice(),
            b.orbit.linear.as_slice(),
            30.0,
            1e-12,
        );
        close(
            "base",
            a.orbit.angular.as_slice(),
            b.orbit.angular.as_slice(),
            30.0,
            1e-12,
        );
        close(
            "energy",
            &[own.kinetic_energy(&state)],
            &[geared.kinetic_energy(&whole)],
            10.0,
            1e-13,
        );
        let (one, other) = (
            own.reactions(0.0, &state, &input),
            geared.reactions(0.0, &whole, &same),
        );
        for (one, other) in [(one.slew, other.slew), (one.lift, other.lift)] {
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
        // the same by the mass matrix
        let matrix = own.mass_matrix(0.0, &state, &input);
        let forces = own.generalized_forces(0.0, &state, &input);
        let numbers = [
            a.orbit.linear.as_slice(),
            a.orbit.angular.as_slice(),
            &[a.slew, a.lift, a.slide, a.thread],
        ];
        let product = matrix * nalgebra::SVector::<f64, 10>::from_column_slice(&numbers.concat());
        close("M q''", product.as_slice(), forces.as_slice(), 100.0, 1e-12);
    }
}

// one arm, by hand: (J + m l^2 + a) q'' = torque - m g l sin q
rigid_system!(Pendulum {
    motion: planar,
    params: [gear = 50, rotor = 1e-4[kg * m ^ 2]],
    inputs: [torque[N * m]],
    bodies: [rod {
        mass: 2[kg],
        inertia: 0.1[kg * m ^ 2],
        points: [p = (0, 0.5)[m]]
    }],
    joints: [pin = revolute(world(0, 0), rod.p).armature(gear * gear * rotor)],
    drives: [motor = torque.on(pin)],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    outputs: [energy, reactions, balance, taylor],
});
rigid_system!(Wanted {
    motion: planar,
    bodies: [rod {
        mass: 2[kg],
        inertia: 0.1[kg * m ^ 2],
        points: [p = (0, 0.5)[m]]
    }],
    joints: [pin = revolute(world(0, 0), rod.p).armature(0.25[kg * m ^ 2])],
    drives: [motor = _.on(pin)],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    outputs: [inverse],
});
rigid_system!(Told {
    motion: planar,
    bodies: [rod {
        mass: 2[kg],
        inertia: 0.1[kg * m ^ 2],
        points: [p = (0, 0.5)[m]]
    }],
    joints: [pin = revolute(world(0, 0), rod.p)
        .driven(3[rad / s ^ 2] * t.powi(2))
        .armature(0.25[kg * m ^ 2])],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    outputs: [reactions, energy],
});

#[test]
fn a_pendulum_on_a_gear() {
    let pendulum = Pendulum::default();
    let state = PendulumState {
        pin: hinge(0.4, 1.5),
    };
    let input = PendulumInput { torque: 7.0 };
    let (inertia, weight) = (0.1 + 0.5 + 0.25, -9.81 * 0.4_f64.sin());
    let found = pendulum.acceleration(0.0, &state, &input);
    close(
        "alone",
        &[found.pin],
        &[(7.0 + weight) / inertia],
        10.0,
        1e-14,
    );
    let kinetic = pendulum.kinetic_energy(&state);
    close("energy", &[kinetic], &[0.5 * inertia * 2.25], 1.0, 1e-14);
    // the joint passes what the rotor leaves
    let reactions = pendulum.reactions(0.0, &state, &input);
    close(
        "moment",
        &[reactions.pin.moment],
        &[7.0 - 0.25 * found.pin],
        10.0,
        1e-14,
    );
    let rest = pendulum
        .residual(0.0, &state, &found, &reactions, &input)
        .rod;
    close("rest", &[rest.moment], &[0.0], 10.0, 1e-14);
    let acceleration = WantedAcceleration { pin: -2.0 };
    let wanted =
        Wanted::default().inverse(0.0, &WantedState { pin: state.pin }, &acceleration, &());
    close(
        "inverse",
        &[wanted.motor],
        &[-2.0 * inertia - weight],
        10.0,
        1e-14,
    );
    let told = Told::default();
    let drive = told.reactions(0.5, &ToldState::default(), &()).pin_drive;
    close(
        "drive",
        &[drive],
        &[6.0 * inertia + 9.81 * 0.75_f64.sin()],
        10.0,
        1e-14,
    );
    let kinetic = told.kinetic_energy(0.5, &ToldState::default(), &());
    close("energy", &[kinetic], &[0.5 * inertia * 9.0], 10.0, 1e-14);
    let whole = |state: &PendulumState| {
        pendulum.kinetic_energy(state)
            + pendulum.potential_energy(0.0, state, &PendulumInput::default())
    };
    let end = pendulum.integrate(&state).to(20.0).unwrap();
    close("conserved", &[whole(&end)], &[whole(&state)], 10.0, 1e-9);
}

#[test]
fn a_drive_beside_an_armature() {
    let (asked, mut numbers) = (Asked::default(), Random::new(44));
    let own = Own::default();
    for step in 0..5 {
        let time = 0.3 * f64::from(step);
        let state = AskedState {
            orbit: Jointed::random(&mut numbers),
            slew: Jointed::random(&mut numbers),
            lift: Jointed::random(&mut numbers),
            thread: Jointed::random(&mut numbers),
        };
        let AskedState {
            orbit,
            slew,
            lift,
            thread,
        } = state;
        let (sine, cosine) = (3.0 * time).sin_cos();
        let slide = Slide {
            position: 0.2 * sine,
            velocity: 0.6 * cosine,
        };
        let whole = OwnState {
            orbit,
            slew,
            lift,
            slide,
            thread,
        };
        let kinetic = asked.kinetic_energy(time, &state, &AskedInput::default());
        close(
            "energy",
            &[kinetic],
            &[own.kinetic_energy(&whole)],
            10.0,
            1e-13,
        );
        // without the drive on the slew, and with that of the slide in the place of the damper
        let (a, input) = (
            asked.acceleration(time, &state, &AskedInput::default()),
            OwnInput::default(),
        );
        let drive = asked
            .reactions(time, &state, &AskedInput::default())
            .slide_drive;
        let matrix = own.mass_matrix(time, &whole, &input);
        let forces = own.generalized_forces(time, &whole, &input);
        let numbers = [
            a.orbit.linear.as_slice(),
            a.orbit.angular.as_slice(),
            &[a.slew, a.lift, -1.8 * sine, a.thread],
        ];
        let mut lacking =
            matrix * nalgebra::SVector::<f64, 10>::from_column_slice(&numbers.concat()) - forces;
        lacking[8] -= drive + 0.3 * slide.velocity;
        close("all freedoms", lacking.as_slice(), &[0.0; 10], 100.0, 1e-12);
    }
}

/// A four-bar on a stage that turns as it is told: with armatures behind two of its hinges, or with
/// rotors on the ground that gears turn with them.
macro_rules! linkage {
    ($name:ident, [$($crank:tt)*], [$($pin:tt)*], [$($rotor:tt)*], [$($axle:tt)*], $constraints:tt) => {
        rigid_system!($name {
            motion: planar,
            bodies: [
                stage { mass: 2[kg], inertia: 0.3[kg * m ^ 2], points: [p = (0.1, 0), q = (0.4, 0)] },
                crank { mass: 0.4[kg], inertia: 4e-4[kg * m ^ 2], points: [o = (-0.04, 0), a = (0.06, 0)] },
                coupler { mass: 1.1[kg], inertia: 0.012[kg * m ^ 2], points: [a = (-0.16, 0), b = (0.19, 0)] },
                rocker { mass: 0.8[kg], inertia: 4.5e-3[kg * m ^ 2], points: [c = (-0.11, 0), b = (0.14, 0)] },
                $($rotor)*
            ],
            joints: [
                table = revolute(world(0, 0), stage.G).driven((2[rad / s] * t).sin()),
                o = revolute(stage.p, crank.o)$($crank)*,
                a = revolute(crank.a, coupler.a)$($pin)*,
                b = revolute(coupler.b, rocker.b),
                c = revolute(stage.q, rocker.c),
                $($axle)*
            ],
            constraints: $constraints,
            fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
            outputs: [reactions(c, table)],
        });
    };
}
linkage!(
    Linkage,
    [.armature(0.02[kg * m ^ 2])],
    [.armature(0.01[kg * m ^ 2])],
    [], [], []
);
linkage!(
    LinkageWithRotors,
    [],
    [],
    [
        first {
            mass: 1[kg],
            inertia: 0.02[kg * m ^ 2]
        },
        second {
            mass: 1[kg],
            inertia: 0.01[kg * m ^ 2]
        },
    ],
    [
        one = revolute(world(0, 0), first.G),
        two = revolute(world(0, 0), second.G)
    ],
    [on_crank = one.angle - o.angle, on_pin = two.angle - a.angle]
);

#[test]
fn an_armature_in_a_loop_of_the_plane() {
    let mut state = LinkageState {
        o: hinge(0.7, 12.0),
        a: hinge(-0.186, -14.65),
        b: hinge(0.726, 3.99),
    };
    let (own, beside) = (Linkage::default(), LinkageWithRotors::default());
    own.project(0.4, &mut state, &())
        .expect("a linkage near its assembly");
    let LinkageState { o, a, b } = state;
    let (one, two) = (o, a);
    let together = LinkageWithRotorsState { o, a, b, one, two };
    let found = own.acceleration(0.4, &state, &());
    let expected = beside.acceleration(0.4, &together, &());
    let (found, expected) = (
        [found.o, found.a, found.b],
        [expected.o, expected.a, expected.b],
    );
    close("accelerations", &found, &expected, 100.0, 1e-12);
    let (found, expected) = (
        own.reactions(0.4, &state, &()),
        beside.reactions(0.4, &together, &()),
    );
    close(
        "pin",
        found.c.force.as_slice(),
        expected.c.force.as_slice(),
        10.0,
        1e-12,
    );
}

rigid_system!(Hoist {
    motion: planar,
    params: [rotor = 2e-5[kg * m ^ 2], ratio = 30, play = 0[kg]],
    bodies: [
        drum {
            mass: 1[kg],
            inertia: 0.5[kg * m ^ 2]
        },
        load {
            mass: 3[kg],
            inertia: 0.1[kg * m ^ 2]
        },
    ],
    joints: [
        axle = revolute(world(0, 0), drum.G).armature(rotor * ratio.powi(2)),
        lift = prismatic(world(1, 0)[m], load.G, body(0, 1)).armature(play - 1[kg] + 1[kg]),
    ],
});

#[test]
fn an_armature_of_params_is_not_negative() {
    let own = *Hoist::default().params();
    assert!(Hoist::new(HoistParams { rotor: 0.0, ..own }).is_ok());
    let error = |params| Hoist::new(params).unwrap_err().to_string();
    let found = error(HoistParams { rotor: -0.5, ..own });
    assert_eq!(found, "the armature of `axle` cannot be -450");
    // otherwise the load would fall upwards
    let found = error(HoistParams { play: -5.0, ..own });
    assert_eq!(found, "the armature of `lift` cannot be -5");
}
