//! Directions in the axes of a rotated body, of its carrier, and of the ground.

use nalgebra::{Rotation3, UnitQuaternion, Vector3};
use newton_euler::prelude::*;

use super::compare::{Random, link, principal};
use super::oracle::{Kind, Link};
use crate::agree;

rigid_system!(Turned {
    params: [tilt = 25[deg]],
    bodies: [
        a {
            mass: 1[kg],
            inertia: principal(0.1, 0.2, 0.25)[kg * m ^ 2],
            points: [q = (0.3, 0, 0)]
        },
        b {
            mass: 2[kg],
            inertia: principal(0.1, 0.3, 0.25)[kg * m ^ 2],
            points: [p = (0, 0.3, 0.1), q = (0.1, 0.1, 0)],
        },
        c {
            mass: 0.5[kg],
            inertia: principal(0.01, 0.02, 0.015)[kg * m ^ 2],
            points: [p = (0.1, 0.3, 0.1)]
        },
        d {
            mass: 0.4[kg],
            inertia: principal(0.01, 0.02, 0.015)[kg * m ^ 2],
            points: [p = (0.1, 0.3, 0.1)]
        },
    ],
    joints: [
        j = revolute(world(0, 0, 0), a.G, world(0, 0, 1))
            .turned(world(1, 0, 0), 90[deg])
            .turned(world(0, 0, 1), tilt),
        k = universal(a.q, b.p, a.body(0, 0, 1), b.body(1, 0, 0))
            .turned(a.body(0, 1, 0), 90[deg])
            .turned(a.body(1, 1, 0), tilt),
        l = cylindrical(b.q, c.p, b.body(1, -2, -1)).turned(c.body(1, 0, 0), 30[deg]),
        m = planar(b.q, d.p, b.body(0, 0, 1)).turned(body(1, 0, 0), 90[deg]),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    outputs: [energy, momentum, reactions],
});

/// The rotation by an angle in degrees about an axis.
fn about(axis: Vector3<f64>, degrees: f64) -> Rotation3<f64> {
    Rotation3::new(axis.normalize() * degrees.to_radians())
}

fn links() -> [Link; 4] {
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
    // each about an axis in the axes before all turns, so the last one stands first
    let first = about(z, 25.0) * about(x, 90.0);
    let second = about(x + y, 25.0) * about(y, 90.0);
    let (third, fourth) = (about(x, 30.0), about(x, 90.0));
    let along = Vector3::new(1.0, -2.0, -1.0).normalize();
    let plate = principal(0.01, 0.02, 0.015);
    let (from, to) = ([0.1, 0.1, 0.0], [0.1, 0.3, 0.1]);
    let mut links = [
        link(
            (1.0, principal(0.1, 0.2, 0.25)),
            None,
            [0.0; 3],
            [0.0; 3],
            Kind::Revolute(first.inverse() * z),
        ),
        link(
            (2.0, principal(0.1, 0.3, 0.25)),
            Some(0),
            [0.3, 0.0, 0.0],
            [0.0, 0.3, 0.1],
            Kind::Universal(second.inverse() * z, x),
        ),
        link(
            (0.5, plate),
            Some(1),
            from,
            to,
            Kind::Cylindrical(third.inverse() * along),
        ),
        // z of the carrier is y of the carried body
        link((0.4, plate), Some(1), from, to, Kind::Planar(z, x, y)),
    ];
    for (link, turn) in links.iter_mut().zip([first, second, third, fourth]) {
        let (axis, angle) = turn.axis_angle().unwrap();
        link.turned = (axis.into_inner(), angle);
    }
    links
}

#[test]
fn directions_are_in_the_axes_in_which_they_are_written() {
    let make = |_: &mut Random| (Turned::default(), (), links());
    agree!(Turned, make, [0.0, 0.0, -9.81], moving [j k l m], held [0 j 1 k 2 l 3 m], still [],
        |_loads, _system, _input| {});
}

rigid_system!(Rail {
    doc: "A slide along x of the world, though the sled is turned.",
    motion: planar,
    bodies: [sled {
        mass: 2[kg],
        inertia: 0.1[kg * m ^ 2],
        points: [p = (0.1, 0.2)]
    }],
    joints: [rail = prismatic(world(0, 0), sled.p, world(1, 0)).turned(90[deg])],
    fields: [weight = mass * world(3[m / s ^ 2], -9.81[m / s ^ 2])],
});

#[test]
fn a_turned_sled_slides_along_the_rail_of_the_ground() {
    let found = Rail::default().acceleration(0.0, &RailState::default(), &());
    assert!((found.rail - 3.0).abs() < 1e-15);
}

macro_rules! turned_ball {
    ($name:ident, $angle:expr) => {
        rigid_system!($name {
            bodies: [
                arm {
                    mass: 0[kg],
                    points: [end = (0.2, 0, 0)[m]]
                },
                frame { mass: 0[kg] },
                ball {
                    mass: 0.2[kg],
                    inertia: principal(0.002, 0.003, 0.004)[kg * m ^ 2],
                    points: [pin = (-0.01, 0, 0)[m]],
                },
            ],
            joints: [
                shoulder = revolute(world(0, 0, 0), arm.G, body(0, 0, 1)),
                seat = weld(arm.end, frame.G).turned(body(1, 2, 2), $angle),
                socket = spherical(frame.G, ball.pin),
            ],
            fields: [weight = mass * world(0, -9.81[m / s ^ 2], 0)],
        });
    };
}

turned_ball!(ByCosine, 2 * 0.8.acos());
turned_ball!(ByDegrees, 73.73979529168804[deg]);

/// The turn is exact: an entry of its matrix is zero, which only an identity proves.
#[test]
fn a_turn_by_its_cosine_is_that_by_its_angle() {
    let (shoulder, socket) = (
        Hinge {
            angle: 0.7,
            angular_velocity: -1.3,
        },
        Rotation {
            attitude: UnitQuaternion::from_euler_angles(0.4, -0.2, 1.1),
            angular_velocity: [0.5, -2.0, 1.5].into(),
        },
    );
    let found = ByCosine::default().acceleration(0.0, &ByCosineState { shoulder, socket }, &());
    let expected =
        ByDegrees::default().acceleration(0.0, &ByDegreesState { shoulder, socket }, &());
    assert!((found.shoulder - expected.shoulder).abs() < 1e-11 * expected.shoulder.abs());
    assert!((found.socket - expected.socket).norm() < 1e-11 * expected.socket.norm());
}
