//! Descriptions that are easy to get wrong, compared with the oracle: all sorts of names, loads
//! that depend on what is otherwise left out, locals, welds between loads.

use nalgebra::{Matrix3, Vector3};
use newton_euler::prelude::*;

use super::agree;
use super::compare::{Random, TIME, link, principal};
use super::oracle::Kind;

// names that generated code has too, and names that joints give to their coordinates
rigid_system!(Named {
    params: [
        elbow_angle[N * m],
        elbow_w[m],
        sum_w = 0.2[m],
        product_1 = 3[N / m]
    ],
    inputs: [elbow_alpha[N * m], sine[N], state[N * m], time[1 / s]],
    bodies: [
        input {
            mass: 1[kg],
            inertia: principal(1, 1.2, 1.1)[kg * m ^ 2],
            points: [x = (elbow_w, 0, 0), sum = (0, sum_w, 0)]
        },
        output {
            mass: 2[kg],
            inertia: principal(1, 2, 1.5)[kg * m ^ 2],
            points: [q = (1, sum_w, 0)]
        },
        inverse {
            mass: 0.5[kg],
            inertia: principal(0.3, 0.2, 0.25)[kg * m ^ 2],
            points: [q = (1, sum_w, 0)],
            forces: [x = body(sine, 0, 0).at(q)],
            moments: [cosine = body(0, state, elbow.angle * elbow_angle)],
        },
    ],
    joints: [
        elbow = revolute(world(0, 0, elbow_w), input.x, body(0, 0, 1)),
        sum = revolute(input.sum, output.q, body(0, 1, 0)),
        R_p = spherical(input.sum, inverse.q),
    ],
    locals: [
        difference = product_1 * (sum.angle + 1) * elbow_w,
        sum_angle = elbow_alpha * (time * t).cos()
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    forces: [self_ = difference.between(output.G, inverse.G)],
    drives: [motor = sum_angle.on(elbow), x = elbow_angle.on(sum)],
    outputs: [reactions, energy, momentum],
});

#[test]
fn names_of_all_sorts() {
    let make = |numbers: &mut Random| {
        let [elbow_angle, elbow_w, sum_w, product_1] = [0; 4].map(|_| 1.5 + numbers.number());
        let [elbow_alpha, sine, state, time] = [0; 4].map(|_| numbers.number());
        let links = [
            link(
                (1.0, principal(1.0, 1.2, 1.1)),
                None,
                [0.0, 0.0, elbow_w],
                [elbow_w, 0.0, 0.0],
                Kind::Revolute(Vector3::z()),
            ),
            link(
                (2.0, principal(1.0, 2.0, 1.5)),
                Some(0),
                [0.0, sum_w, 0.0],
                [1.0, sum_w, 0.0],
                Kind::Revolute(Vector3::y()),
            ),
            link(
                (0.5, principal(0.3, 0.2, 0.25)),
                Some(0),
                [0.0, sum_w, 0.0],
                [1.0, sum_w, 0.0],
                Kind::Spherical,
            ),
        ];
        let params = NamedParams {
            elbow_angle,
            elbow_w,
            sum_w,
            product_1,
        };
        (
            Named::new(params).unwrap(),
            NamedInput {
                elbow_alpha,
                sine,
                state,
                time,
            },
            links,
        )
    };
    agree!(Named, make, [0.0, 0.0, -9.81], moving [elbow sum R_p],
    held [0 elbow 1 sum 2 R_p], still [], |loads, system, input| {
        let params = system.params();
        let pin = [1.0, params.sum_w, 0.0];
        loads.force(2, pin, loads.turned(2, [input.sine, 0.0, 0.0]));
        let angle = loads.rates[0].0[0];
        loads.moment(2, loads.turned(2, [0.0, input.state, angle * params.elbow_angle]));
        let pull = params.product_1 * (loads.rates[1].0[0] + 1.0) * params.elbow_w;
        loads.tension(pull, (1, [0.0; 3]), (2, [0.0; 3]));
        loads.drives[0] = vec![input.elbow_alpha * (input.time * TIME).cos()];
        loads.drives[1] = vec![params.elbow_angle];
    });
}

// wheels of which the angle is seen: by a force in body axes, a moment, a drive, a joint
rigid_system!(Seen {
    bodies: [
        cart {
            mass: 3[kg],
            inertia: principal(1, 1.4, 1.8)[kg * m ^ 2],
            points: [
                a = (1, 0.5, 0),
                b = (1, -0.5, 0),
                c = (-1, 0.5, 0),
                d = (-1, -0.5, 0)
            ]
        },
        pushed {
            mass: 0.4[kg],
            inertia: principal(0.02, 0.03, 0.02)[kg * m ^ 2],
            points: [rim = (0.2, 0, 0)],
            forces: [tread = body(0.5, 0, 0.3)[N].at(rim)],
        },
        turned {
            mass: 0.4[kg],
            inertia: principal(0.02, 0.03, 0.02)[kg * m ^ 2],
            moments: [
                uneven = body(0.2[N * m * s] * angular_velocity.in_body().x, 0.1[N * m], 0),
                even = -0.05[N * m * s] * angular_velocity,
            ],
        },
        driven {
            mass: 0.4[kg],
            inertia: principal(0.02, 0.03, 0.02)[kg * m ^ 2]
        },
        carrier {
            mass: 0.4[kg],
            inertia: principal(0.02, 0.03, 0.02)[kg * m ^ 2],
            points: [rim = (0, 0, 0.2)]
        },
        valve {
            mass: 0.1[kg],
            inertia: principal(0.001, 0.001, 0.001)[kg * m ^ 2]
        },
    ],
    joints: [
        road = free(cart),
        p = revolute(cart.a, pushed.G, body(0, 1, 0)),
        q = revolute(cart.b, turned.G, body(0, 1, 0)),
        r = revolute(cart.c, driven.G, body(0, 1, 0)),
        s = revolute(cart.d, carrier.G, body(0, 1, 0)),
        glue = weld(carrier.rim, valve.G).turned(body(0, 0, 1), 30[deg]),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [x = (0.3[N * m] * r.angle.cos()).on(r)],
    forces: [
        held = (4[N]).between(carrier.G, valve.G),
        own = (2[N]).between(cart.a, turned.G)
    ],
    outputs: [reactions, energy, momentum],
});

#[test]
fn wheels_of_which_the_angle_is_seen() {
    let round = principal(0.02, 0.03, 0.02);
    let wheel = |x: f64, y: f64| {
        link(
            (0.4, round),
            Some(0),
            [x, y, 0.0],
            [0.0; 3],
            Kind::Revolute(Vector3::y()),
        )
    };
    let mut links = [
        link(
            (3.0, principal(1.0, 1.4, 1.8)),
            None,
            [0.0; 3],
            [0.0; 3],
            Kind::Free,
        ),
        wheel(1.0, 0.5),
        wheel(1.0, -0.5),
        wheel(-1.0, 0.5),
        wheel(-1.0, -0.5),
        link(
            (0.1, principal(0.001, 0.001, 0.001)),
            Some(4),
            [0.0, 0.0, 0.2],
            [0.0; 3],
            Kind::Weld,
        ),
    ];
    links[5].turned = (Vector3::z(), 30.0_f64.to_radians());
    let make = |_: &mut Random| (Seen::default(), (), links);
    agree!(Seen, make, [0.0, 0.0, -9.81], moving [road p q r s],
    held [1 p 2 q 3 r 4 s 5 glue], still [5], |loads, _system, _input| {
        loads.force(1, [0.2, 0.0, 0.0], loads.turned(1, [0.5, 0.0, 0.3]));
        let spin = loads.motions[2].angular_velocity;
        let in_body = loads.motions[2].attitude.transpose() * spin;
        loads.moment(2, loads.turned(2, [0.2 * in_body.x, 0.1, 0.0]) - spin * 0.05);
        loads.drives[3] = vec![0.3 * loads.rates[3].0[0].cos()];
        loads.tension(4.0, (4, [0.0; 3]), (5, [0.0; 3]));
        loads.tension(2.0, (0, [1.0, 0.5, 0.0]), (2, [0.0; 3]));
    });
}

// composed bodies, locals of the whole and of bodies, vectors in the axes of another body
rigid_system!(Locals {
    params: [k = 3[N / m]],
    bodies: [
        base {
            inertia: compose([
                cuboid(1[m], 0.2[m], 0.4[m]).mass(1[kg]),
                cuboid(0.2[m], 0.2[m], 0.2[m])
                    .mass(0.5[kg])
                    .at((0.5, 0.3, 0)),
            ]),
            points: [h = (0.1, 0.2, 0)],
        },
        arm {
            mass: 2[kg],
            inertia: tensor {
                xx: 1.3,
                yy: 1.35,
                zz: 1.25,
                xy: 0.02,
                yz: -0.03,
                zx: 0.05
            }[kg * m ^ 2],
            points: [h = (0.1, 0.2, 0)],
            locals: [fast = velocity.norm()],
            forces: [drag = -0.1[N * s ^ 2 / m ^ 2] * fast * velocity],
            moments: [
                from_base = base.body(0.1, 0.2, 0)[N * m] * v.angular_velocity.norm() / 1[rad / s]
            ],
        },
    ],
    joints: [fly = free(base), v = spherical(base.h, arm.h)],
    locals: [
        force = k * (way.norm() - rest),
        way = arm.h.position() - base.position,
        rest = 0.1[m],
        pull = v.angular_velocity,
        spin = -0.2[N * m * s] * pull.in_body(base).x,
    ],
    forces: [s = force.between(base.G, arm.G)],
    moments: [m = moment(arm.body(0, spin, 0)).between(arm, base)],
    drives: [d = (-0.1[N * m * s] * pull).on(v)],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    outputs: [reactions, energy, momentum],
});

/// Mass, tensor about G, and h from G.
fn composed() -> (f64, Matrix3<f64>, [f64; 3]) {
    let cuboid = |mass: f64, a: f64, b: f64, c: f64| {
        principal(b * b + c * c, c * c + a * a, a * a + b * b) * (mass / 12.0)
    };
    let (at, mass) = (Vector3::new(0.5, 0.3, 0.0), 1.5);
    let center = at * (0.5 / mass);
    let steiner = |mass: f64, r: Vector3<f64>| {
        (Matrix3::identity() * r.norm_squared() - r * r.transpose()) * mass
    };
    let tensor = cuboid(1.0, 1.0, 0.2, 0.4)
        + steiner(1.0, -center)
        + cuboid(0.5, 0.2, 0.2, 0.2)
        + steiner(0.5, at - center);
    (mass, tensor, (Vector3::new(0.1, 0.2, 0.0) - center).into())
}

#[test]
fn locals_and_composed_bodies() {
    let (mass, inertia, h) = composed();
    let tensor = Matrix3::new(1.3, 0.02, 0.05, 0.02, 1.35, -0.03, 0.05, -0.03, 1.25);
    let links = [
        link((mass, inertia), None, [0.0; 3], [0.0; 3], Kind::Free),
        link((2.0, tensor), Some(0), h, [0.1, 0.2, 0.0], Kind::Spherical),
    ];
    let make = |_: &mut Random| (Locals::default(), (), links);
    agree!(Locals, make, [0.0, 0.0, -9.81], moving [fly v], held [1 v], still [], |loads, _system, _input| {
        let velocity = loads.motions[1].velocity;
        loads.force(1, [0.0; 3], velocity * (-0.1 * velocity.norm()));
        let pull = Vector3::from_row_slice(&loads.rates[1].1);
        loads.moment(1, loads.turned(0, [0.1, 0.2, 0.0]) * pull.norm());
        let way = (loads.point(1, [0.1, 0.2, 0.0]) - loads.motions[0].position).norm();
        loads.tension(3.0 * (way - 0.1), (0, [0.0; 3]), (1, [0.0; 3]));
        let in_base = loads.motions[0].attitude.transpose() * loads.motions[1].attitude * pull;
        let moment = loads.turned(1, [0.0, -0.2 * in_base.x, 0.0]);
        loads.moment(0, moment);
        loads.moment(1, -moment);
        loads.drives[1] = (pull * -0.1).iter().copied().collect();
    });
}
