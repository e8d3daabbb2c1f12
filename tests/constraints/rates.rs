//! The symbolic derivatives of constraints, compared with differences in time, for expressions of
//! every kind.
//!
//! In any state, consistent or not, the rate of a constraint of positions is its change as the
//! state moves with its velocities, and the accelerations that the reactions cause leave this rate
//! unchanged: `g' = h`, `h' = 0`. Central differences over 2e-5 s are accurate to 1e-10 of third
//! derivatives, and to 1e-11 because of rounding; both are of the order of 10.

use newton_euler::{nalgebra, prelude::*};
use proptest::prelude::*;

use crate::oracle::{planar, rotation, spatial, translation};

const STEP: f64 = 1e-5;

/// For states in which the constraints are nowhere near singular.
fn check<B>(body: &B, time: f64, state: &B::State, input: &B::Input)
where
    B: Constrained<Scalar = f64>,
{
    let rate = state.rate(&body.acceleration(time, state, input));
    let at = |step: f64| {
        let moved = body.input_after(input, step);
        let (time, state) = (time + step, state.moved(&(rate * step)));
        body.violations(time, &state, moved.as_ref().unwrap_or(input))
    };
    let (before, now, after) = (at(-STEP), at(0.0), at(STEP));
    let (before, now, after) = (before.as_ref(), now.as_ref(), after.as_ref());
    for ((before, now), after) in before.iter().zip(now).zip(after) {
        let name = now.name;
        if let (Some(a), Some(b)) = (before.position, after.position) {
            let change = (b - a) / (2.0 * STEP);
            let size = 1.0 + now.velocity.abs();
            assert!(
                (change - now.velocity).abs() < 1e-6 * size,
                "{name}: {change} for {}",
                now.velocity
            );
        }
        let change = (after.velocity - before.velocity) / (2.0 * STEP);
        let size = 1.0 + now.velocity.powi(2);
        assert!(change.abs() < 1e-5 * size, "{name}: {change}");
    }
}

mod bodies {
    newton_euler::rigid_body!(Roped {
        doc: "In space: a rope to a moving point, a slot in the body for a point of space, an attitude.",
        motion: spatial,
        params: [length = 2[m]],
        inputs: [lift[m].moving, aside = body(_, _, _)[m].moving],
        mass: 2[kg],
        inertia: tensor {
            xx: 1.3,
            yy: 1.7,
            zz: 2.1,
            xy: -0.12,
            yz: -0.05,
            zx: 0.07
        },
        points: [eye = (0.4, -0.2, 0.3)[m], nail = world(0.5, 0.2, -0.7)[m]],
        locals: [
            hook = world(0, 0, 9 + lift + 0.2[m] * (3[1 / s] * t).sin()),
            rope = eye.position() - hook,
        ],
        constraints: [
            taut = rope.norm() - length * (1 + 0.1 * (2[1 / s] * t).cos()),
            slot = (nail.position() - position - 0.1 * aside).in_body().y
                - 0.1 * (1 + aside.in_world().x),
            upright = attitude.i * attitude.j - 0.3 * attitude.w,
        ],
        reactions: [
            tension = (_ * rope.normalize()).at(eye),
            rail = body(0, _, 0),
            couple = moment(_ * world(0, 0, 1)),
        ],
    });

    newton_euler::rigid_body!(Dragged {
        doc: "In the plane: a choice, functions, velocities of points, a product of both kinds of axes.",
        motion: planar,
        mass: 1.5[kg],
        inertia: 0.4[kg * m ^ 2],
        points: [tip = (0.5, 0.3)[m], tail = (-0.4, 0.1)[m]],
        locals: [x = tip.position().in_world().x / 1[m]],
        constraints: [
            track = tip.position().in_world().y
                - 1[m]
                    * if x > 0 {
                        (x / 3).sinh()
                    } else {
                        (x / 3).tan().atan2(2)
                    },
            wheel = tail.velocity().in_body().y - 0.3 * t * tail.velocity().in_body().x,
        ],
        reactions: [at_tip = world(0, _).at(tip), at_tail = body(0, _).at(tail)],
        forces: [rubbed = world(-0.2 * at_tip.in_world().y, 0).at(tip)],
    });

    newton_euler::rigid_body!(Bead {
        doc: "Without turning: a curve in space, cut out by two surfaces.",
        motion: translation,
        mass: 0.3[kg],
        locals: [x = position.in_world().x, y = position.in_world().y],
        constraints: [
            bowl = position.in_world().z - (x.powi(2) + 0.5 * y.powi(2)).sqrt(),
            sheet = y - 1[m] * (0.1 * x).exp() * (t / 1[s]).cos(),
        ],
        reactions: [push = _ * world(0, 0, 1), side = world(0, _, 0)],
    });

    newton_euler::rigid_body!(Pointed {
        doc: "Attitude alone: an axis in a cone, and no spin.",
        motion: rotation,
        inertia: principal(1, 2, 2.5),
        locals: [axis = body(0, 0.6, 0.8)],
        constraints: [
            cone = axis.dot(world(1, 0, 0)) - 0.2 * t,
            spin = angular_velocity.dot(axis) - angular_velocity.in_world().y,
        ],
        reactions: [
            across = moment(_ * axis.cross(world(1, 0, 0))),
            along = moment(_ * (axis - world(0, 1, 0)))
        ],
    });
}

/// Of no interest are states near those in which the accelerations grow beyond bounds.
fn is_bounded(values: &[f64]) -> bool {
    values.iter().all(|value| value.abs() < 100.0)
}

proptest! {
    #[test]
    fn in_space(state in spatial(), time in -2.0..2.0, lift in prop::array::uniform3(-0.5..0.5), aside in prop::array::uniform9(-1.0..1.0)) {
        let [lift, lift_rate, lift_acceleration] = lift;
        let [aside, aside_rate, aside_acceleration] =
            [0, 3, 6].map(|i| nalgebra::Vector3::new(aside[i], aside[i + 1], aside[i + 2]));
        let (body, input) = (bodies::Roped::default(), bodies::RopedInput {
            lift,
            lift_rate,
            lift_acceleration,
            aside,
            aside_rate,
            aside_acceleration,
        });
        let acceleration = body.acceleration(time, &state, &input);
        prop_assume!(is_bounded(acceleration.linear.as_slice()) && is_bounded(acceleration.angular.as_slice()));
        check(&body, time, &state, &input);
    }

    #[test]
    fn in_the_plane(state in planar(), time in -2.0..2.0) {
        let body = bodies::Dragged::default();
        let state = Planar { position: state.position * 0.5, ..state };
        // the track bends where the tip crosses the plane of `y` and `z`
        let (sine, cosine) = state.angle.sin_cos();
        prop_assume!((state.position.x + 0.5 * cosine - 0.3 * sine).abs() > 0.01);
        let acceleration = body.acceleration(time, &state, &());
        prop_assume!(is_bounded(acceleration.linear.as_slice()) && is_bounded(&[acceleration.angular]));
        check(&body, time, &state, &());
    }

    #[test]
    fn without_turning(state in translation(), time in -2.0..2.0) {
        let body = bodies::Bead::default();
        prop_assume!(state.position.xy().norm() > 0.5);
        check(&body, time, &state, &());
    }

    #[test]
    fn of_attitude_alone(state in rotation(), time in -2.0..2.0) {
        let body = bodies::Pointed::default();
        prop_assume!(is_bounded(body.acceleration(time, &state, &()).as_slice()));
        check(&body, time, &state, &());
    }
}
