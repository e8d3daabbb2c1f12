//! Massless links: the distances that they keep, and their tensions.

use nalgebra::{Unit, UnitQuaternion, Vector2, Vector3};
use newton_euler::prelude::*;

use super::compare::{Random, close};

// a truss of four nodes and five links, on a pin and a roller
rigid_system!(Truss {
    motion: planar,
    inputs: [load_x[N], load_y[N]],
    bodies: [
        roller {
            mass: 1[kg],
            inertia: 1[kg * m ^ 2]
        },
        left {
            mass: 2[kg],
            inertia: 1[kg * m ^ 2]
        },
        right {
            mass: 3[kg],
            inertia: 1[kg * m ^ 2],
            forces: [load = world(load_x, load_y)]
        },
    ],
    joints: [
        roll = prismatic(world(4, 0), roller.G, body(1, 0)),
        first = translation(left),
        second = translation(right),
        bottom = link(world(0, 0), roller.G, 4[m]),
        post = link(world(0, 0), left.G, 3[m]),
        top = link(left.G, right.G, 4[m]),
        side = link(roller.G, right.G, 3[m]),
        diagonal = link(world(0, 0), right.G, 5[m]),
    ],
    outputs: [reactions],
});

#[test]
fn a_truss_of_links() {
    let truss = Truss::default();
    let mut state = TrussState {
        first: PlanarTranslation {
            position: [0.1, 2.9].into(),
            ..PlanarTranslation::default()
        },
        second: PlanarTranslation {
            position: [4.1, 3.05].into(),
            ..PlanarTranslation::default()
        },
        ..TrussState::default()
    };
    truss
        .project(0.0, &mut state, &TrussInput::default())
        .unwrap();
    close(
        "left",
        state.first.position.as_slice(),
        &[0.0, 3.0],
        4.0,
        1e-15,
    );
    close(
        "right",
        state.second.position.as_slice(),
        &[4.0, 3.0],
        4.0,
        1e-15,
    );
    let mut numbers = Random::new(8);
    for _ in 0..10 {
        let [x, y] = [0; 2].map(|_| 100.0 * numbers.number());
        let found = truss.reactions(
            0.0,
            &state,
            &TrussInput {
                load_x: x,
                load_y: y,
            },
        );
        // node by node: nothing pulls on the left one
        let diagonal = x / 0.8;
        let side = y - 0.6 * diagonal;
        let tensions = [
            found.bottom,
            found.post,
            found.top,
            found.side,
            found.diagonal,
        ];
        close(
            "tensions",
            &tensions,
            &[0.0, 0.0, 0.0, side, diagonal],
            100.0,
            1e-13,
        );
        close(
            "roller",
            found.roll.force.as_slice(),
            &[0.0, -side],
            100.0,
            1e-13,
        );
    }
}

// a point mass on a link is a simple pendulum
rigid_system!(Bob {
    motion: planar,
    bodies: [bob {
        mass: 1.5[kg],
        inertia: 1[kg * m ^ 2]
    }],
    joints: [
        flight = translation(bob),
        rod = link(world(0, 1), bob.G, 0.8[m])
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    outputs: [reactions, energy],
});

#[test]
fn a_pendulum_on_a_link() {
    let bob = Bob::default();
    let (angle, rate) = (0.7_f64, 2.5_f64);
    let (along, across) = (
        Vector2::new(angle.sin(), -angle.cos()),
        Vector2::new(angle.cos(), angle.sin()),
    );
    let start = BobState {
        flight: PlanarTranslation {
            position: Vector2::new(0.0, 1.0) + 0.8 * along,
            velocity: 0.8 * rate * across,
        },
    };
    bob.check(0.0, &start, &()).unwrap();
    let tension = 1.5 * (0.8 * rate * rate + 9.81 * angle.cos());
    close(
        "tension",
        &[bob.reactions(0.0, &start, &()).rod],
        &[tension],
        10.0,
        1e-14,
    );
    let found = bob.acceleration(0.0, &start, &()).flight;
    let expected = -9.81 * angle.sin() * across - 0.8 * rate * rate * along;
    close(
        "acceleration",
        found.as_slice(),
        expected.as_slice(),
        10.0,
        1e-14,
    );
    let whole =
        |state: &BobState| bob.kinetic_energy(state) + bob.potential_energy(0.0, state, &());
    let end = bob.integrate(&start).to(10.0).unwrap();
    close("energy", &[whole(&end)], &[whole(&start)], 10.0, 1e-7);
    close(
        "length",
        &[(end.flight.position - Vector2::new(0.0, 1.0)).norm()],
        &[0.8],
        1.0,
        1e-15,
    );
}

// two bodies in space with a link between them, whose length changes as it is told
rigid_system!(Dumbbell {
    params: [length = 1.3[m]],
    bodies: [
        first {
            mass: 2[kg],
            inertia: principal(0.3, 0.4, 0.5)[kg * m ^ 2],
            points: [p = (0.2, -0.3, 0.1)[m]],
            forces: [push = body(1[N], 2[N], -1[N])],
        },
        second {
            mass: 0.7[kg],
            inertia: principal(0.1, 0.07, 0.05)[kg * m ^ 2],
            points: [q = (-0.1, 0.05, 0.2)[m]],
            moments: [turn = world(0.3, 0, 0.1)[N * m]],
        },
    ],
    joints: [
        one = free(first),
        other = free(second),
        rod = link(first.p, second.q, length + 0.1[m] * (3[rad / s] * t).sin()),
    ],
    outputs: [reactions],
});

/// Place and velocity of a point of a body, and its acceleration without that of its body.
fn point(state: &Spatial, offset: Vector3<f64>) -> (Vector3<f64>, Vector3<f64>) {
    let arm = state.attitude * offset;
    let w = state.attitude * state.angular_velocity;
    (state.position + arm, state.velocity + w.cross(&arm))
}

/// The acceleration of such a point.
fn accelerated(state: &Spatial, found: &SpatialAcceleration, offset: Vector3<f64>) -> Vector3<f64> {
    let arm = state.attitude * offset;
    let w = state.attitude * state.angular_velocity;
    let turned = state.attitude * found.angular;
    found.linear + turned.cross(&arm) + w.cross(&w.cross(&arm))
}

#[test]
fn two_bodies_and_the_laws_of_newton_and_euler() {
    let (dumbbell, mut numbers) = (Dumbbell::default(), Random::new(31));
    let mut spatial = || Spatial {
        position: numbers.vector(),
        attitude: UnitQuaternion::new(numbers.vector()),
        velocity: numbers.vector(),
        angular_velocity: numbers.vector(),
    };
    for step in 0..20 {
        let time = 0.1 * f64::from(step);
        let mut state = DumbbellState {
            one: spatial(),
            other: spatial(),
        };
        state.other.position += Vector3::new(0.0, 0.0, 2.0);
        dumbbell.project(time, &mut state, &()).unwrap();
        let (p, q) = (Vector3::new(0.2, -0.3, 0.1), Vector3::new(-0.1, 0.05, 0.2));
        let ((start, start_rate), (end, end_rate)) = (point(&state.one, p), point(&state.other, q));
        let (sine, cosine) = (3.0 * time).sin_cos();
        let [length, rate, second] = [1.3 + 0.1 * sine, 0.3 * cosine, -0.9 * sine];
        let (line, moving) = (end - start, end_rate - start_rate);
        close(
            "length",
            &[line.norm(), line.dot(&moving) / length],
            &[length, rate],
            1.0,
            1e-14,
        );
        let found = dumbbell.acceleration(time, &state, &());
        let apart =
            accelerated(&state.other, &found.other, q) - accelerated(&state.one, &found.one, p);
        // half of the second derivative of the square of the distance
        let bent = moving.norm_squared() + line.dot(&apart);
        close(
            "bent",
            &[bent],
            &[rate * rate + length * second],
            1.0,
            1e-12,
        );
        let pull =
            dumbbell.reactions(time, &state, &()).rod * Unit::new_normalize(line).into_inner();
        let (one, other) = (&state.one, &state.other);
        let forces = [
            2.0 * found.one.linear - one.attitude * Vector3::new(1.0, 2.0, -1.0),
            -0.7 * found.other.linear,
        ];
        for force in forces {
            close("force", force.as_slice(), pull.as_slice(), 3.0, 1e-12);
        }
        let spin = |inertia: Vector3<f64>, state: &Spatial, found: &SpatialAcceleration| {
            let (w, turned) = (state.angular_velocity, found.angular);
            inertia.component_mul(&turned) + w.cross(&inertia.component_mul(&w))
        };
        let on_one = p.cross(&(one.attitude.inverse() * pull));
        let found_one = spin(Vector3::new(0.3, 0.4, 0.5), one, &found.one);
        close(
            "moment",
            found_one.as_slice(),
            on_one.as_slice(),
            1.0,
            1e-12,
        );
        let turn = other.attitude.inverse() * Vector3::new(0.3, 0.0, 0.1);
        let on_other = turn - q.cross(&(other.attitude.inverse() * pull));
        let found_other = spin(Vector3::new(0.1, 0.07, 0.05), other, &found.other);
        close(
            "moment",
            found_other.as_slice(),
            on_other.as_slice(),
            1.0,
            1e-12,
        );
    }
}

// beside the same with a rod that has next to no mass, and in all of its states the same motion
rigid_system!(Linked {
    motion: planar,
    bodies: [
        crank {
            mass: 1[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [a = (0.3, 0)[m]]
        },
        rocker {
            mass: 2[kg],
            inertia: 0.3[kg * m ^ 2],
            points: [b = (0, 0.7)[m]]
        },
    ],
    joints: [
        o = revolute(world(0, 0), crank.G),
        c = revolute(world(1, 0), rocker.G),
        coupler = link(crank.a, rocker.b, 0.9[m]),
    ],
    moments: [drive = moment(2[N * m]).on(crank)],
    outputs: [reactions],
});
rigid_system!(Jointed {
    motion: planar,
    bodies: [
        crank {
            mass: 1[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [a = (0.3, 0)[m]]
        },
        rocker {
            mass: 2[kg],
            inertia: 0.3[kg * m ^ 2],
            points: [b = (0, 0.7)[m]]
        },
        coupler {
            mass: 1e-8[kg],
            inertia: 1e-9[kg * m ^ 2],
            points: [a = (-0.45, 0)[m], b = (0.45, 0)[m]]
        },
    ],
    joints: [
        o = revolute(world(0, 0), crank.G),
        c = revolute(world(1, 0), rocker.G),
        a = revolute(crank.a, coupler.a),
        b = revolute(rocker.b, coupler.b),
    ],
    moments: [drive = moment(2[N * m]).on(crank)],
    outputs: [reactions],
});

#[test]
fn a_rod_of_no_mass_is_a_link() {
    let (linked, jointed) = (Linked::default(), Jointed::default());
    for step in 0..8 {
        let angle = 0.7 * f64::from(step);
        let hinge = |angle: f64, angular_velocity: f64| Hinge {
            angle,
            angular_velocity,
        };
        let mut state = LinkedState {
            o: hinge(angle, 3.0),
            c: hinge(-0.2, 0.0),
        };
        linked.project(0.0, &mut state, &()).unwrap();
        let a = Vector2::new(state.o.angle.cos(), state.o.angle.sin()) * 0.3;
        let b = Vector2::new(1.0 - 0.7 * state.c.angle.sin(), 0.7 * state.c.angle.cos());
        let turned = (b - a).y.atan2((b - a).x);
        let mut whole = JointedState {
            o: state.o,
            c: state.c,
            a: hinge(turned - state.o.angle, 0.0),
        };
        jointed.project(0.0, &mut whole, &()).unwrap();
        // both loops are closed by the same motion of the crank
        let scale = state.o.angular_velocity / whole.o.angular_velocity;
        for hinge in [&mut whole.o, &mut whole.c, &mut whole.a] {
            hinge.angular_velocity *= scale;
        }
        let rates = [state.c.angle, state.c.angular_velocity];
        close(
            "pose",
            &rates,
            &[whole.c.angle, whole.c.angular_velocity],
            3.0,
            1e-12,
        );
        let (one, other) = (
            linked.acceleration(0.0, &state, &()),
            jointed.acceleration(0.0, &whole, &()),
        );
        close("motion", &[one.o, one.c], &[other.o, other.c], 30.0, 3e-8);
        let pull = linked.reactions(0.0, &state, &()).coupler * (b - a).normalize();
        let loads = jointed.reactions(0.0, &whole, &());
        close(
            "tension",
            pull.as_slice(),
            (-loads.a.force).as_slice(),
            30.0,
            3e-8,
        );
    }
}
