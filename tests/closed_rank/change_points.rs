//! Where a linkage folds into a line, the loop does not determine which way it moves on. The error
//! of an integration says so, with the last good state.

use std::f64::consts::FRAC_PI_2;

use newton_euler::integrate::IntegrationError;
use newton_euler::prelude::*;

rigid_system!(Parallelogram {
    motion: planar,
    bodies: [
        first {
            mass: 1[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [o = (0, -0.5), a = (0, 0.5)]
        },
        coupler {
            mass: 2[kg],
            inertia: 0.8[kg * m ^ 2],
            points: [a = (-1, 0), b = (1, 0)]
        },
        second {
            mass: 1.5[kg],
            inertia: 0.2[kg * m ^ 2],
            points: [p = (0, -0.5), b = (0, 0.5)]
        },
    ],
    joints: [
        o = revolute(world(0, 0), first.o),
        a = revolute(first.a, coupler.a),
        b = revolute(coupler.b, second.b),
        p = revolute(world(2, 0), second.p),
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
});

// the first crank folds onto the ground, and the other two turn together about its end
rigid_system!(Kite {
    motion: planar,
    params: [pull = 5[N * m]],
    bodies: [
        crank {
            mass: 1[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [o = (-0.5, 0), a = (0.5, 0)]
        },
        coupler {
            mass: 2[kg],
            inertia: 0.8[kg * m ^ 2],
            points: [a = (-1, 0), b = (1, 0)]
        },
        rocker {
            mass: 1.5[kg],
            inertia: 0.6[kg * m ^ 2],
            points: [c = (-1, 0), b = (1, 0)]
        },
    ],
    joints: [
        o = revolute(world(0, 0), crank.o),
        a = revolute(crank.a, coupler.a),
        b = revolute(coupler.b, rocker.b),
        c = revolute(world(1, 0), rocker.c),
    ],
    drives: [motor = (-pull).on(o)],
});

// two storeys, each a parallelogram
rigid_system!(Storeys {
    motion: planar,
    bodies: [
        c1 {
            mass: 1.0[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [au = (-0.11, -0.5), bu = (0.09, 0.5)]
        },
        c2 {
            mass: 1.3[kg],
            inertia: 0.15[kg * m ^ 2],
            points: [cu = (-0.12, -0.48), du = (0.08, 0.52)]
        },
        p1 {
            mass: 1.6[kg],
            inertia: 0.2[kg * m ^ 2],
            points: [bu = (-1.03, 0.04), du = (0.97, 0.04)]
        },
        c3 {
            mass: 1.9[kg],
            inertia: 0.25[kg * m ^ 2],
            points: [bu = (0.06, -0.49), eu = (-0.14, 0.61)]
        },
        c4 {
            mass: 2.2[kg],
            inertia: 0.3[kg * m ^ 2],
            points: [du = (0.05, -0.47), fu = (-0.15, 0.63)]
        },
        p2 {
            mass: 2.5[kg],
            inertia: 0.35[kg * m ^ 2],
            points: [eu = (-1.06, 0.1), fu = (0.94, 0.1)]
        },
    ],
    joints: [
        j0 = revolute(world(0, 0), c1.au),
        j1 = revolute(c1.bu, p1.bu),
        j2 = revolute(p1.du, c2.du),
        j3 = revolute(p1.bu, c3.bu),
        j4 = revolute(c3.eu, p2.eu),
        j5 = revolute(p2.fu, c4.fu),
        j6 = revolute(world(2, 0), c2.cu),
        j7 = revolute(p1.du, c4.du),
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    outputs: [energy],
});

macro_rules! hinges {
    ($state:ident { $($name:ident: $angle:expr),* }, $rate:expr) => {
        $state { $($name: Hinge { angle: $angle, angular_velocity: $rate * $angle.signum() }),* }
    };
}

/// What is undetermined: when, with which state and constraint.
fn undetermined<S>(error: IntegrationError<S>) -> (f64, S, &'static str)
where
    IntegrationError<S>: std::fmt::Display,
{
    let text = error.to_string();
    assert!(text.contains("the motion is not determined"), "{text}");
    match error {
        IntegrationError::Undetermined {
            time,
            state,
            constraint,
        } => (time, state, constraint),
        _ => panic!("{text}"),
    }
}

#[test]
fn a_parallelogram_in_a_line_is_not_determined() {
    let linkage = Parallelogram::default();
    for rate in [0.0, 1.0] {
        let angle = FRAC_PI_2;
        let start = hinges!(
            ParallelogramState {
                o: angle,
                a: -angle,
                b: angle
            },
            rate
        );
        linkage.check(0.0, &start, &()).unwrap();
        let error = linkage.integrate(&start).to(1.0).unwrap_err();
        let (time, state, constraint) = undetermined(error);
        assert_eq!((time, &state), (0.0, &start));
        assert!(["p_1", "p_2"].contains(&constraint), "{constraint}");
    }
}

#[test]
fn elsewhere_nothing_depends() {
    let linkage = Parallelogram::default();
    for number in 0..100 {
        let angle = 0.0628 * f64::from(number);
        let state = hinges!(
            ParallelogramState {
                o: angle,
                a: -angle,
                b: angle
            },
            1.0
        );
        let found = linkage.dependent(0.0, &state, &());
        let is_near = angle.cos().abs() < 2e-3;
        assert!(found.is_none() || is_near, "{angle}: {found:?}");
    }
}

#[test]
fn a_kite_folds_to_where_two_ways_lead_on() {
    let kite = Kite::default();
    // of the first link, the two that are longer stand in a mirror image over the diagonal
    let crank: f64 = 0.8;
    let (x, y) = (crank.cos(), crank.sin());
    let (across, half) = ((x - 1.0).hypot(y), (x - 1.0).hypot(y) / 2.0);
    let height = (4.0 - half * half).sqrt();
    let normal = [y / across, (1.0 - x) / across];
    let far = [
        0.5 * (x + 1.0) + height * normal[0],
        y / 2.0 + height * normal[1],
    ];
    let coupler = (far[1] - y).atan2(far[0] - x);
    let rocker = far[1].atan2(far[0] - 1.0);
    let mut start = KiteState::default();
    start.o.angle = crank;
    start.a.angle = coupler - crank;
    start.b.angle = rocker - coupler;
    kite.check(0.0, &start, &()).unwrap();
    let error = kite.integrate(&start).to(10.0).unwrap_err();
    let (time, state, constraint) = undetermined(error);
    assert!(
        time > 0.1 && constraint.starts_with("c_"),
        "{time} {constraint}"
    );
    kite.check(time, &state, &()).unwrap();
    assert!(state.o.angle.abs() < 1e-2, "{state:?}");
}

// the upper story goes through a line while the lower one swings: long steps pass, short ones come to an
// end where rounding would tell the way
#[test]
fn short_steps_to_a_change_point_come_to_an_end() {
    let storeys = Storeys::default();
    let mut start = StoreysState::default();
    start.j0.angular_velocity = 0.7;
    storeys.project(0.0, &mut start, &()).unwrap();
    let energy = |state: &StoreysState| {
        storeys.kinetic_energy(state) + storeys.potential_energy(0.0, state, &())
    };
    let end = storeys.integrate(&start).tolerance(1e-9).to(0.7).unwrap();
    assert!((energy(&end) - energy(&start)).abs() < 1e-8, "{end:?}");
    assert!((end.j3.angle + end.j4.angle).abs() < 1e-9, "{end:?}");
    for tolerance in [1e-11, 1e-13] {
        let error = storeys
            .integrate(&start)
            .tolerance(tolerance)
            .to(0.7)
            .unwrap_err();
        let (time, state, constraint) = undetermined(error);
        assert!(
            (time - 0.6396).abs() < 1e-4 && constraint.starts_with("j7_"),
            "{time} {constraint}"
        );
        assert!((energy(&state) - energy(&start)).abs() < 1e-7, "{state:?}");
    }
}

// a piston that is driven does not say which way the crank leaves a dead point
rigid_system!(Piston {
    motion: planar,
    bodies: [
        piston {
            mass: 1[kg],
            inertia: 0.1[kg * m ^ 2]
        },
        rod {
            mass: 0.5[kg],
            inertia: 0.02[kg * m ^ 2],
            points: [wrist = (0.25, 0), knee = (-0.25, 0)]
        },
        crank {
            mass: 1[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [knee = (0.3, 0)]
        },
    ],
    joints: [
        rail =
            prismatic(world(0, 0), piston.G, world(1, 0)).driven(0.8[m] - 0.05[m / s ^ 2] * t * t),
        wrist = revolute(piston.G, rod.wrist),
        turn = revolute(world(0, 0), crank.G),
        knee = revolute(rod.knee, crank.knee),
    ],
});

#[test]
fn a_driven_piston_does_not_pass_a_dead_point() {
    let (body, start) = (Piston::default(), PistonState::default());
    body.check(0.0, &start, &()).unwrap();
    assert!(body.dependent(0.0, &start, &()).is_some());
    let found = body.integrate(&start).to(1.0);
    assert!(
        matches!(found, Err(IntegrationError::Undetermined { .. })),
        "{found:?}"
    );
}
