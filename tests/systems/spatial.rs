//! Systems in space, compared with the oracle.

use nalgebra::{Matrix3, Vector3};
use newton_euler::prelude::*;

use super::agree;
use super::compare::{Random, link, principal, unit};
use super::oracle::Kind;

// every kind with one direction, oblique, away from G, with drives and friction
rigid_system!(Serial {
    inputs: [torque[N * m], push[N]],
    params: [damping = 0.3[N * m * s]],
    bodies: [
        a {
            mass: 1.3[kg],
            inertia: principal(0.3, 0.4, 0.5)[kg * m ^ 2],
            points: [p = (0.1, -0.2, 0.3), q = (-0.2, 0.4, 0.15)],
        },
        b {
            mass: 0.7[kg],
            inertia: tensor {
                xx: 0.3,
                yy: 0.35,
                zz: 0.25,
                xy: 0.02,
                yz: -0.03,
                zx: 0.05
            }[kg * m ^ 2],
            points: [p = (0.25, 0.1, -0.1), q = (0, -0.3, 0.2)],
        },
        c {
            mass: 0.9[kg],
            inertia: principal(0.12, 0.2, 0.16)[kg * m ^ 2],
            points: [p = (-0.1, 0.2, 0.3), q = (0.3, 0.1, 0)],
        },
        d {
            mass: 0.4[kg],
            inertia: principal(0.05, 0.06, 0.04)[kg * m ^ 2],
            points: [p = (0.1, 0.12, 0.2), q = (0.1, 0.2, -0.3)],
        },
        e {
            mass: 0.5[kg],
            inertia: principal(0.07, 0.05, 0.06)[kg * m ^ 2],
            points: [p = (0.2, -0.1, 0.1)],
        },
    ],
    joints: [
        turn = revolute(world(0.5, 0.2, -0.1), a.p, body(2, -1, 2)),
        slide = prismatic(a.q, b.p, body(1, 2, -2)),
        both = cylindrical(b.q, c.p, body(0, 3, 4)),
        nut = screw(c.q, d.p, body(3, 0, -4), 0.15[m]),
        cross = universal(d.q, e.p, body(1, 0, 0), body(0, 3, 4)),
    ],
    fields: [weight = mass * world(0.3, -0.2, -9.81[m / s ^ 2])],
    drives: [
        motor = torque.on(turn),
        friction = (-damping * turn.angular_velocity).on(turn),
        pushed = push.on(slide),
        spring = (-20[N / m] * slide.position - 3[N * s / m] * slide.velocity).on(slide),
        along = (2[N] - 5[N / m] * both.position).on(both.position),
        about = (-damping * both.angular_velocity).on(both.angle),
        screwed = (torque * nut.angle.sin()).on(nut),
        first = (0.7 * torque).on(cross.angle_1),
        second =
            (-0.2[N * m] * cross.angle_2 - damping * cross.angular_velocity_2).on(cross.angle_2),
    ],
    outputs: [energy, momentum, reactions],
});

#[test]
fn joints_of_every_kind_in_a_row() {
    let links = [
        link(
            (1.3, principal(0.3, 0.4, 0.5)),
            None,
            [0.5, 0.2, -0.1],
            [0.1, -0.2, 0.3],
            Kind::Revolute(unit(2.0, -1.0, 2.0)),
        ),
        link(
            (0.7, tensor()),
            Some(0),
            [-0.2, 0.4, 0.15],
            [0.25, 0.1, -0.1],
            Kind::Prismatic(unit(1.0, 2.0, -2.0)),
        ),
        link(
            (0.9, principal(0.12, 0.2, 0.16)),
            Some(1),
            [0.0, -0.3, 0.2],
            [-0.1, 0.2, 0.3],
            Kind::Cylindrical(unit(0.0, 3.0, 4.0)),
        ),
        link(
            (0.4, principal(0.05, 0.06, 0.04)),
            Some(2),
            [0.3, 0.1, 0.0],
            [0.1, 0.12, 0.2],
            Kind::Screw(unit(3.0, 0.0, -4.0), 0.15),
        ),
        link(
            (0.5, principal(0.07, 0.05, 0.06)),
            Some(3),
            [0.1, 0.2, -0.3],
            [0.2, -0.1, 0.1],
            Kind::Universal(Vector3::x(), unit(0.0, 3.0, 4.0)),
        ),
    ];
    let make = |numbers: &mut Random| {
        let (torque, push) = (numbers.number(), 3.0 * numbers.number());
        (Serial::default(), SerialInput { torque, push }, links)
    };
    agree!(Serial, make, [0.3, -0.2, -9.81], moving [turn slide both nut cross],
    held [0 turn 1 slide 2 both 3 nut 4 cross], still [], |loads, _system, input| {
        let (q, v): (Vec<_>, Vec<_>) = loads.rates.iter().cloned().unzip();
        loads.drives = vec![
            vec![input.torque - 0.3 * v[0][0]],
            vec![input.push - 20.0 * q[1][0] - 3.0 * v[1][0]],
            vec![2.0 - 5.0 * q[2][0], -0.3 * v[2][1]],
            vec![input.torque * q[3][0].sin()],
            vec![0.7 * input.torque, -0.2 * q[4][1] - 0.3 * v[4][1]],
        ];
    });
}

fn tensor() -> Matrix3<f64> {
    Matrix3::new(0.3, 0.02, 0.05, 0.02, 0.35, -0.03, 0.05, -0.03, 0.25)
}

// a free base with branches, welds in chains, loads of all sorts
rigid_system!(Craft {
    inputs: [wind = world(_, _, _)[m / s], couple = world(_, _, _)[N * m]],
    bodies: [
        hub {
            mass: 4[kg],
            inertia: principal(0.5, 0.7, 0.9)[kg * m ^ 2],
            points: [
                left = (0.1, 0.5, 0.2),
                right = (0, -0.6, 0.1),
                top = (0.1, 0.2, 0.4)
            ],
            locals: [along = velocity - wind],
            forces: [
                drag = -0.4[N * s / m] * along,
                thrust = body(0, 0, 3)[N].at(top),
                pull = world(1, 2, -1)[N].at(left),
            ],
            moments: [damping = -0.1[N * m * s] * angular_velocity],
        },
        mast {
            mass: 0.6[kg],
            inertia: principal(0.06, 0.05, 0.03)[kg * m ^ 2],
            points: [foot = (0, 0.1, -0.3), head = (0.1, 0, 0.4)],
            forces: [sail = (-0.7[N * s / m] * (head.velocity() - wind)).at(head)],
        },
        flag {
            mass: 0.2[kg],
            inertia: principal(0.01, 0.012, 0.014)[kg * m ^ 2],
            points: [edge = (0.1, 0.05, 0)],
            forces: [lift = body(0.1[N], 0.2[N], 0).at(edge)],
            moments: [twist = body(0.02, 0, -0.03)[N * m]],
        },
        bob {
            mass: 0.8[kg],
            inertia: principal(0.02, 0.03, 0.04)[kg * m ^ 2],
            points: [ring = (0.05, -0.1, 0.3), end = (0, 0.1, -0.2)],
        },
        fin {
            mass: 0.3[kg],
            inertia: principal(0.02, 0.02, 0.03)[kg * m ^ 2],
            points: [root = (0.1, 0.2, 0.1)],
        },
        tail {
            mass: 0.25[kg],
            inertia: principal(0.015, 0.02, 0.01)[kg * m ^ 2],
            points: [root = (0, 0.15, 0.05)],
        },
    ],
    joints: [
        base = free(hub),
        stepped = weld(hub.top, mast.foot).turned(body(1, 2, 2), 0.7),
        hinge = revolute(mast.head, flag.edge, body(0, 0, 1)).turned(body(1, 0, 0), 90[deg]),
        ball = spherical(hub.left, bob.ring),
        root = revolute(hub.right, fin.root, body(0, 1, 0)),
        glued = weld(fin.root, tail.root),
    ],
    fields: [
        weight = mass * world(0, 0, -9.81[m / s ^ 2]),
        air = -0.05[N * s / m] * velocity,
    ],
    drives: [
        held = (-0.3[N * m * s] * ball.angular_velocity).on(ball),
        motor = (0.4[N * m] * root.angle).on(root),
    ],
    forces: [
        spring = (12[N / m] * (hub.right.position() - bob.end.position()).norm())
            .between(hub.right, bob.end),
        rope = (0.9[N]).between(flag.G, world(1, 2, 3)),
        guy = (1.4[N]).between(world(-2, 0, 1), tail.G),
    ],
    moments: [
        gust = moment(couple).on(flag),
        coil = moment(hub.body(0.2, 0.1, 0)[N * m]).between(hub, fin),
    ],
    outputs: [energy, momentum, reactions],
});

#[test]
fn a_free_base_with_branches_and_loads() {
    let without = "`air` in the potential energy";
    assert!(Craft::SKIPPED.iter().any(|line| line.starts_with(without)));
    let pi = std::f64::consts::PI;
    let mut links = [
        link(
            (4.0, principal(0.5, 0.7, 0.9)),
            None,
            [0.0; 3],
            [0.0; 3],
            Kind::Free,
        ),
        link(
            (0.6, principal(0.06, 0.05, 0.03)),
            Some(0),
            [0.1, 0.2, 0.4],
            [0.0, 0.1, -0.3],
            Kind::Weld,
        ),
        link(
            (0.2, principal(0.01, 0.012, 0.014)),
            Some(1),
            [0.1, 0.0, 0.4],
            [0.1, 0.05, 0.0],
            Kind::Revolute(Vector3::z()),
        ),
        link(
            (0.8, principal(0.02, 0.03, 0.04)),
            Some(0),
            [0.1, 0.5, 0.2],
            [0.05, -0.1, 0.3],
            Kind::Spherical,
        ),
        link(
            (0.3, principal(0.02, 0.02, 0.03)),
            Some(0),
            [0.0, -0.6, 0.1],
            [0.1, 0.2, 0.1],
            Kind::Revolute(Vector3::y()),
        ),
        link(
            (0.25, principal(0.015, 0.02, 0.01)),
            Some(4),
            [0.1, 0.2, 0.1],
            [0.0, 0.15, 0.05],
            Kind::Weld,
        ),
    ];
    links[1].turned = (unit(1.0, 2.0, 2.0), 0.7);
    links[2].turned = (Vector3::x(), pi / 2.0);
    let make = |numbers: &mut Random| {
        let (wind, couple) = (numbers.vector(), numbers.vector());
        (Craft::default(), CraftInput { wind, couple }, links)
    };
    agree!(Craft, make, [0.0, 0.0, -9.81], moving [base hinge ball root],
    held [1 stepped 2 hinge 3 ball 4 root 5 glued], still [1 5], |loads, _system, input| {
        let (wind, couple) = (input.wind, input.couple);
        for body in 0..6 {
            let velocity = loads.motions[body].velocity;
            loads.force(body, [0.0; 3], velocity * -0.05);
        }
        loads.force(0, [0.0; 3], (loads.motions[0].velocity - wind) * -0.4);
        loads.force(0, [0.1, 0.2, 0.4], loads.turned(0, [0.0, 0.0, 3.0]));
        loads.force(0, [0.1, 0.5, 0.2], Vector3::new(1.0, 2.0, -1.0));
        loads.moment(0, loads.motions[0].angular_velocity * -0.1);
        let head = [0.1, 0.0, 0.4];
        loads.force(1, head, (loads.velocity(1, head) - wind) * -0.7);
        loads.force(2, [0.1, 0.05, 0.0], loads.turned(2, [0.1, 0.2, 0.0]));
        loads.moment(2, loads.turned(2, [0.02, 0.0, -0.03]));
        let (right, end) = ([0.0, -0.6, 0.1], [0.0, 0.1, -0.2]);
        let stretch = (loads.point(0, right) - loads.point(3, end)).norm();
        loads.tension(12.0 * stretch, (0, right), (3, end));
        loads.pull(0.9, (2, [0.0; 3]), [1.0, 2.0, 3.0]);
        loads.pull(1.4, (5, [0.0; 3]), [-2.0, 0.0, 1.0]);
        loads.moment(2, couple);
        let coil = loads.turned(0, [0.2, 0.1, 0.0]);
        loads.moment(4, coil);
        loads.moment(0, -coil);
        let (ball, root) = (loads.rates[3].1.clone(), loads.rates[4].0[0]);
        loads.drives[3] = ball.iter().map(|w| -0.3 * w).collect();
        loads.drives[4] = vec![0.4 * root];
    });
}

// two free bodies, joined by loads alone, the bodies written after what they carry
rigid_system!(Pair {
    bodies: [
        finger {
            mass: 0.5[kg],
            inertia: principal(0.04, 0.05, 0.03)[kg * m ^ 2],
            points: [p = (0.1, 0.2, 0), tip = (0, -0.2, 0.1)],
        },
        left {
            mass: 2[kg],
            inertia: principal(0.3, 0.4, 0.35)[kg * m ^ 2],
            points: [p = (0.3, 0.1, 0.2)],
        },
        right {
            mass: 3[kg],
            inertia: principal(0.5, 0.4, 0.6)[kg * m ^ 2],
            points: [p = (0.1, 0.4, 0.2)],
            fields: [own = mass * world(0, 0, -2[m / s ^ 2])],
        },
    ],
    joints: [
        grip = universal(left.p, finger.p, body(1, 0, 0), body(0, 1, 0)),
        first = free(left),
        second = free(right),
    ],
    forces: [
        damper = (-2[N * s / m] * (finger.tip.velocity() - right.p.velocity()).norm())
            .between(finger.tip, right.p),
    ],
    moments: [
        twist = moment(0.3[N * m * s] * (left.angular_velocity - right.angular_velocity))
            .between(left, right)
    ],
    drives: [a = (-0.2[N * m] * grip.angle_1).on(grip.angle_1)],
    outputs: [energy, momentum, reactions],
});

#[test]
fn two_free_bodies() {
    let links = [
        link(
            (2.0, principal(0.3, 0.4, 0.35)),
            None,
            [0.0; 3],
            [0.0; 3],
            Kind::Free,
        ),
        link(
            (3.0, principal(0.5, 0.4, 0.6)),
            None,
            [0.0; 3],
            [0.0; 3],
            Kind::Free,
        ),
        link(
            (0.5, principal(0.04, 0.05, 0.03)),
            Some(0),
            [0.3, 0.1, 0.2],
            [0.1, 0.2, 0.0],
            Kind::Universal(Vector3::x(), Vector3::y()),
        ),
    ];
    let make = |_: &mut Random| (Pair::default(), (), links);
    agree!(Pair, make, [0.0; 3], moving [first second grip], held [2 grip], still [], |loads, _system, _input| {
        loads.force(1, [0.0; 3], Vector3::new(0.0, 0.0, -6.0));
        let (tip, p) = ([0.0, -0.2, 0.1], [0.1, 0.4, 0.2]);
        let speed = (loads.velocity(2, tip) - loads.velocity(1, p)).norm();
        loads.tension(-2.0 * speed, (2, tip), (1, p));
        let twist = (loads.motions[0].angular_velocity - loads.motions[1].angular_velocity) * 0.3;
        loads.moment(1, twist);
        loads.moment(0, -twist);
        loads.drives[2] = vec![-0.2 * loads.rates[2].0[0], 0.0];
    });
}
