//! The balances of each body: they are zero on a true motion, and show what a wrong reaction
//! leaves.

use nalgebra::Vector3;
use newton_euler::load::Load;
use newton_euler::prelude::*;

use super::compare::{Jointed, Random, close};

// each kind of joint, a driven one, and not in the order of the tree
rigid_system!(Weighed {
    inputs: [push[N]],
    bodies: [
        rod {
            mass: 0.3[kg],
            inertia: principal(0.02, 0.03, 0.01)[kg * m ^ 2],
            points: [p = (0.1, 0.1, 0)],
        },
        hub {
            mass: 3[kg],
            inertia: principal(0.5, 0.4, 0.6)[kg * m ^ 2],
            points: [p = (0.1, 0.2, 0.3), q = (-0.2, 0.1, 0)],
            forces: [jet = body(push, 0, 0).at(p), drag = -0.3[kg / s] * velocity],
        },
        boom {
            mass: 0.6[kg],
            inertia: principal(0.05, 0.04, 0.03)[kg * m ^ 2],
            points: [p = (0, 0.1, 0.3), q = (0.1, 0, -0.3)],
        },
        ball {
            mass: 0.8[kg],
            inertia: principal(0.02, 0.03, 0.04)[kg * m ^ 2],
            points: [p = (0, 0.1, 0.2)],
        },
        slider {
            mass: 0.5[kg],
            inertia: principal(0.01, 0.01, 0.02)[kg * m ^ 2],
            points: [p = (0.1, 0, 0)],
        },
        nut {
            mass: 0.2[kg],
            inertia: principal(0.002, 0.002, 0.001)[kg * m ^ 2]
        },
        plate {
            mass: 0.2[kg],
            inertia: principal(0.002, 0.002, 0.001)[kg * m ^ 2],
            points: [p = (0.1, 0, 0.1)],
        },
    ],
    joints: [
        rail = cylindrical(boom.q, rod.p, body(1, 2, 2)),
        cardan = universal(hub.p, boom.p, body(1, 0, 0), body(0, 1, 0)),
        base = free(hub),
        socket = spherical(hub.q, ball.p),
        slide = prismatic(hub.G, slider.p, body(0, 1, 0)),
        thread = screw(slider.G, nut.G, body(0, 0, 1), 0.02[m]).driven(3[rad / s] * t),
        clamp = weld(ball.G, plate.p).turned(body(0, 1, 0), 0.3),
    ],
    fields: [weight = mass * world(0.3[m / s ^ 2], 0, -9.81[m / s ^ 2])],
    drives: [motor = (2[N * m] * (3[rad / s] * t).cos()).on(cardan.angle_1)],
    forces: [spring = 7[N].between(nut.G, rod.G)],
    outputs: [balance, reactions],
});

#[test]
fn balances_are_zero_on_a_true_motion() {
    let system = Weighed::default();
    let mut numbers = Random::new(111);
    for _ in 0..20 {
        let (t, input) = (
            numbers.number(),
            WeighedInput {
                push: numbers.number(),
            },
        );
        let state = WeighedState {
            rail: Jointed::random(&mut numbers),
            cardan: Jointed::random(&mut numbers),
            base: Jointed::random(&mut numbers),
            socket: Jointed::random(&mut numbers),
            slide: Jointed::random(&mut numbers),
        };
        let acceleration = system.acceleration(t, &state, &input);
        let mut reactions = system.reactions(t, &state, &input);
        let left = |reactions: &WeighedReactions| {
            system.residual(t, &state, &acceleration, reactions, &input)
        };
        let all = left(&reactions);
        for body in [
            all.rod, all.hub, all.boom, all.ball, all.slider, all.nut, all.plate,
        ] {
            close("force", body.force.as_slice(), &[0.0; 3], 30.0, 1e-13);
            close("moment", body.moment.as_slice(), &[0.0; 3], 30.0, 1e-13);
        }
        // what is added to a reaction is left over, with both signs
        let more = Vector3::new(0.1, -0.2, 0.3);
        reactions.rail.force += more;
        let all = left(&reactions);
        close(
            "on the rod",
            all.rod.force.as_slice(),
            more.as_slice(),
            30.0,
            1e-13,
        );
        close(
            "on the boom",
            all.boom.force.as_slice(),
            (-more).as_slice(),
            30.0,
            1e-13,
        );
        close(
            "on the hub",
            all.hub.force.as_slice(),
            &[0.0; 3],
            30.0,
            1e-13,
        );
        given_loads(t, &state, input);
    }
}

/// Given loads, one by one and together.
fn given_loads(t: f64, state: &WeighedState, input: WeighedInput) {
    let system = Weighed::default();
    let (applied, lists) = (
        system.applied(t, state, &input),
        system.loads(t, state, &input),
    );
    let [weight, jet, drag] = lists.hub;
    assert_eq!(
        [weight.name, jet.name, drag.name],
        ["weight", "jet", "drag"]
    );
    let sum: Vector3<f64> = weight.force + jet.force + drag.force;
    close(
        "hub",
        applied.hub.force.as_slice(),
        sum.as_slice(),
        30.0,
        1e-14,
    );
    close(
        "weight",
        weight.force.as_slice(),
        &[0.9, 0.0, -29.43],
        30.0,
        1e-14,
    );
    close(
        "drag",
        drag.force.as_slice(),
        (-0.3 * state.base.velocity).as_slice(),
        1.0,
        1e-15,
    );
    let arm = state.base.attitude * Vector3::new(0.1, 0.2, 0.3);
    let push = state.base.attitude * Vector3::new(input.push, 0.0, 0.0);
    close(
        "moment",
        applied.hub.moment.as_slice(),
        arm.cross(&push).as_slice(),
        1.0,
        1e-14,
    );
    close(
        "place",
        jet.point.as_slice(),
        (state.base.position + arm).as_slice(),
        1.0,
        1e-14,
    );
    let [_, on_rod]: [Load; 2] = lists.rod;
    let [_, on_nut] = lists.nut;
    assert_eq!((on_rod.name, on_nut.name), ("spring", "spring"));
    close(
        "spring",
        on_rod.force.as_slice(),
        (-on_nut.force).as_slice(),
        1.0,
        1e-14,
    );
    assert!((on_nut.force.norm() - 7.0).abs() < 1e-13);
}

// in the plane, of parameters, and without reactions among the outputs
rigid_system!(Leaning {
    motion: planar,
    params: [load = 0.8[kg]],
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: 0.04[kg * m ^ 2],
            points: [hinge = (-0.28, 0)[m], tip = (0.32, 0)[m]],
        },
        lower {
            mass: load,
            inertia: 0.015[kg * m ^ 2],
            points: [hinge = (-0.22, 0)[m]]
        },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.hinge),
        elbow = revolute(upper.tip, lower.hinge),
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    outputs: [balance],
});

#[test]
fn reactions_may_be_guessed() {
    let system = Leaning::default();
    // hanging at rest
    let state = LeaningState {
        shoulder: Hinge {
            angle: -core::f64::consts::FRAC_PI_2,
            angular_velocity: 0.0,
        },
        elbow: Hinge::default(),
    };
    let still = LeaningAcceleration::default();
    let carried = |mass: f64| PlanarWrench {
        force: [0.0, mass * 9.81].into(),
        moment: 0.0,
    };
    let reactions = LeaningReactions {
        shoulder: carried(2.0),
        elbow: carried(0.8),
    };
    let left: LeaningWrenches = system.residual(0.0, &state, &still, &reactions, &());
    for body in [left.upper, left.lower] {
        close("force", body.force.as_slice(), &[0.0; 2], 30.0, 1e-15);
        close("moment", &[body.moment], &[0.0], 30.0, 1e-15);
    }
    let [weight] = system.loads(0.0, &state, &()).lower;
    assert_eq!(weight.name, "weight");
}

// loads that follow the load of a constraint, of a link and of a vector, for any scalar
rigid_system!(Rubbed::<T> {
    params: [mu = 0.3],
    bodies: [
        disc {
            mass: 2[kg],
            inertia: sphere(0.3[m]),
            constraints: [touch = position.in_world().z],
            forces: [rub = world(-mu * touch, 0, 0)],
        },
        arm {
            mass: 1[kg],
            inertia: sphere(0.1[m]),
            points: [hinge = (-0.4, 0, 0)[m], tip = (0.4, 0, 0)[m]],
        },
        bob {
            mass: 1[kg],
            inertia: sphere(0.1[m])
        },
    ],
    joints: [
        away = free(disc),
        hinge = revolute(world(0, 0, 1)[m], arm.hinge, body(0, 1, 0)),
        loose = free(bob),
        rod = link(arm.tip, bob.G, 0.5[m]),
    ],
    constraints: [slot = bob.G.position().in_world().y],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    moments: [brake = moment(-0.1[m] * slot * world(0, 1, 0)).on(arm)],
    forces: [drag = (0.2 * rod).between(disc.G, bob.G)],
    outputs: [balance, reactions],
});

#[test]
fn what_follows_a_constraint_does_so_as_it_is_given() {
    let system = Rubbed::<f64>::default();
    let mut state = RubbedState::default();
    state.away.position = [0.3, -0.1, 0.0].into();
    state.away.velocity = [0.5, 0.2, 0.0].into();
    state.loose.position = [0.8, 0.0, 0.5].into();
    state.loose.angular_velocity = [0.3, -0.4, 0.7].into();
    system.check(0.0, &state, &()).unwrap();
    let acceleration = system.acceleration(0.0, &state, &());
    let mut reactions = system.reactions(0.0, &state, &());
    let left = |reactions: &RubbedReactions<f64>| {
        system.residual(0.0, &state, &acceleration, reactions, &())
    };
    let whole = left(&reactions);
    for body in [whole.disc, whole.arm, whole.bob] {
        close("force", body.force.as_slice(), &[0.0; 3], 30.0, 1e-13);
        close("moment", body.moment.as_slice(), &[0.0; 3], 30.0, 1e-13);
    }
    reactions.disc_touch += 1.0;
    reactions.slot += 1.0;
    let more = left(&reactions);
    let force = more.disc.force;
    close("disc", force.as_slice(), &[-0.3, 0.0, 1.0], 30.0, 1e-13);
    let (force, moment) = (more.bob.force, more.arm.moment);
    close("bob", force.as_slice(), &[0.0, 1.0, 0.0], 30.0, 1e-13);
    close("arm", moment.as_slice(), &[0.0, -0.1, 0.0], 30.0, 1e-13);
    // the link pulls its ends together, and a fifth of it the disc and the bob
    reactions = system.reactions(0.0, &state, &());
    reactions.rod += 1.0;
    let more = left(&reactions);
    let between = state.loose.position - state.away.position;
    let pull = 0.2 * between.normalize();
    close(
        "disc",
        more.disc.force.as_slice(),
        pull.as_slice(),
        1.0,
        1e-13,
    );
    let rest = more.bob.force + pull;
    close("bob", rest.as_slice(), &[0.0, 0.0, 1.0], 1.0, 1e-13);
}
