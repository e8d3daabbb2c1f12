//! Whipple's bicycle: the modes of upright riding, compared with those published for the benchmark
//! (J. P. Meijaard, J. M. Papadopoulos, A. Ruina, A. L. Schwab, Linearized dynamics equations for
//! the balance and steer of a bicycle, Proc. R. Soc. A 463, 2007, 1955: its parameters, and the
//! eigenvalues at 5 m/s).

use newton_euler::prelude::*;

rigid_system!(Bicycle {
    doc: "A rider on a bicycle; x ahead, y to the right, z down.",
    drawing: zero_pose,
    bodies: [
        rear {
            mass: 85[kg],
            inertia: tensor {
                xx: 9.2,
                yy: 11,
                zz: 2.8,
                zx: 2.4
            }[kg * m ^ 2]
                .at((0.3, 0, -0.9)[m]),
        },
        fork {
            mass: 4[kg],
            inertia: tensor {
                xx: 0.05892,
                yy: 0.06,
                zz: 0.00708,
                zx: -0.00756
            }[kg * m ^ 2]
                .at((0.9, 0, -0.7)[m]),
        },
        rear_wheel {
            mass: 2[kg],
            inertia: principal(0.0603, 0.12, 0.0603)[kg * m ^ 2].at((0, 0, -0.3)[m]),
            locals: [
                axle = body(0, 1, 0),
                down = world(0, 0, 1) - axle * axle.dot(world(0, 0, 1))
            ],
            points: [contact = G + 0.3[m] * down.normalize()],
        },
        front_wheel {
            mass: 3[kg],
            inertia: principal(0.1405, 0.28, 0.1405)[kg * m ^ 2].at((1.02, 0, -0.35)[m]),
            locals: [
                axle = body(0, 1, 0),
                down = world(0, 0, 1) - axle * axle.dot(world(0, 0, 1))
            ],
            points: [contact = G + 0.35[m] * down.normalize()],
        },
    ],
    joints: [
        base = free(rear),
        head = revolute(rear, fork, ((PI / 10).sin(), 0, (PI / 10).cos())).at((1.1, 0, 0)[m]),
        rear_axle = revolute(rear, rear_wheel, (0, 1, 0)).at((0, 0, -0.3)[m]),
        front_axle = revolute(fork, front_wheel, (0, 1, 0)).at((1.02, 0, -0.35)[m]),
    ],
    fields: [weight = mass * world(0, 0, 9.81[m / s ^ 2])],
    constraints: [
        rear_touches = rear_wheel.contact.position().in_world().z,
        front_touches = front_wheel.contact.position().in_world().z,
        rear_x = rear_wheel.contact.velocity().in_world().x,
        rear_y = rear_wheel.contact.velocity().in_world().y,
        front_x = front_wheel.contact.velocity().in_world().x,
        front_y = front_wheel.contact.velocity().in_world().y,
    ],
    outputs: [linearization],
});

/// Castering, weave and capsize at 5 m/s \[1/s\].
const MODES: [[f64; 2]; 3] = [
    [-14.078_389_692_798, 0.0],
    [-0.775_341_882_196, 4.464_867_713_788],
    [-0.322_866_429_004, 0.0],
];

#[test]
fn it_has_the_modes_of_the_benchmark() {
    let speed = 5.0;
    let riding = BicycleState {
        base: Spatial {
            position: [0.3, 0.0, -0.9].into(),
            velocity: [speed, 0.0, 0.0].into(),
            ..Spatial::default()
        },
        rear_axle: Hinge {
            angle: 0.0,
            angular_velocity: -speed / 0.3,
        },
        front_axle: Hinge {
            angle: 0.0,
            angular_velocity: -speed / 0.35,
        },
        ..BicycleState::default()
    };
    let bicycle = Bicycle::default();
    bicycle.check(0.0, &riding, &()).expect("it rolls");
    let upright = bicycle.trim(&riding).solve().expect("it rides on");
    let modes = upright.modes().expect("derivatives that are finite");
    let moving: Vec<_> = modes.iter().filter(|mode| !mode.is_neutral).collect();
    assert_eq!(moving.len(), MODES.len());
    for (mode, [real, imaginary]) in moving.into_iter().zip(MODES) {
        let found = mode.eigenvalue;
        assert!(
            (found.re - real).abs() < 1e-10 && (found.im - imaginary).abs() < 1e-10,
            "{found}"
        );
    }
}
