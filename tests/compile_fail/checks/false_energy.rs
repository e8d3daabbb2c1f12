use newton_euler::rigid_body;

rigid_body!(Pendulum {
    motion: pivot(pin),
    inputs: [torque[N * m]],
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [pin = (0, 0.5)],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    moments: [motor = torque],
    checks: [
        rests = (angular_acceleration == 0[rad / s ^ 2]).given(angle = 1e-30[rad], torque = 0[N * m]),
        fast = (kinetic_energy <= 1[J]).given(angular_velocity = 3[rad / s]),
    ],
});

fn main() {}
