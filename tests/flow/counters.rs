//! Wheels on pendulums: each turns against the swing of its pendulum, wherever its joint is written.

use newton_euler::integrate::RungeKuttaPair;
use newton_euler::prelude::*;

/// A wheel on a pendulum, among other bodies and joints.
macro_rules! wheel {
    ($name:ident [$($bodies:tt)*] [$($joints:tt)*]) => {
        rigid_system!($name {
            motion: planar,
            bodies: [
                arm { mass: 1[kg], inertia: 3[kg * m ^ 2], points: [o = (0.1, 0)[m]] },
                wheel { mass: 1[kg], inertia: 2[kg * m ^ 2] },
                $($bodies)*
            ],
            joints: [$($joints)*],
            fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
            outputs: [flow],
        });
    };
}
wheel!(InOrder [] [swing = revolute(world(0, 0), arm.o), turn = revolute(arm.G, wheel.G)]);
wheel!(WheelFirst [] [turn = revolute(arm.G, wheel.G), swing = revolute(world(0, 0), arm.o)]);
wheel!(
    BehindWelds
    [post { mass: 1[kg], inertia: 1[kg * m ^ 2] }, base { mass: 2[kg], inertia: 1[kg * m ^ 2] }]
    [
        fixed = weld(world(0, 0), post.G),
        held = weld(world(1, 0), base.G),
        swing = revolute(world(0, 0), arm.o),
        turn = revolute(arm.G, wheel.G),
    ]
);
wheel!(
    BehindDriven
    [rotor { mass: 1[kg], inertia: 1[kg * m ^ 2] }, cart { mass: 2[kg] }]
    [
        spin = revolute(world(0, 0), rotor.G).driven(3[rad / s] * t),
        swing = revolute(world(0, 0), arm.o),
        glide = translation(cart),
        turn = revolute(arm.G, wheel.G),
    ]
);

#[test]
fn counters_find_their_pendulums() {
    let hinge = |angle, angular_velocity| Hinge {
        angle,
        angular_velocity,
    };
    let swing = hinge(-0.309_532_25, -0.322_083_9);
    let turn = hinge(-0.879_022_01, 0.177_177_21);
    let method = || RungeKuttaPair { tolerance: 1e-12 };
    macro_rules! ends {
        ($name:ident $state:expr) => {{
            let (body, state) = ($name::default(), $state);
            let closed = body.integrate(&state).to(2.0).unwrap();
            let stepped = body.integrate(&state).method(method()).to(2.0).unwrap();
            [closed.swing, closed.turn, stepped.swing, stepped.turn]
        }};
    }
    let all = [
        ends!(InOrder InOrderState { swing, turn }),
        ends!(WheelFirst WheelFirstState { turn, swing }),
        ends!(BehindWelds BehindWeldsState { swing, turn }),
        ends!(BehindDriven BehindDrivenState { swing, glide: PlanarTranslation::default(), turn }),
    ];
    for [swing, turn, stepped_swing, stepped_turn] in all {
        for (closed, stepped) in [(swing, stepped_swing), (turn, stepped_turn)] {
            assert!(
                (closed.angle - stepped.angle).abs() < 1e-9,
                "{closed:?}, {stepped:?}"
            );
            assert!((closed.angular_velocity - stepped.angular_velocity).abs() < 1e-9);
        }
        // no moment turns the wheel
        let kept = turn.angular_velocity + swing.angular_velocity;
        assert!((kept - (0.177_177_21 - 0.322_083_9)).abs() < 1e-14);
    }
}
