use newton_euler::rigid_system;

rigid_system!(Satellite {
    bodies: [
        hub { mass: 120[kg], inertia: principal(12, 14, 9)[kg * m ^ 2], points: [p = (0.3, 0, 0)] },
        wheel { mass: 4[kg], inertia: disc(0.13[m]) },
    ],
    joints: [orbit = free(hub), spin = revolute(hub.p, wheel.G, body(0, 0, 1))],
    drives: [all = _.on(orbit), motor = _.on(spin)],
    outputs: [inverse],
});

fn main() {}
