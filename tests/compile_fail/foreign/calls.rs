use newton_euler::rigid_body;

rigid_body!(Wing {
    motion: translation,
    mass: 12[kg],
    inputs: [speed[m / s], share],
    functions: [
        thrust(speed[m / s], share) = crate::thrust[N],
        unused(share) = crate::unused,
        speed(share) = crate::unused,
    ],
    forces: [
        few = thrust(share) * world(1, 0, 0),
        dimension = thrust(share, share) * world(1, 0, 0),
        wrong = thrust(velocity.norm(), velocity.norm()) * world(1, 0, 0),
        vector = thrust(velocity, share) * world(1, 0, 0),
        other = thurst(velocity.norm(), share) * world(1, 0, 0),
        value = thrust * world(1, 0, 0),
        unit = 1[m] * thrust(velocity.norm(), share) * world(1, 0, 0),
        moment = (2[m] + thrust(velocity.norm(), share)) * world(1, 0, 0),
    ],
});

fn main() {}
