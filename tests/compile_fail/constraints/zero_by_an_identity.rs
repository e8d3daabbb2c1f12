use newton_euler::rigid_body;

rigid_body!(Block {
    motion: planar_translation,
    mass: 1[kg],
    locals: [angle = position.in_world().y / 1[m]],
    constraints: [
        double = (2 * angle).sin() - 2 * angle.sin() * angle.cos(),
        shifted = (angle + PI / 2).sin() - angle.cos(),
        half = 1 - angle.cos() - 2 * (angle / 2).sin().powi(2),
    ],
});

fn main() {}
