#![deny(warnings)]
use newton_euler::rigid_system;

rigid_system!(Pendulum {
    motion: planar,
    params: [gain = 2],
    inputs: [push[N]],
    locals: [twice = 2 * t],
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: 0.04[kg * m ^ 2],
            points: [hinge = (-0.28, 0)[m], tip = (0.32, 0)[m], foot = (1, 0)[m]],
            locals: [thrice = 3 * t],
        },
        lower { mass: 0.8[kg], inertia: 0.015[kg * m ^ 2], points: [hinge = (-0.22, 0)[m]] },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.hinge),
        elbow = revolute(upper.tip, lower.hinge),
    ],
});

fn main() {}
