//! Loops: published numbers, and laws.

use newton_euler::prelude::*;

use super::compare::close;

macro_rules! four_bar {
    ($name:ident, $crank:expr, $outputs:tt) => {
        rigid_system!($name {
            motion: planar,
            bodies: [
                crank {
                    mass: 0.4[kg],
                    inertia: 4e-4[kg * m ^ 2],
                    points: [o = (-0.04, 0), a = (0.06, 0)],
                },
                coupler {
                    mass: 1.1[kg],
                    inertia: 0.012[kg * m ^ 2],
                    points: [a = (-0.16, 0), b = (0.19, 0)],
                },
                rocker {
                    mass: 0.8[kg],
                    inertia: 4.5e-3[kg * m ^ 2],
                    points: [c = (-0.11, 0), b = (0.14, 0)],
                },
            ],
            joints: [
                o = $crank,
                a = revolute(crank.a, coupler.a),
                b = revolute(coupler.b, rocker.b),
                c = revolute(world(0.3, 0), rocker.c),
            ],
            fields: [weight = mass * world(0, -9.806_65[m / s ^ 2])],
            moments: [load = moment(-0.6[N * m]).on(rocker)],
            outputs: $outputs,
        });
    };
}
four_bar!(
    FourBar,
    revolute(world(0, 0), crank.o),
    [reactions, energy, balance]
);
four_bar!(
    Cranked,
    revolute(world(0, 0), crank.o).driven(0.7[rad] + 12[rad / s] * t - 15[rad / s ^ 2] * t.powi(2)),
    [reactions, energy]
);

const PHI: f64 = 0.513_679_082_047_022_6;
const PSI: f64 = 1.239_513_404_417_099_6;
const PHI_RATE: f64 = -2.653_551_909_435_223;
const PSI_RATE: f64 = 1.339_603_476_620_209;

fn start() -> FourBarState {
    FourBarState {
        o: Hinge {
            angle: 0.7,
            angular_velocity: 12.0,
        },
        a: Hinge {
            angle: PHI - 0.7,
            angular_velocity: PHI_RATE - 12.0,
        },
        b: Hinge {
            angle: PSI - PHI,
            angular_velocity: PSI_RATE - PHI_RATE,
        },
    }
}

// reference/systems/four_bar.json: maximal coordinates with multipliers, 45 digits
#[test]
fn a_four_bar_by_its_crank() {
    let free = start();
    let state = CrankedState {
        a: free.a,
        b: free.b,
    };
    let system = Cranked::default();
    let found = system.acceleration(0.0, &state, &());
    let expected = [
        65.817_348_730_974_43 + 30.0,
        94.756_885_411_389_3 - 65.817_348_730_974_43,
    ];
    close(
        "accelerations",
        &[found.a, found.b],
        &expected,
        100.0,
        1e-13,
    );
    let reactions = system.reactions(0.0, &state, &());
    close(
        "torque",
        &[reactions.o_drive],
        &[1.295_124_497_292_162],
        10.0,
        1e-13,
    );
    for (found, expected) in [
        (reactions.o, [-34.309_716_632_691_49, -9.831_507_647_407_6]),
        (
            reactions.a,
            [-32.856_744_723_062_12, -11.902_765_846_115_404],
        ),
        (
            reactions.b,
            [-16.096_095_244_387_385, -19.441_603_230_488_976],
        ),
        (reactions.c, [8.159_529_723_221_798, 29.849_776_105_426_336]),
    ] {
        close("pins", found.force.as_slice(), &expected, 30.0, 1e-13);
    }
}

#[test]
fn a_four_bar_that_is_free() {
    let (system, state) = (FourBar::default(), start());
    let found = system.acceleration(0.0, &state, &());
    close(
        "crank",
        &[found.o],
        &[-228.291_150_244_825_16],
        300.0,
        1e-13,
    );
    let reactions = system.reactions(0.0, &state, &());
    for (found, expected) in [
        (
            reactions.o,
            [-18.022_701_002_646_038, -14.498_211_357_584_896],
        ),
        (
            reactions.a,
            [-18.613_611_752_383_434, -14.142_886_563_134_155],
        ),
        (
            reactions.b,
            [-12.112_517_932_792_592, -11.720_243_822_593_009],
        ),
        (reactions.c, [6.017_997_925_390_057, 21.494_828_679_716_77]),
    ] {
        close("pins", found.force.as_slice(), &expected, 30.0, 1e-12);
        close("pins", &[found.moment], &[0.0], 30.0, 1e-14);
    }
    let left = system.residual(0.0, &state, &found, &reactions, &());
    for body in [left.crank, left.coupler, left.rocker] {
        close("balance", body.force.as_slice(), &[0.0; 2], 30.0, 1e-13);
        close("balance", &[body.moment], &[0.0], 30.0, 1e-13);
    }
    let mut from = state;
    system.project(0.0, &mut from, &()).unwrap();
    let end = system.integrate(&from).tolerance(1e-12).to(0.05).unwrap();
    close(
        "angle",
        &[end.o.angle],
        &[1.107_447_515_234_424_5],
        1.0,
        1e-10,
    );
    close(
        "rate",
        &[end.o.angular_velocity],
        &[5.535_594_739_426_658],
        1.0,
        1e-9,
    );
    let phi = end.o.angle + end.a.angle;
    close("coupler", &[phi], &[0.453_734_842_003_843_8], 1.0, 1e-10);
}

#[test]
fn operations_of_a_four_bar() {
    let mut rows = FourBar::OPERATIONS.iter();
    let row = rows.find(|row| row.function == "acceleration").unwrap();
    let count = row.mul + row.add + row.div;
    assert!(count <= 93, "{row:?}");
}

// a crank of no length: it swings alone, and the loop is a triangle
rigid_system!(Eccentric {
    motion: planar,
    params: [eccentricity = 0.1[m]],
    bodies: [
        crank {
            mass: 0.4[kg],
            inertia: 4e-4[kg * m ^ 2],
            points: [o = (-0.04, 0), a = (-0.04[m] + eccentricity, 0)],
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
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    outputs: [reactions],
});

#[test]
fn an_arm_of_a_loop_may_have_no_length() {
    let system = Eccentric::new(EccentricParams { eccentricity: 0.0 }).unwrap();
    // of the triangle with the sides 0.35, 0.25 and 0.3
    let coupler =
        ((0.35_f64.powi(2) + 0.3_f64.powi(2) - 0.25_f64.powi(2)) / (2.0 * 0.35 * 0.3)).acos();
    let rocker = (0.35 * coupler.sin()).atan2(0.35 * coupler.cos() - 0.3);
    let crank = 0.7_f64;
    let hinge = |angle| Hinge {
        angle,
        angular_velocity: 0.0,
    };
    let state = EccentricState {
        o: hinge(crank),
        a: hinge(coupler - crank),
        b: hinge(rocker - coupler),
    };
    let found = system.acceleration(0.0, &state, &());
    let swings = -0.4 * 9.81 * 0.04 * crank.cos() / (4e-4 + 0.4 * 0.04_f64.powi(2));
    close(
        "accelerations",
        &[found.o, found.a, found.b],
        &[swings, -swings, 0.0],
        100.0,
        1e-13,
    );
    // the triangle stands: moments of the weights about the ends of its sides
    let reactions = system.reactions(0.0, &state, &());
    let (pin, end) = (reactions.b.force, 0.35);
    let about_a =
        end * (coupler.cos() * -pin.y + coupler.sin() * pin.x) - 1.1 * 9.81 * 0.16 * coupler.cos();
    let about_c =
        0.25 * (rocker.cos() * pin.y - rocker.sin() * pin.x) - 0.8 * 9.81 * 0.11 * rocker.cos();
    close("moments", &[about_a, about_c], &[0.0, 0.0], 10.0, 1e-13);
}

// what is written with a body alone carries it, and the next joint closes a loop
rigid_system!(Gliding {
    motion: planar,
    bodies: [sled {
        mass: 2[kg],
        inertia: 0.1[kg * m ^ 2]
    }],
    joints: [
        flight = translation(sled),
        rail = prismatic(world(0, 0), sled.G, body(3, 4)),
    ],
    fields: [weight = mass * world(0, -10[m / s ^ 2])],
});

#[test]
fn a_sled_on_a_rail() {
    let state = GlidingState::default();
    let found = Gliding::default().acceleration(0.0, &state, &()).flight;
    close("sled", found.as_slice(), &[-4.8, -6.4], 10.0, 1e-14);
}

rigid_system!(HungTurned {
    inputs: [weight[m / s ^ 2]],
    bodies: [plate {
        mass: 1.3[kg],
        inertia: principal(0.1, 0.1, 0.15)[kg * m ^ 2],
        points: [hinge = (0.34375, 0, 0)[m], eye = (0, 0.1, 0.25)[m]],
    }],
    joints: [
        axle = revolute(world(0, 0, 0), plate.hinge, body(0, 0, 1)).turned(body(0, 0, 1), 1.5[rad]),
        rod = link(world(0, 0.09375[m], 0), plate.eye, 0.375[m]),
    ],
    fields: [pull = mass * world(weight, 0, 0)],
    drives: [motor = 0.7[N * m].on(axle)],
    outputs: [reactions],
});

rigid_system!(Hung {
    inputs: [weight[m / s ^ 2]],
    bodies: [plate {
        mass: 1.3[kg],
        inertia: principal(0.1, 0.1, 0.15)[kg * m ^ 2],
        points: [hinge = (0.34375, 0, 0)[m], eye = (0, 0.1, 0.25)[m]],
    }],
    joints: [
        axle = revolute(world(0, 0, 0), plate.hinge, body(0, 0, 1)),
        rod = link(world(0, 0.09375[m], 0), plate.eye, 0.375[m]),
    ],
    fields: [pull = mass * world(weight, 0, 0)],
    drives: [motor = 0.7[N * m].on(axle)],
    outputs: [reactions],
});

/// A constant turn about the axis of a hinge is an angle more: the slopes of what is turned twice are
/// those of what is turned once.
#[test]
fn a_link_behind_two_turns_about_one_axis() {
    let (turned, plain) = (HungTurned::default(), Hung::default());
    for angle in [0.3, 1.1, -2.0] {
        let hinge = |angle| Hinge {
            angle,
            angular_velocity: 0.6,
        };
        let weight = 2.5;
        let ours = turned.reactions(
            0.0,
            &HungTurnedState { axle: hinge(angle) },
            &HungTurnedInput { weight },
        );
        let theirs = plain.reactions(
            0.0,
            &HungState {
                axle: hinge(angle + 1.5),
            },
            &HungInput { weight },
        );
        assert!(
            (ours.rod - theirs.rod).abs() < 1e-12 * theirs.rod.abs(),
            "{ours:?} {theirs:?}"
        );
        let away = ours.axle.force - theirs.axle.force;
        assert!(
            away.norm() < 1e-12 * theirs.axle.force.norm(),
            "{ours:?} {theirs:?}"
        );
    }
}
