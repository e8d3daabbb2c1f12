//! `outputs: [linearization]`: A and B of bodies and systems of every kind beside dual numbers.

mod bodies;
mod oracle;
mod own;
mod systems;
