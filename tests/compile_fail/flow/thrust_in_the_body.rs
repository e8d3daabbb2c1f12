use newton_euler::rigid_body;

rigid_body!(Rocket {
    motion: spatial,
    mass: 2[kg],
    inertia: principal(0.3, 0.3, 0.1),
    forces: [thrust = body(0, 0, 40)[N]],
    outputs: [flow],
});

fn main() {}
