//! Constraints over time: projection, inconsistent states, singular configurations; and the same
//! body derived in two ways.

use nalgebra::{Rotation2, Vector2};
use newton_euler::integrate::{self, IntegrationError};
use newton_euler::prelude::*;
use proptest::prelude::*;

const GRAVITY: f64 = 9.80665;

/// A compound pendulum: its pin as a constraint, and as a support.
mod pendulum {
    newton_euler::rigid_body!(Constrained {
        motion: planar,
        mass: 2[kg],
        inertia: 0.3[kg * m ^ 2],
        points: [pin = (0.2, 0.5)[m]],
        fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
        constraints: [held = pin.position()],
        reactions: [hinge = world(_, _).at(pin)],
        outputs: [reactions, energy, balance],
    });

    newton_euler::rigid_body!(Supported {
        motion: pivot(pin),
        mass: 2[kg],
        inertia: 0.3[kg * m ^ 2],
        points: [pin = (0.2, 0.5)[m]],
        fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
        reactions: [hinge = world(_, _).at(pin)],
        outputs: [reactions],
    });
}

fn hanging(angle: f64, rate: f64) -> Planar {
    let center = Rotation2::new(angle) * Vector2::new(-0.2, -0.5);
    Planar {
        position: center,
        angle,
        velocity: Vector2::new(-center.y, center.x) * rate,
        angular_velocity: rate,
    }
}

proptest! {
    /// To 1e-13 of the weight and the centrifugal force: twice some twenty roundings.
    #[test]
    fn a_pin_is_a_constraint_and_a_support(angle in -4.0..4.0, rate in -5.0..5.0) {
        let constrained = pendulum::Constrained::default();
        let state = hanging(angle, rate);
        let hinge = Hinge { angle, angular_velocity: rate };
        let supported = pendulum::Supported::default();
        let size = GRAVITY + rate * rate;
        let acceleration = constrained.acceleration(0.0, &state, &());
        prop_assert!((acceleration.angular - supported.acceleration(0.0, &hinge, &())).abs() < 1e-13 * size);
        let reactions = constrained.reactions(0.0, &state, &()).unwrap();
        let expected = supported.reactions(0.0, &hinge, &()).hinge;
        prop_assert!((reactions.hinge - expected).norm() < 2e-13 * size);
        let residual = constrained.residual(0.0, &state, &acceleration, &reactions, &());
        prop_assert!(residual.force.norm() < 1e-13 * size && residual.moment.abs() < 1e-13 * size);
    }

    /// Wherever it starts, the nearest consistent state is found; and what is consistent is left alone.
    #[test]
    fn projection_reaches_the_constraints(
        angle in -3.0..3.0, x in -0.2..0.2, y in -0.2..0.2, rate in -2.0..2.0,
    ) {
        let body = pendulum::Constrained::default();
        let mut state = hanging(angle, rate);
        state.position += Vector2::new(x, y);
        state.velocity += Vector2::new(y, x);
        body.project(0.0, &mut state, &()).unwrap();
        for violation in body.violations(0.0, &state, &()) {
            prop_assert!(violation.position.unwrap().abs() < 1e-15);
            prop_assert!(violation.velocity.abs() < 4e-15);
        }
        let before = state;
        body.project(0.0, &mut state, &()).unwrap();
        prop_assert!((state.position - before.position).norm() < 1e-15);
        prop_assert!((state.velocity - before.velocity).norm() < 4e-15);
    }
}

fn gap(body: &pendulum::Constrained, state: &Planar) -> f64 {
    let violations = body.violations(0.0, state, &());
    violations
        .iter()
        .map(|violation| violation.position.unwrap().abs())
        .fold(0.0, f64::max)
}

/// H15: what is kept in its second derivative alone drifts away; the limit with projection is 1e-12.
#[test]
fn without_projection_constraints_drift() {
    let body = pendulum::Constrained::default();
    let start = hanging(1.5, 0.0);
    let energy =
        |state: &Planar| body.kinetic_energy(state) + body.potential_energy(0.0, state, &());
    let free = integrate::cf4(&body, &start, &(), 0.0..100.0, 10_000);
    assert!(gap(&body, &free) > 1e-6);
    let kept = integrate::cf4_projected(&body, &start, &(), 0.0..100.0, 10_000).unwrap();
    assert!(gap(&body, &kept) < 1e-15);
    // what is left is the dissipation of the method, 1e-6 J here; the gap made it 3e-3 J
    assert!((energy(&kept) - energy(&start)).abs() < 1e-5);
    assert!((energy(&free) - energy(&start)).abs() > 1e-4);
}

/// The order of the method is that without constraints: half the step, a sixteenth of the error.
#[test]
fn projection_keeps_the_order() {
    let (body, supported) = (
        pendulum::Constrained::default(),
        pendulum::Supported::default(),
    );
    let hinge = Hinge {
        angle: 1.5,
        angular_velocity: 0.0,
    };
    let exact = integrate::cf4(&supported, &hinge, &(), 0.0..2.0, 20_000).angle;
    let error = |steps: usize| {
        let end = integrate::cf4_projected(&body, &hanging(1.5, 0.0), &(), 0.0..2.0, steps);
        (end.unwrap().angle - exact).abs()
    };
    let ratio = error(400) / error(800);
    assert!((13.0..19.0).contains(&ratio), "{ratio}");
}

newton_euler::rigid_body!(Disc {
    doc: "An eccentric disc that rolls.",
    motion: planar,
    params: [radius = 0.3[m], offset = 0.1[m]],
    mass: 2[kg],
    inertia: 0.05[kg * m ^ 2],
    points: [
        center = (offset, 0),
        contact = center - radius * world(0, 1)
    ],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    constraints: [
        height = center.position().in_world().y - radius,
        rolling = contact.velocity().in_world().x,
    ],
    reactions: [ground = world(_, _).at(contact)],
    outputs: [reactions, energy],
});

/// Lagrange: `I = J + m (R^2 + e^2 - 2 R e sin)`, `I angle'' = m e cos (g + R w^2)`.
#[test]
fn an_eccentric_disc_rolls() {
    let (disc, angle, rate) = (Disc::default(), 0.4_f64, -3.0);
    let (sine, cosine) = angle.sin_cos();
    let state = Planar {
        position: Vector2::new(1.0, 0.3) - Vector2::new(cosine, sine) * 0.1,
        angle,
        velocity: Vector2::new(-0.3 + 0.1 * sine, -0.1 * cosine) * rate,
        angular_velocity: rate,
    };
    let about_contact = 0.05 + 2.0 * (0.09 + 0.01 - 0.06 * sine);
    let angular = 2.0 * 0.1 * cosine * (GRAVITY + 0.3 * rate * rate) / about_contact;
    let acceleration = disc.acceleration(0.0, &state, &());
    assert!((acceleration.angular - angular).abs() < 1e-12);
    let ground = disc.reactions(0.0, &state, &()).unwrap().ground;
    let needed = acceleration.linear * 2.0 + Vector2::new(0.0, 2.0 * GRAVITY);
    assert!((ground - needed).norm() < 1e-12);

    let energy =
        |state: &Planar| disc.kinetic_energy(state) + disc.potential_energy(0.0, state, &());
    let later = integrate::cf4_projected(&disc, &state, &(), 0.0..5.0, 2000).unwrap();
    assert!((energy(&later) - energy(&state)).abs() < 1e-8);
    // it has rolled: the center is where the angle says
    let center = later.position + Rotation2::new(later.angle) * Vector2::new(0.1, 0.0);
    assert!((center.x - (1.0 - 0.3 * (later.angle - angle))).abs() < 1e-8);
}

newton_euler::rigid_body!(Wheel {
    doc: "The disc of any size.",
    motion: planar,
    params: [radius = 0.3[m]],
    mass: 2[kg],
    inertia: mass * radius.powi(2) / 3,
    points: [
        center = (radius / 3, 0),
        contact = center - radius * world(0, 1)
    ],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    constraints: [
        height = center.position().in_world().y - radius,
        rolling = contact.velocity().in_world().x,
    ],
    reactions: [ground = world(_, _).at(contact)],
});

/// A wheel at an angle where it rolls so fast.
fn rolling(radius: f64, angle: f64, rate: f64) -> (Wheel, Planar) {
    let offset = radius / 3.0;
    let wheel = Wheel::new(WheelParams { radius }).unwrap();
    let lever = Rotation2::new(angle) * Vector2::new(offset, 0.0);
    let state = Planar {
        position: Vector2::new(7.0 * radius, radius) - lever,
        angle,
        velocity: Vector2::new(-radius * rate + lever.y * rate, -lever.x * rate),
        angular_velocity: rate,
    };
    (wheel, state)
}

/// At any scale: what is rounded is a start, what is further off is an error that says what and by how much, and is none when projected.
#[test]
fn a_start_that_is_off_is_an_error() {
    for radius in [0.3, 1e-9, 4e7] {
        for (angle, rate) in [(0.4, -3.0), (100.0, 1e-12), (-2.0, 1e9), (1.0, 0.0)] {
            let (wheel, state) = rolling(radius, angle, rate);
            let time = 1e-3 / (1.0 + f64::abs(rate));
            let integrate = |state: &Planar| wheel.integrate(state).to(time);
            assert!(wheel.check(0.0, &state, &()).is_ok() && integrate(&state).is_ok());

            for part in [1.0 / 30.0, -1e-10] {
                let mut off = state;
                off.position.y += part * radius;
                let Err(IntegrationError::Inconsistent {
                    time: 0.0,
                    state: kept,
                    violated,
                }) = integrate(&off)
                else {
                    panic!("{radius} {angle} {rate} {part}");
                };
                assert!(kept == off && violated.constraint == "height" && violated.is_start);
                assert!(!violated.is_velocity);
                assert!((violated.violation / (part * radius) - 1.0).abs() < 1e-4);
                let alone = integrate::cf4_projected(&wheel, &off, &(), 0.0..time, 1);
                assert_eq!(alone.unwrap_err(), violated);
                wheel.project(0.0, &mut off, &()).unwrap();
                assert!(integrate(&off).is_ok());

                let mut off = state;
                let speed = part * radius * f64::max(rate.abs(), 1e-3);
                off.velocity.x += speed;
                let violated = wheel.check(0.0, &off, &()).unwrap_err();
                assert!(violated.constraint == "rolling" && violated.is_velocity);
                assert!((violated.violation / speed - 1.0).abs() < 1e-4);
                assert!(integrate(&off).is_err());
                wheel.project(0.0, &mut off, &()).unwrap();
                assert!(integrate(&off).is_ok());
            }
        }
    }
    let (wheel, mut state) = rolling(0.3, 0.4, -3.0);
    state.position.y += 0.01;
    let error = wheel.integrate(&state).to(1.0).unwrap_err();
    let expected =
        "at 0 s: inconsistent start: `height` is off by 0.01 in position; `project` finds";
    assert!(error.to_string().starts_with(expected), "{error}");
}

newton_euler::rigid_body!(Spindle {
    doc: "A rotor whose center of mass is held at the origin.",
    motion: planar,
    mass: 2[kg],
    inertia: 0.05[kg * m ^ 2],
    constraints: [held = position],
    reactions: [bearing = world(_, _)],
});

/// What is zero but for the rounding of what it is computed from, is rounding, though all terms are that small.
#[test]
fn dust_is_rounding() {
    let dust = Vector2::new(6e-17, -1e-16);
    let start = Planar {
        position: dust,
        angle: 0.3,
        velocity: dust * 10.0,
        angular_velocity: 10.0,
    };
    assert!(Spindle::default().integrate(&start).to(1.0).is_ok());
    let still = Planar {
        angular_velocity: 0.0,
        ..start
    };
    let violated = Spindle::default().check(0.0, &still, &()).unwrap_err();
    assert!(violated.is_velocity);
}

newton_euler::rigid_body!(Impossible {
    motion: planar_translation,
    mass: 1[kg],
    constraints: [circle = position.norm_squared() + 1[m ^ 2]],
    reactions: [push = _ * position.normalize()],
});

#[test]
fn states_that_cannot_be_made_consistent_are_reported_with_their_violation() {
    let mut state = PlanarTranslation {
        position: [0.8, 0.3].into(),
        ..PlanarTranslation::default()
    };
    let error = Impossible::default()
        .project(0.0, &mut state, &())
        .unwrap_err();
    assert_eq!(error.constraint, "circle");
    assert!(error.violation >= 1.0);
    let ran = integrate::cf4_projected(&Impossible::default(), &state, &(), 0.0..1.0, 10);
    assert_eq!(ran.unwrap_err().constraint, "circle");
}

newton_euler::rigid_body!(Toggle {
    doc: "A slider that is held on y = 0 by a push along an axis of the body: of no use where that lies along x.",
    motion: planar,
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    constraints: [line = position.in_world().y],
    reactions: [push = body(0, _)],
    outputs: [reactions],
});

fn turned(angle: f64) -> Planar {
    Planar {
        angle,
        ..Planar::default()
    }
}

/// H17.
#[test]
fn a_reaction_across_its_constraint_is_an_error() {
    let toggle = Toggle::default();
    let push = toggle.reactions(0.0, &turned(1.0), &()).unwrap().push;
    assert!((push.y - GRAVITY).abs() < 1e-14);
    let singular = toggle.reactions(0.0, &turned(core::f64::consts::FRAC_PI_2), &());
    let singular = singular.unwrap_err();
    assert_eq!(singular.unknown, "Toggle.push.y");
    assert!(singular.value.abs() < 1e-16 && (singular.scale - 1.0).abs() < 1e-15);
}

#[test]
fn and_its_acceleration_is_not_a_number() {
    let upright = turned(core::f64::consts::FRAC_PI_2);
    let acceleration = Toggle::default().acceleration(0.0, &upright, &());
    assert!(
        acceleration
            .linear
            .iter()
            .all(|component| component.is_nan())
    );
}

newton_euler::rigid_body!(Carriage {
    doc: "A carriage on a rail, pulled beside G: the guide has a moment.",
    motion: planar_translation,
    mass: 3[kg],
    inputs: [pull[N]],
    points: [shoe = (0.2, -0.1)[m], hook = (0.4, 0.3)[m]],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    constraints: [rail = position.in_world().y],
    reactions: [guide = world(0, _).at(shoe), couple = moment(_)],
    forces: [rope = world(pull, 0).at(hook)],
    outputs: [reactions],
});

#[test]
fn a_guide_balances_the_moment_of_a_carriage() {
    let (carriage, input) = (Carriage::default(), CarriageInput { pull: 6.0 });
    let state = PlanarTranslation::default();
    assert!((carriage.acceleration(0.0, &state, &input) - Vector2::new(2.0, 0.0)).norm() < 1e-15);
    let reactions = carriage.reactions(0.0, &state, &input).unwrap();
    assert!((reactions.guide.y - 3.0 * GRAVITY).abs() < 1e-14);
    // the rope turns by -0.3 * 6, the shoe by 0.2 N
    assert!((reactions.couple - (1.8 - 0.2 * 3.0 * GRAVITY)).abs() < 1e-14);
}
