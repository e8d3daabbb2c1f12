//! Potentials in space: their loads, written by hand, and the conservation of energy.

use nalgebra::Vector3;
use newton_euler::prelude::*;

use crate::agree;
use crate::compare::{Jointed, Random, close, link, principal, unit};
use crate::oracle::{Kind, Link};

// of joints, of one body, between bodies, to the ground; in axes of bodies, of joints and of the
// world; through locals
rigid_system!(Springs {
    inputs: [stiffness[N / m]],
    params: [rest = 0.4[m], hook = world(1, 2, 3)[m]],
    bodies: [
        a {
            mass: 1.3[kg],
            inertia: principal(0.3, 0.4, 0.5)[kg * m ^ 2],
            points: [
                p = (0.1, -0.2, 0.3),
                q = (-0.2, 0.4, 0.15),
                r = (0.3, 0, 0.1)
            ],
            potentials: [
                height = mass * 2[m / s ^ 2] * position.in_world().z,
                hung = 10[N / m] * (r.position() - hook).norm_squared(),
            ],
        },
        b {
            mass: 0.7[kg],
            inertia: principal(0.12, 0.2, 0.16)[kg * m ^ 2],
            points: [p = (0.25, 0.1, -0.1), q = (0, -0.3, 0.2)],
            locals: [needle = body(1, 2, 0)],
            potentials: [magnet = -1.5[N * m] * needle.dot(world(0, 1, 3))],
        },
        c {
            mass: 0.9[kg],
            inertia: principal(0.05, 0.06, 0.04)[kg * m ^ 2],
            points: [p = (-0.1, 0.2, 0.3), q = (0.3, 0.1, 0)],
        },
        d {
            mass: 0.4[kg],
            inertia: principal(0.07, 0.05, 0.06)[kg * m ^ 2],
            points: [p = (0.1, 0.12, 0.2)]
        },
    ],
    joints: [
        cross = universal(world(0.5, 0.2, -0.1), a.p, body(1, 0, 0), body(0, 3, 4)),
        ball = spherical(a.q, b.p),
        rail = cylindrical(b.q, c.p, body(1, 2, -2)),
        table = planar(a.r, d.p, body(0, 0, 1)).turned(body(1, 0, 0), 30[deg]),
    ],
    locals: [
        line = c.q.position() - d.G.position(),
        stretch = line.norm() - rest
    ],
    fields: [weight = mass * world(0.3, -0.2, -9.81[m / s ^ 2])],
    potentials: [
        coil = 1.5[N * m] * cross.angle_1.powi(2) * cross.angle_2,
        both = 3[N] * rail.position * rail.angle.sin(),
        spring = 0.5 * stiffness * stretch.powi(2),
        couple = 0.8[N * m] * a.body(1, 0, 0).dot(c.body(0, 1, 2)),
        across = 2[N / m] * (table.position - a.body(0.1, 0.2, 0.3)[m]).norm_squared(),
        seen = 5[N / m] * (d.G.position() - world(1, 0, 0)[m]).in_body(a).y.powi(2),
    ],
    outputs: [energy, momentum, reactions],
});

fn springs() -> [Link; 4] {
    let mut links = [
        link(
            (1.3, principal(0.3, 0.4, 0.5)),
            None,
            [0.5, 0.2, -0.1],
            [0.1, -0.2, 0.3],
            Kind::Universal(Vector3::x(), unit(0.0, 3.0, 4.0)),
        ),
        link(
            (0.7, principal(0.12, 0.2, 0.16)),
            Some(0),
            [-0.2, 0.4, 0.15],
            [0.25, 0.1, -0.1],
            Kind::Spherical,
        ),
        link(
            (0.9, principal(0.05, 0.06, 0.04)),
            Some(1),
            [0.0, -0.3, 0.2],
            [-0.1, 0.2, 0.3],
            Kind::Cylindrical(unit(1.0, 2.0, -2.0)),
        ),
        link(
            (0.4, principal(0.07, 0.05, 0.06)),
            Some(0),
            [0.3, 0.0, 0.1],
            [0.1, 0.12, 0.2],
            Kind::Planar(Vector3::x(), Vector3::y(), Vector3::z()),
        ),
    ];
    links[3].turned = (Vector3::x(), 30.0_f64.to_radians());
    links
}

#[test]
fn the_loads_of_potentials() {
    let make = |numbers: &mut Random| {
        let hook = numbers.vector();
        let params = SpringsParams {
            rest: 0.4 + 0.1 * numbers.number(),
            hook,
        };
        let input = SpringsInput {
            stiffness: 9.0 + numbers.number(),
        };
        (Springs::new(params).unwrap(), input, springs())
    };
    agree!(Springs, make, [0.3, -0.2, -9.81], moving [cross ball rail table],
    held [0 cross 1 ball 2 rail 3 table], still [], |loads, system, input| {
        let q: Vec<Vec<f64>> = loads.rates.iter().map(|rates| rates.0.clone()).collect();
        loads.force(0, [0.0; 3], Vector3::new(0.0, 0.0, -1.3 * 2.0));
        let r = [0.3, 0.0, 0.1];
        loads.force(0, r, (system.params().hook - loads.point(0, r)) * 20.0);
        let needle = loads.turned(1, [1.0, 2.0, 0.0]);
        loads.moment(1, needle.cross(&Vector3::new(0.0, 1.0, 3.0)) * 1.5);
        let (end, start) = ([0.3, 0.1, 0.0], [0.0; 3]);
        let stretch = (loads.point(2, end) - loads.point(3, start)).norm() - system.params().rest;
        loads.tension(input.stiffness * stretch, (2, end), (3, start));
        let couple = loads.turned(0, [1.0, 0.0, 0.0]).cross(&loads.turned(2, [0.0, 1.0, 2.0]));
        loads.moment(0, -couple * 0.8);
        loads.moment(2, couple * 0.8);
        // the table slides in axes of its carrier that are turned
        let turn = nalgebra::Rotation3::new(Vector3::x() * 30.0_f64.to_radians());
        let place = turn * Vector3::new(q[3][0], q[3][1], 0.0);
        let apart = place - Vector3::new(0.1, 0.2, 0.3);
        let slope = turn.inverse() * (apart * 4.0);
        // d - 1 in the axes of a: along its y
        let from = loads.point(3, [0.0; 3]) - Vector3::x();
        let y = loads.turned(0, [0.0, 1.0, 0.0]);
        loads.force(3, [0.0; 3], y * (-10.0 * from.dot(&y)));
        loads.moment(0, y.cross(&from) * (-10.0 * from.dot(&y)));
        loads.drives = vec![
            vec![-3.0 * q[0][0] * q[0][1], -1.5 * q[0][0] * q[0][0]],
            vec![0.0; 3],
            vec![-3.0 * q[2][1].sin(), -3.0 * q[2][0] * q[2][1].cos()],
            vec![-slope.x, -slope.y, 0.0],
        ];
    });
}

// a free base, what it carries, and another free body
rigid_system!(Tethered::<T> {
    bodies: [
        hub {
            mass: 3[kg],
            inertia: principal(0.5, 0.4, 0.6)[kg * m ^ 2],
            points: [p = (0.1, 0.2, 0.3), q = (0.3, -0.2, 0)],
            potentials: [
                trap = 4[N / m] * position.norm_squared(),
                held = 2[N * m] * (1 - body(0, 0, 1).in_world().z),
                turned = 1.5[N * m] * attitude.i * attitude.w,
            ],
        },
        boom {
            mass: 0.6[kg],
            inertia: principal(0.05, 0.04, 0.03)[kg * m ^ 2],
            points: [p = (0, 0.1, 0.3), q = (0.1, 0, -0.3)],
        },
        other {
            mass: 1[kg],
            inertia: principal(0.1, 0.15, 0.2)[kg * m ^ 2],
            points: [q = (0.1, 0.1, 0)]
        },
        cart { mass: 2[kg] },
    ],
    joints: [
        orbit = free(hub),
        joint = universal(hub.p, boom.p, body(1, 0, 0), body(0, 1, 0)),
        flight = free(other),
        shift = translation(cart),
    ],
    potentials: [
        bend = (1[N * m] * joint.angle_1 + 2[N * m] * joint.angle_2).powi(2) / 1[N * m],
        tie = 3[N / m] * (boom.q.position() - other.q.position()).norm_squared(),
        far = -5[N * m ^ 2] / (2[m] + (orbit.position - flight.position).norm()),
        pull = 2[N / m] * (shift.position - hub.q.position()).norm_squared(),
        own = 1.5[N / m] * shift.position.norm_squared(),
    ],
    outputs: [energy, momentum],
});

#[test]
fn energy_is_kept() {
    let system = Tethered::<f64>::default();
    let mut numbers = Random::new(8);
    for _ in 0..5 {
        let state = TetheredState {
            orbit: Jointed::random(&mut numbers),
            joint: Jointed::random(&mut numbers),
            flight: Jointed::random(&mut numbers),
            shift: Jointed::random(&mut numbers),
        };
        let energy = |state: &TetheredState<f64>| {
            system.kinetic_energy(state) + system.potential_energy(0.0, state, &())
        };
        let later = system.integrate(&state).tolerance(1e-14).to(2.0).unwrap();
        let start = energy(&state);
        let drift = (energy(&later) - start).abs();
        assert!(
            drift <= 1e-12 * system.kinetic_energy(&state).abs().max(start.abs()),
            "{drift} of {start}"
        );
        assert!((system.kinetic_energy(&later) - system.kinetic_energy(&state)).abs() > 1e-3);
    }
}

/// What is said in axes of bodies far away is said of their difference.
#[test]
fn far_from_the_origin() {
    let system = Far::default();
    let mut numbers = Random::new(9);
    for _ in 0..20 {
        let mut state = FarState {
            orbit: Jointed::random(&mut numbers),
            joint: Jointed::random(&mut numbers),
        };
        state.orbit.position = Vector3::zeros();
        let near = system.acceleration(0.0, &state, &());
        state.orbit.position = Vector3::new(1e12, -3e12, 2e12);
        let far = system.acceleration(0.0, &state, &());
        assert_eq!(near, far);
    }
}

rigid_system!(Far {
    bodies: [
        hub {
            mass: 3[kg],
            inertia: principal(0.5, 0.4, 0.6)[kg * m ^ 2],
            points: [p = (0.1, 0.2, 0.3), q = (0.3, -0.2, 0)],
        },
        boom {
            mass: 0.6[kg],
            inertia: principal(0.05, 0.04, 0.03)[kg * m ^ 2],
            points: [p = (0, 0.1, 0.3), q = (0.1, 0, -0.3)],
        },
    ],
    joints: [
        orbit = free(hub),
        joint = universal(hub.p, boom.p, body(1, 0, 0), body(0, 1, 0))
    ],
    potentials: [tie = 3[N / m] * (boom.q.position() - hub.q.position()).norm_squared()],
});

#[test]
fn slopes_of_the_energy_are_the_drives() {
    // potential against drive: the same to the last bit
    let mut numbers = Random::new(10);
    for _ in 0..20 {
        let hinge: Hinge = Jointed::random(&mut numbers);
        let by_energy = Coil::default().acceleration(0.0, &CoilState { hinge }, &());
        let by_drive = Driven::default().acceleration(0.0, &DrivenState { hinge }, &());
        close(
            "acceleration",
            &[by_energy.hinge],
            &[by_drive.hinge],
            1.0,
            0.0,
        );
    }
}

rigid_system!(Coil {
    bodies: [arm {
        mass: 1[kg],
        inertia: principal(1, 2, 3)[kg * m ^ 2],
        points: [p = (1, 0, 0)]
    }],
    joints: [hinge = revolute(world(0, 0, 0), arm.p, body(0, 0, 1))],
    potentials: [coil = 0.5 * 3[N * m] * hinge.angle.powi(2)],
});
rigid_system!(Driven {
    bodies: [arm {
        mass: 1[kg],
        inertia: principal(1, 2, 3)[kg * m ^ 2],
        points: [p = (1, 0, 0)]
    }],
    joints: [hinge = revolute(world(0, 0, 0), arm.p, body(0, 0, 1))],
    drives: [coil = (-3[N * m] * hinge.angle).on(hinge)],
});
