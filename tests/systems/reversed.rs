//! The angles that joints of loops hold are also zero where an axis is reversed, or a body is turned
//! by 120 degrees about the diagonal of its axes: such assemblies are no states of the motion.

use core::f64::consts::PI;

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::prelude::*;

/// Two bodies in space with a joint between them that closes a loop.
macro_rules! pair {
    ($name:ident $($joint:tt)+) => {
        rigid_system!($name {
            bodies: [
                hub { mass: 1[kg], inertia: principal(0.1, 0.2, 0.25) },
                lid { mass: 2[kg], inertia: principal(0.2, 0.1, 0.25) },
            ],
            joints: [of_hub = free(hub), of_lid = free(lid), lock = $($joint)+],
        });
    };
}
pair!(Welded weld(hub.G, lid.G));
pair!(Hinged revolute(hub.G, lid.G, body(0, 1, 2)));
pair!(Sleeved cylindrical(hub.G, lid.G, body(1, 0, 0)));
pair!(Slid prismatic(hub.G, lid.G, body(0, 0, 1)));
pair!(Flat planar(hub.G, lid.G, body(0, 1, 0)));
pair!(Screwed screw(hub.G, lid.G, body(0, 0, 1), 0.1[m]));
pair!(Crossed universal(hub.G, lid.G, body(0, 0, 1), body(1, 0, 0)));
pair!(Turned weld(hub.G, lid.G).turned(body(1, 0, 0), 50[deg]).turned(body(0, 1, 1), 200[deg]));

/// A turn about an axis by a part of a turn.
fn turn(axis: [f64; 3], parts: f64) -> UnitQuaternion<f64> {
    UnitQuaternion::from_scaled_axis(Vector3::from(axis).normalize() * (2.0 * PI * parts))
}

/// Whether a turn of the lid from the given attitude is a state of the motion.
macro_rules! check {
    ($name:ident $state:ident $start:expr, $turned:expr, $is_state:expr) => {
        let system = $name::default();
        let hub = turn([0.3, 0.5, -0.2], 0.2);
        let turned: UnitQuaternion<f64> = $turned;
        let state = $state {
            of_hub: Spatial {
                attitude: hub,
                ..Default::default()
            },
            of_lid: Spatial {
                attitude: hub * $start * turned,
                ..Default::default()
            },
        };
        let what = format!("{} {:?}", stringify!($name), turned.scaled_axis());
        let checked = system.check(0.0, &state, &());
        assert_eq!(checked.is_ok(), $is_state, "{what}: {checked:?}");
        if !$is_state {
            let off = checked.unwrap_err();
            assert!(
                off.constraint.starts_with("lock") && off.violation > 0.5,
                "{what}: {off}"
            );
            let worst = system.violations(0.0, &state, &());
            let worst = worst.iter().filter_map(|one| one.position);
            assert!(worst.fold(0.0, f64::max) > 0.5, "{what}");
            let mut projected = state.clone();
            system.project(0.0, &mut projected, &()).unwrap();
            system.check(0.0, &projected, &()).unwrap();
        }
    };
}

#[test]
fn reversed_assemblies_are_no_states() {
    let one = UnitQuaternion::identity();
    let thirds = [1.0, 2.0].map(|parts| turn([1.0, 1.0, 1.0], parts / 3.0));
    let halves = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| turn(axis, 0.5));
    for turned in thirds.into_iter().chain(halves) {
        check!(Welded WeldedState one, turned, false);
        check!(Slid SlidState one, turned, false);
        let start = turn([1.0, 0.0, 0.0], 50.0 / 360.0) * turn([0.0, 1.0, 1.0], 200.0 / 360.0);
        check!(Turned TurnedState start, turned, false);
    }
    check!(Welded WeldedState one, one, true);
    check!(Hinged HingedState one, turn([0.0, 1.0, 2.0], 0.5), true);
    check!(Hinged HingedState one, turn([1.0, 0.0, 0.0], 0.5), false);
    check!(Hinged HingedState one, turn([0.0, 2.0, -1.0], 0.5), false);
    check!(Sleeved SleevedState one, turn([1.0, 0.0, 0.0], 0.4), true);
    check!(Sleeved SleevedState one, turn([0.0, 0.2, 1.0], 0.5), false);
    check!(Flat FlatState one, turn([0.0, 1.0, 0.0], 0.7), true);
    check!(Flat FlatState one, turn([1.0, 0.0, 1.0], 0.5), false);
    check!(Screwed ScrewedState one, one, true);
    check!(Screwed ScrewedState one, turn([1.0, 0.0, 0.0], 0.5), false);
    // a cross of two axes has no sense
    check!(Crossed CrossedState one, turn([1.0, 0.0, 0.0], 0.3), true);
    check!(Crossed CrossedState one, halves[1], true);
}

rigid_system!(Plate {
    motion: planar,
    bodies: [
        hub {
            mass: 1[kg],
            inertia: 1[kg * m ^ 2]
        },
        lid {
            mass: 2[kg],
            inertia: 1[kg * m ^ 2]
        },
    ],
    joints: [
        of_hub = free(hub),
        of_lid = free(lid),
        lock = weld(hub.G, lid.G).turned(30[deg])
    ],
});

#[test]
fn reversed_plates_are_no_states() {
    let at = |angle: f64| PlateState {
        of_lid: Planar {
            angle: angle.to_radians(),
            ..Default::default()
        },
        ..Default::default()
    };
    let plate = Plate::default();
    plate.check(0.0, &at(30.0), &()).unwrap();
    plate.check(0.0, &at(390.0), &()).unwrap();
    let off = plate.check(0.0, &at(210.0), &()).unwrap_err();
    assert!((off.violation - 2.0).abs() < 1e-12, "{off}");
    let mut state = at(50.0);
    plate.project(0.0, &mut state, &()).unwrap();
    plate.check(0.0, &state, &()).unwrap();
    for start in [209.0, 210.0, -60.0] {
        let mut state = at(start);
        plate.project(0.0, &mut state, &()).unwrap();
        plate.check(0.0, &state, &()).unwrap();
        let turned = state.of_lid.angle - state.of_hub.angle - PI / 6.0;
        let turns = turned / (2.0 * PI);
        assert!((turns - turns.round()).abs() < 1e-12, "{turned}");
    }
}
