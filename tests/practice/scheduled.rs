//! Loads that follow a schedule: the thrust curve of a model rocket's motor, a delay, a parachute.

use newton_euler::prelude::*;

rigid_body!(Model {
    doc: "A model rocket: its motor by a table, its parachute after a delay.",
    motion: planar_translation,
    params: [area = 4.5e-4[m ^ 2], chute = 0.07[m ^ 2], opens = 8[s]],
    inputs: [wind[m / s]],
    mass: 0.12[kg],
    locals: [
        thrust = table(
            t,
            [0, 0.1, 0.2, 0.3, 0.5, 1.6, 1.7, 1.75][s],
            [0, 4, 12, 6, 5, 4.5, 1, 0][N]
        ),
        air = velocity - world(wind, 0),
        drag = if t < opens { 0.75 * area } else { 1.5 * chute },
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    forces: [
        motor = thrust * world(0, 1),
        resistance = -0.5 * 1.2[kg / m ^ 3] * drag * air.norm() * air,
    ],
    outputs: [energy],
});

/// The places of the table and their values.
const CURVE: [[f64; 2]; 8] = [
    [0.0, 0.0],
    [0.1, 4.0],
    [0.2, 12.0],
    [0.3, 6.0],
    [0.5, 5.0],
    [1.6, 4.5],
    [1.7, 1.0],
    [1.75, 0.0],
];

/// The integrals of the curve until a time: of the thrust, and of that again.
fn impulse(time: f64) -> [f64; 2] {
    let (mut once, mut twice) = (0.0, 0.0);
    for pair in CURVE.windows(2) {
        let [[from, value], [to, next]] = [pair[0], pair[1]];
        let h = (time.min(to) - from).max(0.0);
        let slope = (next - value) / (to - from);
        twice += once * h + value * h * h / 2.0 + slope * h.powi(3) / 6.0;
        once += value * h + slope * h * h / 2.0;
    }
    let rest = (time - 1.75).max(0.0);
    [once, twice + once * rest]
}

/// Without air, velocity and height are integrals of the curve.
#[test]
fn in_a_vacuum_the_curve_is_integrated() {
    let params = ModelParams {
        area: 0.0,
        ..ModelParams::default()
    };
    let model = Model::new(params).expect("a possible body");
    for time in [0.05, 0.25, 1.0, 1.72, 4.0] {
        let end = model.integrate(&PlanarTranslation::default());
        let end = end.tolerance(1e-12).to(time).expect("it flies");
        let [once, twice] = impulse(time).map(|x| x / 0.12);
        assert!(
            (end.velocity.y - (once - 9.81 * time)).abs() < 1e-9,
            "{time}"
        );
        assert!(
            (end.position.y - (twice - 4.905 * time * time)).abs() < 1e-9,
            "{time}"
        );
    }
}

/// Under its parachute it sinks at `sqrt(2 m g / (rho C A))`, and goes with the wind.
#[test]
fn comes_down_by_its_parachute() {
    let model = Model::default();
    let input = ModelInput { wind: 2.0 };
    let motion = model.integrate(&PlanarTranslation::default()).input(input);
    let end = motion.tolerance(1e-10).to(40.0).expect("it comes down");
    let sinking = f64::sqrt(2.0 * 0.12 * 9.81 / (1.2 * 1.5 * 0.07));
    assert!((end.velocity.y + sinking).abs() < 1e-7, "{}", end.velocity);
    assert!((end.velocity.x - 2.0).abs() < 1e-7);
    // before it opens it is past the top
    let falls = model.integrate(&PlanarTranslation::default()).input(input);
    let falls = falls.to(8.0).expect("it flies");
    assert!(
        falls.velocity.y < 0.0 && falls.position.y > 50.0,
        "{falls:?}"
    );
}
