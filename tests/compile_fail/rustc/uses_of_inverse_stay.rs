use newton_euler::prelude::*;

rigid_system!(Cart {
    motion: planar,
    bodies: [
        cart { mass: 2[kg] },
        pole { mass: 0.4[kg], inertia: 0.01[kg * m], points: [pin = (0, -0.3)[m]] },
    ],
    joints: [
        rail = prismatic(world(0, 0), cart.G, body(1, 0)),
        swing = revolute(cart.G, pole.pin),
    ],
    drives: [motor = _.on(rail), servo = _.on(swing)],
    outputs: [inverse],
});

fn main() {
    let state = CartState { rail: Slide::default(), swing: Hinge::default() };
    let given = Cart::default().acceleration(0.0, &state, &());
    let drives: CartDrives = Cart::default().inverse(0.0, &state, &given, &());
    let _ = drives.motor + drives.servo;
}
