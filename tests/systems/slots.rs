//! Pins in slots, as joints of the tree and as joints that close loops.

use newton_euler::prelude::*;

use super::compare::Random;

/// Beside equations in closed form: a bar on a pin that slides in a slot of the ground, and a
/// Scotch yoke (E. Dijksman, Motion Geometry of Mechanisms).
mod scenes {
    use newton_euler::prelude::*;

    rigid_system!(Sliding {
        motion: planar,
        bodies: [bar {
            mass: 2[kg],
            inertia: 0.3[kg * m ^ 2],
            points: [pin = (0, 0.7)],
        }],
        joints: [slot = pin_in_slot(world(0, 0), bar.pin, body(1, 0))],
        fields: [weight = mass * world(0, -9.8[m / s ^ 2])],
        outputs: [reactions, energy],
    });

    rigid_system!(Leaning {
        motion: planar,
        bodies: [bar {
            mass: 2[kg],
            inertia: 0.3[kg * m ^ 2],
            points: [pin = (0, 0.7)],
        }],
        joints: [slot = pin_in_slot(world(0, 0), bar.pin, body(0, -1)).turned(90[deg])],
        fields: [weight = mass * world(0, -9.8[m / s ^ 2])],
    });

    rigid_system!(Yoke {
        motion: planar,
        inputs: [torque[N * m]],
        bodies: [
            crank {
                mass: 1[kg],
                inertia: 0.02[kg * m ^ 2],
                points: [pin = (0.2, 0)]
            },
            yoke {
                mass: 3[kg],
                inertia: 0.1[kg * m ^ 2]
            },
        ],
        joints: [
            axle = revolute(world(0, 0), crank.G),
            guide = prismatic(world(0, 0), yoke.G, body(1, 0)),
            slot = pin_in_slot(yoke.G, crank.pin, body(0, 1)),
        ],
        drives: [motor = torque.on(axle)],
        outputs: [reactions],
    });
}

const GRAVITY: f64 = 9.8;

/// G does not accelerate sideways, and the slot carries what holds it: `(J + m l^2 s^2) a'' = ..`.
#[test]
fn a_bar_on_a_pin_that_slides() {
    let (sliding, leaning) = (scenes::Sliding::default(), scenes::Leaning::default());
    let (mass, inertia, length) = (2.0, 0.3, 0.7);
    let mut random = Random::new(5);
    for _ in 0..50 {
        let [position, angle, velocity, rate] = [0; 4].map(|_| 2.0 * random.number());
        let (sine, cosine) = angle.sin_cos();
        let over = inertia + mass * length * length * sine * sine;
        let lever = mass * length * sine;
        let turning = -(lever * length * cosine * rate * rate + lever * GRAVITY) / over;
        // G is at the pin + l (sin, -cos)
        let sideways = -length * (turning * cosine - rate * rate * sine);
        let slot = Cylinder {
            position,
            angle,
            velocity,
            angular_velocity: rate,
        };
        let state = scenes::SlidingState { slot };
        let found = sliding.acceleration(0.0, &state, &()).slot;
        assert!((found.angular - turning).abs() < 1e-12 * (1.0 + turning.abs()));
        assert!((found.linear - sideways).abs() < 1e-12 * (1.0 + sideways.abs()));

        let reactions = sliding.reactions(0.0, &state, &());
        let upwards = mass * (GRAVITY + length * (turning * sine + rate * rate * cosine));
        assert!(reactions.slot.force.x.abs() < 1e-12 * upwards.abs().max(1.0));
        assert!((reactions.slot.force.y - upwards).abs() < 1e-12 * upwards.abs().max(1.0));

        // the same slot, written in axes of a body that is turned
        let leaning_state = scenes::LeaningState {
            slot: Cylinder {
                angle: angle - std::f64::consts::FRAC_PI_2,
                ..slot
            },
        };
        let other = leaning.acceleration(0.0, &leaning_state, &()).slot;
        assert!((found.angular - other.angular).abs() < 1e-11 * (1.0 + turning.abs()));
        assert!((found.linear - other.linear).abs() < 1e-11 * (1.0 + sideways.abs()));
    }
}

/// The yoke is at r cos a: `(J + m r^2 s^2) a'' + m r^2 s c a'^2 = M`, and all of it over dead points.
#[test]
fn a_scotch_yoke() {
    let yoke = scenes::Yoke::default();
    let (radius, mass, inertia) = (0.2, 3.0, 0.02);
    let mut random = Random::new(6);
    let angles = (0..50).map(|_| 3.0 * random.number());
    let dead = [0.0, std::f64::consts::FRAC_PI_2, std::f64::consts::PI];
    for angle in angles.collect::<Vec<_>>().into_iter().chain(dead) {
        let (rate, torque) = (4.0, 0.5);
        let (sine, cosine) = f64::sin_cos(angle);
        let state = scenes::YokeState {
            axle: Hinge {
                angle,
                angular_velocity: rate,
            },
            guide: Slide {
                position: radius * cosine,
                velocity: -radius * sine * rate,
            },
        };
        let input = scenes::YokeInput { torque };
        let square = mass * radius * radius;
        let turning =
            (torque - square * sine * cosine * rate * rate) / (inertia + square * sine * sine);
        let sideways = -radius * (turning * sine + rate * rate * cosine);
        let found = yoke.acceleration(0.0, &state, &input);
        assert!(
            (found.axle - turning).abs() < 1e-12 * (1.0 + turning.abs()),
            "{angle}"
        );
        assert!(
            (found.guide - sideways).abs() < 1e-12 * (1.0 + sideways.abs()),
            "{angle}"
        );
        // the slot pushes the yoke sideways, and nothing else does
        let found = yoke.reactions(0.0, &state, &input).slot.force;
        assert!(
            (found.x + mass * sideways).abs() < 1e-11 * (1.0 + mass * sideways.abs()),
            "{angle}: {found}"
        );
    }
    let start = scenes::YokeState {
        axle: Hinge {
            angle: 0.3,
            angular_velocity: 4.0,
        },
        guide: Slide {
            position: radius * f64::cos(0.3),
            velocity: -radius * f64::sin(0.3) * 4.0,
        },
    };
    let end = yoke.integrate(&start).tolerance(1e-12).to(3.0).unwrap();
    assert!((end.guide.position - radius * end.axle.angle.cos()).abs() < 1e-11);
    let energy = |state: &scenes::YokeState| {
        0.5 * (inertia * state.axle.angular_velocity.powi(2) + mass * state.guide.velocity.powi(2))
    };
    assert!((energy(&end) - energy(&start)).abs() < 1e-10 * energy(&start));
}
