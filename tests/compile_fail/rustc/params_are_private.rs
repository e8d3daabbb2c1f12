use newton_euler::prelude::*;

rigid_body!(Arm {
    motion: pivot(elbow),
    params: [length = 0.35[m]],
    mass: 2.7[kg],
    inertia: mass * length.powi(2) / 3,
    points: [elbow = (0, length)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
});

fn main() {
    let mut arm = Arm::default();
    arm.params.length = 0.4;
    arm.length = 0.4;
}
