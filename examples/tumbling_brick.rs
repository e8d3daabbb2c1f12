//! NASA's tumbling brick: check-cases 2 and 3 for flight simulations, compared with published
//! simulations.
//!
//! Source: NASA/TM-2015-218675, Check-Cases for Verification of 6-Degree-of-Freedom Flight Vehicle
//! Simulations (2015), volume II, sections B.1.3, C.1.2 and C.1.3. The trajectories of its
//! simulations, SIM 1 to SIM 6, are published with it as `Atmos_02_sim_01.csv` and so on.
//!
//! A brick of 8 x 4 x 2.25 inches is released above the equator, 30,000 ft high, moving with the
//! air and rotating at 10, 20, 30 deg/s about its axes, and falls for 30 s; body x points north, z
//! down. In case 2 the air exerts no load, so the rates are those of a free body, in closed form.
//! In case 3 the air damps each rate, L = q S b (b p / 2 V) Cₗₚ with Cₗₚ = -1, which is -¼ ρ V S b²
//! p. World axes do not rotate. The Earth is an ellipsoid (WGS-84) with gravitation to J₂; its air
//! rotates with it, with the density of the US Standard Atmosphere of 1976.
//!
//! Asserts: the rates against 40-digit arithmetic and against the publication, in which SIM 1 and
//! SIM 4 agree to ten digits; height and angles from north, east and down against the publication.
//! Its simulations interpret case 3 in two ways: in SIM 1, 2 and 4 the air damps the rates relative
//! to the stars, in SIM 5 and 6 those relative to the rotating air, as `wind = 1` does here.

#![allow(clippy::unreadable_literal, reason = "as published")]

use newton_euler::integrate::DormandPrince;
use newton_euler::nalgebra::{UnitQuaternion, Vector3};
use newton_euler::prelude::*;

rigid_body!(Brick {
    doc: "A brick without loads.",
    motion: rotation,
    inertia: principal(0.001894220, 0.006211019, 0.007194665)[slug * ft ^ 2],
    outputs: [energy, momentum, flow],
});

rigid_body!(FallingBrick {
    doc: "The brick in the field of the Earth and in its air; world z along the axis of the Earth.",
    motion: spatial,
    params: [damping = 1, wind = 1],
    mass: 0.155404754[slug],
    inertia: principal(0.001894220, 0.006211019, 0.007194665)[slug * ft ^ 2],
    locals: [
        mu = 3.986004418e14[m ^ 3 / s ^ 2],
        radius = 6378137[m],
        earth = world(0, 0, 7.292115e-5[rad / s]),
        distance = position.norm(),
        height = distance - radius,
        sine = position.in_world().z / distance,
        geopotential = 6356766[m] * height / (6356766[m] + height),
        cooling = 1 - 0.0065[K / m] * geopotential / 288.15[K],
        density = 1.225[kg / m ^ 3] * cooling.powf(9.80665 * 28.9644 / (8314.32 * 0.0065) - 1),
        speed = (velocity - earth.cross(position)).norm(),
        drag = density * speed * 0.22222[ft ^ 2] / 4,
        rates = (angular_velocity - wind * earth).in_body(),
        span = 0.33333[ft],
        chord = 0.66667[ft],
    ],
    potentials: [gravity = -mu * mass / distance
        * (1 - 1.08262982e-3 * (radius / distance).powi(2) * (3 * sine.powi(2) - 1) / 2)],
    moments: [air = -damping
        * drag
        * body(
            span.powi(2) * rates.x,
            chord.powi(2) * rates.y,
            span.powi(2) * rates.z,
        )],
});

/// The duration of the fall \[s\].
pub(crate) const SECONDS: f64 = 30.0;
const FOOT: f64 = 0.3048;
const RADIUS: f64 = 6_378_137.0;
const EARTH: f64 = 7.292_115e-5;

/// About the axes of the body \[rad/s\].
pub(crate) fn rates() -> Vector3<f64> {
    Vector3::new(10.0, 20.0, 30.0).map(f64::to_radians)
}

/// The start of the brick without loads.
pub(crate) fn free() -> Rotation {
    Rotation {
        angular_velocity: rates(),
        ..Rotation::default()
    }
}

/// On world x, moving with the air.
pub(crate) fn let_go() -> Spatial {
    let away = RADIUS + 30_000.0 * FOOT;
    Spatial {
        position: Vector3::x() * away,
        attitude: UnitQuaternion::from_axis_angle(&-Vector3::y_axis(), std::f64::consts::FRAC_PI_2),
        velocity: Vector3::y() * (EARTH * away),
        angular_velocity: rates(),
    }
}

/// After the fall, with errors of 1e-13 per step.
pub(crate) fn fallen(damping: f64, wind: f64) -> Spatial {
    let brick = FallingBrick::new(FallingBrickParams { damping, wind });
    let brick = brick.expect("a brick");
    // where the air is at rest the speed has no series
    let method = DormandPrince { tolerance: 1e-13 };
    let end = brick.integrate(&let_go()).method(method).to(SECONDS);
    end.expect("nothing stops it")
}

/// Height \[ft\], and roll, pitch and yaw from north, east and down \[deg\], above the equator.
pub(crate) fn flown(state: &Spatial) -> [f64; 4] {
    let place = state.position.y.atan2(state.position.x);
    let [north, east, down] = [
        Vector3::z(),
        Vector3::new(-place.sin(), place.cos(), 0.0),
        Vector3::new(-place.cos(), -place.sin(), 0.0),
    ];
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| state.attitude * axis);
    let (roll, yaw) = (
        y.dot(&down).atan2(z.dot(&down)),
        x.dot(&east).atan2(x.dot(&north)),
    );
    let pitch = -x.dot(&down).asin();
    let [roll, pitch, yaw] = [roll, pitch, yaw].map(f64::to_degrees);
    [(state.position.norm() - RADIUS) / FOOT, roll, pitch, yaw]
}

fn degrees(rates: &Vector3<f64>) -> [f64; 3] {
    rates.map(f64::to_degrees).into()
}

/// The published results after 30 s: rates about the axes of the body \[deg/s\] in case 2.
const TURNS: [(&str, [f64; 3]); 5] = [
    (
        "SIM 1",
        [12.61839077566776, -17.3974747618308, 31.11958888682995],
    ),
    (
        "SIM 2",
        [12.619216961385067, -17.396709626714614, 31.119942061280724],
    ),
    ("SIM 4", [12.6183907757, -17.3974747619, 31.1195888868]),
    (
        "SIM 5",
        [12.618423766019587, -17.397444101295715, 31.11960300607054],
    ),
    (
        "SIM 6",
        [12.620844062702608, -17.394550197091117, 31.12073831148526],
    ),
];

/// Height \[ft\], roll, pitch and yaw \[deg\] of case 2.
pub(crate) const UNDAMPED: [(&str, [f64; 4]); 5] = [
    (
        "SIM 1",
        [
            15598.9059736,
            -56.151307596646866,
            -3.81965492049295,
            -4.289355039311268,
        ],
    ),
    (
        "SIM 2",
        [15598.90389, -59.85663392, -3.505810107, -4.146742],
    ),
    (
        "SIM 4",
        [
            15598.9043522,
            -56.1513075938,
            -3.81965492189,
            -4.28935504226,
        ],
    ),
    (
        "SIM 5",
        [
            15598.90435244888,
            -56.15127539110731,
            -3.8196332007898666,
            -4.289288509139801,
        ],
    ),
    (
        "SIM 6",
        [
            15598.90435512364,
            -56.150304320773394,
            -3.821955266387911,
            -4.2881229394049,
        ],
    ),
];

/// The same for case 3.
pub(crate) const DAMPED: [(&str, [f64; 4]); 5] = [
    (
        "SIM 1",
        [
            15598.9046837,
            -5.118798532894921,
            -38.779476468273074,
            -111.66967658395333,
        ],
    ),
    (
        "SIM 2",
        [15598.90389, -5.083261585, -39.35000687, -111.5047838],
    ),
    (
        "SIM 4",
        [
            15598.9043522,
            -5.09406213522,
            -38.7889055337,
            -111.383858577,
        ],
    ),
    (
        "SIM 5",
        [
            15598.90435244888,
            -5.152247846246952,
            -38.69966907660681,
            -111.35575173210002,
        ],
    ),
    (
        "SIM 6",
        [
            15598.90435512364,
            -5.148413928481029,
            -38.69970978266794,
            -111.35836388895274,
        ],
    ),
];

fn row(name: &str, values: &[f64]) {
    print!("  {name:<22}");
    for value in values {
        print!("{value:>20.11}");
    }
    println!();
}

fn main() {
    let mass = 0.155404754;
    let square = |inches: f64| (inches / 12.0).powi(2);
    let [x, y, z] = [square(8.0), square(4.0), square(2.25)];
    let moments = [y + z, z + x, x + y].map(|sum| mass / 12.0 * sum);
    println!("moments of a uniform brick {moments:.9?} slug ft²");
    println!("published                  [0.001894220, 0.006211019, 0.007194665]\n");

    let brick = Brick::default();
    let end = brick.flow(&free(), SECONDS);
    println!("case 2, no load: p, q, r in deg/s after 30 s");
    row("closed form", &degrees(&end.angular_velocity));
    row(
        "in 60 digits, rounded",
        &[12.618390775914, -17.397474761611, 31.119588886944],
    );
    for (name, published) in TURNS {
        row(name, &published);
    }

    println!("\ncase 2: height in ft; roll, pitch and yaw in deg");
    row("DOP853", &flown(&fallen(0.0, 1.0)));
    for (name, published) in UNDAMPED {
        row(name, &published);
    }

    println!("\ncase 3, damped by the air: height in ft; roll, pitch and yaw in deg");
    row("rates against the air", &flown(&fallen(1.0, 1.0)));
    row("rates against the stars", &flown(&fallen(1.0, 0.0)));
    for (name, published) in DAMPED {
        row(name, &published);
    }
    let rest = fallen(1.0, 1.0).angular_velocity.norm().to_degrees();
    println!(
        "\nit ends at {rest:.9} deg/s, the Earth turns at {:.9}",
        EARTH.to_degrees()
    );
    println!("\n{}", FallingBrick::EQUATIONS);
}
