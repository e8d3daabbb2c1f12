use newton_euler::prelude::*;

rigid_body!(Rock {
    motion: spatial,
    mass: 2[kg],
    inertia: principal(1, 2, 3)[kg * m ^ 2]
});

fn energy_of(_: &impl Energy) {}
fn blocks_of(_: &impl Linearization) {}

fn main() {
    let rock = Rock::default();
    energy_of(&rock);
    blocks_of(&rock);
}
