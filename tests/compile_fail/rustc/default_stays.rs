use newton_euler::prelude::*;
use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: translation,
    params: [drag = 1e400],
    mass: 1[kg],
    forces: [air = -drag * velocity],
});

fn main() {
    let stone = Stone::default();
    let _ = stone.acceleration(0.0, &Translation::default(), &());
}
