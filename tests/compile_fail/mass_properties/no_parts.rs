use newton_euler::rigid_body;

rigid_body!(Drum {
    motion: spatial,
    inertia: compose([]),
});

fn main() {}
