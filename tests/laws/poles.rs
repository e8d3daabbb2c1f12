//! The pole is a free choice in a description: it changes the moments, by the pole law, but never
//! the motion.

use nalgebra::Vector3;
use newton_euler::prelude::*;
use proptest::prelude::*;

use crate::oracle::{Sum, is, spatial, vectors};

/// One body written about many poles.
mod written {
    macro_rules! about {
        ($name:ident, $pole:expr) => {
            newton_euler::rigid_body!($name {
                motion: spatial,
                inputs: [push = body(_, _, _), twist = world(_, _, _)],
                mass: 2.5,
                inertia: tensor {
                    xx: 1.3,
                    yy: 1.7,
                    zz: 2.1,
                    xy: -0.12,
                    yz: -0.05,
                    zx: 0.07
                },
                points: [tip = (0.3, -0.2, 0.5), peg = world(3, -4, 5)],
                pole: $pole,
                forces: [
                    pushed = push.at(tip),
                    spring = 12 * (peg.position() - position)
                ],
                moments: [twisted = twist],
                fields: [weight = mass * world(0, 0, -9.80665)],
                outputs: [balance, momentum],
            });
        };
    }

    about!(Center, G);
    about!(OnBody, tip);
    about!(InSpace, peg);
    about!(AtOrigin, world(0, 0, 0));
}

newton_euler::rigid_body!(AtZero {
    motion: planar,
    mass: 2,
    inertia: 0.5,
    points: [center = body(0, 0), origin = world(0, 0)],
    forces: [
        at_center = world(1, 0).at(center),
        at_origin = world(0, 3).at(origin)
    ],
    outputs: [balance],
});

/// Zero components are those of G in body axes, and of the origin in world axes.
#[test]
fn zero_is_a_point_of_the_frame_it_is_written_in() {
    let state = Planar {
        position: [2.0, 5.0].into(),
        ..Planar::default()
    };
    let [at_center, at_origin] = AtZero::default().loads(0.0, &state, &());
    assert_eq!(at_center.point, state.position);
    assert_eq!(at_origin.point, nalgebra::Vector2::zeros());
    let acceleration = AtZero::default().acceleration(0.0, &state, &());
    assert!((acceleration.angular + 2.0 * 3.0 / 0.5).abs() < 1e-14);
}

/// Acceleration, residual of a given motion and of the true one, and angular momentum, about one pole.
macro_rules! about {
    ($body:ident, $input:ident, $state:expr, $given:expr, $push:expr, $twist:expr) => {{
        let (body, input) = (
            written::$body {},
            written::$input {
                push: $push,
                twist: $twist,
            },
        );
        let acceleration = body.acceleration(0.0, $state, &input);
        let residual = |a: &SpatialAcceleration| body.residual(0.0, $state, a, &(), &input);
        let momentum = body.angular_momentum_about_pole(0.0, $state);
        (
            acceleration,
            residual($given),
            residual(&acceleration),
            momentum,
        )
    }};
}

proptest! {
    #[test]
    fn poles_change_nothing_but_the_pole(
        state in spatial(),
        linear in vectors(9.0),
        angular in vectors(9.0),
        push in vectors(8.0),
        twist in vectors(8.0),
    ) {
        let given = SpatialAcceleration { linear, angular };
        let on_body = state.position + state.attitude * Vector3::new(0.3, -0.2, 0.5);
        let all = [
            (state.position, about!(Center, CenterInput, &state, &given, push, twist)),
            (on_body, about!(OnBody, OnBodyInput, &state, &given, push, twist)),
            (Vector3::new(3.0, -4.0, 5.0), about!(InSpace, InSpaceInput, &state, &given, push, twist)),
            (Vector3::zeros(), about!(AtOrigin, AtOriginInput, &state, &given, push, twist)),
        ];
        // Forces to 12 (|peg| + |x|) N at (|peg| + |x|) m; four terms make the resultant.
        let reach = 50.0_f64.sqrt() + state.position.norm();
        let size = 4.0 * 12.0 * reach * reach + 2.1 * state.angular_velocity.norm_squared();
        let (origin, (motion, residual, _, momentum)) = all[0];
        let carried = state.velocity * 2.5;
        for (pole, (acceleration, about, on_true_motion, l)) in all {
            prop_assert_eq!(acceleration, motion); // the pole is no part of the motion
            // M_O' = M_O + (O - O') × R, and so for L with P
            let expected = residual.moment + (origin - pole).cross(&residual.force);
            prop_assert_eq!(about.force, residual.force);
            is(&about.moment, &Sum { value: expected, largest: size })?;
            let expected = momentum + (origin - pole).cross(&carried);
            is(&l, &Sum { value: expected, largest: reach * carried.norm() + 6.0 })?;
            let balanced = Sum { value: Vector3::zeros(), largest: size };
            is(&on_true_motion.force, &balanced)?;
            is(&on_true_motion.moment, &balanced)?;
        }
    }
}
