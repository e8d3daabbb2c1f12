use newton_euler::prelude::*;

// that nothing is known of how `wheel` moves follows, and is not said
rigid_system!(Coupled {
    params: [pin = 1[m]],
    bodies: [
        disc { mass: 2[kg], inertia: sphere(0.3), points: [pin = (0, 0, 1)] },
        wheel { mass: 1[kg], inertia: sphere(0.1) },
    ],
    joints: [adrift = free(disc), axle = revolute(disc.pin, wheel.G, body(0, 0, 1))],
    forces: [pull = (1[N * s ^ 2 / m] * wheel.acceleration.in_world().z).between(disc.pin, wheel.G)],
    constraints: [level = wheel.G.velocity().in_world().z],
});

fn main() {}
