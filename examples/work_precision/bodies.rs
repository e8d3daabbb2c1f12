//! The bodies, described; each has the methods that its outputs name.

use newton_euler::rigid_body;

rigid_body!(SymmetricFree {
    motion: rotation,
    inertia: principal(2, 2, 1)[kg * m ^ 2],
    outputs: [flow, taylor],
});

rigid_body!(AsymmetricFree {
    motion: rotation,
    inertia: principal(0.6, 0.8, 1)[kg * m ^ 2],
    outputs: [flow, taylor],
});

rigid_body!(Dzhanibekov {
    motion: rotation,
    inertia: principal(1, 2, 3)[kg * m ^ 2],
    outputs: [flow, taylor],
});

rigid_body!(LagrangeTop {
    motion: rotation,
    inertia: principal(1, 1, 0.5)[kg * m ^ 2],
    moments: [weight = body(0, 0, 1[m]).cross(world(0, 0, -5[N]))],
    outputs: [flow, taylor],
});

rigid_body!(HeavyTop {
    motion: rotation,
    inertia: principal(0.6, 0.8, 1)[kg * m ^ 2],
    moments: [weight = body(0, 0, 1[m]).cross(world(0, 0, -1[N]))],
    outputs: [taylor],
});

rigid_body!(Pendulum {
    doc: "A moment of inertia of 0.3 kg m² about the pin, a weight of 10 N at 0.4 m.",
    motion: pivot(pin),
    mass: 1[kg],
    inertia: 0.14[kg * m ^ 2],
    points: [pin = (0, 0.4[m])],
    fields: [weight = mass * world(0, -10[m / s ^ 2])],
    outputs: [flow, taylor],
});

rigid_body!(PendulumInSpace {
    doc: "The same, swinging about body x.",
    motion: rotation,
    inertia: principal(0.3, 0.5, 0.4)[kg * m ^ 2],
    moments: [weight = body(0, 0, -0.4[m]).cross(world(0, 0, -10[N]))],
    outputs: [taylor],
});

rigid_body!(Quadrotor {
    doc: "Four unequal rotors, drag of the body by the square of its speed and of its turning by the rate.",
    motion: spatial,
    params: [arm = 0.17[m], drag_ratio = 0.016[m]],
    mass: 1.2[kg],
    inertia: principal(0.0123, 0.0117, 0.0224)[kg * m ^ 2],
    points: [
        front = (arm, 0, 0),
        left = (0, arm, 0),
        back = (-arm, 0, 0),
        right = (0, -arm, 0),
    ],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [
        lift_1 = body(0, 0, 3.1[N]).at(front),
        lift_2 = body(0, 0, 2.9[N]).at(left),
        lift_3 = body(0, 0, 3[N]).at(back),
        lift_4 = body(0, 0, 3.2[N]).at(right),
        drag = -0.08[kg / m] * velocity.norm() * velocity,
    ],
    moments: [
        rotors = body(0, 0, drag_ratio * (3.1 - 2.9 + 3 - 3.2)[N]),
        air = -0.01[N * m * s] * angular_velocity,
    ],
    outputs: [taylor],
});

rigid_body!(Satellite {
    doc: "The satellite of the example of that name.",
    motion: spatial,
    params: [mu = 3.986004418e14[m ^ 3 / s ^ 2]],
    mass: 500[kg],
    inertia: principal(120, 150, 90)[kg * m ^ 2],
    locals: [
        distance = position.norm(),
        n = position.in_body(),
        along = n.dot(body(120 * n.x, 150 * n.y, 90 * n.z)[kg * m ^ 2]),
        trace = 360[kg * m ^ 2],
    ],
    potentials: [gravity =
        -mu * mass / distance - mu / 2 * (trace / distance.powi(3) - 3 * along / distance.powi(5))],
    outputs: [taylor],
});

/// Tops that ensembles move: bodies over any scalar.
pub mod many {
    use newton_euler::rigid_body;

    rigid_body!(LagrangeTop::<T> {
        motion: rotation,
        inertia: principal(1, 1, 0.5)[kg * m ^ 2],
        moments: [weight = body(0, 0, 1[m]).cross(world(0, 0, -5[N]))],
        outputs: [flow],
    });

    rigid_body!(HeavyTop::<T> {
        motion: rotation,
        inertia: principal(0.6, 0.8, 1)[kg * m ^ 2],
        moments: [weight = body(0, 0, 1[m]).cross(world(0, 0, -1[N]))],
        outputs: [taylor],
    });
}
