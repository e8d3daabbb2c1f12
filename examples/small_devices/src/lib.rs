//! A drone on a microcontroller with a single-precision floating-point unit: steps of its motion,
//! as a filter predicts them.
#![no_std]

use core::hint::black_box;

use newton_euler::integrate::cf4_step;
use newton_euler::prelude::*;
use newton_euler::state::generic;

rigid_body!(Drone::<T> {
    motion: spatial,
    inputs: [thrust_1[N], thrust_2[N], thrust_3[N], thrust_4[N]],
    mass: 27[g],
    inertia: principal(1.66e-5, 1.67e-5, 2.93e-5)[kg * m ^ 2],
    points: [
        rotor_1 = (32.5, -32.5, 0)[mm],
        rotor_2 = (-32.5, -32.5, 0)[mm],
        rotor_3 = (-32.5, 32.5, 0)[mm],
        rotor_4 = (32.5, 32.5, 0)[mm],
    ],
    forces: [
        lift_1 = body(0, 0, thrust_1).at(rotor_1),
        lift_2 = body(0, 0, thrust_2).at(rotor_2),
        lift_3 = body(0, 0, thrust_3).at(rotor_3),
        lift_4 = body(0, 0, thrust_4).at(rotor_4),
    ],
    moments: [drag = body(0, 0, 0.006[m] * (thrust_1 - thrust_2 + thrust_3 - thrust_4))],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
});

rigid_body!(Swing::<T> {
    motion: pivot(tip),
    mass: 0.2[kg],
    inertia: 0.001[kg * m ^ 2],
    points: [tip = (0, 0.1[m])],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
});

/// Moves a drone, step by step, for ever.
pub fn fly<T: newton_euler::Scalar>(step: T) -> ! {
    let mut state = black_box(generic::Spatial::<T>::default());
    let mut time = T::default();
    loop {
        let input = black_box(DroneInput::<T>::default());
        state = black_box(cf4_step(&Drone::default(), time, &state, &input, step));
        time += step;
    }
}

/// Moves a pendulum, step by step, for ever.
pub fn swing<T: newton_euler::Scalar>(step: T) -> ! {
    let swing = Swing::<T>::default();
    let mut state = black_box(generic::Hinge::<T>::default());
    let mut time = T::default();
    loop {
        state = black_box(cf4_step(&swing, time, &state, &(), step));
        time += step;
    }
}
