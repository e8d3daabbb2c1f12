use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    params: [late = 1 > 2],
    forces: [push = body(0, if late { 1 } else { 2 })],
});

fn main() {}
