use newton_euler::rigid_body;

rigid_body!(Ball {
    motion: translation,
    mass: 1[kg],
    points: [ground = world(0, 0, 0)],
    locals: [depth = -(position - ground.position()).in_world().z],
    forces: [contact = world(0, 0, if depth > 0 { 900[N / m] * depth } else { 0 })],
    outputs: [energy, taylor],
});

fn main() {}
