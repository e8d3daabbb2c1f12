//! A drone that carries a load on a rope.

use newton_euler::nalgebra::Vector3;
use newton_euler::prelude::*;

rigid_system!(Carrier {
    doc: "A drone, and a load that a rod without mass keeps at its distance from the hook below it.",
    params: [drag = 0.02[N * s / m]],
    inputs: [thrust[N], moment_x[N * m], moment_y[N * m], moment_z[N * m]],
    bodies: [
        drone {
            mass: 1.4[kg],
            inertia: principal(0.012, 0.013, 0.021)[kg * m ^ 2],
            points: [hook = (0, 0, -0.05)[m]],
            forces: [rotors = body(0, 0, thrust)],
            moments: [control = body(moment_x, moment_y, moment_z)],
        },
        load {
            mass: 0.5[kg],
            inertia: sphere(0.05[m]),
            forces: [resistance = -drag * velocity],
        },
    ],
    joints: [
        flight = free(drone),
        swing = translation(load),
        rope = link(drone.hook, load.G, 1.2[m]),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    outputs: [energy, reactions, linearization],
});

fn hanging() -> CarrierState {
    let mut state = CarrierState::default();
    state.swing.position = Vector3::new(0.0, 0.0, -1.25);
    state
}

#[test]
fn hovers_with_the_weight_of_both() {
    let carrier = Carrier::default();
    let search = carrier.trim(&hanging()).free(["thrust"]);
    let hover = search.solve().expect("it hovers");
    assert!((hover.input.thrust - 1.9 * 9.81).abs() < 1e-12);
    let reactions = carrier.reactions(0.0, &hover.state, &hover.input);
    assert!((reactions.rope - 0.5 * 9.81).abs() < 1e-12, "{reactions:?}");
}

/// By hand, from rest, with the drone held level by its moment: the tension is `m g cos a`, and pulls both.
#[test]
fn swings_as_two_masses_on_a_rod() {
    let carrier = Carrier::default();
    for angle in [1e-3, 0.3, -1.1] {
        let (sine, cosine) = f64::sin_cos(angle);
        let tension = 0.5 * 9.81 * cosine;
        let mut state = hanging();
        state.swing.position = Vector3::new(1.2 * sine, 0.0, -0.05 - 1.2 * cosine);
        let input = CarrierInput {
            thrust: 1.9 * 9.81,
            moment_y: 0.05 * tension * sine,
            ..CarrierInput::default()
        };
        let found = carrier.acceleration(0.0, &state, &input);
        let rod = Vector3::new(sine, 0.0, -cosine);
        let load = -tension / 0.5 * rod - Vector3::new(0.0, 0.0, 9.81);
        let drone = (tension * rod + Vector3::new(0.0, 0.0, 0.5 * 9.81)) / 1.4;
        assert!((found.swing - load).norm() < 1e-12, "{found:?} {load}");
        assert!((found.flight.linear - drone).norm() < 1e-12);
        assert!(found.flight.angular.norm() < 1e-10);
    }
}

/// Let go, drone and load swing: without drag energy is the work of the thrust, and the rope keeps its length.
#[test]
fn energy_is_the_work_of_the_thrust() {
    let carrier = Carrier::new(CarrierParams { drag: 0.0 }).expect("possible bodies");
    let mut start = hanging();
    start.swing.velocity = Vector3::new(0.8, 0.3, 0.0);
    let input = CarrierInput {
        thrust: 1.9 * 9.81,
        ..CarrierInput::default()
    };
    let energy = |state: &CarrierState| {
        carrier.kinetic_energy(state) + carrier.potential_energy(0.0, state, &input)
    };
    let motion = carrier.integrate(&start).input(input).tolerance(1e-11);
    let samples = motion.samples(2.0, 0.002);
    let states: Vec<CarrierState> = samples.map(|sample| sample.expect("taut").state).collect();
    let power = |state: &CarrierState| {
        let up = state.flight.attitude * Vector3::z();
        1.9 * 9.81 * up.dot(&state.flight.velocity)
    };
    let thirds = states
        .windows(3)
        .step_by(2)
        .map(|three| 0.002 / 3.0 * (power(&three[0]) + 4.0 * power(&three[1]) + power(&three[2])));
    let (work, end) = (thirds.sum::<f64>(), states[states.len() - 1]);
    assert!(
        (energy(&end) - energy(&start) - work).abs() < 1e-8,
        "{work}"
    );
    let hook = end.flight.position + end.flight.attitude * Vector3::new(0.0, 0.0, -0.05);
    assert!(((end.swing.position - hook).norm() - 1.2).abs() < 1e-12);
}
