use newton_euler::rigid_body;

rigid_body!(Dumbbell {
    motion: spatial,
    inertia: compose([
        sphere(1[um]).mass(1[kg]).at((0, 0, 0)),
        sphere(1[um]).mass(1[kg]).at((0, 1[m], 0)),
    ]),
});

fn main() {}
