//! Systems in space of unusual shapes, compared with the oracle.

use nalgebra::{Matrix3, Vector3};
use newton_euler::prelude::*;

use super::agree;
use super::compare::{Random, link, principal, unit};
use super::oracle::{Kind, Link};

// every joint turned, the ground's too
rigid_system!(Turned {
    bodies: [
        a {
            mass: 1.1[kg],
            inertia: principal(0.2, 0.3, 0.4)[kg * m ^ 2],
            points: [p = (0.1, 0, 0.2), q = (0.3, -0.1, 0)],
        },
        b {
            mass: 0.8[kg],
            inertia: principal(0.15, 0.1, 0.2)[kg * m ^ 2],
            points: [p = (0, 0.2, 0.1), q = (0.2, 0.1, -0.3)],
        },
        c {
            mass: 0.6[kg],
            inertia: principal(0.1, 0.12, 0.08)[kg * m ^ 2],
            points: [p = (0.1, 0.1, 0.1), q = (-0.1, -0.2, 0.2)],
        },
        d {
            mass: 0.5[kg],
            inertia: principal(0.09, 0.07, 0.06)[kg * m ^ 2],
            points: [p = (0.15, 0, 0.1), q = (0, 0.1, 0.2)],
        },
        e {
            mass: 0.4[kg],
            inertia: principal(0.04, 0.05, 0.06)[kg * m ^ 2],
            points: [p = (0, 0, 0.2), q = (0.1, 0.2, 0.1)],
        },
        f {
            mass: 0.3[kg],
            inertia: principal(0.03, 0.05, 0.04)[kg * m ^ 2],
            points: [p = (0.1, 0.05, 0)],
        },
    ],
    joints: [
        one = universal(world(0, 0, 1), a.p, body(0, 1, 0), body(3, 0, 4))
            .turned(body(0, 0, 1), 90[deg]),
        two = screw(a.q, b.p, body(1, 0, 0), -0.2[m]).turned(body(1, 1, 1), 120[deg]),
        three = spherical(b.q, c.p).turned(body(2, 3, 6), 0.4),
        four = prismatic(c.q, d.p, body(1, 2, 2)).turned(body(1, 0, 0), -30[deg]),
        five = cylindrical(d.q, e.p, body(0, 0, 1)).turned(body(0, 1, 0), 180[deg]),
        six = revolute(e.q, f.p, body(4, 3, 0)).turned(body(0, 0, 1), 45[deg]),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [
        b = world(0.2, 0.1, -0.3)[N * m].on(three),
        a = (0.5[N * m]).on(two)
    ],
    outputs: [energy, momentum, reactions],
});

#[test]
fn every_joint_turned() {
    let mut links = [
        link(
            (1.1, principal(0.2, 0.3, 0.4)),
            None,
            [0.0, 0.0, 1.0],
            [0.1, 0.0, 0.2],
            Kind::Universal(Vector3::y(), unit(3.0, 0.0, 4.0)),
        ),
        link(
            (0.8, principal(0.15, 0.1, 0.2)),
            Some(0),
            [0.3, -0.1, 0.0],
            [0.0, 0.2, 0.1],
            Kind::Screw(Vector3::x(), -0.2),
        ),
        link(
            (0.6, principal(0.1, 0.12, 0.08)),
            Some(1),
            [0.2, 0.1, -0.3],
            [0.1, 0.1, 0.1],
            Kind::Spherical,
        ),
        link(
            (0.5, principal(0.09, 0.07, 0.06)),
            Some(2),
            [-0.1, -0.2, 0.2],
            [0.15, 0.0, 0.1],
            Kind::Prismatic(unit(1.0, 2.0, 2.0)),
        ),
        link(
            (0.4, principal(0.04, 0.05, 0.06)),
            Some(3),
            [0.0, 0.1, 0.2],
            [0.0, 0.0, 0.2],
            Kind::Cylindrical(Vector3::z()),
        ),
        link(
            (0.3, principal(0.03, 0.05, 0.04)),
            Some(4),
            [0.1, 0.2, 0.1],
            [0.1, 0.05, 0.0],
            Kind::Revolute(unit(4.0, 3.0, 0.0)),
        ),
    ];
    let turns = [
        (Vector3::z(), 90.0),
        (unit(1.0, 1.0, 1.0), 120.0),
        (unit(2.0, 3.0, 6.0), 0.4_f64.to_degrees()),
        (Vector3::x(), -30.0),
        (Vector3::y(), 180.0),
        (Vector3::z(), 45.0),
    ];
    for (link, (axis, degrees)) in links.iter_mut().zip(turns) {
        link.turned = (axis, degrees.to_radians());
    }
    let make = |_: &mut Random| (Turned::default(), (), links);
    agree!(Turned, make, [0.0, 0.0, -9.81], moving [one two three four five six],
    held [0 one 1 two 2 three 3 four 4 five 5 six], still [], |loads, _system, _input| {
        let moment = loads.motions[2].attitude.transpose() * Vector3::new(0.2, 0.1, -0.3);
        loads.drives[2] = moment.iter().copied().collect();
        loads.drives[1] = vec![0.5];
    });
}

// wheels that need no sine, until something sees their angle; masses and moments are params
rigid_system!(Wheels {
    inputs: [torque[N * m]],
    params: [
        hub_mass[kg],
        wheel_mass[kg],
        across[kg * m ^ 2],
        along[kg * m ^ 2],
        reach[m]
    ],
    bodies: [
        hub {
            mass: hub_mass,
            inertia: principal(across, 2 * across, 1.5 * across),
            points: [x = (reach, 0, 0), y = (0, reach, 0), z = (0, 0, reach)],
        },
        wheel {
            copies: [x = body(1, 0, 0), y = body(0, 1, 0)],
            mass: wheel_mass,
            inertia: disc(0.2[m]),
            points: [rim = (0.1, 0.1, 0.1)],
        },
        rotor {
            mass: wheel_mass,
            inertia: principal(along, along, 1.5 * along)
        },
        pod {
            mass: 0.5 * wheel_mass,
            inertia: principal(along, along, 1.2 * along),
            points: [p = (0, 0, -reach)]
        },
    ],
    joints: [
        orbit = free(hub),
        spin_x = revolute(hub.x, wheel_x.G, body(1, 0, 0)),
        spin_y = revolute(hub.y, wheel_y.G, body(0, 1, 0)),
        spin_z = revolute(hub.z, rotor.G, body(0, 0, 1)),
        hung = revolute(rotor.G, pod.p, body(0, 0, 1)),
    ],
    drives: [
        a = torque.on(spin_x),
        b = (-torque).on(spin_z),
        c = (-0.1[N * m * s] * spin_y.angular_velocity).on(spin_y)
    ],
    forces: [belt = (3[N]).between(wheel_y.rim, world(0, 1, 0))],
    outputs: [energy, momentum, reactions],
});

#[test]
fn wheels_and_copies() {
    let make = |numbers: &mut Random| {
        let [a, b, c, d, e] = [0; 5].map(|_| 1.5 + numbers.number());
        let params = WheelsParams {
            hub_mass: a,
            wheel_mass: b,
            across: c,
            along: d,
            reach: e,
        };
        let links = wheels(a, b, c, d, e);
        (
            Wheels::new(params).unwrap(),
            WheelsInput {
                torque: 5.0 * numbers.number(),
            },
            links,
        )
    };
    agree!(Wheels, make, [0.0; 3], moving [orbit spin_x spin_y spin_z hung],
    held [1 spin_x 2 spin_y 3 spin_z 4 hung], still [], |loads, _system, input| {
        loads.drives[1] = vec![input.torque];
        loads.drives[3] = vec![-input.torque];
        loads.drives[2] = vec![-0.1 * loads.rates[2].1[0]];
        loads.pull(3.0, (2, [0.1, 0.1, 0.1]), [0.0, 1.0, 0.0]);
    });
}

fn wheels(hub: f64, wheel: f64, across: f64, along: f64, reach: f64) -> [Link; 5] {
    let [thin, thick] = [wheel * 0.2 * 0.2 / 4.0, wheel * 0.2 * 0.2 / 2.0];
    let spin = |inertia: Matrix3<f64>, place: [f64; 3], axis: Vector3<f64>| {
        link(
            (wheel, inertia),
            Some(0),
            place,
            [0.0; 3],
            Kind::Revolute(axis),
        )
    };
    let pod = (0.5 * wheel, principal(along, along, 1.2 * along));
    [
        link(
            (hub, principal(across, 2.0 * across, 1.5 * across)),
            None,
            [0.0; 3],
            [0.0; 3],
            Kind::Free,
        ),
        spin(
            principal(thick, thin, thin),
            [reach, 0.0, 0.0],
            Vector3::x(),
        ),
        spin(
            principal(thin, thick, thin),
            [0.0, reach, 0.0],
            Vector3::y(),
        ),
        spin(
            principal(along, along, 1.5 * along),
            [0.0, 0.0, reach],
            Vector3::z(),
        ),
        link(
            pod,
            Some(3),
            [0.0; 3],
            [0.0, 0.0, -reach],
            Kind::Revolute(Vector3::z()),
        ),
    ]
}

// no offset at all, no weight on one, and everything in one point
rigid_system!(Gimbal {
    bodies: [
        outer {
            mass: 1[kg],
            inertia: principal(0.3, 0.4, 0.5)[kg * m ^ 2]
        },
        inner {
            mass: 2[kg],
            inertia: principal(0.2, 0.25, 0.3)[kg * m ^ 2]
        },
        rotor {
            mass: 3[kg],
            inertia: principal(0.1, 0.1, 0.15)[kg * m ^ 2]
        },
        stand {
            mass: 4[kg],
            inertia: principal(1, 1, 1)[kg * m ^ 2]
        },
        sphere {
            mass: 1[kg],
            inertia: principal(0.2, 0.2, 0.2)[kg * m ^ 2]
        },
    ],
    joints: [
        foot = weld(world(0, 0, 0), stand.G),
        yaw = revolute(stand.G, outer.G, body(0, 0, 1)),
        tilt = revolute(outer.G, inner.G, body(1, 0, 0)),
        spin = revolute(inner.G, rotor.G, body(0, 0, 1)),
        roll = spherical(rotor.G, sphere.G),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    outputs: [energy, momentum, reactions],
});

#[test]
fn everything_in_one_point() {
    let here = [0.0; 3];
    let links = [
        link(
            (4.0, principal(1.0, 1.0, 1.0)),
            None,
            here,
            here,
            Kind::Weld,
        ),
        link(
            (1.0, principal(0.3, 0.4, 0.5)),
            Some(0),
            here,
            here,
            Kind::Revolute(Vector3::z()),
        ),
        link(
            (2.0, principal(0.2, 0.25, 0.3)),
            Some(1),
            here,
            here,
            Kind::Revolute(Vector3::x()),
        ),
        link(
            (3.0, principal(0.1, 0.1, 0.15)),
            Some(2),
            here,
            here,
            Kind::Revolute(Vector3::z()),
        ),
        link(
            (1.0, principal(0.2, 0.2, 0.2)),
            Some(3),
            here,
            here,
            Kind::Spherical,
        ),
    ];
    let make = |_: &mut Random| (Gimbal::default(), (), links);
    agree!(Gimbal, make, [0.0, 0.0, -9.81], moving [yaw tilt spin roll],
        held [0 foot 1 yaw 2 tilt 3 spin 4 roll], still [0], |_loads, _system, _input| {});
}
