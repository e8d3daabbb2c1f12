//! A quadruped, and inverse dynamics of an arm with everything in it, compared with the oracle.

use nalgebra::Vector3;
use newton_euler::prelude::*;

use super::agree;
use super::balances::solve;
use super::compare::{Jointed, Random, TIME, close, link, principal, unit};
use super::oracle::{Kind, Link};

rigid_system!(Quadruped {
    params: [reach = 0.3[m]],
    inputs: [gravity = world(_, _, _)[m / s ^ 2], stiffness[N * m]],
    bodies: [
        trunk {
            mass: 6[kg],
            inertia: tensor {
                xx: 0.3,
                yy: 0.35,
                zz: 0.45,
                xy: 0.01,
                yz: -0.02,
                zx: 0.03
            }[kg * m ^ 2],
            points: [
                fl = (reach, 0.1, 0),
                fr = (reach, -0.1, 0),
                hl = (-reach, 0.1, 0),
                hr = (-reach, -0.1, 0)
            ],
        },
        hip {
            copies: [fl, fr, hl, hr],
            mass: 0.4[kg],
            inertia: principal(0.002, 0.003, 0.0025)[kg * m ^ 2],
            points: [in_ = (0, -0.02, 0), out = (0.01, 0.05, 0)],
        },
        thigh {
            copies: [fl, fr, hl, hr],
            mass: 0.9[kg],
            inertia: principal(0.01, 0.012, 0.004)[kg * m ^ 2],
            points: [top = (0, 0.02, 0.1), knee = (0, 0.01, -0.15)],
        },
        shank {
            copies: [fl, fr, hl, hr],
            mass: 0.2[kg],
            inertia: principal(0.003, 0.0032, 0.0005)[kg * m ^ 2],
            points: [top = (0, 0, 0.12), foot = (0, 0, -0.13)],
            forces: [ground = (-30[N * s / m] * foot.velocity()).at(foot)],
        },
    ],
    joints: [
        body_ = free(trunk),
        roll_fl = revolute(trunk.fl, hip_fl.in_, body(1, 0, 0)),
        roll_fr = revolute(trunk.fr, hip_fr.in_, body(1, 0, 0)),
        roll_hl = revolute(trunk.hl, hip_hl.in_, body(1, 0, 0)),
        roll_hr = revolute(trunk.hr, hip_hr.in_, body(1, 0, 0)),
        pitch_fl = revolute(hip_fl.out, thigh_fl.top, body(0, 1, 0)),
        pitch_fr = revolute(hip_fr.out, thigh_fr.top, body(0, 1, 0)),
        pitch_hl = revolute(hip_hl.out, thigh_hl.top, body(0, 1, 0)),
        pitch_hr = revolute(hip_hr.out, thigh_hr.top, body(0, 1, 0)),
        knee_fl = revolute(thigh_fl.knee, shank_fl.top, body(0, 1, 0)),
        knee_fr = revolute(thigh_fr.knee, shank_fr.top, body(0, 1, 0)),
        knee_hl = revolute(thigh_hl.knee, shank_hl.top, body(0, 1, 0)),
        knee_hr = revolute(thigh_hr.knee, shank_hr.top, body(0, 1, 0)),
    ],
    fields: [weight = mass * gravity],
    drives: [
        spring_fl = (-stiffness * knee_fl.angle).on(knee_fl),
        spring_hr = (stiffness * pitch_hr.angle).on(pitch_hr),
    ],
    outputs: [energy, momentum, reactions],
});

/// The trunk, then hips, thighs and shanks, each in the order of the legs.
fn quadruped(reach: f64) -> Vec<Link> {
    let tensor = nalgebra::Matrix3::new(0.3, 0.01, 0.03, 0.01, 0.35, -0.02, 0.03, -0.02, 0.45);
    let mut links = vec![link((6.0, tensor), None, [0.0; 3], [0.0; 3], Kind::Free)];
    let (roll, pitch) = (Kind::Revolute(Vector3::x()), Kind::Revolute(Vector3::y()));
    for [x, y] in [[1.0, 0.1], [1.0, -0.1], [-1.0, 0.1], [-1.0, -0.1]] {
        let hip = (0.4, principal(0.002, 0.003, 0.0025));
        links.push(link(
            hip,
            Some(0),
            [x * reach, y, 0.0],
            [0.0, -0.02, 0.0],
            roll,
        ));
    }
    for leg in 1..5 {
        let thigh = (0.9, principal(0.01, 0.012, 0.004));
        links.push(link(
            thigh,
            Some(leg),
            [0.01, 0.05, 0.0],
            [0.0, 0.02, 0.1],
            pitch,
        ));
    }
    for leg in 5..9 {
        let shank = (0.2, principal(0.003, 0.0032, 0.0005));
        links.push(link(
            shank,
            Some(leg),
            [0.0, 0.01, -0.15],
            [0.0, 0.0, 0.12],
            pitch,
        ));
    }
    links
}

#[test]
fn a_quadruped() {
    let make = |numbers: &mut Random| {
        let reach = 0.3 + 0.1 * numbers.number();
        let gravity = numbers.vector() * 10.0;
        let input = QuadrupedInput {
            gravity,
            stiffness: numbers.number(),
        };
        (
            Quadruped::new(QuadrupedParams { reach }).unwrap(),
            input,
            quadruped(reach),
        )
    };
    agree!(Quadruped, make, [0.0; 3],
    moving [body_ roll_fl roll_fr roll_hl roll_hr pitch_fl pitch_fr pitch_hl pitch_hr knee_fl knee_fr knee_hl knee_hr],
    held [1 roll_fl 2 roll_fr 3 roll_hl 4 roll_hr 5 pitch_fl 6 pitch_fr 7 pitch_hl 8 pitch_hr
        9 knee_fl 10 knee_fr 11 knee_hl 12 knee_hr],
    still [], |loads, system, input| {
        for (body, link) in quadruped(system.params().reach).iter().enumerate() {
            loads.force(body, [0.0; 3], input.gravity * link.mass);
        }
        for shank in 9..13 {
            let foot = [0.0, 0.0, -0.13];
            loads.force(shank, foot, loads.velocity(shank, foot) * -30.0);
        }
        loads.drives[9] = vec![-input.stiffness * loads.rates[9].0[0]];
        loads.drives[8] = vec![input.stiffness * loads.rates[8].0[0]];
    });
}

// open drives on a tree with a weld, a wheel that needs no sine, a screw, and loads of all sorts
rigid_system!(Hand {
    bodies: [
        foot {
            mass: 5[kg],
            inertia: principal(1, 1, 1)[kg * m ^ 2],
            points: [top = (0.1, 0, 0.3)]
        },
        arm {
            mass: 2[kg],
            inertia: principal(0.1, 0.2, 0.25)[kg * m ^ 2],
            points: [p = (-0.2, 0, 0.1), q = (0.3, 0.05, 0), w = (0.1, 0.1, 0.1)],
        },
        wheel {
            mass: 0.7[kg],
            inertia: principal(0.02, 0.02, 0.03)[kg * m ^ 2]
        },
        plate {
            mass: 0.5[kg],
            inertia: principal(0.03, 0.04, 0.02)[kg * m ^ 2],
            points: [p = (0.1, 0, 0.2), q = (0, 0.2, 0.1)]
        },
        bolt {
            mass: 0.3[kg],
            inertia: principal(0.01, 0.02, 0.015)[kg * m ^ 2],
            points: [p = (0.05, 0, 0.1)],
            forces: [x = body(1, 0.5, 0)[N].at(p)],
        },
        slider {
            mass: 0.4[kg],
            inertia: principal(0.01, 0.01, 0.01)[kg * m ^ 2],
            points: [p = (0.05, 0.02, 0.1)]
        },
    ],
    joints: [
        swing = revolute(foot.top, arm.p, body(0, 1, 0)),
        spin = revolute(arm.w, wheel.G, body(0, 0, 1)),
        bolted = weld(world(0, 0, 0), foot.G).turned(body(0, 0, 1), 20[deg]),
        glued = weld(arm.q, plate.p).turned(body(0, 0, 1), 90[deg]),
        screwed = screw(plate.q, bolt.p, body(1, 0, 0), 0.3[m]),
        slide = prismatic(plate.q, slider.p, body(0, 3, 4)),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    forces: [
        spring = (3[N]).between(bolt.G, slider.G),
        tie = (2[N] * t / 1[s]).between(wheel.G, world(1, 1, 1))
    ],
    moments: [m = moment(world(0.1, 0.2, 0.3)[N * m]).on(wheel)],
    drives: [
        a = _.on(swing),
        b = _.on(spin),
        c = _.on(screwed),
        d = _.on(slide)
    ],
    outputs: [inverse],
});

#[test]
fn inverse_dynamics_against_the_oracle() {
    let swing = Kind::Revolute(Vector3::y());
    let mut links = [
        link(
            (5.0, principal(1.0, 1.0, 1.0)),
            None,
            [0.0; 3],
            [0.0; 3],
            Kind::Weld,
        ),
        link(
            (2.0, principal(0.1, 0.2, 0.25)),
            Some(0),
            [0.1, 0.0, 0.3],
            [-0.2, 0.0, 0.1],
            swing,
        ),
        link(
            (0.7, principal(0.02, 0.02, 0.03)),
            Some(1),
            [0.1; 3],
            [0.0; 3],
            Kind::Revolute(Vector3::z()),
        ),
        link(
            (0.5, principal(0.03, 0.04, 0.02)),
            Some(1),
            [0.3, 0.05, 0.0],
            [0.1, 0.0, 0.2],
            Kind::Weld,
        ),
        link(
            (0.3, principal(0.01, 0.02, 0.015)),
            Some(3),
            [0.0, 0.2, 0.1],
            [0.05, 0.0, 0.1],
            Kind::Screw(Vector3::x(), 0.3),
        ),
        link(
            (0.4, principal(0.01, 0.01, 0.01)),
            Some(3),
            [0.0, 0.2, 0.1],
            [0.05, 0.02, 0.1],
            Kind::Prismatic(unit(0.0, 3.0, 4.0)),
        ),
    ];
    links[0].turned = (Vector3::z(), 20.0_f64.to_radians());
    links[3].turned = (Vector3::z(), 90.0_f64.to_radians());
    let mut numbers = Random::new(9);
    for _ in 0..50 {
        let state = HandState {
            swing: Jointed::random(&mut numbers),
            spin: Jointed::random(&mut numbers),
            screwed: Jointed::random(&mut numbers),
            slide: Jointed::random(&mut numbers),
        };
        let [swing, spin, screwed, slide] = [0; 4].map(|_| 10.0 * numbers.number());
        let given = HandAcceleration {
            swing,
            spin,
            screwed,
            slide,
        };
        let found = Hand::default().inverse(TIME, &state, &given, &());
        let still = (vec![], vec![]);
        let rates = [
            still.clone(),
            state.swing.rates(),
            state.spin.rates(),
            still,
            state.screwed.rates(),
            state.slide.rates(),
        ];
        let solution = solve(&links, &rates, Vector3::new(0.0, 0.0, -9.81), |loads| {
            loads.force(4, [0.05, 0.0, 0.1], loads.turned(4, [1.0, 0.5, 0.0]));
            loads.tension(3.0, (4, [0.0; 3]), (5, [0.0; 3]));
            loads.pull(2.0 * TIME, (2, [0.0; 3]), [1.0; 3]);
            loads.moment(2, Vector3::new(0.1, 0.2, 0.3));
            loads.drives = vec![
                vec![],
                vec![found.a],
                vec![found.b],
                vec![],
                vec![found.c],
                vec![found.d],
            ];
        });
        let moved = solution.accelerations.concat();
        close(
            "acceleration",
            &moved,
            &[swing, spin, screwed, slide],
            10.0,
            1e-11,
        );
    }
}
