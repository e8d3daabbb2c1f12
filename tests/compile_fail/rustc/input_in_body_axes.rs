use newton_euler::prelude::*;

rigid_system!(Sled {
    motion: planar,
    inputs: [kick = body(_, _)[N]],
    bodies: [sled {
        mass: 1[kg],
        inertia: 0.1[kg * m ^ 2],
        points: [hitch = (0.2, 0.1)],
        forces: [pull = kick.at(hitch)],
    }],
    joints: [slides = free(sled)],
});

fn main() {
    let _ = SledInput { kick: [3.0, 1.0].into() };
    let _ = Sled::default();
}
