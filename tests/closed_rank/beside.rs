//! A linkage with a crank too many, beside a body that has nothing to do with it.

use newton_euler::prelude::*;

/// Three parallel cranks under a bar, and what is beside them.
macro_rules! cranks {
    ([$($body:tt)*], [$($joint:tt)*], $($key:tt)*) => {
        newton_euler::rigid_system!(Beside {
            motion: planar,
            bodies: [
                bar { mass: 2[kg], inertia: 0.3[kg * m ^ 2], points: [l = (-1, 0), m = (0, 0), r = (1, 0)] },
                first { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [pin = (0, 0), end = (1, 0)] },
                second { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [pin = (0, 0), end = (1, 0)] },
                third { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [pin = (0, 0), end = (1, 0)] },
                $($body)*
            ],
            joints: [
                a = revolute(world(0, 0), first.pin),
                b = revolute(first.end, bar.l),
                c = revolute(world(1, 0), second.pin),
                d = revolute(world(2, 0), third.pin),
                $($joint)*
                middle = revolute(bar.m, second.end),
                right = revolute(bar.r, third.end),
            ],
            fields: [weight = mass * world(1[m / s ^ 2], -9.8[m / s ^ 2])],
            $($key)*
        });
    };
}

/// The cranks, and a slider with a constraint of its own.
macro_rules! sliders {
    ($($name:ident: $constraint:expr;)*) => {$(
        #[allow(unused_variables, reason = "a constraint reads some of the locals")]
        mod $name {
            use super::{Hinge, PlanarTranslation};

            cranks!(
                [slider { mass: 1[kg], inertia: 0.1[kg * m ^ 2] }],
                [base = translation(slider),],
                locals: [
                    x = slider.position.in_world().x / 1[m],
                    y = slider.position.in_world().y / 1[m],
                    angle = a.angle / 1[rad],
                    rate = a.angular_velocity / 1[rad / s],
                    time = t / 1[s],
                ],
                constraints: [rail = $constraint],
            );

            pub fn state(angle: f64, angular_velocity: f64, x: f64) -> BesideState {
                let crank = Hinge { angle, angular_velocity };
                BesideState {
                    a: crank,
                    b: Hinge { angle: -angle, angular_velocity: -angular_velocity },
                    c: crank,
                    d: crank,
                    base: PlanarTranslation { position: [x, 0.0].into(), ..Default::default() },
                }
            }
        }
    )*};
}

sliders! {
    straight: y + 0.1 * x;
    curved: y + 0.1 * x * x;
    bent: y + (x - 1).max(0);
    two_rails: if x > 1 { y } else { y - x };
    ledge: if x > 1 { y } else { 0 };
    gap: (x.floor() - 2) * y;
    raised: if x > 1 { y } else { 7 };
    weak: y * (1 + x * x);
    product: y * (x - 3);
    soft: y / (1 + (-x).exp());
    clipped: (x + 0.4).max(0) * y;
    driven_elsewhere: if x > 9 { rate - 0.3 } else { 0 };
    driven_rate: rate - 0.3;
    driven_here: if x > 0 { rate - 0.3 } else { 0 };
    shared: y + angle + 0.1 * x;
    driven: angle - 0.3 * time;
    driven_by_two: angle + y - 0.3 * time;
    tabulated: y + table(x, [0, 1, 2, 3], [0.3, 0.1, 0.2, 0.5]);
    often_bent: y + (x - 1).max(0) + (x - 2).max(0) + (x - 3).max(0) + (x - 4).max(0) + (x - 5).max(0)
        + (x - 6).max(0) + (x - 7).max(0);
}

/// By hand: the cranks turn about their G, and the bar moves on a circle.
#[test]
fn a_slider_does_not_lock_the_cranks_beside_it() {
    macro_rules! check {
        ($($name:ident)*) => {$(
            for (angle, x) in [(0.8_f64, 2.5), (-0.4, 0.5)] {
                let state = $name::state(angle, 0.7, x);
                let motion = $name::Beside::default().acceleration(0.0, &state, &());
                let expected = 2.0 * (-angle.sin() - 9.8 * angle.cos()) / (3.0 * 0.1 + 2.0);
                for (found, sign) in [(motion.a, 1.0), (motion.b, -1.0), (motion.c, 1.0), (motion.d, 1.0)] {
                    assert!((found - sign * expected).abs() < 1e-12, "{} {motion:?}", stringify!($name));
                }
            }
        )*};
    }
    check!(straight curved bent two_rails ledge gap raised tabulated often_bent);
    check!(weak product soft clipped driven_elsewhere);
}

/// The same cranks, with a constraint on their angle, the slider and time: by hand, with its load.
#[test]
fn a_slider_and_a_drive_may_share_the_angle_of_the_cranks() {
    macro_rules! check {
        ($($name:ident: $gradient:expr;)*) => {$(
            for (angle, x) in [(0.8_f64, 2.5), (-0.4, 0.5)] {
                let state = $name::state(angle, 0.3, x);
                let motion = $name::Beside::default().acceleration(angle / 0.3, &state, &());
                let push = 2.0 * (-angle.sin() - 9.8 * angle.cos());
                let (loads, masses) = ([push, 1.0, -9.8], [3.0 * 0.1 + 2.0, 1.0, 1.0]);
                let inner = |factors: [f64; 3]| (0..3).map(|own| $gradient[own] * factors[own] / masses[own]).sum::<f64>();
                let load = -inner(loads) / inner($gradient);
                let expected = |own: usize| (loads[own] + load * $gradient[own]) / masses[own];
                for (found, expected) in [
                    (motion.a, expected(0)),
                    (motion.b, -expected(0)),
                    (motion.c, expected(0)),
                    (motion.d, expected(0)),
                    (motion.base.x, expected(1)),
                    (motion.base.y, expected(2)),
                ] {
                    assert!((found - expected).abs() < 1e-11, "{} {motion:?} {expected}", stringify!($name));
                }
            }
        )*};
    }
    check! {
        shared: [1.0, 0.1, 1.0];
        driven: [1.0, 0.0, 0.0];
        driven_rate: [1.0, 0.0, 0.0];
        driven_here: [1.0, 0.0, 0.0];
        driven_by_two: [1.0, 0.0, 1.0];
    }
}

/// The cranks, and a body that a slide and a weld hold: two rows are multiples of each other.
mod held {
    cranks!(
        [block {
            mass: 1[kg],
            inertia: 1[kg * m ^ 2]
        }],
        [
            slide = prismatic(world(0, 0), block.G, body(1, 1)),
            weld = weld(world(0, 0), block.G),
        ],
    );
}

#[test]
fn a_body_held_in_a_skew_slide() -> Result<(), Box<dyn std::error::Error>> {
    let crank = |sign: f64| Hinge {
        angle: 0.5 * sign,
        angular_velocity: 0.3 * sign,
    };
    let [turned, back] = [1.0, -1.0].map(crank);
    let state = held::BesideState {
        a: turned,
        b: back,
        c: turned,
        d: turned,
        slide: Slide::default(),
    };
    let held = held::Beside::default();
    held.check(0.0, &state, &())?;
    let motion = held.acceleration(0.0, &state, &());
    // Lagrange's equation of the one angle: the bar moves along the circle of the ends of the cranks
    let inertia = 3.0 * 0.1 + 2.0;
    let (sine, cosine) = 0.5_f64.sin_cos();
    let expected = 2.0 * (-9.8 * cosine - sine) / inertia;
    assert!(
        (motion.a - expected).abs() < 1e-13,
        "{} {expected}",
        motion.a
    );
    assert!(motion.slide.abs() < 1e-15);
    held.integrate(&state).to(1.0)?;
    Ok(())
}
