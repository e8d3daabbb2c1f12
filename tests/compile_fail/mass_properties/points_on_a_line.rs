use newton_euler::rigid_body;

rigid_body!(Dumbbell {
    motion: spatial,
    inertia: compose([point(1[kg]).at((-1, 0, 1)), point(2[kg]).at((1, 0, 3))]),
});

fn main() {}
