use newton_euler::prelude::*;
use newton_euler::rigid_body;

rigid_body!(Drone {
    motion: spatial,
    params: [arm = 0.17[m], span = 2 * arm, gain],
    inputs: [thrust[N], wind = world(_, _, _)[m / s]],
    mass: 1.2[kg],
    inertia: principal(0.0123, 0.0123, 0.224)[kg * m ^ 2],
    points: [front = (arm, 0, 0)],
    forces: [lift = body(0, 0, gain * thrust).at(frnt), drag = -0.1[N * s / m] * wind],
    outputs: [energy, momentum, balance],
});

// what uses the type is not touched by the mistakes above
fn main() {
    let drone = Drone::new(DroneParams {
        arm: 0.2,
        span: 0.4,
        gain: 1.0,
    })
    .unwrap();
    let arm: f64 = drone.params().arm;
    let input = DroneInput {
        thrust: arm,
        ..Default::default()
    };
    let state = Spatial::default();
    let _: SpatialAcceleration = drone.acceleration(0.0, &state, &input);
    let _: f64 = drone.kinetic_energy(&state);
    let [lift, drag] = drone.loads(0.0, &state, &input);
    println!("{} {}", lift.name, drag.name);
    println!("{}", Drone::EQUATIONS);
}
