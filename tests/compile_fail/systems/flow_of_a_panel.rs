use newton_euler::rigid_system;

rigid_system!(Satellite {
    bodies: [
        hub { mass: 8[kg], inertia: principal(0.5, 0.9, 0.9), points: [seat = (-0.2, 0, 0)] },
        panel { mass: 2[kg], inertia: principal(0.03, 0.02, 0.02), points: [edge = (0, 1, 0)] },
    ],
    joints: [orbit = free(hub), hinge = revolute(hub.seat, panel.edge, body(1, 0, 0))],
    outputs: [flow],
});

fn main() {}
