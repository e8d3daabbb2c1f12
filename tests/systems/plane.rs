//! Systems in the plane, compared with the oracle.

use nalgebra::{Matrix3, Vector3};
use newton_euler::prelude::*;

use super::agree;
use super::compare::{Random, link, unit};
use super::oracle::{Kind, Link};

fn disc(inertia: f64) -> Matrix3<f64> {
    Matrix3::identity() * inertia
}

fn flat(
    body: (f64, f64),
    carrier: Option<usize>,
    place: [f64; 2],
    pin: [f64; 2],
    kind: Kind,
) -> Link {
    let [place, pin] = [place, pin].map(|[x, y]| [x, y, 0.0]);
    link((body.0, disc(body.1)), carrier, place, pin, kind)
}

const TURN: Kind = Kind::Revolute(Vector3::new(0.0, 0.0, 1.0));

// a chain of five, all masses and moments params
rigid_system!(Chain {
    motion: planar,
    params: [m[kg], j[kg * m ^ 2], half[m], offset[m]],
    bodies: [
        a {
            mass: m,
            inertia: j,
            points: [p = (-half, 0), q = (half, offset)]
        },
        b {
            mass: 0.9 * m,
            inertia: j,
            points: [p = (-half, offset), q = (half, 0)]
        },
        c {
            mass: 0.8 * m,
            inertia: 2 * j,
            points: [p = (-half, 0), q = (half, 0)]
        },
        d {
            mass: 0.7 * m,
            inertia: j,
            points: [p = (-half, 0), q = (half, 0)]
        },
        e {
            mass: 0.6 * m,
            inertia: j,
            points: [p = (-half, 0)]
        },
    ],
    joints: [
        one = revolute(world(0.1, 0.2), a.p),
        two = revolute(a.q, b.p),
        three = revolute(b.q, c.p),
        four = revolute(c.q, d.p).turned(0.6),
        five = revolute(d.q, e.p).turned(90[deg]),
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    drives: [a = (-0.2[N * m * s] * two.angular_velocity).on(two)],
    outputs: [energy, momentum, reactions],
});

#[test]
fn a_chain_of_params() {
    let make = |numbers: &mut Random| {
        let [m, j, half, offset] = [0; 4].map(|_| 1.5 + numbers.number());
        let mut links = [
            flat((m, j), None, [0.1, 0.2], [-half, 0.0], TURN),
            flat((0.9 * m, j), Some(0), [half, offset], [-half, offset], TURN),
            flat((0.8 * m, 2.0 * j), Some(1), [half, 0.0], [-half, 0.0], TURN),
            flat((0.7 * m, j), Some(2), [half, 0.0], [-half, 0.0], TURN),
            flat((0.6 * m, j), Some(3), [half, 0.0], [-half, 0.0], TURN),
        ];
        links[3].turned = (Vector3::z(), 0.6);
        links[4].turned = (Vector3::z(), 90.0_f64.to_radians());
        (
            Chain::new(ChainParams { m, j, half, offset }).unwrap(),
            (),
            links,
        )
    };
    agree!(Chain, make, [0.0, -9.81, 0.0], moving [one two three four five],
    held [0 one 1 two 2 three 3 four 4 five], still [], |loads, _system, _input| {
        loads.drives[1] = vec![-0.2 * loads.rates[1].1[0]];
    });
}

// a free base with two arms: slides, a weld, turned joints, loads of all sorts
rigid_system!(Craft {
    motion: planar,
    inputs: [wind = world(_, _)[m / s], torque[N * m]],
    bodies: [
        hub {
            mass: 3[kg],
            inertia: 0.6[kg * m ^ 2],
            points: [left = (-0.4, 0.1), right = (0.5, -0.2)],
            forces: [
                jet = body(0, 2)[N].at(right),
                tow = world(1, 0.5)[N].at(left)
            ],
            moments: [damper = -0.1[N * m * s] * angular_velocity],
        },
        rod {
            mass: 0.5[kg],
            inertia: 0.03[kg * m ^ 2],
            points: [p = (0.1, 0.2), q = (0, -0.3)],
            forces: [sail = (-0.6[N * s / m] * (q.velocity() - wind)).at(q)],
        },
        plate {
            mass: 0.4[kg],
            inertia: 0.02[kg * m ^ 2],
            points: [p = (0.1, -0.1), q = (0.2, 0)]
        },
        arm {
            mass: 0.7[kg],
            inertia: 0.05[kg * m ^ 2],
            points: [p = (-0.3, 0.1), q = (0.2, 0.2)]
        },
        bob {
            mass: 0.2[kg],
            inertia: 0.01[kg * m ^ 2],
            points: [p = (0, 0.15)]
        },
    ],
    joints: [
        base = free(hub),
        slide = prismatic(hub.left, rod.p, body(3, 4)).turned(30[deg]),
        glue = weld(rod.q, plate.p).turned(-0.5),
        shoulder = revolute(hub.right, arm.p),
        wrist = revolute(arm.q, bob.p),
    ],
    fields: [
        weight = mass * world(0, -9.81[m / s ^ 2]),
        air = -0.2[N * s / m] * velocity,
    ],
    drives: [
        motor = torque.on(shoulder),
        spring = (-9[N / m] * slide.position - 0.4[N * s / m] * slide.velocity).on(slide),
    ],
    forces: [
        band = (4[N / m] * (plate.q.position() - bob.G.position()).norm()).between(plate.q, bob.G),
        rope = (2[N]).between(arm.G, world(1, 2)),
    ],
    moments: [
        load = moment(0.3[N * m]).on(bob),
        coil = moment(-0.2[N * m] * hub.attitude).between(plate, arm),
    ],
    outputs: [energy, momentum, reactions],
});

#[test]
fn a_free_base_with_arms() {
    let mut links = [
        flat((3.0, 0.6), None, [0.0; 2], [0.0; 2], Kind::Plane),
        flat(
            (0.5, 0.03),
            Some(0),
            [-0.4, 0.1],
            [0.1, 0.2],
            Kind::Prismatic(unit(3.0, 4.0, 0.0)),
        ),
        flat((0.4, 0.02), Some(1), [0.0, -0.3], [0.1, -0.1], Kind::Weld),
        flat((0.7, 0.05), Some(0), [0.5, -0.2], [-0.3, 0.1], TURN),
        flat((0.2, 0.01), Some(3), [0.2, 0.2], [0.0, 0.15], TURN),
    ];
    links[1].turned = (Vector3::z(), 30.0_f64.to_radians());
    links[2].turned = (Vector3::z(), -0.5);
    let make = |numbers: &mut Random| {
        let input = CraftInput {
            wind: numbers.vector().xy(),
            torque: numbers.number(),
        };
        (Craft::default(), input, links)
    };
    agree!(Craft, make, [0.0, -9.81, 0.0], moving [base slide shoulder wrist],
    held [1 slide 2 glue 3 shoulder 4 wrist], still [2], |loads, _system, input| {
        for body in 0..5 {
            let velocity = loads.motions[body].velocity;
            loads.force(body, [0.0; 3], velocity * -0.2);
        }
        loads.force(0, [0.5, -0.2, 0.0], loads.turned(0, [0.0, 2.0, 0.0]));
        loads.force(0, [-0.4, 0.1, 0.0], Vector3::new(1.0, 0.5, 0.0));
        loads.moment(0, loads.motions[0].angular_velocity * -0.1);
        let (q, wind) = ([0.0, -0.3, 0.0], Vector3::new(input.wind.x, input.wind.y, 0.0));
        loads.force(1, q, (loads.velocity(1, q) - wind) * -0.6);
        let end = [0.2, 0.0, 0.0];
        let stretch = (loads.point(2, end) - loads.point(4, [0.0; 3])).norm();
        loads.tension(4.0 * stretch, (2, end), (4, [0.0; 3]));
        loads.pull(2.0, (3, [0.0; 3]), [1.0, 2.0, 0.0]);
        loads.moment(4, Vector3::z() * 0.3);
        let coil = Vector3::z() * (-0.2 * loads.rates[0].0[2]);
        loads.moment(3, coil);
        loads.moment(2, -coil);
        loads.drives[3] = vec![input.torque];
        loads.drives[1] = vec![-9.0 * loads.rates[1].0[0] - 0.4 * loads.rates[1].1[0]];
    });
}

// slides on slides, a body that only slides, and one that is welded to the ground
rigid_system!(Crane {
    motion: planar,
    params: [cart_mass[kg], load_mass[kg], height = 2[m]],
    inputs: [push[N]],
    bodies: [
        wall {
            mass: 10[kg],
            inertia: 1[kg * m ^ 2],
            points: [rail = (0.5, height)]
        },
        cart {
            mass: cart_mass,
            inertia: 0.2[kg * m ^ 2],
            points: [hook = (0, -0.2)]
        },
        hoist {
            mass: 0.3[kg],
            inertia: 0.02[kg * m ^ 2],
            points: [eye = (0.1, 0.3)]
        },
        load {
            mass: load_mass,
            inertia: 0.4[kg * m ^ 2],
            points: [top = (0.05, 0.4)]
        },
    ],
    joints: [
        bolts = weld(world(0, 0), wall.G).turned(0.1),
        rail = prismatic(wall.rail, cart.G, body(1, 0)),
        lift = prismatic(cart.hook, hoist.eye, body(0, -1)),
        swing = revolute(hoist.G, load.top),
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    drives: [motor = push.on(rail), winch = (-30[N]).on(lift)],
    outputs: [energy, momentum, reactions],
});

#[test]
fn slides_on_slides() {
    let make = |numbers: &mut Random| {
        let [cart_mass, load_mass] = [0; 2].map(|_| 1.5 + numbers.number());
        let height = 2.0 + numbers.number();
        let mut links = [
            flat((10.0, 1.0), None, [0.0; 2], [0.0; 2], Kind::Weld),
            flat(
                (cart_mass, 0.2),
                Some(0),
                [0.5, height],
                [0.0; 2],
                Kind::Prismatic(Vector3::x()),
            ),
            flat(
                (0.3, 0.02),
                Some(1),
                [0.0, -0.2],
                [0.1, 0.3],
                Kind::Prismatic(-Vector3::y()),
            ),
            flat((load_mass, 0.4), Some(2), [0.0; 2], [0.05, 0.4], TURN),
        ];
        links[0].turned = (Vector3::z(), 0.1);
        let params = CraneParams {
            cart_mass,
            load_mass,
            height,
        };
        (
            Crane::new(params).unwrap(),
            CraneInput {
                push: 10.0 * numbers.number(),
            },
            links,
        )
    };
    agree!(Crane, make, [0.0, -9.81, 0.0], moving [rail lift swing],
    held [0 bolts 1 rail 2 lift 3 swing], still [0], |loads, _system, input| {
        loads.drives[1] = vec![input.push];
        loads.drives[2] = vec![-30.0];
    });
}
