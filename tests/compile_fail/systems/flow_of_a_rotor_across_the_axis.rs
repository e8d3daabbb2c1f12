use newton_euler::rigid_system;

rigid_system!(Satellite {
    bodies: [
        hub { mass: 50[kg], inertia: principal(10, 10, 9) },
        wheel { mass: 3[kg], inertia: principal(0.6, 0.4, 0.4) },
    ],
    joints: [orbit = free(hub), spin = revolute(hub.G, wheel.G, body(1, 0, 0))],
    outputs: [flow],
});

fn main() {}
