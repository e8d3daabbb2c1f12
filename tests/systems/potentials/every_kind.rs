//! Energies between all bodies of a tree that has every kind of joint, and the conservation of
//! energy.

use newton_euler::prelude::*;

use crate::compare::{Jointed, Random};

rigid_system!(Everything {
    params: [bend = 20[deg], arm = 0.3[m], lead = 0.1[m]],
    bodies: [
        base {
            mass: 4[kg],
            inertia: principal(0.5, 0.4, 0.6)[kg * m ^ 2],
            points: [p = (arm, 0.2, 0.3), q = (0.3, -0.2, 0), r = (0, -arm, 0.2)],
            potentials: [trap = 4[N / m] * (position - world(0, 1, 0)[m]).norm_squared()],
        },
        link {
            copies: [a, b],
            mass: 0.6[kg],
            inertia: principal(0.05, 0.04, 0.03)[kg * m ^ 2],
            points: [p = (0, 0.1, 2 * arm), q = (0.1, 0, -arm)],
            locals: [arrow = body(1, 0.5, -2)],
            potentials: [
                needle = 0.6[N * m] * arrow.dot(world(0, 1, 1)),
                floor = if q.position().in_world().z > 0[m] {
                    3[N / m] * q.position().in_world().z.powi(2)
                } else {
                    0[J]
                },
            ],
        },
        nut {
            mass: 0.5[kg],
            inertia: principal(0.02, 0.03, 0.025)[kg * m ^ 2],
            points: [p = (0.1, 0, 0.1)],
        },
        plate {
            mass: 0.7[kg],
            inertia: principal(0.03, 0.02, 0.04)[kg * m ^ 2],
            points: [p = (0.1, -0.1, 0.1), q = (0, 0.2, 0)],
        },
        drum {
            mass: 0.4[kg],
            inertia: principal(0.01, 0.02, 0.015)[kg * m ^ 2],
            points: [p = (0.05, 0.1, 0)],
        },
        rod_ {
            mass: 0.3[kg],
            inertia: principal(0.01, 0.012, 0.006)[kg * m ^ 2],
            points: [p = (0, 0.1, -0.2)],
        },
        ring {
            mass: 1[kg],
            inertia: principal(0.1, 0.15, 0.2)[kg * m ^ 2],
            points: [q = (0.1, 0.1, 0)],
            potentials: [own = 0.5[N * m] * attitude.i * attitude.k],
        },
    ],
    joints: [
        float = free(base),
        hinge = revolute(base.p, link_a.p, body(1, 2, 2)).turned(body(0, 3, 4), bend),
        ball = spherical(base.q, link_b.p),
        thread = screw(link_a.q, nut.p, body(0, 0, 1), lead),
        table = planar(base.r, plate.p, body(2, 1, 2)),
        glue = weld(plate.q, drum.p).turned(body(1, 0, 0), bend),
        rail = cylindrical(link_b.q, rod_.p, body(0, 1, 0)),
        gimbal = rotation(ring),
    ],
    potentials: [
        ab = 3[N / m] * (link_a.q.position() - link_b.G.position()).norm_squared(),
        far = -2[N * m ^ 2] / (3[m] + (nut.G.position() - ring.q.position()).norm()),
        drum_ = 2[N / m] * (drum.p.position() - rod_.p.position()).norm_squared(),
        twisted = 0.3[N * m] * drum.body(0, 1, 0).dot(nut.body(1, 0, 1)),
        seen = 1.5[N / m]
            * (plate.G.position() - nut.p.position())
                .in_body(link_b)
                .y
                .powi(2),
        mixed = 0.5[N] * thread.angle.sin() * rail.position
            + 0.2[N * m] * hinge.angle * rail.angle.cos(),
        slid = 2[N / m] * (table.position - drum.body(0.1, 0, 0)[m]).norm_squared(),
        triple = 0.4[N * m]
            * ring
                .body(1, 0, 0)
                .cross(base.body(0, 1, 0))
                .dot(drum.body(0, 1, 1)),
        torsion = 0.7[N * m] * (table.angle - hinge.angle).powi(2),
    ],
    outputs: [energy],
});

#[test]
fn energy_is_kept() {
    let system = Everything::default();
    let mut numbers = Random::new(8);
    for _ in 0..4 {
        let state = EverythingState {
            float: Jointed::random(&mut numbers),
            hinge: Jointed::random(&mut numbers),
            ball: Jointed::random(&mut numbers),
            thread: Jointed::random(&mut numbers),
            table: Jointed::random(&mut numbers),
            rail: Jointed::random(&mut numbers),
            gimbal: Jointed::random(&mut numbers),
        };
        let kinetic = |state| system.kinetic_energy(state);
        let energy = |state| kinetic(state) + system.potential_energy(0.0, state, &());
        let later = system.integrate(&state).tolerance(1e-14).to(0.5).unwrap();
        let drift = (energy(&later) - energy(&state)).abs();
        let size = kinetic(&state) + energy(&state).abs();
        assert!(drift <= 1e-12 * size, "{drift} of {size}");
        assert!((kinetic(&later) - kinetic(&state)).abs() > 1e-2);
    }
}
