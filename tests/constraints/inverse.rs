//! Inverse dynamics: the drives of a given motion produce that motion again; and the published
//! torque of M1.
#![allow(missing_docs)]

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::prelude::*;

rigid_body!(Arm {
    motion: pivot(pin),
    mass: 2.7[kg],
    inertia: 0.18[kg * m ^ 2],
    points: [pin = (0, 0.35)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    moments: [motor = _],
    outputs: [inverse],
});

rigid_body!(ArmDriven {
    motion: pivot(pin),
    inputs: [torque[N * m]],
    mass: 2.7[kg],
    inertia: 0.18[kg * m ^ 2],
    points: [pin = (0, 0.35)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    moments: [motor = torque],
});

rigid_body!(Craft {
    motion: spatial,
    params: [reach = 0.4[m]],
    mass: 3.2[kg],
    inertia: tensor {
        xx: 1.3,
        yy: 1.7,
        zz: 2.1,
        xy: -0.12,
        yz: -0.05,
        zx: 0.07
    }[kg * m ^ 2],
    points: [nozzle = (-reach, 0.1, 0)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [thrust = body(_, _, _).at(nozzle)],
    joint_moments: [wheels = body(_, _, _)],
    outputs: [inverse],
});

rigid_body!(CraftDriven {
    motion: spatial,
    params: [reach = 0.4[m]],
    inputs: [push = body(_, _, _)[N], turn = body(_, _, _)[N * m]],
    mass: 3.2[kg],
    inertia: tensor {
        xx: 1.3,
        yy: 1.7,
        zz: 2.1,
        xy: -0.12,
        yz: -0.05,
        zx: 0.07
    }[kg * m ^ 2],
    points: [nozzle = (-reach, 0.1, 0)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [thrust = push.at(nozzle)],
    joint_moments: [wheels = turn],
});

rigid_body!(Rotor {
    motion: fixed_axis(a, body(0, 0, 1)),
    mass: 13[kg],
    inertia: tensor {
        xx: 1,
        yy: 1.1,
        zz: 0.9,
        xy: 0.02,
        yz: -0.05,
        zx: 0.07
    }[kg * m ^ 2],
    points: [a = (0.01, -0.02, -0.3), b = (0.01, -0.02, 0.25)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2], 0)],
    moments: [motor = body(0, 0, _)],
    reactions: [
        bearing_a = body(_, _, _).at(a),
        bearing_b = body(_, _, 0).at(b)
    ],
    outputs: [inverse, reactions],
});

rigid_body!(RotorDriven {
    motion: fixed_axis(a, body(0, 0, 1)),
    inputs: [torque[N * m]],
    mass: 13[kg],
    inertia: tensor {
        xx: 1,
        yy: 1.1,
        zz: 0.9,
        xy: 0.02,
        yz: -0.05,
        zx: 0.07
    }[kg * m ^ 2],
    points: [a = (0.01, -0.02, -0.3)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2], 0)],
    moments: [motor = body(0, 0, torque)],
});

/// Numbers from -1 to 1 without a pattern.
fn spread(n: u32) -> f64 {
    (f64::from(n).sin() * 43_758.545_3).fract()
}

#[test]
fn published_torque_of_m1() {
    let state = Hinge {
        angle: 0.7,
        angular_velocity: -1.3,
    };
    let motor = Arm::default().inverse(0.0, &state, &2.5, &()).motor;
    // a sum of three terms, none above 8
    assert!((motor - 7.247_023_426_509_28).abs() < 4.0 * f64::EPSILON * 8.0);
}

#[test]
fn the_drives_of_a_motion_make_it() {
    for seed in 0..200_u32 {
        let x = |k: u32| spread(seed * 17 + k);
        let hinge = Hinge {
            angle: 3.0 * x(0),
            angular_velocity: 4.0 * x(1),
        };
        let wanted = 10.0 * x(2);
        let torque = Arm::default().inverse(0.0, &hinge, &wanted, &()).motor;
        let input = ArmDrivenInput { torque };
        let again = ArmDriven::default().acceleration(0.0, &hinge, &input);
        assert!(
            (again - wanted).abs() < 1e-12 * (1.0 + wanted.abs()),
            "{again} {wanted}"
        );

        let torque = Rotor::default().inverse(0.0, &hinge, &wanted, &()).motor.z;
        let input = RotorDrivenInput { torque };
        let again = RotorDriven::default().acceleration(0.0, &hinge, &input);
        assert!(
            (again - wanted).abs() < 1e-12 * (1.0 + wanted.abs()),
            "{again} {wanted}"
        );

        let state = Spatial {
            attitude: UnitQuaternion::from_euler_angles(x(3), 2.0 * x(4), 3.0 * x(5)),
            angular_velocity: Vector3::new(x(6), x(7), x(8)) * 3.0,
            ..Spatial::default()
        };
        let wanted = SpatialAcceleration {
            linear: Vector3::new(x(9), x(10), x(11)) * 9.0,
            angular: Vector3::new(x(12), x(13), x(14)) * 7.0,
        };
        let drives = Craft::default().inverse(0.0, &state, &wanted, &());
        let input = CraftDrivenInput {
            push: drives.thrust,
            turn: drives.wheels,
        };
        let again = CraftDriven::default().acceleration(0.0, &state, &input);
        // a few dozen operations on terms of order ten
        assert!(
            (again.linear - wanted.linear).norm() < 1e-12,
            "{again:?} {wanted:?}"
        );
        assert!(
            (again.angular - wanted.angular).norm() < 1e-12,
            "{again:?} {wanted:?}"
        );
    }
}

mod partly_driven {
    use newton_euler::rigid_body;

    rigid_body!(Multicopter {
        motion: spatial,
        inputs: [wind = world(_, _, _)[N]],
        mass: 1.2[kg],
        inertia: principal(0.0123, 0.0131, 0.0224)[kg * m ^ 2],
        points: [hub = (0.01, 0, 0.05)],
        fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
        forces: [lift = body(0, 0, _).at(hub), push = wind],
        moments: [torque = body(_, _, _)],
        outputs: [inverse, balance],
    });

    rigid_body!(Wheel {
        motion: rotation,
        inertia: principal(1, 2, 3)[kg * m ^ 2],
        moments: [motor = body(0, _, 0)],
        outputs: [inverse],
    });

    rigid_body!(Sledge {
        motion: planar,
        mass: 3[kg],
        inertia: 0.2[kg * m ^ 2],
        forces: [jet = body(_, 0)],
        outputs: [inverse],
    });
}

/// Drives along some directions only: the balances along the others are not looked at.
#[test]
fn some_directions() {
    use partly_driven::{Multicopter, MulticopterInput, Sledge, Wheel};
    let state = Spatial {
        attitude: UnitQuaternion::from_euler_angles(0.2, -0.3, 0.5),
        angular_velocity: Vector3::new(0.4, -0.7, 1.1),
        ..Spatial::default()
    };
    let acceleration = SpatialAcceleration {
        linear: Vector3::new(0.5, 0.1, 1.7),
        angular: Vector3::new(2.0, -1.0, 0.5),
    };
    let input = MulticopterInput {
        wind: Vector3::new(0.3, 0.2, -0.1),
    };
    let drives = Multicopter::default().inverse(0.0, &state, &acceleration, &input);
    let needed = (acceleration.linear + Vector3::z() * 9.80665) * 1.2 - input.wind;
    let lift = (state.attitude.inverse() * needed).z;
    assert!(
        (drives.lift - Vector3::new(0.0, 0.0, lift)).amax() < 1e-13,
        "{drives:?}"
    );
    let inertia = nalgebra::Matrix3::from_diagonal(&Vector3::new(0.0123, 0.0131, 0.0224));
    let w = state.angular_velocity;
    let total = inertia * acceleration.angular + w.cross(&(inertia * w));
    let torque = total - Vector3::new(0.01, 0.0, 0.05).cross(&Vector3::new(0.0, 0.0, lift));
    assert!((drives.torque - torque).amax() < 1e-15, "{drives:?}");

    let spinning = Rotation {
        angular_velocity: w,
        ..Rotation::default()
    };
    let motor = Wheel::default()
        .inverse(0.0, &spinning, &Vector3::new(0.3, 0.5, 0.7), &())
        .motor;
    assert!((motor.y - (2.0 * 0.5 + (1.0 - 3.0) * w.z * w.x)).abs() < 1e-14);
    assert_eq!((motor.x, motor.z), (0.0, 0.0));

    let angled = Planar {
        angle: 0.4,
        ..Planar::default()
    };
    let wanted = PlanarAcceleration {
        linear: [1.0, 2.0].into(),
        angular: 0.3,
    };
    let jet = Sledge::default().inverse(0.0, &angled, &wanted, &()).jet;
    assert!((jet.x - 3.0 * (0.4_f64.cos() + 2.0 * 0.4_f64.sin())).abs() < 1e-14);
}
