use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    inputs: [thrust[N]],
    forces: [thrust * body(0, 1), velocity.norm() * body(0, 1)[N * s / m]],
    fields: [mass * world(0, -9.80665[m / s ^ 2])],
});

fn main() {}
