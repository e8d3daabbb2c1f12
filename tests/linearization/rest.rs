//! Norms that are zero: quadratic drag at rest, whose slopes are zero there; and rotated vectors
//! with equal components.

use nalgebra::{Matrix3, Vector3};
use newton_euler::prelude::*;

rigid_body!(Airship {
    motion: spatial,
    inputs: [wind = world(_, _, _)[m / s], thrust[N]],
    mass: 2[kg],
    inertia: principal(0.1, 0.2, 0.3)[kg * m ^ 2],
    points: [tail = (-0.5, 0, 0)],
    locals: [air = velocity - wind, swept = tail.velocity() - wind],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    forces: [
        lift = body(0, 0, thrust),
        drag = -0.5[kg / m] * air.norm() * air,
        fin = (-0.2[kg / m] * swept.norm() * swept).at(tail),
    ],
    moments: [damping = -0.1[N * m * s ^ 2] * angular_velocity.norm() * angular_velocity],
    outputs: [linearization],
});

rigid_body!(Rubbing {
    motion: translation,
    mass: 2[kg],
    forces: [friction = -0.5[N] * velocity.normalize()],
    outputs: [linearization],
});

#[test]
fn quadratic_drag_has_no_slope_at_rest() {
    let (airship, input) = (Airship::default(), AirshipInput::default());
    let still = airship.linearize(0.0, &Spatial::default(), &input);
    let rows = still.a().fixed_rows::<6>(6).into_owned();
    assert_eq!(rows, nalgebra::SMatrix::<f64, 6, 12>::zeros());
    assert!(still.b().iter().all(|entry| entry.is_finite()));
    // and as the limit of what it is in motion: |v| + v v^T / |v|
    let v = Vector3::new(1.0, -2.0, 2.0);
    for size in [1e-8, 1e-3, 1.0] {
        let moving = Spatial {
            velocity: v * size,
            ..Spatial::default()
        };
        let found = airship.linearize(0.0, &moving, &input).linear_by_velocity;
        let slope = (Matrix3::identity() * 3.0 + v * v.transpose() / 3.0) * size;
        let known = slope * (-(0.5 + 0.2) / 2.0);
        assert!((found - known).norm() < 1e-14 * size, "{found} {known}");
    }
}

#[test]
fn hovers_in_still_air() {
    let airship = Airship::default();
    let search = airship.trim(&Spatial::default()).free(["thrust"]);
    let hover = search.solve().expect("it hovers");
    assert!((hover.input.thrust - 2.0 * 9.81).abs() < 1e-13);
    let modes = hover.modes().expect("its derivatives are finite");
    assert_eq!(modes.neutral(), 12);
}

/// Dry friction has no value at rest, and no slope.
#[test]
fn what_is_divided_by_stays_a_divisor() {
    let found = Rubbing::default().linearize(0.0, &Translation::default(), &());
    assert!(found.a().iter().any(|entry| !entry.is_finite()));
}

rigid_system!(Slanted {
    doc: "A turn by 45 degrees makes two components of the angular velocity of the arm equal, which are one term then.",
    bodies: [
        arm {
            mass: 1.7[kg],
            inertia: sphere(0.4[m]),
        },
        slider {
            mass: 2.9[kg],
            inertia: principal(0.9, 0.95, 0.4)[kg * m ^ 2],
        },
    ],
    joints: [
        turn = revolute(world(0, 0, 0), arm.G, body(1, 0, 0)),
        slide = prismatic(arm.G, slider.G, body(1, -1, -2)).turned(body(0, 1, 0), 45[deg]),
    ],
    outputs: [linearization],
});

#[test]
fn equal_components_count_once() {
    let slanted = Slanted::default();
    let at = |by: f64| SlantedState {
        turn: Hinge {
            angle: 0.3,
            angular_velocity: 1.3 + by,
        },
        slide: Slide {
            position: 0.7,
            velocity: 0.9,
        },
    };
    let found = slanted.linearize(0.0, &at(0.0), &()).a();
    // the accelerations are quadratic in the rate: this difference is exact
    let [after, before] = [0.5, -0.5].map(|by| slanted.acceleration(0.0, &at(by), &()));
    let known = [after.turn - before.turn, after.slide - before.slide];
    for (row, known) in [2, 3].into_iter().zip(known) {
        assert!((found[(row, 2)] - known).abs() < 1e-13, "{found} {known}");
    }
}
