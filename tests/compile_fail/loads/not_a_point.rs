use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    params: [arm = 0.5[m]],
    forces: [push = body(0, 1).at(arm)],
});

fn main() {}
