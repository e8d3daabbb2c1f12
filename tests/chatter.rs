//! Laws that have no value where they drive a motion to: an integration that chatters there ends, with an error or at its end. And what is long,
//! stiff or steep, and looks alike step by step, goes on to its end.

use newton_euler::integrate::{
    DormandPrince, Integration, IntegrationError, Method, Projected, TaylorSeries,
};
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

#[test]
fn a_point_that_comes_to_rest() {
    let speed = |_: f64, state: &PlanarTranslation| state.velocity.norm();
    let body = Slide::default();
    for (velocity, tolerance) in [([1.0, 0.0], 1e-9), ([0.8, 0.3], 1e-13)] {
        let start = sliding(velocity);
        let motion = body.integrate(&start).method(DormandPrince { tolerance });
        ends(motion.to(2.0), 0.5 * start.velocity.norm(), speed, "DOP853");
    }
    let start = sliding([0.8, 0.3]);
    let motion = body.integrate(&start).tolerance(1e-9);
    ends(motion.to(2.0), 0.5 * start.velocity.norm(), speed, "series");
}

/// What does chatter, but comes to its end soon, does so, as near as the tolerance has it.
#[test]
fn a_short_rest() {
    let start = sliding([0.8, 0.3]);
    let (body, fast) = (Slide::default(), start.velocity.norm());
    let there = start.velocity * (fast / 4.0);
    for tolerance in [1e-4, 1e-5] {
        let ends = [
            body.integrate(&start).tolerance(tolerance).to(0.6),
            body.integrate(&start)
                .method(DormandPrince { tolerance })
                .to(0.6),
        ];
        for end in ends {
            let end = end.expect("an end");
            let off = (end.position - there).norm() + end.velocity.norm();
            assert!(off < 30.0 * tolerance, "{tolerance:e}: {off:e}");
        }
    }
}

#[test]
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

rigid_body!(Stiff {
    doc: "A point that follows another, which moves, at once; and friction that is smooth, but steep.",
    motion: planar_translation,
    mass: 1[kg],
    params: [damping = 1[N * s / m], friction = 0[N], width = 1[m / s]],
    locals: [slip = velocity - world((t / 1[s]).cos() * 1[m / s], 0)],
    forces: [
        follows = -damping * slip,
        rubs = -friction * velocity / (velocity.dot(velocity) + width.powi(2)).sqrt(),
    ],
    outputs: [taylor],
});

/// How many steps it took.
fn counted<M: Method<Stiff>, C>(
    motion: Integration<'_, Stiff, M, C>,
    end: f64,
) -> (usize, PlanarTranslation)
where
    C: newton_euler::integrate::Control<PlanarTranslation, ()>,
{
    let last = motion.steps(end).map(|step| step.expect("an end").state);
    last.fold((0, PlanarTranslation::default()), |(count, _), state| {
        (count + 1, state)
    })
}

/// Hundreds of thousands of steps, stiff and steep.
#[test]
fn what_is_stiff_comes_to_its_end() {
    let stiff = |damping: f64, friction: f64, width: f64| {
        let params = StiffParams {
            damping,
            friction,
            width,
        };
        Stiff::new(params).expect("a body")
    };
    let follows = stiff(1e6, 0.0, 1.0);
    let start = sliding([1.0, 0.0]);
    for tolerance in [1e-6] {
        let (count, end) = counted(follows.integrate(&start).tolerance(tolerance), 0.6);
        let off = (end.velocity.x - 0.6_f64.cos()).abs();
        assert!(
            count > 70_000 && off < tolerance.max(1e-5),
            "{tolerance:e}: {count}, {off:e}"
        );
    }
    let method = DormandPrince { tolerance: 1e-6 };
    let (count, end) = counted(follows.integrate(&start).method(method), 2.5);
    let off = (end.velocity.x - 2.5_f64.cos()).abs();
    assert!(count > 270_000 && off < 1e-5, "{count}, {off:e}");

    let rubs = stiff(0.0, 2.0, 1e-6);
    for tolerance in [1e-6] {
        let (count, end) = counted(rubs.integrate(&start).tolerance(tolerance), 1.0);
        let off = (end.position.x - 0.25).abs() + end.velocity.norm();
        assert!(
            count > 150_000 && off < 1e-5,
            "{tolerance:e}: {count}, {off:e}"
        );
    }
}

rigid_body!(Noisy {
    doc: "A load that jumps a thousand times a second, but in time.",
    motion: planar_translation,
    mass: 1[kg],
    locals: [tick = (t / 1[ms]).floor()],
    forces: [jerks = world((7 * tick * tick).sin() * 1[N], 0)],
});

rigid_body!(Tiny {
    doc: "Nanometres, much below the tolerance.",
    motion: planar_translation,
    mass: 1[kg],
    forces: [spring = -1e12[N / m] * position],
    outputs: [taylor],
});

#[test]
fn what_jumps_in_time_or_is_tiny_comes_to_its_end() {
    let method = DormandPrince { tolerance: 1e-9 };
    let rest = PlanarTranslation::default();
    Noisy::default()
        .integrate(&rest)
        .method(method)
        .to(15.0)
        .expect("an end");
    let start = PlanarTranslation {
        position: [1e-9, 0.0].into(),
        ..rest
    };
    for tolerance in [1e-6, 1e-9] {
        let tiny = Tiny::default();
        let end = tiny.integrate(&start).method(TaylorSeries { tolerance });
        end.to(0.2).expect("an end");
    }
}
