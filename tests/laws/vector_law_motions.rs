//! Bodies in the plane, and bodies that do not rotate, compared with the vector law written by hand
//! with nalgebra.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

use nalgebra::{Rotation2, SVector, Vector2, Vector3};
use newton_euler::prelude::*;
use proptest::prelude::*;

use crate::oracle::{
    Sum, is, is_scalar, planar, planar_translation, plane_vectors, translation, vectors,
};

/// In the plane, with numbers baked in and as parameters.
mod plate {
    macro_rules! plate {
        ($name:ident, $params:tt, $m:tt, $j:tt, [$px:tt, $py:tt], $drag:tt, $stiffness:tt) => {
            newton_euler::rigid_body!($name {
                motion: planar,
                params: $params,
                inputs: [
                    push = body(_, _)[N],
                    pull = world(_, _)[N],
                    wind = world(_, _)[m / s],
                    turn
                ],
                mass: $m,
                inertia: $j,
                points: [
                    tip = ($px, $py),
                    tail = (-0.6, 0.1),
                    mast = world(2, -1),
                    wall = world(-1, 0.5)
                ],
                pole: wall,
                locals: [air = tail.velocity() - wind],
                reactions: [held = pull.at(wall), clamped = moment(0.5 * turn)],
                joint_forces: [linked = (2 * push).at(wall)],
                joint_moments: [hinged = tip.position().cross(world(0.5, -0.25))],
                forces: [
                    pushed = push.at(tip),
                    pulled = pull.at(tail),
                    drag = (-$drag * air.norm() * air).at(tail),
                    spring = ($stiffness * (mast.position() - tip.position())).at(tip),
                    carried = (0.5 * angular_velocity.cross(body(0.25, 1))).at(tip),
                ],
                moments: [
                    turned = if attitude < 0 || turn > 3 {
                        turn
                    } else {
                        -2 * turn
                    },
                    damped = -0.3 * angular_velocity,
                    beaten = 1[N * m] * (3 * t).sin() * angular_velocity.signum(),
                ],
                fields: [
                    weight = mass * world(0, -9.80665),
                    lifted = world(0.5, 2).at(tip)
                ],
                outputs: [energy, momentum, balance],
            });
        };
    }

    plate!(Baked, [], 2.5, 1.3, [0.4, (-0.2)], 0.8, 12.5);
    plate!(
        Parametric,
        [m = 2.5, j = 1.3, px = 0.4, py = -0.2, c = 0.8, k = 12.5],
        m,
        j,
        [px, py],
        c,
        k
    );
}

const MASS: f64 = 2.5;
const INERTIA: f64 = 1.3;

#[derive(Clone, Debug)]
struct Given {
    time: f64,
    state: Planar,
    push: Vector2<f64>,
    pull: Vector2<f64>,
    wind: Vector2<f64>,
    turn: f64,
}

fn given() -> impl Strategy<Value = Given> {
    let v = || plane_vectors(8.0);
    (0.0..9.0, planar(), v(), v(), v(), -8.0..8.0).prop_map(
        |(time, state, push, pull, wind, turn)| Given {
            time,
            state,
            push,
            pull,
            wind,
            turn,
        },
    )
}

/// Resultant and moment about G.
fn loads(given: &Given) -> (Sum<2>, Sum<1>) {
    let Planar {
        position: g,
        angle,
        velocity: v,
        angular_velocity: w,
    } = given.state;
    let turn = Rotation2::new(angle);
    let [tip, tail] = [[0.4, -0.2], [-0.6, 0.1]].map(Vector2::from);
    let [mast, wall] = [[2.0, -1.0], [-1.0, 0.5]].map(Vector2::from);
    let [at_tip, at_tail] = [tip, tail].map(|r| (turn * r, r.norm()));
    let at_wall = (wall - g, wall.norm() + g.norm());
    let across = |r: Vector2<f64>| Vector2::new(-r.y, r.x) * w;
    let air = v + across(at_tail.0) - given.wind;
    let airspeed = v.norm() + w.abs() * tail.norm() + given.wind.norm();
    let stretch = mast - g - at_tip.0;
    let stretch_size = mast.norm() + g.norm() + tip.norm();
    let [push, pull] = [turn * given.push, given.pull];
    let forces = [
        (pull, pull.norm(), at_wall),
        (2.0 * push, 2.0 * push.norm(), at_wall),
        (push, push.norm(), at_tip),
        (pull, pull.norm(), at_tail),
        (air * -0.8 * air.norm(), 0.8 * airspeed.powi(2), at_tail),
        (stretch * 12.5, 12.5 * stretch_size, at_tip),
        (
            across(turn * Vector2::new(0.25, 1.0)) * 0.5,
            w.abs(),
            at_tip,
        ),
        (
            Vector2::new(0.0, -MASS * 9.80665),
            MASS * 9.80665,
            (Vector2::zeros(), 0.0),
        ),
        (Vector2::new(0.5, 2.0), 2.5, at_tip),
    ];
    let turned = if angle < 0.0 || given.turn > 3.0 {
        given.turn
    } else {
        -2.0 * given.turn
    };
    let hinged = (g + at_tip.0).perp(&Vector2::new(0.5, -0.25));
    let couples = [
        (0.5 * given.turn, given.turn.abs()),
        (hinged, g.norm() + tip.norm()),
        (turned, 2.0 * given.turn.abs()),
        (-0.3 * w, w.abs()),
        ((3.0 * given.time).sin() * w.signum(), 1.0),
    ];
    let (mut force, mut moment) = (Sum::new(), Sum::new());
    for (f, size, (arm, length)) in forces {
        force = force.and(f, size);
        moment = moment.and(SVector::from([arm.perp(&f)]), length * size);
    }
    for (k, size) in couples {
        moment = moment.and(SVector::from([k]), size);
    }
    (force, moment)
}

fn over<const N: usize>(sum: &Sum<N>, divisor: f64) -> Sum<N> {
    Sum {
        value: sum.value / divisor,
        largest: sum.largest / divisor,
    }
}

macro_rules! in_the_plane {
    ($test:ident, $body:expr, $input:ident) => {
        proptest! {
            #[test]
            fn $test(
                given in given(),
                linear in plane_vectors(9.0),
                angular in -9.0..9.0_f64,
            ) {
                let (body, time, state) = ($body, given.time, given.state);
                let Given { push, pull, wind, turn, .. } = given;
                let input = plate::$input { push, pull, wind, turn };
                let (force, moment) = loads(&given);
                let computed = body.acceleration(time, &state, &input);
                is(&computed.linear, &over(&force, MASS))?;
                is(&SVector::from([computed.angular]), &over(&moment, INERTIA))?;

                let wrench = body.applied(time, &state, &input);
                is(&wrench.force, &force)?;
                is(&SVector::from([wrench.moment]), &moment)?;

                let force = force.and(linear * -MASS, MASS * linear.norm());
                let moment = moment.and(SVector::from([-INERTIA * angular]), INERTIA * angular.abs());
                let from_pole = state.position - Vector2::new(-1.0, 0.5);
                let transport = SVector::from([from_pole.perp(&force.value)]);
                // The resultant is a sum of ten terms.
                let moment = moment.and(transport, from_pole.norm() * 10.0 * force.largest);
                let acceleration = PlanarAcceleration { linear, angular };
                let residual = body.residual(time, &state, &acceleration, &(), &input);
                is(&residual.force, &force)?;
                is(&SVector::from([residual.moment]), &moment)?;

                // Loads add up to what is applied.
                let listed = body.loads(time, &state, &input);
                prop_assert_eq!(listed.len(), 14);
                let sum = listed.iter().fold(Vector2::zeros(), |sum, load| sum + load.force);
                is(&sum, &loads(&given).0)?;
                let about_g = |load: &PlanarLoad| {
                    (load.point - state.position).perp(&load.force) + load.moment
                };
                let largest = (state.position.norm() + 3.0) * loads(&given).0.largest;
                let sum = listed.iter().map(about_g).sum::<f64>();
                is_scalar(sum, wrench.moment, largest.max(loads(&given).1.largest))?;

                let (v, w) = (state.velocity, state.angular_velocity);
                is(&body.linear_momentum(&state), &Sum::new().and(v * MASS, MASS * v.norm()))?;
                is_scalar(body.angular_momentum(&state), INERTIA * w, INERTIA * w.abs())?;
                let carried = MASS * from_pole.perp(&v);
                let largest = (MASS * from_pole.norm() * v.norm()).max(INERTIA * w.abs());
                let about_pole = body.angular_momentum_about_pole(time, &state);
                is_scalar(about_pole, INERTIA * w + carried, largest)?;
                let kinetic = 0.5 * (MASS * v.norm_squared() + INERTIA * w * w);
                is_scalar(body.kinetic_energy(&state), kinetic, kinetic)?;
                let tip = state.position + Rotation2::new(state.angle) * Vector2::new(0.4, -0.2);
                let potential = MASS * 9.80665 * state.position.y - tip.dot(&Vector2::new(0.5, 2.0));
                let largest = MASS * 9.80665 * state.position.norm() + 2.1;
                is_scalar(body.potential_energy(time, &state, &input), potential, largest)?;
            }
        }
    };
}

in_the_plane!(planar_baked, plate::Baked {}, BakedInput);
in_the_plane!(
    planar_with_parameters,
    plate::Parametric::default(),
    ParametricInput
);

/// Bodies that do not turn: axes of the body along those of space.
mod sliding {
    newton_euler::rigid_body!(Puck {
        motion: planar_translation,
        params: [c = 0.8, k = 12.5],
        inputs: [push = body(_, _), wind = world(_, _)],
        mass: 2.5,
        points: [mast = world(2, -1)],
        locals: [air = velocity - wind],
        forces: [
            pushed = push,
            drag = -c * air.norm() * air,
            spring = k * (mast.position() - position),
        ],
        fields: [weight = mass * world(0, -9.80665)],
        outputs: [energy, momentum, balance],
    });

    newton_euler::rigid_body!(Ball {
        motion: translation,
        params: [c = 0.8, k = 12.5],
        inputs: [push = body(_, _, _), wind = world(_, _, _)],
        mass: 2.5,
        points: [mast = world(2, -1, 3), high = (0, 0, 0.5)],
        pole: mast,
        locals: [air = high.velocity() - wind],
        forces: [
            pushed = push.at(high),
            drag = -c * air.norm() * air,
            spring = k * (mast.position() - position),
        ],
        reactions: [guide = moment(-body(0, 0, 0.5).cross(push))],
        fields: [weight = mass * world(0, 0, -9.80665)],
        outputs: [energy, momentum, balance],
    });
}

/// Push, drag, spring and weight.
fn sum_of<const N: usize>([g, v, push, wind, mast, down]: [SVector<f64, N>; 6]) -> Sum<N> {
    let air = v - wind;
    let weight = down * (MASS * 9.80665);
    Sum::new()
        .and(push, push.norm())
        .and(
            air * -0.8 * air.norm(),
            0.8 * (v.norm() + wind.norm()).powi(2),
        )
        .and((mast - g) * 12.5, 12.5 * (mast.norm() + g.norm()))
        .and(weight, weight.norm())
}

proptest! {
    #[test]
    fn planar_translation_of_a_puck(
        state in planar_translation(),
        push in plane_vectors(8.0),
        wind in plane_vectors(8.0),
        a in plane_vectors(9.0),
    ) {
        let PlanarTranslation { position: g, velocity: v } = state;
        let force = sum_of([g, v, push, wind, Vector2::new(2.0, -1.0), -Vector2::y()]);
        let input = sliding::PuckInput { push, wind };
        let body = sliding::Puck::default();
        is(&body.acceleration(0.0, &state, &input), &over(&force, MASS))?;
        is(&body.applied(0.0, &state, &input).force, &force)?;
        prop_assert_eq!(body.applied(0.0, &state, &input).moment, 0.0);
        let residual = body.residual(0.0, &state, &a, &(), &input);
        is(&residual.force, &force.and(a * -MASS, MASS * a.norm()))?;
        is(&body.linear_momentum(&state), &Sum::new().and(v * MASS, MASS * v.norm()))?;
        let energy = 0.5 * MASS * v.norm_squared();
        is_scalar(body.kinetic_energy(&state), energy, energy)?;
        let height = MASS * 9.80665 * g.y;
        is_scalar(body.potential_energy(0.0, &state, &input), height, height.abs())?;
    }

    #[test]
    fn translation_of_a_ball(
        state in translation(),
        push in vectors(8.0),
        wind in vectors(8.0),
        a in vectors(9.0),
    ) {
        let Translation { position: g, velocity: v } = state;
        let mast = Vector3::new(2.0, -1.0, 3.0);
        let force = sum_of([g, v, push, wind, mast, -Vector3::z()]);
        let input = sliding::BallInput { push, wind };
        let body = sliding::Ball::default();
        is(&body.acceleration(0.0, &state, &input), &over(&force, MASS))?;
        is(&body.applied(0.0, &state, &input).force, &force)?;
        // The guide holds what the push would turn.
        let largest = 0.5 * push.norm();
        let balanced = Sum { value: Vector3::zeros(), largest };
        is(&body.applied(0.0, &state, &input).moment, &balanced)?;
        let force = force.and(a * -MASS, MASS * a.norm());
        let residual = body.residual(0.0, &state, &a, &(), &input);
        is(&residual.force, &force)?;
        let arm = g - mast;
        let largest = largest.max(5.0 * arm.norm() * force.largest); // five terms
        is(&residual.moment, &Sum { value: arm.cross(&force.value), largest })?;
        let carried = Sum::new().and(arm.cross(&(v * MASS)), MASS * arm.norm() * v.norm());
        is(&body.angular_momentum_about_pole(0.0, &state), &carried)?;
        prop_assert_eq!(body.angular_momentum(&state), Vector3::zeros());
        let listed = body.loads(0.0, &state, &input);
        let guide = listed.iter().find(|load| load.name == "guide").unwrap();
        let holds = Vector3::new(0.0, 0.0, -0.5).cross(&push);
        is(&guide.moment, &Sum::new().and(holds, 0.5 * push.norm()))?;
    }
}
