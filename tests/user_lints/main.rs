//! Generated code under a user's strictest lints: it is documented, safe, and clean of pedantic
//! warnings.
#![deny(
    warnings,
    missing_docs,
    clippy::pedantic,
    clippy::all,
    rust_2018_idioms,
    unused
)]
#![deny(
    missing_debug_implementations,
    missing_copy_implementations,
    unreachable_pub
)]
#![deny(
    unused_qualifications,
    unused_results,
    let_underscore_drop,
    non_ascii_idents
)]
#![deny(
    single_use_lifetimes,
    trivial_casts,
    trivial_numeric_casts,
    variant_size_differences
)]
#![forbid(unsafe_code)]

#[no_implicit_prelude]
pub mod paths;
#[no_implicit_prelude]
pub mod scalars;
#[no_implicit_prelude]
pub mod systems;

/// In a private module, what is public is not reachable: a description has no word for that.
mod private {
    ::newton_euler::rigid_body!(Stone {
        motion: translation,
        mass: 1[kg]
    });
    ::newton_euler::rigid_body!(Cart::<T> {
        motion: planar,
        params: [m = 2[kg]],
        mass: m,
        inertia: m * 1[m ^ 2]
    });
    ::newton_euler::rigid_system!(Door {
        motion: planar,
        params: [width = 0.8[m]],
        inputs: [push[N * m]],
        bodies: [leaf {
            mass: 20[kg],
            inertia: 20[kg] * width.powi(2) / 12,
            points: [pin = (-width / 2, 0)]
        }],
        joints: [hinge = revolute(world(0, 0), leaf.pin)],
        drives: [hand = push.on(hinge)],
        outputs: [energy, reactions, linearization],
    });
}

/// A body of each motion with all outputs, in modules without imports and without the prelude.
#[no_implicit_prelude]
pub mod motions {
    /// In space.
    pub mod spatial {
        ::newton_euler::rigid_body!(Craft {
            doc: "A craft.",
            motion: spatial,
            params: [m = 2.5[kg], xy = -0.12, tip = body(0.4, -0.2, 0.1)[m], k],
            inputs: [throttle, wind = world(_, _, _)[m / s]],
            mass: m,
            inertia: tensor {
                xx: 1.3,
                yy: 1.7,
                zz: 2.1,
                xy: xy,
                yz: -0.05,
                zx: 0.07
            },
            points: [nozzle = tip, mast = world(100000, -1, 1e-9)],
            locals: [air = nozzle.velocity() - wind],
            forces: [
                jet = body(
                    0,
                    0,
                    if throttle < 0.5 && t > 1 {
                        throttle
                    } else {
                        1 - throttle
                    }
                )
                .at(nozzle),
                drag = (-0.8 * air.norm() * air).at(nozzle),
                spring = k * (mast.position() - position),
            ],
            fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
            pole: nozzle,
            outputs: [
                linearization,
                sensitivity,
                regressor,
                energy,
                momentum,
                balance
            ],
        });
    }

    /// In space, without parameters, inputs or loads.
    pub mod free {
        ::newton_euler::rigid_body!(Stone {
            motion: spatial,
            mass: 123456789[g],
            inertia: principal(1, 2, 3),
            outputs: [linearization, energy, momentum, balance],
        });
    }

    /// Short and similar names, comparisons and negations.
    pub mod words {
        ::newton_euler::rigid_body!(Letters {
            motion: spatial,
            params: [
                a = 1,
                b = 2,
                c = 3,
                d = 4,
                item = 5,
                items = 6,
                e_x = 1e-300,
                f = 0.1
            ],
            inputs: [thrust_1, thrust_2, thrust_3, thrust_4],
            mass: 1.2,
            inertia: tensor {
                xx: 3,
                yy: 4,
                zz: 5,
                xy: 0.1,
                yz: 0.2,
                zx: 0.3
            },
            locals: [
                g = a * thrust_1 + b * thrust_2,
                h = c * thrust_3 - d * thrust_4,
                k = if !(g < h) { item * g } else { items * h },
                l = if g == h || g != 2 {
                    k.sin()
                } else {
                    k.powf(2.5)
                },
                m = if !(g < 1) && h >= 2 {
                    k.max(l).min(3).clamp(1, 2)
                } else {
                    0
                },
            ],
            forces: [
                p = body(g, h, k).at((0.1, 0.2, 0.3)),
                q = c * world(l, 1 / (2 + g * g), m),
                r = if a < g { body(1, 2, 3) } else { world(0, 0, 1) },
                range = body(if 1 <= g && g < 2 { g } else { h }, 0, 0),
            ],
            moments: [
                n = body(e_x, f, -t * d),
                o = angular_velocity * 1.0000000000000002
            ],
            outputs: [linearization, energy, momentum, balance],
        });
    }

    /// The names of the first example.
    pub mod quadrotor {
        ::newton_euler::rigid_body!(Quadrotor {
            motion: spatial,
            params: [arm_front = 0.17[m], arm_back = 0.17[m], arm_left = 0.17[m]],
            inputs: [thrust_1[N], thrust_2[N], thrust_3[N], thrust_4[N]],
            mass: 1.2[kg],
            inertia: principal(0.0123, 0.0123, 0.0224)[kg * m ^ 2],
            forces: [
                lift_1 = body(0, 0, thrust_1).at((arm_front, 0, 0)),
                lift_2 = body(0, 0, thrust_2).at((0, arm_left, 0)),
                lift_3 = body(0, 0, thrust_3 + thrust_4).at((-arm_back, 0, 0)),
            ],
            outputs: [linearization, energy, momentum, balance],
        });
    }

    /// About G.
    pub mod rotation {
        ::newton_euler::rigid_body!(Gyroscope {
            motion: rotation,
            params: [polar = 0.02],
            inputs: [twist = body(_, _, _)[N * m]],
            inertia: principal(0.015, 0.015, polar),
            moments: [motor = twist, damped = -1e-3 * angular_velocity],
            outputs: [
                linearization,
                sensitivity,
                regressor,
                energy,
                momentum,
                balance
            ],
        });
    }

    /// Without turning.
    pub mod translation {
        ::newton_euler::rigid_body!(Ball {
            motion: translation,
            inputs: [wind = world(_, _, _)[m / s]],
            mass: 0.43[kg],
            forces: [drag = -0.3 * (velocity - wind).norm() * (velocity - wind)],
            fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
            outputs: [linearization, energy, momentum, balance],
        });
    }

    /// In the plane.
    pub mod planar {
        ::newton_euler::rigid_body!(Plate {
            motion: planar,
            params: [J = 0.3, tip = (0.5, 0.1)],
            inputs: [push = body(_, _)[N], turn[N * m]],
            mass: 1.5[kg],
            inertia: J,
            forces: [pushed = push.at(tip)],
            moments: [turned = turn],
            fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
            pole: tip,
            outputs: [linearization, energy, momentum, balance],
        });
    }

    /// Numbers near constants that std has names for.
    pub mod constants {
        ::newton_euler::rigid_body!(Wave {
            motion: planar_translation,
            params: [height = 3.14159, depth = 2.718],
            mass: 1,
            locals: [half_turn = PI + 2 * t],
            forces: [pushed = world(half_turn, 0.7071 * t + height / depth)],
            outputs: [linearization, energy],
        });
    }

    /// On a pin, with a force named as in textbooks.
    pub mod pivot {
        ::newton_euler::rigid_body!(Pendulum {
            motion: pivot(pin).at(world(0, height)),
            params: [length = 0.5[m], height[m]],
            mass: 2[kg],
            inertia: 0.05[kg * m ^ 2],
            points: [pin = (0, length)],
            fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
            reactions: [R_v = world(_, _).at(pin)],
            outputs: [linearization, energy, momentum, balance, reactions],
        });
    }

    /// On its tip.
    pub mod fixed_point {
        ::newton_euler::rigid_body!(Top {
            motion: fixed_point(tip),
            mass: 0.4[kg],
            inertia: principal(7e-4, 7e-4, 9e-4)[kg * m ^ 2],
            points: [tip = (0, 0, -0.06)],
            fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
            reactions: [ground = body(_, _, _).at(tip)],
            outputs: [linearization, energy, momentum, balance, reactions],
        });
    }

    /// On two bearings.
    pub mod fixed_axis {
        ::newton_euler::rigid_body!(Rotor {
            motion: fixed_axis(a, along),
            params: [along = body(1, 2, 2), gravity = world(_, _, _)[m / s ^ 2]],
            inputs: [torque],
            mass: 2[kg],
            inertia: tensor {
                xx: 1.3,
                yy: 1.7,
                zz: 2.1,
                xy: -0.12,
                yz: -0.05,
                zx: 0.07
            },
            points: [a = (0.1, 0.2, 0.3), b = body(0.1, 0.2, 0.3) + 0.1 * along],
            fields: [weight = mass * gravity],
            moments: [drive = torque * along],
            reactions: [A = body(_, _, _).at(a), B = body(0.25, _, _).at(b)],
            outputs: [linearization, energy, momentum, balance, reactions],
        });
    }

    /// Under constraints.
    pub mod constrained {
        ::newton_euler::rigid_body!(Sphere {
            motion: spatial,
            params: [r, mu = 0.3],
            inputs: [push[N]],
            mass: 2[kg],
            inertia: principal(0.03, 0.04, 0.05)[kg * m ^ 2],
            points: [contact = G - r * world(0, 0, 1)],
            forces: [driven = world(push, 0, 0)],
            constraints: [
                touching = position.in_world().z - r,
                straight = contact.velocity().in_world().y,
            ],
            reactions: [
                ground = world(0, _, _).at(contact),
                friction = world(-mu * ground.in_world().z, 0, 0).at(contact),
            ],
            outputs: [linearization, reactions, balance, energy, momentum],
        });
    }

    /// A rod.
    pub mod rod {
        ::newton_euler::rigid_body!(Javelin {
            motion: rod(body(1, slope, 0)),
            params: [slope = 0.5, l = 2[m], stiffness],
            inputs: [thrust[N], wind = world(_, _, _)[m / s]],
            mass: 0.8[kg],
            inertia: rod(l),
            points: [
                tail = (-0.4 * l, -0.4 * slope * l, 0),
                hook = world(1, 2, 3)
            ],
            pole: tail,
            locals: [air = tail.velocity() - wind],
            fields: [weight = mass * world(0, 0, -9.80665)],
            forces: [
                drag = (-0.2 * air).at(tail),
                engine = body(thrust, slope * thrust, 0)
            ],
            moments: [damped = -0.1[N * m * s] * angular_velocity],
            potentials: [spring = stiffness * (tail.position() - hook.position()).norm()],
            constraints: [on_floor = tail.position().in_world().z],
            reactions: [floor = world(0, 0, _).at(tail)],
            outputs: [linearization, energy, momentum, balance, reactions],
        });
    }

    /// In the plane, without turning.
    pub mod planar_translation {
        ::newton_euler::rigid_body!(Puck {
            motion: planar_translation,
            params: [friction],
            mass: 0.17[kg],
            forces: [rubbed = -friction * velocity],
            outputs: [linearization, energy, momentum, balance],
        });
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;
    use newton_euler::body::{Energy, RigidBody};
    use newton_euler::state::{PlanarTranslation, Spatial};

    use super::{motions, private};

    #[test]
    fn in_private_modules() {
        let _ = private::Stone::default();
        let (cart, door) = (private::Cart::<f64>::default(), private::Door::default());
        assert!(cart.params().m > 0.0 && door.params().width > 0.0);
    }

    #[test]
    fn units_are_folded() {
        let at = Spatial {
            velocity: Vector3::x(),
            ..Spatial::default()
        };
        // 123456.789 kg, rounded once, and halved.
        let energy = motions::free::Stone {}.kinetic_energy(&at);
        assert_eq!((energy * 2.0).to_bits(), 123_456.789_f64.to_bits());
    }

    #[test]
    fn parameters_without_default() {
        let params = motions::planar_translation::PuckParams { friction: 0.34 };
        let puck = motions::planar_translation::Puck::new(params).unwrap();
        let at = PlanarTranslation {
            velocity: [1.0, 0.0].into(),
            ..PlanarTranslation::default()
        };
        // 0.34 / 0.17, each literal and the quotient rounded.
        assert!((puck.acceleration(0.0, &at, &()).x + 2.0).abs() < 1e-15);
    }
}
