//! A light aeroplane, the Navion: trimmed for level flight and for a level turn, and its modes next
//! to the published ones.
//!
//! Coefficients and modes are those of R. C. Nelson, Flight Stability and Automatic Control, 2nd
//! edition, appendix B and examples 4.3 and 5.3, quoted without the book at hand. The textbook's
//! linear equations, set up from these coefficients in `tests/linearization/textbook.rs`, give the
//! same short period, phugoid and roll to a thousandth, the Dutch roll to 0.6 % and the spiral
//! to 7 %; the book rounds intermediate derivatives. Axes are aeronautical: body x points to the
//! nose, y to the right wing, z down; world z points down.
//!
//! Asserts: the modes of level flight agree with the published ones to a hundredth, their rounding,
//! and the slow spiral to six hundredths; after a whole turn the aeroplane is back where it
//! started.

use newton_euler::nalgebra::Vector3;
use newton_euler::prelude::*;

rigid_body!(Navion {
    doc: "A Navion at sea level, its coefficients linear about 176 ft/s.",
    motion: spatial,
    inputs: [thrust[N], elevator[rad], aileron[rad], rudder[rad]],
    params: [density = 1.225[kg / m ^ 3]],
    mass: 2750[lb],
    inertia: principal(1048, 3000, 3530)[slug * ft ^ 2],
    locals: [
        area = 184[ft ^ 2],
        span = 33.4[ft],
        chord = 5.7[ft],
        u = velocity.dot(body(1, 0, 0)),
        w = velocity.dot(body(0, 0, 1)),
        speed = velocity.norm(),
        alpha = (w / u).atan(),
        beta = (velocity.dot(body(0, 1, 0)) / speed).asin(),
        load = density * speed.powi(2) / 2 * area,
        lift = 0.41 + 4.44 * alpha + 0.355 * elevator,
        drag = 0.05 + 0.33 * alpha,
        side = -0.564 * beta + 0.157 * rudder,
        along = lift * alpha.sin() - drag * alpha.cos(),
        down = -lift * alpha.cos() - drag * alpha.sin(),
        air = load * body(along, side, down),
        // the rate of the angle of attack, from the forces
        acceleration_of_air = (air + body(thrust, 0, 0)) / mass + world(0, 0, 9.80665[m / s ^ 2])
            - angular_velocity.cross(velocity),
        alpha_rate = (u * acceleration_of_air.dot(body(0, 0, 1))
            - w * acceleration_of_air.dot(body(1, 0, 0)))
            / (u.powi(2) + w.powi(2)),
        roll = angular_velocity.dot(body(1, 0, 0)) * span / (2 * speed),
        pitch = angular_velocity.dot(body(0, 1, 0)) * chord / (2 * speed),
        yaw = angular_velocity.dot(body(0, 0, 1)) * span / (2 * speed),
        rolling = -0.074 * beta - 0.41 * roll + 0.107 * yaw - 0.134 * aileron + 0.0107 * rudder,
        pitching = -0.683 * alpha
            - 4.36 * alpha_rate * chord / (2 * speed)
            - 9.96 * pitch
            - 0.923 * elevator,
        yawing = 0.071 * beta - 0.0575 * roll - 0.125 * yaw - 0.0035 * aileron - 0.072 * rudder,
    ],
    fields: [weight = mass * world(0, 0, 9.80665[m / s ^ 2])],
    forces: [wing = air, propeller = body(thrust, 0, 0)],
    moments: [tail = load * body(span * rolling, chord * pitching, span * yawing)],
    outputs: [linearization],
});

/// Nelson's oscillatory modes: natural frequency \[rad/s\] and damping ratio.
const SWINGS: [(&str, f64, f64); 3] = [
    ("short period", 3.60, 0.694),
    ("Dutch roll", 2.385, 0.204),
    ("phugoid", 0.2137, 0.080),
];
/// The decay without oscillation \[1/s\].
const DECAYS: [(&str, f64); 2] = [("roll", 8.435), ("spiral", 0.00877)];

const SPEED: f64 = 176.0 * 0.3048;
const CONTROLS: [&str; 4] = ["thrust", "elevator", "aileron", "rudder"];

fn sideslip(state: &Spatial, _: &NavionInput) -> f64 {
    state.attitude.inverse_transform_vector(&state.velocity).y
}

fn level_flight(navion: &Navion) -> (Spatial, NavionInput) {
    let ahead = Spatial {
        velocity: Vector3::new(SPEED, 0.0, 0.0),
        ..Spatial::default()
    };
    let search = navion.trim(&ahead).free(CONTROLS).free(["attitude"]);
    let level = search.hold("sideslip", sideslip).solve();
    let level = level.expect("it flies");
    println!(
        "level flight at {SPEED:.1} m/s: thrust {:.0} N, pitch {:.2}°, elevator {:.2}°",
        level.input.thrust,
        level.state.attitude.euler_angles().1.to_degrees(),
        level.input.elevator.to_degrees(),
    );
    let modes = level.modes().expect("the derivatives are finite");
    let moving = || modes.iter().filter(|mode| !mode.is_neutral);
    println!("  rad/s and damping of the modes       published");
    let swinging = moving().filter(|mode| mode.period().is_some());
    for ((name, frequency, damping), mode) in SWINGS.iter().zip(swinging) {
        let found = [mode.natural_frequency(), mode.damping_ratio()];
        println!(
            "  {name:<14} {:8.4} {:8.4}   {frequency:8.4} {damping:6.3}",
            found[0], found[1]
        );
        assert!((found[0] / frequency - 1.0).abs() < 0.01);
        assert!((found[1] / damping - 1.0).abs() < 0.01);
    }
    let decaying = moving().filter(|mode| mode.period().is_none());
    for ((name, rate), mode) in DECAYS.iter().zip(decaying) {
        let found = mode.natural_frequency();
        println!("  {name:<14} {found:8.4}            {rate:8.4}");
        assert!((found / rate - 1.0).abs() < 0.06);
    }
    assert_eq!((moving().count(), modes.neutral()), (5, 4));
    (level.state, level.input)
}

fn level_turn(navion: &Navion, (state, input): &(Spatial, NavionInput)) {
    let rate = 0.1;
    let search = navion.trim(state).input(input).turning([0.0, 0.0, rate]);
    let search = search.free(CONTROLS).free(["attitude"]);
    let turn = search.hold("sideslip", sideslip).solve();
    let turn = turn.expect("it turns");
    let (bank, pitch, _) = turn.state.attitude.euler_angles();
    let NavionInput {
        thrust,
        elevator,
        aileron,
        rudder,
    } = turn.input;
    let [bank, pitch, elevator, aileron, rudder] =
        [bank, pitch, elevator, aileron, rudder].map(f64::to_degrees);
    println!("\nlevel turn with {rate} rad/s: thrust {thrust:.0} N, pitch {pitch:.2}°");
    println!("  elevator {elevator:.2}°, aileron {aileron:.2}°, rudder {rudder:.2}°");
    let known = (SPEED * rate / 9.80665).atan().to_degrees();
    println!("  bank {bank:.2}°, without side force {known:.2}°");
    assert!((bank - known).abs() < 0.5);
    let modes = turn.modes().expect("the derivatives are finite");
    for mode in modes.iter().filter(|mode| !mode.is_neutral) {
        let (frequency, damping) = (mode.natural_frequency(), mode.damping_ratio());
        println!("  {frequency:8.4} rad/s, damping {damping:.4}");
    }
    assert!(modes.is_stable());

    let period = core::f64::consts::TAU / rate;
    let motion = navion.integrate(&turn.state).input(turn.input);
    let later = motion.to(period).expect("it flies");
    let off = (later.position - turn.state.position).norm();
    println!("  after a turn of {period:.0} s it is off by {off:.0e} m");
    assert!(off < 1e-5);
}

/// Level flight, and the turn.
pub fn main() {
    let navion = Navion::default();
    println!("{}\n", Navion::EQUATIONS);
    let level = level_flight(&navion);
    level_turn(&navion, &level);
}
