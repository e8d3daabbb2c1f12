use newton_euler::rigid_body;

rigid_body!(Bob {
    motion: planar,
    inertia: compose([point(1[kg]).at((1, 0)), point(2[kg]).at((1, 0))]),
});

fn main() {}
