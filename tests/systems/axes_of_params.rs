//! Joints along axes that parameters give move as those along the same numbers, also where they close
//! loops: the directions across the axis follow from the parameters.

use newton_euler::prelude::*;

/// A crank, a rod and a rocker in space, with ball joints at the ends of the rod.
macro_rules! linkage {
    ($name:ident $last:ident [$($params:tt)*] $tilt:expr) => {
        rigid_system!($name {
            params: [$($params)*],
            bodies: [
                crank {
                    mass: 1[kg],
                    inertia: principal(0.1, 0.2, 0.3),
                    points: [o = (0, 0, 0), a = (0.3, 0.4, 0)],
                },
                rod {
                    mass: 1[kg],
                    inertia: principal(0.3, 0.2, 0.1),
                    points: [b = (0.6, 0.7, 0.1)],
                },
                rocker {
                    mass: 1[kg],
                    inertia: principal(0.3, 0.2, 0.1),
                    points: [b = (0.1, 0.7, 0.2), c = (0, 0, 0.1)],
                },
            ],
            joints: [
                o = revolute(world(0, 0, 0), crank.o, world(0, 0, 1)),
                a = spherical(crank.a, rod.G),
                b = spherical(rod.b, rocker.b),
                c = $last(world(0.8, 0.4, 0), rocker.c, world(1, $tilt, 0.3)),
            ],
            outputs: [energy],
            fields: [weight = mass * world(0, -9.81[m / s ^ 2], 0)],
        });
    };
}
linkage!(Tilted revolute [tilt = 0.2] tilt);
linkage!(At2 revolute [] 0.2);
linkage!(At5 revolute [] -0.5);
// the axis is nearer to y than to x, unlike at the default
linkage!(At20 revolute [] 2);
linkage!(Sliding cylindrical [tilt] tilt);
linkage!(SlidingAt5 cylindrical [] -0.5);

macro_rules! same {
    ($found:expr, $state:ident, $expected:ident $expected_state:ident) => {
        let (found, expected) = ($found, $expected::default());
        let state = $state::default();
        let expected_state = $expected_state::default();
        found.check(0.0, &state, &()).unwrap();
        expected.check(0.0, &expected_state, &()).unwrap();
        let [found, expected] = [
            found.acceleration(0.0, &state, &()).o,
            expected.acceleration(0.0, &expected_state, &()).o,
        ];
        assert!(
            found.abs() > 0.1 && (found - expected).abs() < 1e-10,
            "{}: {found}, {expected}",
            stringify!($expected)
        );
    };
}

#[test]
fn loops_close_along_axes_of_params() {
    let tilted = |tilt| Tilted::new(TiltedParams { tilt }).unwrap();
    same!(tilted(0.2), TiltedState, At2 At2State);
    same!(tilted(-0.5), TiltedState, At5 At5State);
    same!(tilted(2.0), TiltedState, At20 At20State);
    let sliding = Sliding::new(SlidingParams { tilt: -0.5 }).unwrap();
    same!(sliding, SlidingState, SlidingAt5 SlidingAt5State);
}

/// A door on two hinges along one axis: the second follows from the first for every tilt.
macro_rules! door {
    ($name:ident [$($params:tt)*] $tilt:expr) => {
        rigid_system!($name {
            params: [$($params)*],
            bodies: [door {
                mass: 1.3[kg],
                inertia: principal(0.1, 0.2, 0.17)[kg * m ^ 2],
                points: [o = (0.3, 0, 0), p = (0.3, 0.5 * $tilt, 0.5)],
            }],
            joints: [
                low = revolute(world(0, 0, 0), door.o, body(0, $tilt, 1)),
                high = revolute(world(0, 0.5 * $tilt, 0.5), door.p, body(0, $tilt, 1)),
            ],
            outputs: [energy],
            fields: [weight = mass * world(0, -9.81[m / s ^ 2], 0)],
        });
    };
}
door!(Door [tilt = 0.2] tilt);

#[test]
fn doors_swing_about_axes_of_params() {
    for tilt in [0.2, 1e-9, 0.0, -3.0, 1e9] {
        let door = Door::new(DoorParams { tilt }).unwrap();
        let state = DoorState::default();
        door.check(0.0, &state, &()).unwrap();
        let found = door.acceleration(0.0, &state, &()).low;
        // the weight acts across the axis at the arm of G, and only in part about the axis
        let about_axis = 1.0 / f64::hypot(1.0, tilt);
        let [along_y, along_z] = [tilt * about_axis, about_axis];
        let inertia = 0.2 * along_y.powi(2) + 0.17 * along_z.powi(2) + 1.3 * 0.3 * 0.3;
        let expected = 1.3 * 9.81 * 0.3 * about_axis / inertia;
        assert!(
            (found / expected - 1.0).abs() < 1e-12,
            "{tilt}: {found}, {expected}"
        );
    }
}

// a plate on an inclined table
rigid_system!(Table {
    params: [slope, up = 1],
    bodies: [plate {
        mass: 2[kg],
        inertia: principal(2, 3, 4)[kg * m ^ 2]
    },],
    joints: [table = planar(world(0, 0, 0), plate.G, body(0, slope, up))],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
});

#[test]
fn plates_slide_on_tables_of_params() {
    for slope in [0.0, 0.3, -2.0, 1e3] {
        let table = Table::new(TableParams { slope, up: 1.0 }).unwrap();
        let found = table.acceleration(0.0, &TableState::default(), &()).table;
        let [sine, cosine] = [slope, 1.0].map(|part| part / f64::hypot(1.0, slope));
        assert!(cosine > 0.0 && found.linear.x.abs() < 1e-12);
        assert!(
            (found.linear.y - 9.81 * sine).abs() < 1e-12,
            "{slope}: {found:?}"
        );
    }
    // nearly upside down, the plate slides as far, and no digits are lost
    for slope in [1e-3, 1e-6, 1e-8, 1e-12] {
        let table = Table::new(TableParams { slope, up: -1.0 }).unwrap();
        let found = table.acceleration(0.0, &TableState::default(), &()).table;
        let expected = 9.81 * slope / f64::hypot(1.0, slope);
        let found = found.linear.norm();
        assert!((found / expected - 1.0).abs() < 1e-14, "{slope}: {found}");
    }
    // no shortest rotation leads from z to its opposite
    let reversed = Table::new(TableParams {
        slope: 0.0,
        up: -1.0,
    });
    let message = reversed.unwrap_err().to_string();
    assert!(
        message.contains("`slope`, `up` must be finite"),
        "{message}"
    );
}
