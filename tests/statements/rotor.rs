//! The rotor M6 of the theory on two bearings, through the macro.
//!
//! The expected numbers are those of the reference, in 40-digit arithmetic by two routes.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::prelude::*;

use crate::reference::{body, number, numbers, vector};

mod scenes {
    use newton_euler::rigid_body;

    rigid_body!(Rotor {
        motion: fixed_axis(a, body(0, 0, 1)),
        params: [
            m[kg],
            center = body(_, _, _)[m],
            xx,
            yy,
            zz,
            xy,
            yz,
            zx,
            z_a[m],
            z_b[m],
            g[m / s ^ 2]
        ],
        inputs: [torque[N * m]],
        mass: m,
        inertia: tensor {
            xx,
            yy,
            zz,
            xy,
            yz,
            zx
        },
        points: [a = body(0, 0, z_a) - center, b = body(0, 0, z_b) - center],
        fields: [weight = mass * world(0, -g, 0)],
        moments: [drive = body(0, 0, torque)],
        reactions: [in_a = body(_, _, _).at(a), in_b = body(_, _, 0).at(b)],
        outputs: [reactions, energy],
    });

    // as it is given: drawn from a point of the axis
    rigid_body!(Drawn {
        motion: fixed_axis(a, body(0, 0, 1)),
        inputs: [torque[N * m]],
        inertia: compose([
            point(4[kg]).at((0.001, 0.0005, 0.02)),
            point(3[kg]).at((0.08, -0.03, -0.05)),
            point(2.5[kg]).at((-0.06, 0.09, 0.07)),
            point(2[kg]).at((-0.05, -0.07, 0.11)),
            point(1.5[kg]).at((0.03, 0.02, -0.16)),
        ]),
        points: [a = (0, 0, -0.3), b = (0, 0, 0.25)],
        fields: [weight = mass * world(0, -9.80665[m / s ^ 2], 0)],
        moments: [drive = body(0, 0, torque)],
        reactions: [in_a = world(_, _, 0).at(a), in_b = world(_, _, _).at(b)],
        outputs: [reactions],
    });

    // held against the world: about an axis of coordinates the same unknowns
    rigid_body!(Coupled {
        motion: fixed_axis(a, world(0, 0, 1)),
        mass: 3[kg],
        inertia: products {
            xx: 0.05,
            yy: 0.06,
            zz: 0.07,
            xy: 0,
            yz: -0.0005,
            zx: 0.0012
        }[kg * m ^ 2],
        points: [a = (0, 0, -0.3), b = (0, 0, 0.25)],
        reactions: [in_a = world(_, _, 0).at(a), in_b = world(_, _, _).at(b)],
        outputs: [reactions],
    });
}
use scenes::{Coupled, Drawn, DrawnInput, Rotor, RotorInput, RotorParams};

/// One-shot algebra: 1e-13 of the largest term, which a sum of a dozen rounded terms leaves far below.
fn is(computed: f64, expected: f64, largest: f64) {
    let error = (computed - expected).abs();
    assert!(
        error <= 1e-13 * largest,
        "{computed} is not {expected}: off by {error:e}"
    );
}

fn is_vector(computed: Vector3<f64>, expected: Vector3<f64>, largest: f64) {
    for (computed, expected) in computed.iter().zip(&expected) {
        is(*computed, *expected, largest);
    }
}

fn expected(name: &str) -> serde_json::Value {
    body("M6")["expect"][name].take()
}

/// Mass, G, and the tensor about G, summed over the five points.
fn parameters() -> RotorParams {
    let given = body("M6")["given"].take();
    let list = given["points"].as_array().unwrap();
    let points = list.iter().map(numbers::<4>);
    let points: Vec<_> = points
        .map(|[m, x, y, z]| (m, Vector3::new(x, y, z)))
        .collect();
    let m: f64 = points.iter().map(|(m, _)| m).sum();
    let center = points.iter().map(|(m, r)| r * *m).sum::<Vector3<f64>>() / m;
    let about = |i: usize, j: usize| -> f64 {
        let entry = |(m, r): &(f64, Vector3<f64>)| {
            let r = r - center;
            let square = if i == j { r.norm_squared() } else { 0.0 };
            m * (square - r[i] * r[j])
        };
        points.iter().map(entry).sum()
    };
    RotorParams {
        m,
        center,
        xx: about(0, 0),
        yy: about(1, 1),
        zz: about(2, 2),
        xy: about(0, 1),
        yz: about(1, 2),
        zx: about(2, 0),
        z_a: number(&given["zA"]),
        z_b: number(&given["zB"]),
        g: number(&given["g"]),
    }
}

#[test]
fn two_bearings() {
    let parameters = parameters();
    assert_eq!(parameters.m, number(&expected("m")));
    is_vector(parameters.center, vector(&expected("G")), 0.02);

    let given = body("M6")["given"].take();
    let rotor = Rotor::new(parameters).unwrap();
    let state = Hinge {
        angle: number(&given["theta"]),
        angular_velocity: number(&given["omega"]),
    };
    let input = RotorInput {
        torque: number(&given["torque"]),
    };
    let alpha = rotor.acceleration(0.0, &state, &input);
    is(alpha, number(&expected("alpha")), 40.0);
    let twice = 2.0 * rotor.kinetic_energy(&state) / state.angular_velocity.powi(2);
    is(twice, number(&expected("Jzz(axis)")), 0.07);

    let reactions = rotor.reactions(0.0, &state, &input);
    let to_world = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), state.angle);
    // moments to 1000 N m at half a meter
    for (load, name) in [(reactions.in_a, "A"), (reactions.in_b, "B")] {
        let [x, y] = numbers(&expected(&format!("{name} world")));
        is_vector(load, Vector3::new(x, y, 0.0), 4000.0);
        let [x, y] = numbers(&expected(&format!("{name} body")));
        let in_body = to_world.inverse() * load;
        is_vector(in_body, Vector3::new(x, y, 0.0), 4000.0);
    }
}

#[test]
fn drawn_from_the_axis() {
    let given = body("M6")["given"].take();
    let state = Hinge {
        angle: number(&given["theta"]),
        angular_velocity: number(&given["omega"]),
    };
    let input = DrawnInput {
        torque: number(&given["torque"]),
    };
    let alpha = Drawn::default().acceleration(0.0, &state, &input);
    is(alpha, number(&expected("alpha")), 40.0);
    let reactions = Drawn::default().reactions(0.0, &state, &input);
    for (load, name) in [(reactions.in_a, "A world"), (reactions.in_b, "B world")] {
        let [x, y] = numbers(&expected(name));
        is_vector(load, Vector3::new(x, y, 0.0), 4000.0);
    }
}

#[test]
fn couple_alone() {
    let couple = body("M6")["couple_only"].take();
    let x = number(&couple["B_x=-A_x = -Jxz w^2/(zB-zA)"]);
    let y = number(&couple["B_y=-A_y = -Jyz w^2/(zB-zA)"]);
    let spinning = Hinge {
        angle: 0.0,
        angular_velocity: 157.0,
    };
    let reactions = Coupled::default().reactions(0.0, &spinning, &());
    is_vector(reactions.in_b, Vector3::new(x, y, 0.0), 60.0);
    is_vector(reactions.in_a, -Vector3::new(x, y, 0.0), 60.0);
    // it turns with the body
    let quarter = Hinge {
        angle: std::f64::consts::FRAC_PI_2,
        ..spinning
    };
    let reactions = Coupled::default().reactions(0.0, &quarter, &());
    is_vector(reactions.in_b, Vector3::new(-y, x, 0.0), 60.0);
}
