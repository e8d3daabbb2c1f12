//! Series and closed forms.

/// With series, recurrences of many kinds, and names that their code has.
pub mod smooth {
    ::newton_euler::rigid_body!(N {
        motion: fixed_point(n),
        params: [order = 0.3, series = 2],
        inputs: [rates, products],
        mass: 1[kg],
        inertia: principal(1, 2, 2.5),
        points: [n = (0, 0, -order)],
        locals: [
            inverse = (series + t / 1[s]).sqrt(),
            time = position.norm() / 1[m]
        ],
        fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
        moments: [
            held = 1[N * m]
                * body(
                    rates / inverse,
                    (time + 3).powf(products),
                    3.14159 * inverse.atan2(time)
                ),
            waves = 1[N * m]
                * body(
                    inverse.sin(),
                    0,
                    if rates == products { time.tanh() } else { 1 }
                ),
        ],
        outputs: [energy, momentum, balance, taylor],
    });
}

/// With series in axes of their own.
pub mod spun {
    ::newton_euler::rigid_body!(Wheel {
        motion: spatial,
        params: [spin = 0.2, axes = 0.3, time = 1],
        inputs: [series],
        mass: 1,
        inertia: principal(spin, axes, axes),
        fields: [weight = mass * world(0, 0, -9.81)],
        forces: [push = body(time * series, 0, 0)],
        outputs: [taylor],
    });
}

/// With series that end, and without products.
pub mod thrown {
    ::newton_euler::rigid_body!(Stone {
        motion: translation,
        mass: 1[kg],
        fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
        outputs: [taylor],
    });
}

/// Motions in closed form.
pub mod flow {
    ::newton_euler::rigid_body!(Brick {
        motion: spatial,
        mass: 2[kg],
        inertia: tensor {
            xx: 1.3,
            yy: 1.7,
            zz: 2.1,
            xy: -0.12,
            yz: -0.05,
            zx: 0.07
        },
        fields: [weight = mass * world(0, 0, -9.80665)],
        outputs: [flow],
    });
    ::newton_euler::rigid_body!(Handle {
        motion: rotation,
        params: [J],
        inertia: principal(J, 2 * J, 2.5 * J),
        outputs: [flow, energy],
    });
    ::newton_euler::rigid_body!(Drum {
        motion: fixed_point(G),
        mass: 1,
        inertia: cylinder(0.1, 0.5).along(body(1, 2, 3)),
        outputs: [flow],
    });
    ::newton_euler::rigid_body!(Clock {
        motion: pivot(pin),
        params: [g = 9.8],
        mass: 2,
        inertia: 1,
        points: [pin = (0.1, 1.25)],
        fields: [weight = mass * world(0, -g)],
        outputs: [flow],
    });
    ::newton_euler::rigid_body!(Towed {
        motion: planar,
        mass: 2,
        inertia: 1,
        points: [hook = (0.1, 1.25)],
        forces: [rope = world(1, 0).at(hook)],
        outputs: [flow],
    });
    ::newton_euler::rigid_body!(Baton {
        motion: rod(body(1, 0, 0)),
        mass: 2,
        inertia: 1,
        outputs: [flow],
    });
}

/// The same of systems.
pub mod parts {
    ::newton_euler::rigid_system!(Satellite {
        params: [torque = 0.02],
        bodies: [
            hub {
                mass: 5,
                inertia: principal(2, 2, 1),
                points: [boom = (0, 0, 1)]
            },
            rotor {
                mass: 3,
                inertia: principal(0.4, 0.4, 0.6)
            },
            bob {
                mass: 3,
                inertia: principal(0.4, 0.4, 0.6),
                points: [pin = (0, 1, 0)]
            },
        ],
        joints: [
            time = free(hub),
            Self_ = revolute(hub.boom, rotor.G, body(0, 0, 1)),
            swing = revolute(world(0, 0, 0), bob.pin, world(1, 0, 0)),
        ],
        fields: [weight = mass * world(0, 0, -9.80665)],
        drives: [motor = torque.on(Self_)],
        outputs: [flow],
    });
    ::newton_euler::rigid_system!(Generic::<T> {
        motion: planar,
        bodies: [
            plate {
                mass: 5,
                inertia: 1,
                points: [boom = (0, 1)]
            },
            wheel {
                mass: 3,
                inertia: 2
            },
        ],
        joints: [path = free(plate), state = revolute(plate.boom, wheel.G),],
        outputs: [flow, taylor],
    });
}
