use newton_euler::rigid_system;

rigid_system!(Bob {
    bodies: [
        bob {
            params: [weight = 1[kg], length = 1[m]],
            inputs: [push[N]],
            mass: weight,
            inertia: sphere(0.1[m]),
            points: [hook = (0, 0, length)],
            forces: [wind = body(push, 0, 0)],
            joints: [cord = spherical(world(0, 0, 0), hook)],
        },
        other {
            params: [weight = 1[kg]],
            mass: weight,
            inertia: sphere(0.1[m]),
            joint: free,
        },
    ],
});

fn main() {}
