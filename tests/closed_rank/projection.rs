//! Projection ends in states that `check` accepts, or with an error.

use newton_euler::prelude::*;

use super::carried::numbers;

// two planes and a slide allow no rotation; one row of the slide is flat where it holds
rigid_system!(Planes {
    bodies: [
        first {
            mass: 2[kg],
            inertia: principal(0.1, 0.2, 0.25)[kg * m ^ 2]
        },
        second {
            mass: 0.01[kg],
            inertia: principal(0.1, 0.2, 0.25)[kg * m ^ 2],
            points: [h = (0.1, -0.2, 0.1)]
        },
    ],
    joints: [
        one = planar(world(0, 0, 0), first.G, world(1, 0, 0)),
        two = planar(first.G, second.h, body(1, 1, 0)),
        last = prismatic(world(0, 0.1, 0.3), second.h, world(1, 1, 0)),
    ],
});

#[test]
fn projection_ends_where_check_accepts() {
    let body = Planes::default();
    let mut next = numbers();
    for scale in [1e-3, 0.3, 1e-9, 0.0].repeat(10) {
        let mut state = PlanesState::default();
        let mut next = || scale * next();
        (state.one.position.x, state.one.velocity.y) = (next(), next());
        (state.one.angle, state.one.angular_velocity) = (next(), next());
        (state.two.position.x, state.two.velocity.y) = (next(), next());
        (state.two.angle, state.two.angular_velocity) = (next(), next());
        body.project(0.0, &mut state, &()).unwrap();
        body.check(0.0, &state, &()).unwrap();
        assert!(state.one.angle.abs().max(state.two.angle.abs()) < 1e-12);
    }
}

// one joint holds the body at the hinge of its carrier, the other one away from it
rigid_system!(Contradiction {
    motion: planar,
    bodies: [
        arm {
            mass: 1[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [h = (0, 0.5)]
        },
        slider {
            mass: 1[kg],
            inertia: 0.1[kg * m ^ 2]
        },
    ],
    joints: [
        hinge = revolute(world(0.1, 0), arm.h),
        slide = prismatic(arm.h, slider.G, body(1, 0)),
        away = revolute(world(0.1, 0.3), slider.G),
        at_hinge = revolute(arm.h, slider.G),
    ],
});

#[test]
fn what_cannot_be_closed_is_an_error() {
    let body = Contradiction::default();
    let mut next = numbers();
    for scale in [1e-3, 0.3, 1e-9, 2.0].repeat(25) {
        let mut state = ContradictionState::default();
        let mut next = || scale * next();
        (state.hinge.angle, state.hinge.angular_velocity) = (next(), next());
        (state.slide.position, state.slide.velocity) = (next(), next());
        let found = body.project(0.0, &mut state, &());
        assert!(found.is_err(), "{state:?}");
    }
}

// the loop stands while the last body spins: its rates are rounding
rigid_system!(Standing {
    bodies: [
        arm {
            mass: 1[kg],
            inertia: principal(0.1, 0.2, 0.25)[kg * m ^ 2],
            points: [h = (0, 0.5, 0), end = (0.1, 0.2, 0.3)]
        },
        rotor {
            mass: 1[kg],
            inertia: principal(0.1, 0.2, 0.25)[kg * m ^ 2],
            points: [h = (0, 0.5, 0)]
        },
    ],
    joints: [
        cross = universal(world(0.1, 0, 0), arm.h, world(0, 0.6, 0.8), world(1, 0, 0)),
        spin = revolute(arm.end, rotor.h, body(1, 0, 0)),
        plane = planar(world(0, 0.3, 0), rotor.h, world(0, 0.6, 0.8)),
    ],
});

#[test]
fn rounding_is_accepted_in_a_loop_that_stands() {
    let body = Standing::default();
    let mut next = numbers();
    for scale in [1e-3, 0.3, 1e-9, 0.0].repeat(15) {
        let mut next = || scale * next();
        let mut state = StandingState::default();
        (state.spin.angle, state.spin.angular_velocity) = (next(), next());
        body.project(0.0, &mut state, &()).unwrap();
        body.check(0.0, &state, &()).unwrap();
        state.cross.angular_velocity_2 += 1e-9;
        body.check(0.0, &state, &()).unwrap_err();
    }
}

#[test]
fn an_error_names_the_row_that_is_farthest_from_closed() {
    let body = Contradiction::default();
    let mut state = ContradictionState::default();
    state.slide.position = 0.1;
    let found = body.project(0.0, &mut state, &()).unwrap_err();
    assert!(found.violation.abs() > 1e-3, "{found}");
}

// other joints hold both ends of the last one; whether they are in one place is up to the parameter
rigid_system!(Placed {
    params: [distance = 0[m]],
    fields: [weight = mass * world(0, -9.81, 0)[m / s ^ 2]],
    bodies: [
        arm {
            mass: 1[kg],
            inertia: principal(1, 1, 1)[kg * m ^ 2],
            points: [pin = (-0.2, 0, 0)[m]]
        },
        rotor {
            mass: 1[kg],
            inertia: principal(1, 1, 1)[kg * m ^ 2]
        },
    ],
    joints: [
        hinge = revolute(world(0, 0, 0), arm.pin, body(0, 0, 1)),
        spin = revolute(arm.pin, rotor.G, body(0, 0, 1)),
        again = spherical(world(distance, 0, 0), arm.pin),
    ],
});

#[test]
fn parameters_may_close_what_no_motion_closes() {
    let mut state = PlacedState::default();
    (state.hinge.angle, state.hinge.angular_velocity) = (0.3, 1.0);
    let closed = Placed::default();
    closed.project(0.0, &mut state, &()).unwrap();
    closed.check(0.0, &state, &()).unwrap();
    let moved = closed.acceleration(0.0, &state, &());
    let pendulum = -9.81 * 0.2 * f64::cos(0.3) / 1.04;
    assert!((moved.hinge - pendulum).abs() < 1e-14, "{moved:?}");
    let apart = Placed::new(PlacedParams { distance: 0.2 }).unwrap();
    let found = apart.project(0.0, &mut state, &()).unwrap_err();
    assert!(found.to_string().contains("`again_1`"), "{found}");
}
