use newton_euler::prelude::*;

rigid_body!(Pendulum {
    motion: pivot(pin),
    mass: 1[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [pin = (0.1, 0.2)],
    moments: [motor = 2 * _],
    outputs: [inverse],
});

rigid_body!(Wheel {
    motion: planar,
    params: [l = 0.3[m]],
    mass: 1[kg],
    inertia: 0.1[kg * m ^ 2],
    constraints: [c = position.in_world().y - l * attitude],
    reactions: [n = 2 * _ * c.gradient()],
    outputs: [inverse],
});

fn main() {
    let _ = Pendulum::default().inverse(0.0, &Hinge::default(), &0.0, &());
    let _ = Wheel::default().inverse(0.0, &Planar::default(), &PlanarAcceleration::default(), &());
}
