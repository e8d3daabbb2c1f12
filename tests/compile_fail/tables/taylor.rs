use newton_euler::rigid_body;

rigid_body!(Float {
    motion: translation,
    mass: 12[kg],
    locals: [depth = -position.in_world().z],
    forces: [lift = world(0, 0, table(depth, [0, 0.4, 0.5][m], [0, 110, 150][N], cubic))],
    outputs: [taylor],
});

fn main() {}
