//! F11 and F12: free bodies from the macro, integrated and compared with the closed forms.

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::{integrate::cf4, prelude::*};
use serde_json::Value;

use crate::reference::{self, attitude, distance, number, statement, trajectory, vector};

mod scenes {
    newton_euler::rigid_body!(Handle {
        motion: rotation,
        inertia: principal(1, 2, 3)[kg * m ^ 2],
        outputs: [energy, momentum],
    });

    newton_euler::rigid_body!(Thrown {
        motion: spatial,
        mass: 0.7[kg],
        inertia: tensor {
            xx: 1,
            yy: 2,
            zz: 3,
            xy: 0,
            yz: 0,
            zx: 0
        }[kg * m ^ 2],
        fields: [weight = mass * world(0, 0, -9.8[m / s ^ 2])],
    });

    newton_euler::rigid_body!(Described {
        motion: rotation,
        params: [a, b, c],
        inputs: [twist[N * m]],
        inertia: principal(a, b, c),
        moments: [along = body(0, 0, twist)],
        outputs: [momentum],
    });
}

fn handle() -> Rotation {
    Rotation {
        angular_velocity: Vector3::new(0.01, 1.0, 0.01),
        ..Rotation::default()
    }
}

/// Attitude and angular velocity agree to 1e-10, which is asked of integrations.
fn arrives(end: &Rotation, q: &Value, w: &Value) {
    let off = (end.angular_velocity - vector(w)).amax();
    assert!(off <= 1e-10, "ω is off by {off:e}");
    let off = distance(&end.attitude, &attitude(q));
    assert!(off <= 1e-10, "q is off by {off:e}");
}

#[test]
fn f11_handle_after_10_s() {
    let expected = statement("F11 torque-free (Dzhanibekov), J=(1,2,3), w0=(.01,1,.01)");
    let [q, w] =
        ["q(10) (scalar first, body->world)", "w(10) closed form"].map(|key| &expected[key]);
    // Order four at steps of 2 ms: (2e-3)⁴ = 1.6e-11 and a small factor; 16 times less at half the step.
    let end = cf4(&scenes::Handle {}, &handle(), &(), 0.0..10.0, 5000);
    arrives(&end, q, w);
    assert!((2.0 * scenes::Handle {}.kinetic_energy(&end) - number(&expected["2T"])).abs() < 1e-11);
    let momentum = scenes::Handle {}.angular_momentum(&end);
    assert!((momentum.norm_squared() - number(&expected["L^2"])).abs() < 1e-11);

    // A full tensor, falling: G and the attitude know nothing of each other.
    let start = Spatial {
        angular_velocity: handle().angular_velocity,
        velocity: Vector3::new(3.0, 4.0, 25.0),
        ..Spatial::default()
    };
    let thrown = cf4(&scenes::Thrown {}, &start, &(), 0.0..10.0, 5000);
    let turned = Rotation {
        attitude: thrown.attitude,
        angular_velocity: thrown.angular_velocity,
    };
    arrives(&turned, q, w);
    // Parabolas are exact: 5000 roundings of 490, on average.
    let fallen = Vector3::new(30.0, 40.0, 250.0 - 490.0);
    assert!((thrown.position - fallen).amax() < 1e-10);
}

#[test]
fn f11_handle_after_100_s() {
    let expected = statement("F11 torque-free (Dzhanibekov), t=100");
    // Five flips, each of which stretches the error of the phase: steps of 1 ms are needed for 1e-10.
    let end = cf4(&scenes::Handle {}, &handle(), &(), 0.0..100.0, 100_000);
    arrives(&end, &expected["q"], &expected["w"]);
    let momentum = scenes::Handle {}.angular_momentum(&end);
    assert!((momentum - Vector3::new(0.01, 2.0, 0.03)).amax() < 1e-10);
}

#[test]
fn free_asymmetric_body_after_10_s() {
    let given = trajectory("asymmetric_free");
    let [a, b, c] = reference::numbers(&given["I"]);
    let start = Rotation {
        angular_velocity: vector(&given["w0"]),
        ..Rotation::default()
    };
    let body = scenes::Described::new(scenes::DescribedParams { a, b, c }).unwrap();
    // Rates of 3 rad/s: (3 · 5e-4)⁴ = 5e-12 and a factor below 10.
    let end = cf4(
        &body,
        &start,
        &scenes::DescribedInput::default(),
        0.0..10.0,
        20_000,
    );
    arrives(&end, &given["at_T_10"]["q_ref"], &given["at_T_10"]["w_ref"]);
}

#[test]
fn axisymmetric_body_under_a_moment_along_its_axis() {
    let expected = statement("axisymmetric, torque along axis: closed form");
    let params = scenes::DescribedParams {
        a: 0.4,
        b: 0.4,
        c: 0.7,
    };
    let body = scenes::Described::new(params).unwrap();
    let start = Rotation {
        angular_velocity: Vector3::new(0.5, 0.0, 2.0),
        ..Rotation::default()
    };
    let input = scenes::DescribedInput { twist: 0.21 };
    // Rates of 3 rad/s: (3 · 1e-3)⁴ = 8e-11 over a hundred.
    let end = cf4(&body, &start, &input, 0.0..3.0, 3000);
    assert!((end.angular_velocity - vector(&expected["w(3)"])).amax() <= 1e-11);
}

#[test]
fn f12_regular_precession() {
    let expected = statement("F12 regular precession");
    let [i1, i3, momentum, tilt, spin, transverse] = [
        "I1",
        "I3",
        "M",
        "theta",
        "Omega3 (33.4)",
        "Omega1=(M/I1) sin th",
    ]
    .map(|name| number(&expected[name]));
    let start = Rotation {
        attitude: UnitQuaternion::from_axis_angle(&Vector3::x_axis(), tilt),
        angular_velocity: Vector3::new(0.0, transverse, spin),
    };
    let params = scenes::DescribedParams {
        a: i1,
        b: i1,
        c: i3,
    };
    let body = scenes::Described::new(params).unwrap();
    // M = 0.456 along the vertical; a few roundings.
    let vertical = Vector3::new(0.0, 0.0, momentum);
    assert!((body.angular_momentum(&start) - vertical).amax() < 1e-15);
    // h = 50 µs at rates of 37 rad/s: (1.9e-3)⁴ · 7 rad · about 1/100.
    let end = cf4(
        &body,
        &start,
        &scenes::DescribedInput::default(),
        0.0..0.2,
        4000,
    );
    let axis = end.attitude * Vector3::z();
    assert!((axis - vector(&expected["axis(t=0.2) closed"])).amax() < 1e-11);
    let closed = "q(0.2) closed = qz(Wpr t) qx(th) qz(psi t)";
    assert!(distance(&end.attitude, &attitude(&expected[closed])) < 1e-11);
}
