use newton_euler::rigid_system;

rigid_system!(Satellite {
    bodies: [
        hub { mass: 50[kg], inertia: principal(10, 11, 9) },
        wheel { mass: 3[kg], inertia: principal(0.4, 0.4, 0.6) },
    ],
    joints: [orbit = free(hub), spin = revolute(hub.G, wheel.G, body(0, 0, 1))],
    outputs: [flow],
});

fn main() {}
