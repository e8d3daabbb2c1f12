//! Constraints on single rates, and on places along axes.

use newton_euler::prelude::*;

use super::compare::{Listed, Random, close};

/// One coordinate alone, whose rate is kept at zero while others move.
mod alone {
    use newton_euler::prelude::*;

    rigid_system!(Alone {
        bodies: [
            hub {
                mass: 3[kg],
                inertia: principal(0.5, 0.4, 0.6)[kg * m ^ 2],
                points: [p = (0.1, 0.2, 0.3)[m]],
            },
            arm {
                mass: 0.8[kg],
                inertia: principal(0.02, 0.03, 0.04)[kg * m ^ 2],
                points: [p = (0, 0.1, 0.2)[m]],
            },
        ],
        joints: [
            base = free(hub),
            joint = universal(hub.p, arm.p, body(1, 0, 0), body(0, 1, 0)),
        ],
        constraints: [still = joint.angular_velocity_2],
    });

    rigid_system!(Upright {
        motion: planar,
        bodies: [load {
            mass: 2[kg],
            inertia: 0.1[kg * m ^ 2]
        }],
        joints: [away = free(load)],
        constraints: [upright = load.attitude],
    });
}

#[test]
fn rounding_of_a_single_rate_is_a_start() {
    let system = alone::Alone::default();
    let mut state = alone::AloneState::default();
    state.base.angular_velocity = [0.3, -0.7, 0.4].into();
    state.joint.angular_velocity_1 = 0.9;
    state.joint.angular_velocity_2 = 1e-17;
    system.check(0.0, &state, &()).unwrap();
    // what is no rounding is none
    state.joint.angular_velocity_2 = 1e-9;
    assert!(system.check(0.0, &state, &()).is_err());
}

#[test]
fn rounding_of_a_single_angle_is_a_start() {
    let system = alone::Upright::default();
    let mut state = alone::UprightState::default();
    state.away.angle = 1e-17;
    system.check(0.0, &state, &()).unwrap();
    state.away.angle = 1e-9;
    assert!(system.check(0.0, &state, &()).is_err());
}

/// One energy in two words: a place that follows from that of a hub, along an axis of this hub.
mod along_an_axis {
    use newton_euler::prelude::*;

    macro_rules! hubs {
        ($name:ident, $energy:expr) => {
            rigid_system!($name {
                bodies: [
                    hub {
                        mass: 3[kg],
                        inertia: principal(0.5, 0.4, 0.6)[kg * m ^ 2],
                        points: [q = (-0.2, 0.1, 0)[m]],
                    },
                    ball {
                        mass: 0.8[kg],
                        inertia: principal(0.02, 0.03, 0.04)[kg * m ^ 2],
                        points: [p = (0, 0.1, 0.2)[m]],
                    },
                ],
                joints: [base = free(hub), socket = spherical(hub.q, ball.p)],
                potentials: [pull = $energy],
            });
        };
    }
    hubs!(
        Components,
        3[N] * (ball.position - hub.position).in_body(hub).x
    );
    hubs!(
        Dots,
        3[N] * (ball.position - hub.position).dot(hub.body(1, 0, 0))
    );
}

#[test]
fn a_place_along_an_axis_of_its_carrier() {
    let mut numbers = Random::new(17);
    for _ in 0..10 {
        let base = Spatial {
            position: numbers.vector(),
            attitude: nalgebra::UnitQuaternion::from_scaled_axis(numbers.vector()),
            velocity: numbers.vector(),
            angular_velocity: numbers.vector(),
        };
        let socket = Rotation {
            attitude: nalgebra::UnitQuaternion::from_scaled_axis(numbers.vector()),
            angular_velocity: numbers.vector(),
        };
        let state = along_an_axis::ComponentsState { base, socket };
        let one = along_an_axis::Components::default().acceleration(0.0, &state, &());
        let state = along_an_axis::DotsState { base, socket };
        let other = along_an_axis::Dots::default().acceleration(0.0, &state, &());
        let listed = |base: SpatialAcceleration| base.list();
        close("hub", &listed(other.base), &listed(one.base), 10.0, 1e-12);
        close(
            "ball",
            other.socket.as_slice(),
            one.socket.as_slice(),
            10.0,
            1e-12,
        );
    }
}
