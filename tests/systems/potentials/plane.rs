//! Potentials in the plane.

use nalgebra::{Matrix3, Vector3};
use newton_euler::prelude::*;

use crate::agree;
use crate::compare::{Jointed, Random, close, link};
use crate::oracle::Kind;

rigid_system!(Flat {
    motion: planar,
    bodies: [
        a {
            mass: 1.2[kg],
            inertia: 0.04[kg * m ^ 2],
            points: [p = (-0.28, 0.1)[m], q = (0.32, 0)[m]],
            potentials: [leaning = 0.7[N * m] * attitude.cos()],
        },
        b {
            mass: 0.8[kg],
            inertia: 0.015[kg * m ^ 2],
            points: [p = (-0.22, 0)[m], q = (0.1, 0.2)[m]],
            potentials: [
                turned = 0.3[N * m] * attitude.powi(2),
                magnet = -body(1, 0.5).dot(world(0, 2))[N * m]
            ],
        },
        c {
            mass: 0.5[kg],
            inertia: 0.02[kg * m ^ 2],
            points: [q = (0.1, 0)]
        },
        d { mass: 0.4[kg] },
    ],
    joints: [
        shoulder = revolute(world(0, 0), a.p),
        elbow = revolute(a.q, b.p),
        flight = free(c),
        cart = translation(d),
    ],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    potentials: [
        coil = 1.5[N * m] * (elbow.angle - 0.3).powi(2),
        spring = 10[N / m] * (b.q.position() - c.q.position()).norm_squared(),
        aligned = 0.4[N * m] * (flight.angle - b.attitude).cos(),
        trap = 2[N / m] * flight.position.norm_squared(),
        rope = 3[N / m] * (cart.position - a.q.position()).norm_squared(),
    ],
    outputs: [energy, momentum, reactions],
});

#[test]
fn the_loads_of_potentials() {
    let flat = |inertia: f64| Matrix3::identity() * inertia;
    let turn = Kind::Revolute(Vector3::z());
    let links = [
        link((1.2, flat(0.04)), None, [0.0; 3], [-0.28, 0.1, 0.0], turn),
        link(
            (0.8, flat(0.015)),
            Some(0),
            [0.32, 0.0, 0.0],
            [-0.22, 0.0, 0.0],
            turn,
        ),
        link((0.5, flat(0.02)), None, [0.0; 3], [0.0; 3], Kind::Plane),
        link((0.4, flat(1.0)), None, [0.0; 3], [0.0; 3], Kind::Shift(2)),
    ];
    let make = |_: &mut Random| (Flat::default(), (), links);
    agree!(Flat, make, [0.0, -9.80665, 0.0], moving [shoulder elbow flight cart],
    held [0 shoulder 1 elbow 3 cart], still [], |loads, _system, _input| {
        let q: Vec<Vec<f64>> = loads.rates.iter().map(|rates| rates.0.clone()).collect();
        let z = Vector3::z();
        let (first, second) = (q[0][0], q[0][0] + q[1][0]);
        loads.moment(0, z * (0.7 * first.sin()));
        loads.moment(1, z * (-0.6 * second));
        let needle = loads.turned(1, [1.0, 0.5, 0.0]);
        loads.moment(1, needle.cross(&(Vector3::y() * 2.0)));
        let (b, c) = ([0.1, 0.2, 0.0], [0.1, 0.0, 0.0]);
        let line = loads.point(1, b) - loads.point(2, c);
        loads.force(1, b, line * -20.0);
        loads.force(2, c, line * 20.0);
        let aligned = 0.4 * (q[2][2] - second).sin();
        loads.moment(2, z * aligned);
        loads.moment(1, -z * aligned);
        let place = loads.point(2, [0.0; 3]);
        loads.force(2, [0.0; 3], place * -4.0);
        let line = Vector3::new(q[3][0], q[3][1], 0.0) - loads.point(0, [0.32, 0.0, 0.0]);
        loads.force(0, [0.32, 0.0, 0.0], line * 6.0);
        // of the coordinates of a joint: along them
        loads.drives[3] = vec![-6.0 * line.x, -6.0 * line.y];
        loads.drives[1] = vec![-3.0 * (q[1][0] - 0.3)];
    });
}

#[test]
fn energy_is_kept() {
    let system = Flat::default();
    let mut numbers = Random::new(4);
    for _ in 0..5 {
        let state = FlatState {
            shoulder: Jointed::random(&mut numbers),
            elbow: Jointed::random(&mut numbers),
            flight: Jointed::random(&mut numbers),
            cart: Jointed::random(&mut numbers),
        };
        let energy = |state: &FlatState| {
            system.kinetic_energy(state) + system.potential_energy(0.0, state, &())
        };
        let later = system.integrate(&state).tolerance(1e-14).to(2.0).unwrap();
        let size = system.kinetic_energy(&state) + energy(&state).abs();
        let drift = (energy(&later) - energy(&state)).abs();
        assert!(drift <= 1e-12 * size, "{drift} of {size}");
    }
}

// with what is no potential: a motor that depends on the time, friction
rigid_system!(Driven {
    motion: planar,
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: 0.04[kg * m ^ 2],
            points: [hinge = (-0.28, 0)[m], tip = (0.32, 0)[m]],
        },
        lower {
            mass: 0.8[kg],
            inertia: 0.015[kg * m ^ 2],
            points: [hinge = (-0.22, 0)[m], tip = (0.2, 0)[m]],
        },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.hinge),
        elbow = revolute(upper.tip, lower.hinge),
        rope = cable(world(0, 5), lower.tip, 0.5[m], 20[N / m]),
    ],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    drives: [
        motor = (2[N * m] * (3[rad / s] * t).cos()).on(shoulder),
        friction = (-0.1[N * m * s] * elbow.angular_velocity).on(elbow),
    ],
    potentials: [
        coil = 1.5[N * m] * elbow.angle.powi(2),
        spring = 10[N / m] * (lower.tip.position() - world(1, 0)[m]).norm_squared(),
    ],
    outputs: [energy],
});

#[test]
fn energy_changes_by_the_power_of_the_drives() {
    let system = Driven::default();
    let mut numbers = Random::new(5);
    for _ in 0..20 {
        let state = DrivenState {
            shoulder: Jointed::random(&mut numbers),
            elbow: Jointed::random(&mut numbers),
        };
        let (start, step) = (0.4, 1e-3);
        let energy = |steps: f64| {
            let end = start + step * steps;
            let run = system.integrate(&state).starting_at(start).tolerance(1e-13);
            let moved = run.to(end).unwrap();
            system.kinetic_energy(&moved) + system.potential_energy(end, &moved, &())
        };
        // by differences of the eighth order
        let weights = [
            (1.0, 0.8),
            (2.0, -0.2),
            (3.0, 4.0 / 105.0),
            (4.0, -1.0 / 280.0),
        ];
        let rate = weights.map(|(steps, share)| share * (energy(steps) - energy(-steps)) / step);
        let rate: f64 = rate.iter().sum();
        let (shoulder, elbow) = (
            state.shoulder.angular_velocity,
            state.elbow.angular_velocity,
        );
        let power = 2.0 * (3.0 * start).cos() * shoulder - 0.1 * elbow * elbow;
        close("power", &[rate], &[power], 100.0, 1e-8);
    }
}
