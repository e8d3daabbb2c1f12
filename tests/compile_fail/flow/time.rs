use newton_euler::rigid_body;

rigid_body!(Parcel {
    motion: translation,
    mass: 2[kg],
    forces: [crane = world(0, 0, 2)[N / s] * t],
    outputs: [flow],
});

fn main() {}
