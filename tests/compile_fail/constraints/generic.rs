use newton_euler::rigid_body;

rigid_body!(Bead::<T> {
    motion: planar_translation,
    mass: 1[kg],
    constraints: [wire = position.in_world().y],
    reactions: [push = world(0, _)],
});

fn main() {
    let _ = Bead::<f32>::default();
}
