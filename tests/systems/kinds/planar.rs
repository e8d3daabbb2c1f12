//! Two slides in a plane, and a rotation about its normal.

use nalgebra::Vector3;
use newton_euler::prelude::*;

use crate::agree;
use crate::compare::{Random, close, link, principal, unit};
use crate::oracle::{Kind, Link};

// on the ground, on a body, turned, along axes in both senses and oblique
rigid_system!(Tables {
    inputs: [torque[N * m], push = world(_, _, _)[N]],
    bodies: [
        a {
            mass: 1.3[kg],
            inertia: principal(0.3, 0.4, 0.5)[kg * m ^ 2],
            points: [
                p = (0.1, -0.2, 0.3),
                q = (-0.2, 0.4, 0.15),
                r = (0.3, 0, 0.1)
            ],
        },
        b {
            mass: 0.7[kg],
            inertia: principal(0.12, 0.2, 0.16)[kg * m ^ 2],
            points: [p = (0.25, 0.1, -0.1), q = (0, -0.3, 0.2)],
        },
        c {
            mass: 0.9[kg],
            inertia: principal(0.05, 0.06, 0.04)[kg * m ^ 2],
            points: [p = (-0.1, 0.2, 0.3)],
        },
        d {
            mass: 0.4[kg],
            inertia: principal(0.07, 0.05, 0.06)[kg * m ^ 2],
            points: [p = (0.1, 0.12, 0.2)]
        },
    ],
    joints: [
        table = planar(world(0.5, 0.2, -0.1), a.p, body(0, 0, 2)),
        swing = revolute(a.q, b.p, body(0, 3, 4)),
        flat = planar(b.q, c.p, body(0, -1, 0)).turned(body(1, 0, 0), 30[deg]),
        slope = planar(a.r, d.p, body(-2, 1, 2)),
    ],
    fields: [weight = mass * world(0.3, -0.2, -9.81[m / s ^ 2])],
    drives: [
        motor = torque.on(table.angle),
        pushed = push.on(table.position),
        spring = (-20[N / m] * slope.position - 3[N * s / m] * slope.velocity).on(slope.position),
        damper = (-0.1[N * m * s] * flat.angular_velocity).on(flat.angle),
        tilted = (push.norm() * a.body(0, 0.5, 0.25)).on(flat.position),
    ],
    outputs: [energy, momentum, reactions],
});

fn tables() -> [Link; 4] {
    let slope = unit(-2.0, 1.0, 2.0);
    let [along, across] = frame_of(slope, -Vector3::x(), [Vector3::y(), -Vector3::z()]);
    let mut links = [
        link(
            (1.3, principal(0.3, 0.4, 0.5)),
            None,
            [0.5, 0.2, -0.1],
            [0.1, -0.2, 0.3],
            Kind::Planar(Vector3::x(), Vector3::y(), Vector3::z()),
        ),
        link(
            (0.7, principal(0.12, 0.2, 0.16)),
            Some(0),
            [-0.2, 0.4, 0.15],
            [0.25, 0.1, -0.1],
            Kind::Revolute(unit(0.0, 3.0, 4.0)),
        ),
        link(
            (0.9, principal(0.05, 0.06, 0.04)),
            Some(1),
            [0.0, -0.3, 0.2],
            [-0.1, 0.2, 0.3],
            Kind::Planar(Vector3::z(), -Vector3::x(), -Vector3::y()),
        ),
        link(
            (0.4, principal(0.07, 0.05, 0.06)),
            Some(0),
            [0.3, 0.0, 0.1],
            [0.1, 0.12, 0.2],
            Kind::Planar(along, across, slope),
        ),
    ];
    links[2].turned = (Vector3::x(), 30.0_f64.to_radians());
    links
}

/// Two vectors across an axis, turned by the shortest rotation that takes the axis to a normal.
fn frame_of(
    normal: Vector3<f64>,
    axis: Vector3<f64>,
    pair: [Vector3<f64>; 2],
) -> [Vector3<f64>; 2] {
    let turn = nalgebra::Rotation3::rotation_between(&axis, &normal).unwrap();
    pair.map(|vector| turn * vector)
}

#[test]
fn planar_joints() {
    let make = |numbers: &mut Random| {
        let input = TablesInput {
            torque: numbers.number(),
            push: numbers.vector() * 3.0,
        };
        (Tables::default(), input, tables())
    };
    agree!(Tables, make, [0.3, -0.2, -9.81], moving [table swing flat slope],
    held [0 table 1 swing 2 flat 3 slope], still [], |loads, _system, input| {
        let (q, v): (Vec<_>, Vec<_>) = loads.rates.iter().cloned().unzip();
        let slide = |axis: usize| -20.0 * q[3][axis] - 3.0 * v[3][axis];
        // the axes in which the flat joint slides: those of its carrier, turned
        let turn = nalgebra::Rotation3::new(Vector3::x() * 30.0_f64.to_radians());
        let tilted = loads.turned(0, [0.0, 0.5, 0.25]) * input.push.norm();
        let tilted = turn.inverse() * (loads.motions[1].attitude.transpose() * tilted);
        loads.drives = vec![
            vec![input.push.x, input.push.y, input.torque],
            vec![0.0],
            vec![tilted.z, -tilted.x, -0.1 * v[2][2]],
            vec![slide(0), slide(1), 0.0],
        ];
    });
}

macro_rules! directions {
    ($($name:ident: $($normal:expr),+ => $along:expr, $across:expr;)*) => {$(
        rigid_system!($name {
            bodies: [plate { mass: 1[kg], inertia: principal(2, 3, 4)[kg * m ^ 2] }],
            joints: [table = planar(world(0, 0, 0), plate.G, body($($normal),+))],
            outputs: [momentum],
        });
    )*
        #[test]
        fn the_axes_of_the_coordinates() {
            $({
                let at = |x: f64, y: f64, w: f64| {
                    let velocity = [x, y].into();
                    let table = Planar { velocity, angular_velocity: w, ..Planar::default() };
                    $name::default().linear_momentum(&<$name as One>::state(table))
                };
                let (along, across) = (at(1.0, 0.0, 0.0), at(0.0, 1.0, 0.0));
                let normal = unit($(f64::from($normal)),+);
                close("along", along.as_slice(), Vector3::from($along).as_slice(), 1.0, 1e-15);
                close("across", across.as_slice(), Vector3::from($across).as_slice(), 1.0, 1e-15);
                close("normal", along.cross(&across).as_slice(), normal.as_slice(), 1.0, 1e-15);
                assert_eq!(at(0.0, 0.0, 1.0), Vector3::zeros());
            })*
        }
    };
}

/// The state of a system with one joint.
trait One {
    type State;
    fn state(table: Planar) -> Self::State;
}

macro_rules! one {
    ($($name:ident $state:ident)*) => {$(
        impl One for $name {
            type State = $state;
            fn state(table: Planar) -> $state {
                $state { table }
            }
        }
    )*};
}
one!(X XState Y YState Z ZState BackX BackXState BackY BackYState BackZ BackZState
    Diagonal DiagonalState Down DownState Near NearState);
const THIRD: f64 = 1.0 / 3.0;

directions! {
    X: 3, 0, 0 => [0.0, 1.0, 0.0], [0.0, 0.0, 1.0];
    Y: 0, 1, 0 => [0.0, 0.0, 1.0], [1.0, 0.0, 0.0];
    Z: 0, 0, 1 => [1.0, 0.0, 0.0], [0.0, 1.0, 0.0];
    BackX: -1, 0, 0 => [0.0, 1.0, 0.0], [0.0, 0.0, -1.0];
    BackY: 0, -1, 0 => [0.0, 0.0, 1.0], [-1.0, 0.0, 0.0];
    BackZ: 0, 0, -1 => [1.0, 0.0, 0.0], [0.0, -1.0, 0.0];
    // of axes that are as near the first
    Diagonal: 2, 2, 1 => [-2.0 * THIRD, 1.0 - 4.0 / 15.0, -2.0 / 15.0], [-THIRD, -2.0 / 15.0, 1.0 - 1.0 / 15.0];
    Down: 0, 3, -4 => [1.0, 0.0, 0.0], [0.0, -0.8, -0.6];
    Near: 1, -2, 2 => [-2.0 / 15.0, 2.0 * THIRD, 11.0 / 15.0], [-14.0 / 15.0, -THIRD, 2.0 / 15.0];
}
