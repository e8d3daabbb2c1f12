use newton_euler::rigid_system;

rigid_system!(Pendulum {
    inputs: [push[N]],
    bodies: [
        bob {
            mass: 8[kg],
            inertia: principal(0.3, 0.3, 0.3),
            points: [pin = (0, 0, 0.4), side = (1, 0, 0)],
            forces: [along = (push * world(0, 1, 0)).at(pin), across = (push * world(0, 0, 1)).at(side)],
        },
    ],
    joints: [swing = revolute(world(0, 0, 0), bob.pin, world(0, 1, 0))],
    outputs: [flow],
});

fn main() {}
