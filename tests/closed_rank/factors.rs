//! Constraints with a factor that may be zero, or tends to zero far away: each is needed where the
//! factor is not zero.

use newton_euler::prelude::*;

/// Two blocks that slide without friction under constant forces.
macro_rules! blocks {
    ($($name:ident: [$($constraint:tt)*];)*) => {$(
        #[allow(unused_variables, reason = "a constraint reads some of the locals")]
        mod $name {
            newton_euler::rigid_system!(Blocks {
                motion: planar,
                bodies: [
                    a { mass: 1[kg], inertia: 1[kg * m ^ 2], forces: [pull = world(0.7, -1.3)[N]] },
                    b { mass: 2[kg], inertia: 1[kg * m ^ 2], forces: [pull = world(-1.1, 0.4)[N]] },
                ],
                joints: [j = translation(a), i = translation(b)],
                locals: [
                    x = a.position.in_world().x / 1[m],
                    y = a.position.in_world().y / 1[m],
                    vx = a.velocity.in_world().x / 1[m / s],
                    place = b.position.in_world().x / 1[m],
                    height = b.position.in_world().y / 1[m],
                    rise = b.velocity.in_world().y / 1[m / s],
                ],
                constraints: [$($constraint)*],
            });
        }
    )*};
}

blocks! {
    either: [k = (x - place) * (y - height)];
    level: [k = (x - 1) * y, h = vx];
    circle: [k = (x * x + y * y - 1) * height, h = rise];
    soft: [k = y / (1 + (-x).exp())];
    grown: [k = y * x.exp()];
    weak: [k = y * (1 + x * x)];
}

/// With the gap that rounding leaves.
#[test]
fn a_constraint_is_needed_where_its_factor_is_not_zero() {
    macro_rules! check {
        ($($name:ident: $first:expr, $second:expr, $expected:expr;)*) => {$(
            for gap in [0.0, 1e-17, -3e-16, 1e-14] {
                let ([x, y, vx, vy], [place, height]) = ($first, $second);
                let state = $name::BlocksState {
                    j: PlanarTranslation { position: [x, y + gap].into(), velocity: [vx, vy].into() },
                    i: PlanarTranslation { position: [place, height].into(), ..Default::default() },
                };
                let motion = $name::Blocks::default().acceleration(0.0, &state, &());
                let found = [motion.j.x, motion.j.y, motion.i.x, motion.i.y];
                for (found, expected) in found.into_iter().zip($expected) {
                    assert!((found - expected).abs() < 1e-12, "{} {gap}: {motion:?}", stringify!($name));
                }
            }
        )*};
    }
    let alone = [0.7, 0.0, -0.55, 0.2];
    // on the circle, with v = 0.5 m/s: the part of the pull along it, and the acceleration to its center
    let along = 0.7 * 0.8 + 1.3 * 0.6;
    let circle = [
        0.8 * along - 0.25 * 0.6,
        -0.6 * along - 0.25 * 0.8,
        -0.55,
        0.0,
    ];
    check! {
        either: [0.4, 0.3, 0.1, 0.0], [3.0, 0.3], [0.7, -0.3, -0.55, -0.3];
        level: [0.4, 0.0, 0.0, 0.0], [3.0, 0.2], [0.0, 0.0, -0.55, 0.2];
        circle: [0.6, 0.8, 0.4, -0.3], [1.7, -1.4], circle;
        soft: [0.4, 0.0, 0.1, 0.0], [3.0, 0.2], alone;
        grown: [0.4, 0.0, 0.1, 0.0], [3.0, 0.2], alone;
        weak: [0.4, 0.0, 0.1, 0.0], [3.0, 0.2], alone;
    }
}
