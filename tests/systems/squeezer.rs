//! Andrews' squeezing mechanism: seven bodies in three loops, in the plane.
//!
//! E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, VII.7. Its state at 0.03 s is
//! from `reference/squeezer.py`.

use newton_euler::prelude::*;

use super::compare::close;
use super::reference;

rigid_system!(Squeezer {
    motion: planar,
    bodies: [
        k1 {
            mass: 0.04325[kg],
            inertia: 2.194e-6[kg * m ^ 2],
            points: [o = (-0.92[mm], 0), f = (6.08[mm], 0)],
        },
        k2 {
            mass: 0.00365[kg],
            inertia: 4.41e-7[kg * m ^ 2],
            points: [f = (11.5[mm], 0), e = (-16.5[mm], 0)],
        },
        k3 {
            mass: 0.02373[kg],
            inertia: 5.255e-6[kg * m ^ 2],
            points: [
                b = (-10.43, 18.74)[mm],
                e = (-10.43, -16.26)[mm],
                d = (9.57, 0.74)[mm],
            ],
        },
        k4 {
            mass: 0.00706[kg],
            inertia: 5.667e-7[kg * m ^ 2],
            points: [h = (0, 5.79[mm]), e = (0, -14.21[mm])],
        },
        k5 {
            mass: 0.0705[kg],
            inertia: 1.169e-5[kg * m ^ 2],
            points: [a = (-23.08, -9.16)[mm], h = (16.92, -9.16)[mm]],
        },
        k6 {
            mass: 0.00706[kg],
            inertia: 5.667e-7[kg * m ^ 2],
            points: [g = (-5.79[mm], 0), e = (14.21[mm], 0)],
        },
        k7 {
            mass: 0.05498[kg],
            inertia: 1.912e-5[kg * m ^ 2],
            points: [a = (4.49, 12.28)[mm], g = (4.49, -27.72)[mm]],
        },
    ],
    joints: [
        beta = revolute(world(0, 0), k1.o),
        theta = revolute(k1.f, k2.f),
        gamma = revolute(world(-36.35, 32.73)[mm], k3.b),
        delta = revolute(world(-69.34, -2.27)[mm], k5.a),
        phi = revolute(k5.h, k4.h),
        epsilon = revolute(world(-69.34, -2.27)[mm], k7.a),
        omega = revolute(k7.g, k6.g),
        e_3 = revolute(k2.e, k3.e),
        e_4 = revolute(k2.e, k4.e),
        e_6 = revolute(k2.e, k6.e),
    ],
    drives: [motor = 0.033[N * m].on(beta)],
    locals: [stretch = (k3.d.position() - world(14, 72)[mm]).norm() - 77.85[mm]],
    potentials: [spring = 0.5 * 4530[N / m] * stretch.powi(2)],
    outputs: [energy],
});

/// The names of the state are those of the book.
fn state(angles: &[f64]) -> SqueezerState {
    let hinge = |number: usize| Hinge {
        angle: angles[number],
        angular_velocity: 0.0,
    };
    SqueezerState {
        beta: hinge(0),
        theta: hinge(1),
        gamma: hinge(2),
        phi: hinge(3),
        delta: hinge(4),
        omega: hinge(5),
        epsilon: hinge(6),
    }
}

fn numbers<const N: usize>(key: &str) -> [f64; N] {
    reference::numbers(&reference::squeezer()[key])
}

fn start(system: &Squeezer) -> SqueezerState {
    let mut start = state(&numbers::<7>("start"));
    system.project(0.0, &mut start, &()).unwrap();
    start
}

#[test]
fn accelerations_at_the_start() {
    let system = Squeezer::default();
    let found = system.acceleration(0.0, &start(&system), &());
    let found = [
        found.beta,
        found.theta,
        found.gamma,
        found.phi,
        found.delta,
        found.omega,
        found.epsilon,
    ];
    let expected = numbers::<7>("start_acceleration");
    close("accelerations", &found, &expected, 1e4, 1e-12);
}

#[test]
fn the_end_in_thirty_digits() {
    let system = Squeezer::default();
    let start = start(&system);
    let energy = |state: &SqueezerState| {
        system.kinetic_energy(state) + system.potential_energy(0.0, state, &())
    };
    let end = system.integrate(&start).tolerance(1e-14).to(0.03).unwrap();
    let expected = numbers::<14>("end");
    let hinges = [
        end.beta,
        end.theta,
        end.gamma,
        end.phi,
        end.delta,
        end.omega,
        end.epsilon,
    ];
    let angles = hinges.map(|hinge| hinge.angle);
    let rates = hinges.map(|hinge| hinge.angular_velocity);
    close("angles", &angles, &expected[..7], 15.0, 1e-11);
    close("rates", &rates, &expected[7..], 1400.0, 1e-11);
    // the motor has worked, and no hinge has
    let work = 0.033 * (end.beta.angle - start.beta.angle);
    let gained = energy(&end) - energy(&start);
    close("energy", &[gained], &[work], 0.5, 1e-13);
}

#[test]
fn operations_stay_few() {
    let mut rows = Squeezer::OPERATIONS.iter();
    let row = rows.find(|row| row.function == "acceleration").unwrap();
    let count = row.mul + row.add + row.div;
    assert!(count <= 289, "{row:?}");
}
