//! Bodies with every kind of inertia, moving freely or rotating about G, compared with Euler's law
//! written by hand.

use nalgebra::{Matrix3, Vector3};
use newton_euler::prelude::*;
use proptest::prelude::*;

use crate::oracle::{Sum, is, is_scalar, rotation, spatial, vectors};

/// Bodies under a force at a point and a moment, in both sets of axes: in space with a baked inertia, and with G left out
/// and the inertia from parameters.
macro_rules! bodies {
    ($module:ident, $word:ident $baked:tt, $params:tt, $named:tt, $tensor:expr) => {
        mod $module {
            use super::*;

            mod described {
                newton_euler::rigid_body!(Free {
                    motion: spatial,
                    inputs: [
                        push = body(_, _, _),
                        pull = world(_, _, _),
                        turn = body(_, _, _),
                        twist = world(_, _, _),
                    ],
                    mass: 1.6,
                    inertia: $word $baked,
                    points: [tip = (0.4, -0.2, 0.1)],
                    forces: [pushed = push.at(tip), pulled = pull.at(tip)],
                    moments: [turned = turn, twisted = twist],
                    outputs: [energy, momentum, balance],
                });

                newton_euler::rigid_body!(Held {
                    motion: rotation,
                    params: $params,
                    inputs: [
                        push = body(_, _, _),
                        pull = world(_, _, _),
                        turn = body(_, _, _),
                        twist = world(_, _, _),
                    ],
                    inertia: $word $named,
                    points: [tip = (0.4, -0.2, 0.1)],
                    forces: [pushed = push.at(tip), pulled = pull.at(tip)],
                    moments: [turned = turn, twisted = twist],
                    outputs: [energy, momentum, balance],
                });
            }

            fn inertia() -> Matrix3<f64> {
                $tensor
            }

            proptest! {
                #[test]
                fn free(
                    state in spatial(),
                    push in vectors(8.0),
                    pull in vectors(8.0),
                    turn in vectors(8.0),
                    twist in vectors(8.0),
                ) {
                    let (q, v, w) = (state.attitude, state.velocity, state.angular_velocity);
                    let (force, moment) = applied(&q, [push, pull, turn, twist]);
                    let input = described::FreeInput { push, pull, turn, twist };
                    let body = described::Free {};
                    let computed = body.acceleration(0.0, &state, &input);
                    let linear = Sum { value: force.value / 1.6, largest: force.largest / 1.6 };
                    is(&computed.linear, &linear)?;
                    is(&computed.angular, &euler(&inertia(), &(q.inverse() * moment.value), moment.largest, &w))?;

                    let wrench = body.applied(0.0, &state, &input);
                    is(&wrench.force, &force)?;
                    is(&wrench.moment, &moment)?;
                    let residual = body.residual(0.0, &state, &computed, &(), &input);
                    is(&residual.force, &Sum { value: Vector3::zeros(), ..force })?;
                    let largest = moment.largest.max(inertia().norm() * w.norm_squared());
                    is(&residual.moment, &Sum { value: Vector3::zeros(), largest: 4.0 * largest })?;
                    let energy = 0.5 * (1.6 * v.norm_squared() + w.dot(&(inertia() * w)));
                    is_scalar(body.kinetic_energy(&state), energy, energy)?;
                }

                #[test]
                fn held(
                    state in rotation(),
                    push in vectors(8.0),
                    pull in vectors(8.0),
                    turn in vectors(8.0),
                    twist in vectors(8.0),
                    rate in vectors(9.0),
                ) {
                    let (q, w) = (state.attitude, state.angular_velocity);
                    let (_, moment) = applied(&q, [push, pull, turn, twist]);
                    let input = described::HeldInput { push, pull, turn, twist };
                    let body = described::Held::default();
                    let computed = body.acceleration(0.0, &state, &input);
                    is(&computed, &euler(&inertia(), &(q.inverse() * moment.value), moment.largest, &w))?;

                    is(&body.applied(0.0, &state, &input), &moment)?;
                    let j = inertia();
                    let residual = moment
                        .and(-(q * (j * rate)), j.norm() * rate.norm())
                        .and(-(q * w.cross(&(j * w))), j.norm() * w.norm_squared());
                    is(&body.residual(0.0, &state, &rate, &(), &input), &residual)?;
                    let spin = Sum::new().and(q * (j * w), j.norm() * w.norm());
                    is(&body.angular_momentum(&state), &spin)?;
                    let energy = 0.5 * w.dot(&(j * w));
                    is_scalar(body.kinetic_energy(&state), energy, energy)?;
                }
            }
        }
    };
}

/// Resultant and moment about G, world axes, of a push and a pull at (0.4, -0.2, 0.1) and two couples.
fn applied(
    q: &nalgebra::UnitQuaternion<f64>,
    [push, pull, turn, twist]: [Vector3<f64>; 4],
) -> (Sum<3>, Sum<3>) {
    let tip = Vector3::new(0.4, -0.2, 0.1);
    let arm = q * tip;
    let force = Sum::new().and(q * push, push.norm()).and(pull, pull.norm());
    let moment = Sum::new()
        .and(q * tip.cross(&push), tip.norm() * push.norm())
        .and(arm.cross(&pull), tip.norm() * pull.norm())
        .and(q * turn, turn.norm())
        .and(twist, twist.norm());
    (force, moment)
}

/// `ω̇ = J⁻¹ (K - ω × J ω)`, body axes.
fn euler(j: &Matrix3<f64>, k: &Vector3<f64>, largest: f64, w: &Vector3<f64>) -> Sum<3> {
    let inverse = j.try_inverse().unwrap();
    let gyroscopic = j.norm() * w.norm_squared();
    Sum {
        value: inverse * (k - w.cross(&(j * w))),
        largest: inverse.norm() * largest.max(gyroscopic),
    }
}

bodies!(
    full,
    tensor { xx: 1.3, yy: 1.7, zz: 2.1, xy: -0.12, yz: -0.05, zx: 0.07 },
    [a = 1.3, b = 1.7, c = 2.1, d = -0.12, e = -0.05, f = 0.07],
    { xx: a, yy: b, zz: c, xy: d, yz: e, zx: f },
    Matrix3::new(1.3, -0.12, 0.07, -0.12, 1.7, -0.05, 0.07, -0.05, 2.1)
);
bodies!(
    product_xy,
    products { xx: 1.3, yy: 1.7, zz: 2.1, xy: 0.12, yz: 0, zx: 0 },
    [a = 1.3, b = 1.7, c = 2.1, d = 0.12],
    { xx: a, yy: b, zz: c, xy: d, yz: 0, zx: 0 },
    Matrix3::new(1.3, -0.12, 0.0, -0.12, 1.7, 0.0, 0.0, 0.0, 2.1)
);
bodies!(
    product_yz,
    products { xx: 1.3, yy: 1.7, zz: 2.1, xy: 0, yz: 0.12, zx: 0 },
    [a = 1.3, b = 1.7, c = 2.1, d = 0.12],
    { xx: a, yy: b, zz: c, xy: 0, yz: d, zx: 0 },
    Matrix3::new(1.3, 0.0, 0.0, 0.0, 1.7, -0.12, 0.0, -0.12, 2.1)
);
bodies!(
    product_zx,
    tensor { xx: 1.3, yy: 1.7, zz: 2.1, xy: 0, yz: 0, zx: -0.12 },
    [a = 1.3, b = 1.7, c = 2.1, d = -0.12],
    { xx: a, yy: b, zz: c, xy: 0, yz: 0, zx: d },
    Matrix3::new(1.3, 0.0, -0.12, 0.0, 1.7, 0.0, -0.12, 0.0, 2.1)
);
bodies!(
    principal,
    principal(1.3, 1.7, 2.1),
    [a = 1.3, b = 1.7, c = 2.1],
    (a, b, c),
    Matrix3::from_diagonal(&Vector3::new(1.3, 1.7, 2.1))
);
bodies!(
    lamina,
    principal(1.25, 0.5, 0.75),
    [a = 1.25, b = 0.5, c = 0.75],
    (a, b, c),
    Matrix3::from_diagonal(&Vector3::new(1.25, 0.5, 0.75))
);
bodies!(
    symmetric_x,
    principal(0.9, 1.7, 1.7),
    [a = 0.9, b = 1.7],
    (a, b, b),
    Matrix3::from_diagonal(&Vector3::new(0.9, 1.7, 1.7))
);
bodies!(
    symmetric_y,
    principal(1.7, 0.9, 1.7),
    [a = 0.9, b = 1.7],
    (b, a, b),
    Matrix3::from_diagonal(&Vector3::new(1.7, 0.9, 1.7))
);
bodies!(
    symmetric_z,
    principal(1.7, 1.7, 0.9),
    [a = 0.9, b = 1.7],
    (b, b, a),
    Matrix3::from_diagonal(&Vector3::new(1.7, 1.7, 0.9))
);
bodies!(
    spherical,
    principal(1.7, 1.7, 1.7),
    [b = 1.7],
    (b, b, b),
    Matrix3::from_diagonal(&Vector3::new(1.7, 1.7, 1.7))
);
