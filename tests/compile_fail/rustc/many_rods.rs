use newton_euler::rigid_body;

rigid_body!(Stick {
    motion: rod(body(1, 0, 0)),
    mass: 2[kg],
    inertia: cylinder(0.1[m], 0.5[m]),
    points: [tip = (0.25, 0.1, 0), end = (0, 0.3, 0)],
    forces: [push = body(0, 0, 1)[N].at(tip), pull = attitude * 2],
    outputs: [energy],
});

fn main() {
    use newton_euler::prelude::*;
    // the types are there all the same
    let thrown = Rod::default();
    let RodAcceleration { linear, axis } = Stick::default().acceleration(0.0, &thrown, &());
    let _ = (linear.x + axis.x, Stick::default().kinetic_energy(&thrown));
}
