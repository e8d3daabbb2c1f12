//! Bodies that are generic over their scalar.

/// Generic over its scalar, with names that its own code has.
pub mod generic {
    ::newton_euler::rigid_body!(Craft::<Real> {
        doc: "A craft.",
        motion: spatial,
        params: [
            half = 2.5[kg],
            constant = -0.12,
            two = body(0.4, -0.2, 0.1)[m],
            scalar
        ],
        inputs: [one, wind = world(_, _, _)[m / s]],
        mass: half,
        inertia: tensor {
            xx: 1.3,
            yy: 1.7,
            zz: 2.1,
            xy: constant,
            yz: -0.05,
            zx: 0.07
        },
        points: [nozzle = two],
        locals: [air = nozzle.velocity() - wind],
        forces: [
            jet = body(
                0,
                0,
                if one < 0.5 && t > 1 || one != 3 {
                    one
                } else {
                    1 - one
                }
            )
            .at(nozzle),
            drag = (-0.8 * air.norm() * air).at(nozzle),
            huge = 1[N] * world(1e300, scalar.sin(), 3.14159),
        ],
        fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
        outputs: [linearization, energy, momentum, balance],
    });
}

/// Generic, without anything that could be left out.
pub mod generic_stone {
    ::newton_euler::rigid_body!(Other::<T> {
        motion: rotation,
        inertia: principal(1, 2, 3),
    });
}

/// Generic, in the plane, with reactions and drives.
pub mod generic_planar {
    ::newton_euler::rigid_body!(Arm::<T> {
        motion: pivot(tip),
        params: [length = 0.5[m]],
        mass: 2[kg],
        inertia: 0.01[kg * m ^ 2],
        points: [tip = (0, length)],
        fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
        moments: [motor = _],
        reactions: [pin = world(_, _).at(tip)],
        outputs: [linearization, energy, momentum, balance, reactions, inverse],
    });
}
