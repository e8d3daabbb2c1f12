//! Potentials in the plane.

use nalgebra::{Matrix3, Vector3};
use newton_euler::prelude::*;

use crate::agree;
use crate::compare::{Jointed, Random, link};
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
