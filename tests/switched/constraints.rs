//! Constraints and reactions that differ from branch to branch, in any order.

use newton_euler::prelude::*;

/// A block on a floor under its weight and a pull, its friction smaller beyond a speed: M3 without the rolling.
mod friction {
    newton_euler::rigid_body!(Block {
        motion: planar_translation,
        params: [pull = 3[N]],
        mass: 2[kg],
        locals: [
            speed = velocity.in_world().x,
            mu = if speed > 0.5[m / s] { 0.1 } else { 0.3 },
        ],
        fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
        forces: [pull_on = world(pull, -pull)],
        constraints: [floor = position.in_world().y],
        reactions: [
            normal = world(0, _),
            friction = world(-mu * normal.in_world().y, 0),
        ],
        outputs: [reactions],
    });

    // the same, with a friction that is none below a speed
    newton_euler::rigid_body!(Lubricated {
        motion: planar_translation,
        params: [pull = 3[N]],
        mass: 2[kg],
        locals: [mu = (0.2[s / m] * (velocity.in_world().x - 1e3[m / s])).max(0)],
        fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
        forces: [pull_on = world(pull, -pull)],
        constraints: [slope = position.in_world().y + position.in_world().x],
        reactions: [
            normal = (_ * world(1, 1)),
            friction = (-mu * normal.in_world().y * world(1, -1)),
        ],
        outputs: [reactions],
    });
}

#[test]
fn friction_has_both_branches() {
    let block = friction::Block::default();
    for (speed, mu) in [(-1.0, 0.3), (0.2, 0.3), (0.6, 0.1), (100.0, 0.1)] {
        let state = PlanarTranslation {
            velocity: [speed, 0.0].into(),
            ..PlanarTranslation::default()
        };
        let normal = 2.0 * 9.80665 + 3.0;
        let acceleration = block.acceleration(0.0, &state, &());
        assert!(
            (acceleration.x - (3.0 - mu * normal) / 2.0).abs() < 1e-14,
            "{speed}"
        );
        assert!(acceleration.y.abs() < 1e-14);
        let reactions = block.reactions(0.0, &state, &()).unwrap();
        assert!((reactions.normal.y - normal).abs() < 1e-13);
    }
    let block = friction::Lubricated::default();
    for speed in [0.0_f64, 999.0, 1001.0, 2000.0] {
        let mu = (0.2 * (speed - 1e3)).max(0.0);
        let state = PlanarTranslation {
            velocity: [speed, -speed].into(),
            ..PlanarTranslation::default()
        };
        // along and across the slope: (1, -1) / sqrt 2 and (1, 1) / sqrt 2
        let (fx, fy) = (3.0, -3.0 - 2.0 * 9.80665);
        let normal = -(fx + fy) / 2.0;
        let along = (fx - fy) / 2.0 - mu * normal;
        let acceleration = block.acceleration(0.0, &state, &());
        let size = along.abs().max(1.0);
        assert!(
            (acceleration.x - along / 2.0).abs() < 1e-13 * size,
            "{speed}: {acceleration}"
        );
        assert!((acceleration.y + along / 2.0).abs() < 1e-13 * size);
        let reactions = block.reactions(0.0, &state, &()).unwrap();
        assert!((reactions.normal.y - normal).abs() < 1e-13 * size);
    }
}

/// A body that is driven along x at a pace and slides on a floor where there is one: in every order.
macro_rules! paced {
    ($name:ident, $floor:expr, [$($constraint:tt)*], [$($reaction:tt)*]) => {
        newton_euler::rigid_body!($name {
            motion: planar_translation,
            params: [height = 1[m]],
            mass: 2[kg],
            locals: [x = position.in_world().x, y = position.in_world().y],
            fields: [weight = mass * world(0.5[m / s ^ 2], -9.80665[m / s ^ 2])],
            constraints: [$($constraint)*],
            reactions: [$($reaction)*],
            outputs: [reactions],
        });
    };
}

macro_rules! orders {
    ($($module:ident: $floor:expr;)*) => {$(
        mod $module {
            paced!(One, 0,
                [floor = $floor, pace = velocity.in_world().x - 3[m / s] * (t / 1[s]).cos()],
                [support = world(0, _), drive = world(_, 0)]);
            paced!(Two, 0,
                [pace = velocity.in_world().x - 3[m / s] * (t / 1[s]).cos(), floor = $floor],
                [support = world(0, _), drive = world(_, 0)]);
            paced!(Three, 0,
                [floor = $floor, pace = velocity.in_world().x - 3[m / s] * (t / 1[s]).cos()],
                [drive = world(_, 0), support = world(0, _)]);
            paced!(Four, 0,
                [pace = velocity.in_world().x - 3[m / s] * (t / 1[s]).cos(), floor = $floor],
                [drive = world(_, 0), support = world(0, _)]);
        }
    )*};
}

orders! {
    near: if x > 10[m] { y - height } else { 0[m] };
    far: if x > 1e6[m] { y - height } else { 0[m] };
    small: if x < 0.001[m] { 0[m] } else { height - y };
    always: if x > 10[m] { y - height } else { 2 * (y - height) };
    clipped: (x - 10[m]).max(0[m]) / 1[m] * (y - height);
    tables: if x < 1[m] { 0[m] } else if x < 2[m] { y - height } else if x < 3[m] { 0[m] }
        else if x < 4[m] { y - height } else if x < 5[m] { 0[m] } else if x < 6[m] { y - height }
        else if x < 7[m] { 0[m] } else if x < 8[m] { y - height } else { 0[m] };
    folded: ((x - 10[m]).abs() + x - 10[m]) / 1[m] * (y - height);
    signed: (1 + (x - 10[m]).signum()) * (y - height);
    curved: table(x / 1[m], [8, 9, 10, 11], [0, 0, 1, 1]) * (y - height);
    timed: table(t / 1[s], [0, 0.1, 0.2, 3], [0, 0, 1, 1]) * (y - height)
        * table(x / 1[m], [8, 9, 10, 11], [0, 0, 1, 1]);
    folded_in_time: ((t - 0.5[s]).abs() + t - 0.5[s]) * (x.signum() + 1) * (y - height) / 1[s];
    counted: (x / 10[m]).floor() * (y - height);
}

#[test]
fn a_floor_that_begins_somewhere_holds_from_there() {
    fn check<B>(
        body: &B,
        name: &str,
        x: f64,
        holds: bool,
        reactions: impl Fn(&B, &PlanarTranslation) -> (f64, f64),
    ) where
        B: RigidBody<State = PlanarTranslation, Input = (), Scalar = f64>,
    {
        let time = 0.7_f64;
        let velocity = 3.0 * time.cos();
        let state = PlanarTranslation {
            position: [x, 1.0].into(),
            velocity: [velocity, 0.0].into(),
        };
        let acceleration = body.acceleration(time, &state, &());
        let along = -3.0 * time.sin();
        let across = if holds { 0.0 } else { -9.80665 };
        assert!(
            (acceleration.x - along).abs() < 1e-13,
            "{name} at {x}: {acceleration}"
        );
        assert!(
            (acceleration.y - across).abs() < 1e-13,
            "{name} at {x}: {acceleration}"
        );
        let (support, drive) = reactions(body, &state);
        let expected = if holds { 2.0 * 9.80665 } else { 0.0 };
        assert!(
            (support - expected).abs() < 1e-12,
            "{name} at {x}: {support}"
        );
        assert!(
            (drive - 2.0 * (along - 0.5)).abs() < 1e-12,
            "{name} at {x}: {drive}"
        );
    }
    macro_rules! check {
        ($($module:ident: [$(($x:expr, $holds:expr)),*];)*) => {$(
            check!(@ $module, One, [$(($x, $holds)),*]);
            check!(@ $module, Two, [$(($x, $holds)),*]);
            check!(@ $module, Three, [$(($x, $holds)),*]);
            check!(@ $module, Four, [$(($x, $holds)),*]);
        )*};
        (@ $module:ident, $body:ident, [$(($x:expr, $holds:expr)),*]) => {
            let body = $module::$body::default();
            for (x, holds) in [$(($x, $holds)),*] {
                check(&body, concat!(stringify!($module), stringify!($body)), x, holds, |body, state| {
                    let reactions = body.reactions(0.7, state, &()).unwrap();
                    (reactions.support.y, reactions.drive.x)
                });
            }
        };
    }
    check! {
        near: [(-20.0, false), (9.99, false), (10.01, true), (1e4, true)];
        far: [(0.0, false), (2e6, true)];
        small: [(-5.0, false), (0.0, false), (0.002, true), (7.0, true)];
        always: [(0.0, true), (20.0, true)];
        clipped: [(0.0, false), (9.0, false), (11.0, true), (1e3, true)];
        tables: [(0.5, false), (1.5, true), (4.5, false), (5.5, true), (7.5, true), (9.0, false)];
        folded: [(-20.0, false), (9.99, false), (10.01, true), (1e4, true)];
        signed: [(-20.0, false), (9.99, false), (10.0, true), (1e4, true)];
        curved: [(-20.0, false), (8.5, false), (9.5, true), (10.5, true), (30.0, true)];
        timed: [(-20.0, false), (8.5, false), (9.5, true), (30.0, true)];
        folded_in_time: [(-20.0, false), (3.0, true)];
        counted: [(-0.01, true), (0.0, false), (9.99, false), (10.01, true)];
    }
}

/// On the way over the edge: falling before it, carried after it.
#[test]
fn a_course_runs_onto_the_floor() {
    let body = near::One::default();
    let state = PlanarTranslation {
        position: [10.5, 1.0].into(),
        velocity: [3.0, 0.0].into(),
    };
    let end = body.integrate(&state).to(1.0).unwrap();
    assert!((end.position.y - 1.0).abs() < 1e-12);
    assert!((end.position.x - (10.5 + 3.0 * 1.0_f64.sin())).abs() < 1e-8);
    let state = PlanarTranslation {
        position: [0.0, 1.0].into(),
        velocity: [3.0, 0.0].into(),
    };
    let end = body.integrate(&state).to(1.0).unwrap();
    assert!((end.position.y - (1.0 - 9.80665 / 2.0)).abs() < 1e-8);
}
