use newton_euler::rigid_body;

rigid_body!(Ball {
    motion: spatial,
    mass: 2[kg],
    inertia: sphere(0.1[m]),
    moments: [turn = sphere(0.1[m])],
    forces: [push = compose([1, 2])],
});

fn main() {}
