//! Taylor series of systems: each satisfies the equations of motion, and the motions agree with
//! those of other methods.

use newton_euler::integrate::{DormandPrince, RungeKuttaPair};
use newton_euler::prelude::*;
use newton_euler::state::Coordinates;
use newton_euler::taylor::Taylor;

use super::compare::{Jointed, Random};

// every kind of joint of space, forces along lines, and drives that see coordinates and time; the
// joints are not in the order of the tree
rigid_system!(Spread {
    inputs: [push[N * m]],
    bodies: [
        hub {
            mass: 3[kg],
            inertia: principal(0.5, 0.4, 0.6)[kg * m ^ 2],
            points: [p = (0.1, 0.2, 0.3), q = (-0.2, 0.1, 0)],
        },
        boom {
            mass: 0.6[kg],
            inertia: principal(0.05, 0.04, 0.03)[kg * m ^ 2],
            points: [p = (0, 0.1, 0.3), q = (0.1, 0, -0.3)],
        },
        mass_ {
            mass: 0.3[kg],
            inertia: principal(0.02, 0.03, 0.01)[kg * m ^ 2],
            points: [p = (0.1, 0.1, 0)],
        },
        ball {
            mass: 0.8[kg],
            inertia: principal(0.02, 0.03, 0.04)[kg * m ^ 2],
            points: [p = (0, 0.1, 0.2)],
            forces: [drag = -0.3[kg / s] * velocity],
        },
        nut {
            mass: 0.4[kg],
            inertia: principal(0.01, 0.02, 0.015)[kg * m ^ 2]
        },
        slider {
            mass: 0.5[kg],
            inertia: principal(0.01, 0.01, 0.02)[kg * m ^ 2],
            points: [p = (0.1, 0, 0)],
        },
        flap {
            mass: 0.2[kg],
            inertia: principal(0.002, 0.003, 0.001)[kg * m ^ 2],
            points: [p = (0, 0.1, 0)],
        },
    ],
    joints: [
        rail = cylindrical(boom.q, mass_.p, body(1, 2, 2)),
        hinge = revolute(slider.G, flap.p, body(0.6, 0, 0.8)),
        joint = universal(hub.p, boom.p, body(1, 0, 0), body(0, 1, 0)),
        base = free(hub),
        socket = spherical(hub.q, ball.p),
        thread = screw(ball.G, nut.G, body(0, 0, 1), 0.02[m]),
        slide = prismatic(hub.G, slider.p, body(0, 1, 0)),
    ],
    drives: [
        a = (2[N * m] * (3[rad / s] * t).cos()).on(joint.angle_1),
        b = (-5[N / m] * rail.position).on(rail.position),
        c = (push * hinge.angle.sin()).on(hinge),
        d = (-30[N / m] * slide.position - 0.5[N * s / m] * slide.velocity).on(slide),
    ],
    forces: [spring = (20[N / m]
        * ((flap.G.position() - boom.G.position()).norm_squared() + 0.1[m ^ 2]).sqrt())
    .between(flap.G, boom.G)],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    outputs: [taylor],
});

fn drawn(numbers: &mut Random) -> SpreadState {
    SpreadState {
        rail: Jointed::random(numbers),
        hinge: Jointed::random(numbers),
        joint: Jointed::random(numbers),
        base: Jointed::random(numbers),
        socket: Jointed::random(numbers),
        thread: Jointed::random(numbers),
        slide: Jointed::random(numbers),
    }
}

#[test]
fn series_satisfy_the_equations() {
    let system = Spread::default();
    let mut numbers = Random::new(31);
    for _ in 0..20 {
        let (state, input) = (
            drawn(&mut numbers),
            SpreadInput {
                push: numbers.number(),
            },
        );
        let series = system.series::<12>(0.3, &state, &input);
        let later = 2e-3;
        let moved = series.after(later);
        let found = moved.rates(&system.acceleration(0.3 + later, &moved, &input));
        let coefficients = series.coefficients();
        for (coordinate, rate) in found.0.iter().enumerate() {
            let slope = (1_u8..12).rev().fold(0.0, |sum, order| {
                sum * later + f64::from(order) * coefficients[usize::from(order)].0[coordinate]
            });
            let off = (slope - rate).abs();
            assert!(
                off < 1e-10 * (1.0 + rate.abs()),
                "{coordinate}: {slope} {rate}"
            );
        }
    }
}

// few enough products for series to be the method of `integrate`
rigid_system!(Swing {
    bodies: [
        arm {
            mass: 0.3[kg],
            inertia: principal(1e-4, 1.2e-3, 1.2e-3)[kg * m ^ 2],
            points: [hub = (-0.1, 0, 0)[m], tip = (0.1, 0, 0)[m]],
        },
        pole {
            mass: 0.12[kg],
            inertia: principal(9e-4, 9e-4, 2e-5)[kg * m ^ 2],
            points: [pin = (0, 0, 0.15)[m]],
        },
    ],
    joints: [
        swing = revolute(arm.tip, pole.pin, body(1, 0, 0)),
        yaw = revolute(world(0, 0, 0), arm.hub, body(0, 0, 1)),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [friction = (-1e-4[N * m * s] * swing.angular_velocity).on(swing)],
    outputs: [taylor],
});

#[test]
fn motions_are_those_of_other_methods() {
    let system = Swing::default();
    let mut numbers = Random::new(32);
    for _ in 0..5 {
        let state = SwingState {
            swing: Jointed::random(&mut numbers),
            yaw: Jointed::random(&mut numbers),
        };
        let by_series = system.integrate(&state).tolerance(1e-12).to(1.0).unwrap();
        let others = system
            .integrate(&state)
            .method(DormandPrince { tolerance: 1e-12 });
        let others = others.to(1.0).unwrap();
        let (a, b) = (by_series.coordinates(), others.coordinates());
        for (a, b) in a.0.iter().zip(&b.0) {
            assert!((a - b).abs() < 1e-9 * (1.0 + b.abs()), "{a} {b}");
        }
    }
}

#[test]
fn many_products_are_left_to_runge_kutta_steps() {
    let system = Spread::default();
    let state = drawn(&mut Random::new(33));
    let input = SpreadInput { push: 0.7 };
    let best = system.integrate(&state).input(input).tolerance(1e-9);
    let other = system.integrate(&state).input(input);
    let other = other.method(RungeKuttaPair { tolerance: 1e-9 });
    assert_eq!(best.to(0.1).unwrap(), other.to(0.1).unwrap());
}
