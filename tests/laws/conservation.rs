//! What a motion conserves, and what changes it if it is not conserved.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

use nalgebra::{UnitQuaternion, Vector2, Vector3};
use newton_euler::{integrate::cf4, prelude::*};

mod scenes {
    newton_euler::rigid_body!(Plank {
        motion: spatial,
        mass: 2.5,
        inertia: tensor {
            xx: 1.3,
            yy: 1.7,
            zz: 2.1,
            xy: -0.12,
            yz: -0.05,
            zx: 0.07
        },
        fields: [
            weight = mass * world(0, 0, -9.80665),
            // a uniform field on a charge off the center: a moment that depends on the attitude
            electric = world(3, -2, 4).at((0.3, -0.4, 0.2)),
        ],
        outputs: [energy, momentum],
    });

    newton_euler::rigid_body!(Free {
        motion: spatial,
        mass: 2.5,
        inertia: tensor {
            xx: 1.3,
            yy: 1.7,
            zz: 2.1,
            xy: -0.12,
            yz: -0.05,
            zx: 0.07
        },
        pole: world(1, 2, 3),
        outputs: [energy, momentum],
    });

    newton_euler::rigid_body!(Thrown {
        motion: planar,
        mass: 2.5,
        inertia: 0.8,
        fields: [
            weight = mass * world(0, -9.80665),
            electric = world(3, -2).at((0.3, -0.4))
        ],
        outputs: [energy, momentum],
    });

    newton_euler::rigid_body!(Compass {
        motion: rotation,
        inertia: principal(1.3, 1.7, 2.1),
        fields: [electric = world(3, -2, 4).at((0.3, -0.4, 0.2))],
        outputs: [energy],
    });

    newton_euler::rigid_body!(Handle {
        motion: spatial,
        mass: 2.5,
        inertia: principal(1, 2, 3),
        fields: [weight = mass * world(0, 0, -9.80665)],
    });

    newton_euler::rigid_body!(Symmetric {
        motion: rotation,
        inertia: principal(2, 3, 2),
    });

    newton_euler::rigid_body!(Driven {
        motion: spatial,
        inputs: [thrust, tilt],
        mass: 2.5,
        inertia: tensor {
            xx: 1.3,
            yy: 1.7,
            zz: 2.1,
            xy: -0.12,
            yz: -0.05,
            zx: 0.07
        },
        points: [
            tail = (-0.6, 0.1, -0.2),
            hook = (0.3, 0, 0.5),
            peg = world(1, 2, -1)
        ],
        fields: [
            weight = mass * world(tilt, 0, -9.80665),
            shaken = (world(1, 0, 2) * (3 * t).sin()).at(hook),
            // where it acts is not fixed in the body: no potential
            streaming = world(0.5, -1, 0.25).at(peg),
        ],
        forces: [
            jet = body(0, 0, thrust).at(tail),
            drag = (-0.8 * tail.velocity().norm() * tail.velocity()).at(tail),
            spring = (12 * (peg.position() - hook.position())).at(hook),
        ],
        moments: [
            damped = -0.3 * angular_velocity,
            beaten = world(0, 0, 1[N * m]) * (2 * t).cos()
        ],
        pole: hook,
        outputs: [energy, momentum, balance],
    });
}

fn launched() -> Spatial {
    Spatial {
        position: Vector3::new(0.5, -1.0, 2.0),
        attitude: UnitQuaternion::from_scaled_axis(Vector3::new(0.4, -0.3, 1.1)),
        velocity: Vector3::new(3.0, 4.0, 5.0),
        angular_velocity: Vector3::new(1.5, -0.8, 2.2),
    }
}

/// The drift over a run and over one of twice as many steps: one of order four falls sixteenfold, by at least eight
/// before rounding is reached.
fn shrinks(drift: impl Fn(usize) -> f64, steps: usize, bound: f64) {
    let [coarse, fine] = [steps, 2 * steps].map(|steps| drift(steps).abs());
    assert!(fine <= bound, "drifts by {fine:e}");
    assert!(
        fine <= coarse / 8.0 || fine < 1e-13 * 200.0,
        "{coarse:e}, then {fine:e}"
    );
}

#[test]
fn energy_of_a_thrown_body() {
    let total = |state: &Spatial| {
        scenes::Plank {}.kinetic_energy(state) + scenes::Plank {}.potential_energy(0.0, state, &())
    };
    let start = launched();
    let drift =
        |steps| total(&cf4(&scenes::Plank {}, &start, &(), 0.0..5.0, steps)) - total(&start);
    // Rates to 4 rad/s at steps of 5 ms: (0.02)⁴ = 1.6e-7 of 10 J over a hundred.
    shrinks(drift, 500, 1e-8);
    // Kinetic and potential energy exchange hundreds of joules meanwhile.
    let end = cf4(&scenes::Plank {}, &start, &(), 0.0..5.0, 1000);
    assert!(
        (scenes::Plank {}.kinetic_energy(&end) - scenes::Plank {}.kinetic_energy(&start)).abs()
            > 100.0
    );
}

#[test]
fn energy_in_the_plane() {
    let body = scenes::Thrown {};
    let total =
        |state: &Planar| body.kinetic_energy(state) + body.potential_energy(0.0, state, &());
    let start = Planar {
        position: Vector2::new(0.5, 2.0),
        angle: 0.4,
        velocity: Vector2::new(3.0, 5.0),
        angular_velocity: 2.2,
    };
    let drift = |steps| total(&cf4(&body, &start, &(), 0.0..5.0, steps)) - total(&start);
    shrinks(drift, 250, 1e-8); // as above
}

#[test]
fn energy_of_a_body_that_only_turns() {
    let body = scenes::Compass {};
    let total =
        |state: &Rotation| body.kinetic_energy(state) + body.potential_energy(0.0, state, &());
    let start = Rotation {
        attitude: launched().attitude,
        angular_velocity: launched().angular_velocity,
    };
    let drift = |steps| total(&cf4(&body, &start, &(), 0.0..5.0, steps)) - total(&start);
    shrinks(drift, 500, 1e-8); // as above
}

#[test]
fn momenta_of_a_free_body() {
    let (body, start) = (scenes::Free {}, launched());
    let end = |steps| cf4(&body, &start, &(), 0.0..10.0, steps);
    // No force at all: not one bit of the velocity changes.
    assert_eq!(end(100).velocity, start.velocity);
    assert_eq!(
        body.linear_momentum(&end(100)),
        body.linear_momentum(&start)
    );
    let of_spin = |s: &Spatial| body.angular_momentum(s);
    let about_pole = |s: &Spatial| body.angular_momentum_about_pole(0.0, s);
    let turned = |steps| (of_spin(&end(steps)) - of_spin(&start)).norm();
    shrinks(turned, 1000, 1e-8); // rates of 3 rad/s at steps of 5 ms
    shrinks(
        |steps| (about_pole(&end(steps)) - about_pole(&start)).norm(),
        1000,
        1e-8,
    );
    shrinks(
        |steps| body.kinetic_energy(&end(steps)) - body.kinetic_energy(&start),
        1000,
        1e-8,
    );
    // In the body the momentum did turn.
    let in_body = |s: &Spatial| s.attitude.inverse() * of_spin(s);
    assert!((in_body(&end(1000)) - in_body(&start)).norm() > 1.0);
}

/// H8b: rounding must not excite a flip, so what is zero stays zero, exactly.
#[test]
fn exact_zeros_stay() {
    let start = Spatial {
        attitude: UnitQuaternion::from_scaled_axis(Vector3::new(0.4, -0.3, 1.1)),
        angular_velocity: Vector3::y(),
        ..Spatial::default()
    };
    // The unstable axis for 1000 s; a component of 1e-16 grows to one in 64 s.
    let end = cf4(&scenes::Handle {}, &start, &(), 0.0..1000.0, 100_000);
    assert_eq!(end.angular_velocity, Vector3::y());
    // Nothing pushes sideways either.
    assert_eq!([end.position.x, end.position.y], [0.0, 0.0]);
    assert_eq!([end.velocity.x, end.velocity.y], [0.0, 0.0]);
    // One that is not quite zero flips indeed.
    let near = Spatial {
        angular_velocity: Vector3::new(1e-16, 1.0, 0.0),
        ..start
    };
    let mut flipped = false;
    let mut state = near;
    for second in 0..100_u32 {
        let from = f64::from(second);
        state = cf4(&scenes::Handle {}, &state, &(), from..from + 1.0, 100);
        flipped |= state.angular_velocity.y < 0.0;
    }
    assert!(flipped);
}

/// The axial rate of a symmetric body is constant to the bit.
#[test]
fn axial_rate_is_constant() {
    let start = Rotation {
        angular_velocity: Vector3::new(0.3, 1.7, -0.4),
        ..Rotation::default()
    };
    let end = cf4(&scenes::Symmetric {}, &start, &(), 0.0..100.0, 10_000);
    assert_eq!(end.angular_velocity.y, 1.7);
    assert_ne!(end.angular_velocity.x, 0.3);
}

/// dE/dt = ∂U/∂t at fixed state + power of the loads that are no uniform field on a point of the body.
#[test]
fn general_law_of_energy() {
    let body = scenes::Driven {};
    let input = scenes::DrivenInput {
        thrust: 30.0,
        tilt: 0.7,
    };
    let total = |t: f64, s: &Spatial| body.kinetic_energy(s) + body.potential_energy(t, s, &input);
    // Written by hand: the power of the jet, the drag, the spring, the stream and the moments.
    let power = |t: f64, s: &Spatial| {
        let (q, v, w) = (s.attitude, s.velocity, s.angular_velocity);
        let of = |r: Vector3<f64>| v + q * w.cross(&r);
        let [tail, hook] = [[-0.6, 0.1, -0.2], [0.3, 0.0, 0.5]].map(Vector3::from);
        let jet = (q * Vector3::new(0.0, 0.0, 30.0)).dot(&of(tail));
        let drag = -0.8 * of(tail).norm().powi(3);
        let stretch = Vector3::new(1.0, 2.0, -1.0) - s.position - q * hook;
        let spring = stretch.dot(&of(hook)) * 12.0;
        let stream = Vector3::new(0.5, -1.0, 0.25);
        let at_peg = v + (q * w).cross(&(Vector3::new(1.0, 2.0, -1.0) - s.position));
        jet + drag + spring + stream.dot(&at_peg) - 0.3 * w.norm_squared()
            + (2.0 * t).cos() * (q * w).z
    };
    // U = -m (tilt, 0, -g) · r_G - sin 3t (1, 0, 2) · r_hook
    let change_of_potential = |t: f64, s: &Spatial| {
        let hook = s.position + s.attitude * Vector3::new(0.3, 0.0, 0.5);
        -3.0 * (3.0 * t).cos() * Vector3::new(1.0, 0.0, 2.0).dot(&hook)
    };
    let (mut state, mut largest) = (launched(), 0.0_f64);
    for tenth in 0..50_u32 {
        let t = f64::from(tenth) / 10.0;
        let later = |h: f64| total(t + h, &cf4(&body, &state, &input, t..t + h, 4));
        // A difference of order four at h = 2 ms: h⁴ / 30 times a fifth derivative, rates of 10 1/s and 300 J: 2e-5;
        // rounding 300 · 1e-16 / h = 1e-11.
        let h = 2e-3;
        let rate = (8.0 * (later(h) - later(-h)) - (later(2.0 * h) - later(-2.0 * h))) / (12.0 * h);
        let expected = change_of_potential(t, &state) + power(t, &state);
        assert!(
            (rate - expected).abs() < 2e-5,
            "at {t}: {rate} is not {expected}"
        );
        largest = largest.max(expected.abs());
        state = cf4(&body, &state, &input, t..t + 0.1, 20);
    }
    assert!(largest > 30.0);
}

/// `dP/dt = F`, `dL_G/dt = K` and `dL_O/dt = M_O - v_O × P` along the driven motion.
#[test]
fn rates_of_the_momenta() {
    let body = scenes::Driven {};
    let input = scenes::DrivenInput {
        thrust: 30.0,
        tilt: 0.7,
    };
    let mut state = launched();
    for tenth in 0..20_u32 {
        let t = f64::from(tenth) / 10.0;
        let h = 2e-3;
        let at = |h: f64| cf4(&body, &state, &input, t..t + h, 4);
        let rate = |f: &dyn Fn(&Spatial) -> Vector3<f64>| {
            let difference = |h: f64| f(&at(h)) - f(&at(-h));
            (difference(h) * 8.0 - difference(2.0 * h)) / (12.0 * h)
        };
        let wrench = body.applied(t, &state, &input);
        // As above, with momenta to 30 kg m/s, and to a few kg m²/s whose fifth derivatives are larger.
        let force = rate(&|s| body.linear_momentum(s));
        assert!((force - wrench.force).amax() < 2e-6, "at {t}: {force}");
        let moment = rate(&|s| body.angular_momentum(s));
        assert!((moment - wrench.moment).amax() < 2e-6, "at {t}: {moment}");
        // About the hook, which moves: dL_O/dt = M_O - v_O × P.
        let about_hook = rate(&|s| body.angular_momentum_about_pole(t, s));
        let arm = state.attitude * -Vector3::new(0.3, 0.0, 0.5);
        let v_o = state.velocity - (state.attitude * state.angular_velocity).cross(&arm);
        let m_o = wrench.moment + arm.cross(&wrench.force);
        let expected = m_o - v_o.cross(&(state.velocity * 2.5));
        assert!(
            (about_hook - expected).amax() < 1e-5,
            "at {t}: {about_hook}"
        );
        state = cf4(&body, &state, &input, t..t + 0.1, 20);
    }
}
