//! `outputs: [linearization]`: A and B of bodies and systems of every kind, compared with dual
//! numbers; steady motions and modes.
#![allow(missing_docs, reason = "tests")]
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

mod alone;
mod bodies;
mod changing;
mod following;
#[path = "../../examples/level_turn.rs"]
mod level_turn;
mod modes;
mod oracle;
mod own;
mod rest;
mod sensitivity;
mod stiff_neighbours;
mod stiff_steps;
mod systems;
mod textbook;
mod together;
mod trim;
mod trim_of_systems;
mod whether_steady;

#[test]
fn an_aeroplane_has_its_published_modes() {
    level_turn::main();
}
