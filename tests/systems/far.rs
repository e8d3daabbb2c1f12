//! `project` from attitudes far from those that a joint of a loop holds, up to half a turn: it finds
//! a state from all of them, and turns no body by more than a turn.

use core::f64::consts::{PI, TAU};

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::prelude::*;

use super::compare::Random;

/// Two bodies in space with a joint between them that closes a loop, projected from starts that are
/// turned by an angle from one that may be a state.
macro_rules! pair {
    ($name:ident $state:ident $($joint:tt)+) => {
        rigid_system!($name {
            bodies: [
                hub { mass: 1[kg], inertia: principal(0.1, 0.2, 0.25) },
                lid {
                    mass: 2[kg],
                    inertia: principal(0.2, 0.1, 0.25),
                    points: [p = (0.3, 0.2, -0.4)]
                },
            ],
            joints: [of_hub = free(hub), of_lid = free(lid), lock = $($joint)+],
        });

        impl $name {
            fn project_from(start: UnitQuaternion<f64>, degrees: f64) {
                let (system, mut numbers) = ($name::default(), Random::new(7));
                for number in 0..40 {
                    let hub = UnitQuaternion::new(numbers.vector() * 2.0);
                    let axis = match number {
                        0 => Vector3::x(),
                        1 => Vector3::y(),
                        2 => Vector3::z(),
                        3 => Vector3::repeat(1.0).normalize(),
                        _ => numbers.vector().normalize(),
                    };
                    let turned = UnitQuaternion::new(axis * degrees.to_radians());
                    let mut state = $state {
                        of_hub: Spatial {
                            attitude: hub,
                            ..Default::default()
                        },
                        of_lid: Spatial {
                            attitude: hub * start * turned,
                            position: numbers.vector(),
                            velocity: numbers.vector(),
                            angular_velocity: numbers.vector(),
                        },
                    };
                    let before = state.clone();
                    system.project(0.0, &mut state, &()).unwrap();
                    system.check(0.0, &state, &()).unwrap();
                    let turn = before.of_hub.attitude.angle_to(&state.of_hub.attitude)
                        + before.of_lid.attitude.angle_to(&state.of_lid.attitude);
                    assert!(turn < TAU, "{degrees}, {axis:?}: {turn}");
                }
            }
        }
    };
}
pair!(Welded WeldedState weld(hub.G, lid.p));
pair!(Hinged HingedState revolute(hub.G, lid.p, body(0, 1, 2)));
pair!(Sleeved SleevedState cylindrical(hub.G, lid.p, body(1, 0, 0)));
pair!(Slid SlidState prismatic(hub.G, lid.p, body(0, 0, 1)));
pair!(Flat FlatState planar(hub.G, lid.p, body(0, 1, 0)));
pair!(Screwed ScrewedState screw(hub.G, lid.p, body(0, 0, 1), 0.1[m]));
pair!(Thin ThinState screw(hub.G, lid.p, body(0, 0, 1), 0.003[m]));
pair!(Steep SteepState screw(hub.G, lid.p, body(0, 0, 1), 3[m]));
pair!(Turned TurnedState weld(hub.G, lid.p).turned(body(1, 0, 0), 50[deg]).turned(body(0, 1, 1), 200[deg]));

#[test]
fn far_from_a_joint() {
    let one = UnitQuaternion::identity();
    let first = UnitQuaternion::new(Vector3::x() * (50.0 * PI / 180.0));
    let second = Vector3::new(0.0, 1.0, 1.0).normalize() * (200.0 * PI / 180.0);
    let start = first * UnitQuaternion::new(second);
    for degrees in [50.0, 60.0, 80.0, 90.0, 100.0, 120.0, 150.0, 175.0, 180.0] {
        Welded::project_from(one, degrees);
        Hinged::project_from(one, degrees);
        Sleeved::project_from(one, degrees);
        Slid::project_from(one, degrees);
        Flat::project_from(one, degrees);
        Screwed::project_from(one, degrees);
        Thin::project_from(one, degrees);
        Steep::project_from(one, degrees);
        Turned::project_from(start, degrees);
    }
}
