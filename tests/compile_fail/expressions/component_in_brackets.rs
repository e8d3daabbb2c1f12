use newton_euler::rigid_body;

rigid_body!(Fin {
    motion: spatial,
    inputs: [u[N]],
    mass: 1[kg],
    inertia: principal(1, 2, 2)[kg * m ^ 2],
    forces: [push = (u * body(1, 0, 0)).at(moved(u[N]))],
    moments: [drag = body(0, 0, -1[N * m * s]) * angular_velocity[1]],
});

rigid_body!(Board {
    motion: planar,
    mass: 1[kg],
    inertia: rectangle(1[m], 2[m], 0.1[m]),
});

fn main() {}
