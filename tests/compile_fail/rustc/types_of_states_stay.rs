use newton_euler::rigid_body;

rigid_body!(Wheel {
    motion: pivot(pin),
    inputs: [command[rad / s]],
    states: [speed[rad / s]],
    rates: [speed = command - speed],
    mass: 2[kg],
    inertia: 1[kg * m ^ 2],
    points: [pin = (0, 0.5)],
    moments: [motor = 0.1[N * m * s] * speed],
    outputs: [energy, taylor, linearization],
});

fn main() {
    use newton_euler::prelude::*;

    let start = WheelState { motion: Hinge::default(), speed: 3.0 };
    let end = Wheel::default().integrate(&start).to(1.0).unwrap();
    let rate: WheelAcceleration = Wheel::default().acceleration(0.0, &end, &WheelInput { command: 1.0 });
    let _: f64 = rate.speed + rate.motion + Wheel::default().kinetic_energy(&end);
}
