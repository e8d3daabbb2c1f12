//! The spatial statements F06 and F10 of the theory, through the macro.

use nalgebra::{Quaternion, Vector3};
use newton_euler::{inertia::InvalidInertia, prelude::*};

use crate::reference::{attitude, completed, number, numbers, statement, vector};

/// One-shot algebra: 1e-13 of the largest term.
fn is(computed: &Vector3<f64>, expected: &Vector3<f64>, largest: f64) {
    let error = (computed - expected).amax();
    assert!(
        error <= 1e-13 * largest,
        "{computed} is not {expected}: off by {error:e}"
    );
}

/// F06: turning about z with products of inertia.
mod unbalanced {
    newton_euler::rigid_body!(Rotor {
        motion: spatial,
        params: [zx = 0.013, yz = -0.0075, zz = 0.21],
        mass: 3[kg],
        inertia: products {
            xx: 0.15,
            yy: 0.17,
            zz: zz,
            xy: 0.02,
            yz: yz,
            zx: zx
        }[kg * m ^ 2],
        outputs: [balance],
    });

    newton_euler::rigid_body!(Shaft {
        motion: rotation,
        inertia: tensor {
            xx: 0.15,
            yy: 0.17,
            zz: 0.21,
            xy: -0.02,
            yz: 0.0075,
            zx: -0.013
        }[kg * m ^ 2],
        outputs: [balance],
    });
}

#[test]
fn f06_moment_of_an_unbalanced_rotor() {
    let expected = statement("F06 rotation about z with products: M_i");
    let [zx, yz, zz, rate, alpha] =
        ["Jxz", "Jyz", "Jzz", "wz", "alphaz"].map(|name| number(&expected[name]));
    let names = [
        "M_ix = Jxz a - Jyz w^2",
        "M_iy = Jyz a + Jxz w^2",
        "M_iz=-Jzz a",
    ];
    let stated = Vector3::from(names.map(|name| number(&expected[name])));
    let [angular_velocity, angular] = [rate, alpha].map(|z| Vector3::new(0.0, 0.0, z));

    let rotor = unbalanced::Rotor::new(unbalanced::RotorParams { zx, yz, zz }).unwrap();
    let state = Spatial {
        angular_velocity,
        ..Spatial::default()
    };
    let acceleration = SpatialAcceleration {
        angular,
        ..SpatialAcceleration::default()
    };
    let wrench = rotor.residual(0.0, &state, &acceleration, &(), &());
    is(&wrench.moment, &stated, 21.0);
    assert_eq!(wrench.force, Vector3::zeros());

    let state = Rotation {
        angular_velocity,
        ..Rotation::default()
    };
    is(
        &unbalanced::Shaft {}.residual(0.0, &state, &angular, &(), &()),
        &stated,
        21.0,
    );

    // The supports of the turned rotor carry the same moment, turned.
    let turned = Rotation {
        attitude: attitude(&statement("F10 six scalar equations")["q"]),
        ..state
    };
    let moment = unbalanced::Shaft {}.residual(0.0, &turned, &angular, &(), &());
    is(&moment, &(turned.attitude * stated), 21.0);
}

/// F10, its loads as numbers, as parameters and as inputs; and the bare body.
mod six {
    newton_euler::rigid_body!(Baked {
        motion: spatial,
        mass: 3.2[kg],
        inertia: tensor {
            xx: 1.3,
            yy: 1.7,
            zz: 2.1,
            xy: -0.12,
            yz: -0.05,
            zx: 0.07
        }[kg * m ^ 2],
        points: [nozzle = (0.1, -0.2, 0.05)],
        forces: [thrust = body(4, -2.5, 10)[N].at(nozzle)],
        fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
        moments: [couple = world(0.3, 0.1, -0.4)[N * m]],
        outputs: [energy, momentum, balance],
    });

    newton_euler::rigid_body!(Parametric {
        motion: spatial,
        params: [
            m = 3.2[kg],
            xx = 1.3,
            yy = 1.7,
            zz = 2.1,
            xy = -0.12,
            yz = -0.05,
            zx = 0.07,
            at = body(0.1, -0.2, 0.05)[m],
            push = body(4, -2.5, 10)[N],
            twist = world(0.3, 0.1, -0.4)[N * m],
        ],
        mass: m,
        inertia: tensor {
            xx: xx,
            yy: yy,
            zz: zz,
            xy: xy,
            yz: yz,
            zx: zx
        },
        points: [nozzle = at],
        forces: [thrust = push.at(nozzle)],
        fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
        moments: [couple = twist],
        outputs: [energy, momentum, balance],
    });

    newton_euler::rigid_body!(Driven {
        motion: spatial,
        inputs: [
            push = body(_, _, _)[N],
            twist = world(_, _, _)[N * m],
            gravity = world(_, _, _)[m / s ^ 2],
        ],
        mass: 3.2[kg],
        inertia: products {
            xx: 1.3,
            yy: 1.7,
            zz: 2.1,
            xy: 0.12,
            yz: 0.05,
            zx: -0.07
        }[kg * m ^ 2],
        points: [nozzle = (0.1, -0.2, 0.05)],
        forces: [thrust = push.at(nozzle)],
        fields: [weight = mass * gravity],
        moments: [couple = twist],
        outputs: [energy, momentum, balance],
    });

    newton_euler::rigid_body!(Bare {
        motion: spatial,
        mass: 3.2[kg],
        inertia: tensor {
            xx: 1.3,
            yy: 1.7,
            zz: 2.1,
            xy: -0.12,
            yz: -0.05,
            zx: 0.07
        }[kg * m ^ 2],
        outputs: [balance],
    });
}

fn state() -> Spatial {
    let given = statement("F10 six scalar equations");
    Spatial {
        position: Vector3::new(100.0, -20.0, 3.0),
        attitude: attitude(&given["q"]),
        velocity: Vector3::zeros(),
        angular_velocity: vector(&given["w body"]),
    }
}

fn input() -> six::DrivenInput {
    let given = statement("F10 six scalar equations");
    six::DrivenInput {
        push: vector(&given["body force"]),
        twist: vector(&given["world couple"]),
        gravity: Vector3::new(0.0, 0.0, -9.80665),
    }
}

#[test]
fn f10_accelerations() {
    let expected = statement("F10 six scalar equations");
    let all = [
        six::Baked {}.acceleration(0.0, &state(), &()),
        six::Parametric::default().acceleration(0.0, &state(), &()),
        six::Driven {}.acceleration(0.0, &state(), &input()),
    ];
    for computed in all {
        // Terms: forces to 31 N over 3.2 kg, moments to 8 N m over 1.3 kg m².
        is(&computed.linear, &vector(&expected["a world"]), 10.0);
        is(&computed.angular, &vector(&expected["alpha body"]), 6.2);
    }
    for (computed, residual) in [
        (
            all[0],
            six::Baked {}.residual(0.0, &state(), &all[0], &(), &()),
        ),
        (
            all[1],
            six::Parametric::default().residual(0.0, &state(), &all[1], &(), &()),
        ),
        (
            all[2],
            six::Driven {}.residual(0.0, &state(), &all[2], &(), &input()),
        ),
    ] {
        assert!(
            residual.force.amax() <= 1e-13 * 31.0,
            "{computed:?}: {residual:?}"
        );
        assert!(
            residual.moment.amax() <= 1e-13 * 8.0,
            "{computed:?}: {residual:?}"
        );
    }
}

#[test]
fn f10_energy_momentum_and_rate_of_the_attitude() {
    let expected = statement("F10 six scalar equations");
    let state = state();
    let twice = 2.0 * number(&expected["T_rot"]);
    for energy in [
        six::Baked {}.kinetic_energy(&state),
        six::Parametric::default().kinetic_energy(&state),
        six::Driven {}.kinetic_energy(&state),
    ] {
        assert!((2.0 * energy - twice).abs() <= 1e-13 * 10.2); // largest term 2.1 · 2.2²
    }
    for momentum in [
        six::Baked {}.angular_momentum(&state),
        six::Parametric::default().angular_momentum(&state),
        six::Driven {}.angular_momentum(&state),
    ] {
        is(&momentum, &vector(&expected["L world"]), 5.5);
    }
    // q' = q (0, ω) / 2, the rate at which the integrator turns the body: a displacement so small that its square is
    // below the rounding of the quotient, 1e-16 / 1e-7.
    let acceleration = six::Baked {}.acceleration(0.0, &state, &());
    let moved = |h: f64| {
        *state
            .moved(&(state.rate(&acceleration) * h))
            .attitude
            .quaternion()
    };
    let rate: Quaternion<f64> = (moved(1e-7) - moved(-1e-7)) / 2e-7;
    let [w, x, y, z] = numbers(&expected["qdot"]);
    assert!((rate - Quaternion::new(w, x, y, z)).norm() < 1e-8);
}

#[test]
fn f10_inertial_moment() {
    let expected = statement("F10 six scalar equations");
    let state = state();
    // Without loads the residual is the inertial wrench; M_i is given in body axes.
    let acceleration = SpatialAcceleration {
        linear: vector(&expected["a world"]),
        angular: vector(&expected["alpha body"]),
    };
    let wrench = six::Bare {}.residual(0.0, &state, &acceleration, &(), &());
    is(
        &(state.attitude.inverse() * wrench.moment),
        &vector(&expected["M_i full"]),
        10.0,
    );
    is(&wrench.force, &(vector(&expected["a world"]) * -3.2), 24.0);
}

/// Section 1.2, the worked example: `M_i` with an angular acceleration.
#[test]
fn worked_example_of_the_completed_equation() {
    let expected = completed()["worked example"].take();
    let [w, dw] = [["wx", "wy", "wz"], ["ax", "ay", "az"]]
        .map(|names| Vector3::from(names.map(|name| number(&expected["inputs"][name]))));
    let state = Spatial {
        angular_velocity: w,
        ..Spatial::default()
    };
    let acceleration = SpatialAcceleration {
        angular: dw,
        linear: Vector3::new(1.0, 2.0, 3.0),
    };
    let wrench = six::Bare {}.residual(0.0, &state, &acceleration, &(), &());
    is(&wrench.moment, &vector(&expected["M_i full"]), 10.0);
    is(&wrench.force, &Vector3::new(-3.2, -6.4, -9.6), 9.6);
    // The printed equation is told apart.
    assert!((wrench.moment - vector(&expected["M_i printed decimal"])).amax() > 0.3);
}

/// F08, the bounds at which a body is possible, for parameters.
mod bounded {
    newton_euler::rigid_body!(Principal {
        motion: rotation,
        params: [a, b, c],
        inertia: principal(a, b, c),
    });

    newton_euler::rigid_body!(WithProduct {
        motion: rotation,
        params: [xy],
        inertia: products {
            xx: 1,
            yy: 1,
            zz: 1,
            xy: xy,
            yz: 0,
            zx: 0
        },
    });
}

#[test]
fn f08_which_inertias_are_possible() {
    let body = |a, b, c| bounded::Principal::new(bounded::PrincipalParams { a, b, c });
    assert!(body(1.0, 2.0, 3.0).is_ok());
    assert!(body(0.1, 0.2, 0.1 + 0.2).is_ok());
    let triangle = InvalidInertia::Triangle {
        axis: "z",
        moment: 2.5,
        others: 2.0,
    };
    assert_eq!(
        body(1.0, 1.0, 2.5).unwrap_err(),
        InvalidBody::Inertia(triangle)
    );
    assert!(matches!(
        body(1.0, f64::NAN, 1.0),
        Err(InvalidBody::NotFinite { name: "b", .. })
    ));
    // |Jxy| <= Jzz / 2
    let body = |xy| bounded::WithProduct::new(bounded::WithProductParams { xy });
    assert!(body(0.5).is_ok());
    assert!(body(-0.5).is_ok());
    assert!(matches!(body(0.6), Err(InvalidBody::Inertia(_))));
    assert!(matches!(body(-0.6), Err(InvalidBody::Inertia(_))));
}
