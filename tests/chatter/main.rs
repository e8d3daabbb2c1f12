//! Laws that have no value at the place to which they drive a motion. If an integration chatters
//! there, it ends, with an error or at its end time. A long, stiff or steep motion whose single
//! steps look alike continues to its end. Without optimization, hundreds of thousands of steps take
//! long, so `cargo test` runs DOP853 and series once each, and `cargo test --release` runs all
//! cases.

mod goes_on;

use newton_euler::integrate::{DormandPrince, IntegrationError, Projected};
use newton_euler::prelude::*;

rigid_body!(Slide {
    doc: "Friction along the velocity.",
    motion: planar_translation,
    mass: 1[kg],
    params: [push = 0[N]],
    forces: [
        friction = (-2[N] * velocity.normalize()).at(G),
        held = world(0, push * (3 * t / 1[s]).sin()),
    ],
    outputs: [taylor],
});

rigid_body!(Brake {
    motion: fixed_axis(hub, world(0, 0, 1)),
    mass: 1[kg],
    inertia: principal(0.4, 0.4, 0.5)[kg * m ^ 2],
    points: [hub = (0, 0, 0)],
    moments: [brake = -3[N * m] * body(0, 0, (angular_velocity.in_world().z / 1[rad / s]).signum())],
});

rigid_body!(Belt {
    doc: "On a belt that moves faster and faster, and carries it along.",
    motion: translation,
    mass: 2[kg],
    locals: [slip = velocity - world(1[m / s] + 1.5[m / s ^ 2] * t, 0, 0)],
    forces: [friction = (-5[N] * slip.normalize()).at(G)],
});

rigid_body!(Sledge {
    doc: "Friction that follows what the floor carries.",
    motion: planar,
    mass: 3[kg],
    inertia: 0.4[kg * m ^ 2],
    points: [front = (0.4, -0.2), back = (-0.4, -0.2)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    constraints: [
        under_front = front.position().in_world().y,
        under_back = back.position().in_world().y,
    ],
    reactions: [r1 = world(0, _).at(front), r2 = world(0, _).at(back)],
    forces: [
        f1 = (-0.2 * r1.in_world().y * front.velocity().normalize()).at(front),
        f2 = (-0.2 * r2.in_world().y * back.velocity().normalize()).at(back),
    ],
});

/// The error comes soon after the motion is at rest.
fn ends<S: std::fmt::Debug>(
    found: Result<S, IntegrationError<S>>,
    rest: f64,
    speed: impl Fn(f64, &S) -> f64,
    name: &str,
) {
    let error = found.expect_err("it chatters");
    assert!(
        matches!(error, IntegrationError::StepTooSmall { .. }),
        "{name}: {error:?}"
    );
    let speed = speed(error.time(), error.state());
    assert!(
        error.time() >= rest - 1e-9 && error.time() < rest + 0.1 && speed < 1e-6,
        "{name}: {error:?}, {speed:e}"
    );
}

fn sliding([x, y]: [f64; 2]) -> PlanarTranslation {
    PlanarTranslation {
        velocity: [x, y].into(),
        ..PlanarTranslation::default()
    }
}

fn pushed(push: f64) -> Slide {
    Slide::new(SlideParams { push }).expect("a body")
}

/// Whether there is time for a motion: one that chatters from its start on takes half as long.
const IS_FAST: bool = !cfg!(debug_assertions);

#[test]
fn a_point_that_comes_to_rest() {
    let fast: &[([f64; 2], f64)] = &[([1.0, 0.0], 1e-9), ([0.8, 0.3], 1e-13)];
    let slow: &[([f64; 2], f64)] = &[([8e-13, -3e-13], 1e-9)];
    let body = pushed(0.0);
    for (velocity, tolerance) in if IS_FAST { fast } else { slow } {
        let start = sliding(*velocity);
        let method = DormandPrince {
            tolerance: *tolerance,
        };
        let end = body.integrate(&start).method(method).to(2.0);
        ends(end, 0.5 * start.velocity.norm(), speed, "DOP853");
    }
}

rigid_body!(Wheel {
    doc: "A brake that has a series, but where it stands still.",
    motion: fixed_axis(hub, world(0, 0, 1)),
    mass: 1[kg],
    inertia: principal(0.4, 0.4, 0.5)[kg * m ^ 2],
    points: [hub = (0, 0, 0)],
    locals: [rate = angular_velocity.in_world().z],
    moments: [brake = -1[N * m] * body(0, 0, rate / rate.powi(2).sqrt())],
    outputs: [taylor],
});

#[test]
fn a_wheel_that_comes_to_rest_along_series() {
    let turning = Hinge {
        angle: 0.3,
        angular_velocity: if IS_FAST { 0.8 } else { 8e-13 },
    };
    let wheel = Wheel::default();
    let end = wheel.integrate(&turning).tolerance(1e-9).to(2.0);
    let rest = 0.5 * turning.angular_velocity;
    ends(end, rest, |_, state| state.angular_velocity.abs(), "series");
}

#[test]
#[cfg_attr(debug_assertions, ignore = "of a release")]
fn a_point_that_comes_to_rest_along_series() {
    let (body, start) = (pushed(0.0), sliding([0.8, 0.3]));
    let end = body.integrate(&start).tolerance(1e-9).to(2.0);
    ends(end, 0.5 * start.velocity.norm(), speed, "series");
}

fn speed(_: f64, state: &PlanarTranslation) -> f64 {
    state.velocity.norm()
}

/// Steps that end elsewhere hide the chatter from none: samples, backwards, short steps.
#[test]
#[cfg_attr(debug_assertions, ignore = "of a release")]
fn whatever_the_steps_end_at() {
    let (body, start) = (pushed(0.0), sliding([0.8, 0.3]));
    let method = DormandPrince { tolerance: 1e-9 };
    let motion = || body.integrate(&start).method(method);
    let rest = 0.5 * start.velocity.norm();
    let sampled = motion().samples(2.0, 1e-3).find_map(Result::err);
    ends(sampled.map_or(Ok(start), Err), rest, speed, "samples");
    ends(motion().max_step(1e-4).to(2.0), rest, speed, "short steps");
    // backwards friction drives from rest, and its like the other way round to it
    let back = Pulled::default().integrate(&start).method(method).to(-2.0);
    let error = back.expect_err("it chatters");
    assert!((-rest - 0.1..=-rest).contains(&error.time()), "{error:?}");
}

rigid_body!(Pulled {
    motion: planar_translation,
    mass: 1[kg],
    forces: [pull = 2[N] * velocity.normalize()],
});

/// What does chatter, but comes to its end in a reasonable number of steps, does so, as near as the
/// tolerance has it: at rest, and pushed on from there.
#[test]
fn a_short_rest() {
    let start = sliding([0.8, 0.3]);
    let (body, fast) = (pushed(0.0), start.velocity.norm());
    let there = start.velocity * (fast / 4.0);
    let most: &[(f64, f64)] = if IS_FAST {
        &[(1e-4, 0.6), (1e-5, 1.6), (1e-6, 1.0)]
    } else {
        &[(1e-4, 0.6)]
    };
    for (tolerance, end) in most.iter().copied() {
        let method = DormandPrince { tolerance };
        let ends = [
            body.integrate(&start).tolerance(tolerance).to(end),
            body.integrate(&start).method(method).to(end),
        ];
        for end in ends {
            let end = end.expect("an end");
            let off = (end.position - there).norm() + end.velocity.norm();
            assert!(off < 30.0 * tolerance, "{tolerance:e}: {off:e}");
        }
    }
    // 3 sin 3t passes the friction of 2 at asin(2/3)/3, and pushes until that has taken all
    let tolerance = if IS_FAST { 1e-6 } else { 1e-4 };
    let rest = sliding([0.0, 1e-9]);
    let (slips, end) = ((2.0_f64 / 3.0).asin() / 3.0, 0.9);
    let method = DormandPrince { tolerance };
    let found = pushed(3.0).integrate(&rest).method(method).to(end);
    let expected = (3.0 * slips).cos() - (3.0 * end).cos() - 2.0 * (end - slips);
    let off = found.expect("an end").velocity.y - expected;
    assert!(off.abs() < 30.0 * tolerance, "{off:e}");
}

/// At rest now and again, and never for long.
#[test]
#[cfg_attr(debug_assertions, ignore = "of a release")]
fn what_sticks_and_slips_goes_on() {
    let (body, rest) = (pushed(3.0), sliding([0.0, 1e-9]));
    let method = DormandPrince { tolerance: 1e-6 };
    let some = body
        .integrate(&rest)
        .method(method)
        .steps(1e9)
        .take(1_200_000);
    let last = some.map(|step| step.expect("no end")).last();
    assert!(last.is_some_and(|step| step.time > 5.0));
}

#[test]
#[cfg_attr(debug_assertions, ignore = "of a release")]
fn what_brakes_or_carries_along() {
    let method = DormandPrince { tolerance: 1e-10 };
    let turning = Hinge {
        angle: 0.3,
        angular_velocity: -6.0,
    };
    let brake = Brake::default();
    let end = brake.integrate(&turning).method(method).to(20.0);
    ends(end, 1.0, |_, state| state.angular_velocity.abs(), "brake");

    // 2.5 m/s^2 of friction, 1.5 of them for the belt
    let belt = Belt::default();
    let end = belt.integrate(&Translation::default()).method(method);
    let slip = |time: f64, state: &Translation| (state.velocity.x - 1.0 - 1.5 * time).abs();
    ends(end.to(20.0), 1.0, slip, "belt");
}

#[test]
#[cfg_attr(debug_assertions, ignore = "of a release")]
fn friction_that_follows_a_support() {
    let start = Planar {
        position: [0.0, 0.2].into(),
        velocity: [1.0, 0.0].into(),
        ..Planar::default()
    };
    let sledge = Sledge::default();
    let rest = 1.0 / (0.2 * 9.80665);
    let method = Projected(DormandPrince { tolerance: 1e-9 });
    let end = sledge.integrate(&start).method(method).to(2.0);
    ends(end, rest, |_, state| state.velocity.norm(), "sledge");
}

rigid_body!(Branches {
    doc: "Friction that is another near rest: none, or what holds against the push.",
    motion: planar_translation,
    mass: 1[kg],
    params: [push = 0[N], hold = 0],
    forces: [
        pushes = world(0, push),
        friction = if velocity.norm() < 1e-6[m / s] {
            world(0, -hold * push)
        } else {
            -2[N] * velocity.normalize()
        },
    ],
});

/// Where a branch takes the friction away, the motion coasts; where it holds, it stays; where it is
/// pushed out again, it chatters about the edge.
#[test]
fn a_branch_around_rest() {
    let branches =
        |push: f64, hold: f64| Branches::new(BranchesParams { push, hold }).expect("a body");
    let start = sliding([0.8, 0.3]);
    for (push, hold) in [(0.0, 0.0), (1.0, 1.0), (-1.9, 1.0)] {
        let body = branches(push, hold);
        for tolerance in [1e-6, 1e-9, 1e-12] {
            let method = DormandPrince { tolerance };
            let end = body.integrate(&start).method(method).to(20.0);
            let end = end.expect("an end");
            assert!(
                end.velocity.norm() < 1.01e-6,
                "{push} {tolerance:e}: {end:?}"
            );
        }
    }
    if IS_FAST {
        let body = branches(1.0, 0.0);
        for tolerance in [1e-8, 1e-9, 1e-12] {
            let method = DormandPrince { tolerance };
            let found = body.integrate(&start).method(method).to(20.0);
            let error = found.expect_err("it chatters");
            let state = error.state();
            assert!(
                matches!(error, IntegrationError::StepTooSmall { .. })
                    && (state.velocity.norm() - 1e-6).abs() < 30.0 * tolerance.max(1e-8)
                    && error.time() < 1.0,
                "{tolerance:e}: {error:?}"
            );
        }
    }
}
