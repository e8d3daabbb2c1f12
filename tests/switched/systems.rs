//! Constraints of systems that differ from branch to branch.

use newton_euler::prelude::*;

/// A block of 2 kg under a weight, and a floor that the word in front gives.
macro_rules! blocks {
    ($($name:ident: $floor:expr;)*) => {$(
        mod $name {
            newton_euler::rigid_system!(Held {
                motion: planar,
                bodies: [block { mass: 2[kg], inertia: 1[kg * m ^ 2] }],
                joints: [base = translation(block)],
                locals: [y = block.position.in_world().y],
                fields: [weight = mass * world(0.5[m / s ^ 2], -9.80665[m / s ^ 2])],
                constraints: [floor = $floor],
                outputs: [reactions],
            });
        }
    )*};
}

blocks! {
    clipped: y.max(0[m]);
    folded: y.abs() + y;
    signed: y * (1 + y.signum());
    lines: table(y, [0, 1, 2][m], [0, 1, 1][m]);
    curves: table(y, [-1, 0, 1, 2][m], [0, 0, 2, 2][m], cubic);
    grid: table(
        y, block.position.in_world().x, [-1, 0, 1][m], [0, 1, 2][m],
        [[0, 0, 0], [0, 0, 0], [1, 1, 1]][m]
    );
    ledge: if block.position.in_world().x > 1[m] { y } else { 7[m] };
    gap: ((block.position.in_world().x / 1[m]).floor() - 1) * y;
    doubled: (2 * (block.position.in_world().x / 1[m]).floor() - 2) * y;
    squared: ((block.position.in_world().x / 1[m]).floor().powi(2) - 1) * y;
}

#[test]
fn a_floor_holds_where_it_is() {
    macro_rules! check {
        ($($name:ident: [$(($x:expr, $y:expr, $holds:expr)),*];)*) => {$(
            for (x, y, holds) in [$(($x, $y, $holds)),*] {
                let base = PlanarTranslation { position: [x, y].into(), ..Default::default() };
                let (system, state) = ($name::Held::default(), $name::HeldState { base });
                let motion = system.acceleration(0.0, &state, &()).base;
                let load = system.reactions(0.0, &state, &()).floor;
                let place = concat!(stringify!($name));
                assert!((motion.x - 0.5).abs() < 1e-14, "{place} {y}: {motion}");
                if holds {
                    assert!(motion.y.abs() < 1e-14 && load != 0.0, "{place} {y}: {motion}");
                } else {
                    assert_eq!((motion.y, load), (-9.80665, 0.0), "{place} {y}");
                }
            }
        )*};
    }
    check! {
        clipped: [(0.0, -0.5, false), (0.0, 0.5, true)];
        folded: [(0.0, -0.5, false), (0.0, 0.5, true)];
        signed: [(0.0, -0.5, false), (0.0, 0.5, true)];
        lines: [(0.0, -0.5, false), (0.0, 0.5, true), (0.0, 1.5, false), (0.0, 9.0, false)];
        curves: [(0.0, -2.0, false), (0.0, -0.5, false), (0.0, 0.5, true), (0.0, 1.5, false), (0.0, 3.0, false)];
        grid: [(0.5, -0.5, false), (1.5, 0.5, true), (1.5, 2.0, false)];
        ledge: [(0.0, 0.0, false), (2.0, 0.0, true)];
        gap: [(0.5, 0.0, true), (1.0, 0.0, false), (1.5, 0.5, false), (2.0, 0.0, true)];
        doubled: [(0.5, 0.0, true), (1.5, 0.5, false), (2.5, 0.5, true)];
        squared: [(0.5, 0.0, true), (2.5, 0.5, true)];
    }
}

/// A factor that is zero on a step which no difference shows: nothing is claimed of it.
#[test]
fn what_a_step_leaves_open_is_nan() {
    let base = PlanarTranslation {
        position: [1.5, 0.0].into(),
        ..Default::default()
    };
    let (system, state) = (squared::Held::default(), squared::HeldState { base });
    assert!(system.acceleration(0.0, &state, &()).base.y.is_nan());
    let message = system.integrate(&state).to(1.0).unwrap_err().to_string();
    assert!(message.contains("`floor`"), "{message}");
}

/// Two bodies; beyond a place, one constraint follows from the other.
macro_rules! pairs {
    ($($name:ident: [$($constraint:tt)*];)*) => {$(
        mod $name {
            newton_euler::rigid_system!(Pair {
                motion: planar,
                bodies: [
                    a { mass: 1[kg], inertia: 0.1[kg * m ^ 2], forces: [pull = world(0.7, -1.3)[N]] },
                    b { mass: 2[kg], inertia: 0.1[kg * m ^ 2], forces: [pull = world(-1.1, 0.4)[N]] },
                ],
                joints: [j = translation(a), i = translation(b)],
                locals: [
                    x = a.position.in_world().x / 1[m],
                    y = a.position.in_world().y / 1[m],
                    place = b.position.in_world().x / 1[m],
                    height = b.position.in_world().y / 1[m],
                ],
                constraints: [$($constraint)*],
            });
        }
    )*};
}

pairs! {
    plain: [k = y, h = if x * place > 0 { height } else { y }];
    scaled: [k = y * (1 + x * x), h = if place > 0 { height } else { 2 * y }];
    turned: [k = y * (1 + x * x), h = if place < 0 { y } else { height }];
    stepped: [k = y + 0 * x, h = y + (height - y) * (place + 0.5).floor()];
    tabulated: [k = y + 0 * x, h = height * table(place, [-2, -1, 0, 0.25, 0.75, 1], [0, 0, 0, 1, 1, 1])
        + y * table(place, [-2, -1, 0, 0.25, 0.75, 1], [1, 1, 1, 0, 0, 0])];
    before: [h = if place + x > x { height } else { y + y * x }, k = y];
}

#[test]
fn what_follows_on_one_branch_is_kept_on_the_other() {
    macro_rules! check {
        ($($name:ident)*) => {$(
            let state = |place: f64| $name::PairState {
                j: PlanarTranslation {
                    position: [1.0, 0.0].into(),
                    velocity: [0.1, 0.0].into(),
                },
                i: PlanarTranslation { position: [place, 0.0].into(), ..Default::default() },
            };
            let pair = $name::Pair::default();
            let motion = pair.acceleration(0.0, &state(0.5), &());
            let found = [motion.j.x, motion.j.y, motion.i.x, motion.i.y];
            for (found, expected) in found.into_iter().zip([0.7, 0.0, -0.55, 0.0]) {
                assert!((found - expected).abs() < 1e-14, "{}: {motion:?}", stringify!($name));
            }
            let refused = pair.integrate(&state(-0.2)).to(0.1);
            let message = refused.expect_err("nothing tells the loads").to_string();
            assert!(message.contains("follows from the other constraints"), "{message}");
        )*};
    }
    check!(plain scaled turned before stepped tabulated);
}
