//! The description of a file with all its values, as `describe` prints it.

use newton_euler::prelude::*;

rigid_system!(SensorPrinted {
    bodies: [
        camera {
            mass: 0.2[kg],
            inertia: principal(1e-4, 2e-4, 1.5e-4),
            points: [origin = (0, 0, 0), tilt = (0, 0, 0.05)],
        },
        lens {
            mass: 0.1[kg],
            inertia: sphere(0.03[m]),
        },
        cart {
            mass: 1.5,
            inertia: tensor {
                xx: 0.004,
                yy: 0.005,
                zz: 0.003,
                xy: 0,
                yz: 0,
                zx: 0.0005
            },
            points: [origin = (-0.02, 0, -0.04), turn = (-0.02, 0, 0.1 - 0.04)],
        },
        palm {
            mass: 0.7,
            inertia: tensor {
                xx: 0.0012,
                yy: 0.0015,
                zz: 0.0008,
                xy: 0,
                yz: 0,
                zx: 0
            }
            .turned(body(1, 0, 0), 0.3),
            points: [origin = (0, -0.01, -0.05), pan = (0.1, -0.01, 0.2 - 0.05)],
        },
        plate {
            mass: 0[kg],
            points: [origin = (0, 0, 0)],
        },
    ],
    joints: [
        rail =
            prismatic(world(0, 0.1, 0), cart.origin, body(0, 0, 1)).turned(body(0, 1, 0), 90[deg]),
        turn = revolute(cart.turn, palm.origin, body(0, -1, 0)).turned(body(0, 0, 1), -0.4),
        pan = revolute(palm.pan, camera.origin, body(0, 0, 1)),
        tilt = revolute(camera.tilt, plate.origin, body(0, 1, 0)),
        glue = weld(plate.origin, lens.G),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
});
