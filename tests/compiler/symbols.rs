//! The symbols that `EQUATIONS` begins with, and their units and axes.

use quote::quote;

use crate::pretty;
use mounted::expand::expand_system;

/// The symbols at the head of `EQUATIONS`.
fn symbols(expansion: &str) -> Vec<String> {
    let (_, text) = expansion
        .split_once("TEXT")
        .unwrap_or_else(|| panic!("{expansion}"));
    let (_, text) = text.split_once('"').expect("a string");
    let lines = text.split("\\n").map_while(|line| line.strip_prefix("# "));
    lines
        .take_while(|line| line.contains(": "))
        .map(str::to_owned)
        .collect()
}

#[test]
fn equations_name_the_units_of_their_symbols() {
    let expansion = pretty(quote!(Craft {
        motion: spatial,
        params: [offset = body(0, 0, 1)[m], idle],
        inputs: [thrust[N], wind = world(_, _, _)[m / s], flag],
        states: [fuel[kg]],
        rates: [fuel = -thrust * idle * 1[s / m]],
        mass: 3[kg] + fuel,
        inertia: principal(1, 2, 2.5)[kg * m ^ 2],
        forces: [
            push = body(0, 0, thrust),
            drag = 1[kg / s] * (wind - velocity)
        ],
    }));
    assert_eq!(
        symbols(&expansion),
        [
            "vx vy vz: velocity, m / s, world axes",
            "qx qy qz qw: attitude, a unit quaternion, from body to world axes",
            "wx wy wz: angular velocity, rad / s, body axes",
            "linear_x linear_y linear_z: acceleration, m / s ^ 2, world axes",
            "angular_x angular_y angular_z: angular acceleration, rad / s ^ 2, body axes",
            "idle: parameter",
            "thrust: input, N",
            "wind_x wind_y wind_z: input, m / s, world axes",
            "fuel: state, kg",
        ]
    );
    // names as they are printed, and parameters with names of the state of other motions
    let expansion = pretty(quote!(Top {
        motion: rotation,
        params: [axis = body(1, 0, 0), Drag[N * m * s], tilt = 30[deg]],
        inertia: principal(1, 2, 2.5)[kg * m ^ 2],
        moments: [
            drag = -Drag * angular_velocity,
            push = 1[N * m / s] * t * tilt.sin() * axis,
        ],
    }));
    assert_eq!(
        symbols(&expansion),
        [
            "wx wy wz: angular velocity, rad / s, body axes",
            "angular_x angular_y angular_z: angular acceleration, rad / s ^ 2, body axes",
            "time: time, s",
            "axis_x axis_y axis_z: parameter, body axes",
            "drag: parameter, N * m * s",
            "tilt: parameter, rad",
        ]
    );
    let expansion = expand_system(quote!((::newton_euler) Cart {
        motion: planar,
        bodies: [
            cart { mass: 2[kg], inertia: 1[kg * m ^ 2] },
            bob { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [pin = (0, 1[m])] },
        ],
        joints: [
            rail = prismatic(world(0, 0), cart.G, world(1, 0)),
            swing = revolute(cart.G, bob.pin),
        ],
        fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    }))
    .to_string();
    let found = symbols(&expansion);
    assert_eq!(
        found,
        [
            "swing_angle: angle, rad",
            "swing_w: angular velocity, rad / s",
            "rail_a: acceleration, m / s ^ 2",
            "swing_alpha: angular acceleration, rad / s ^ 2",
        ]
    );
}
