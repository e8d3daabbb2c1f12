use newton_euler::rigid_body;

rigid_body!(Drone {
    motion: spatial,
    mass: 1.2[kg],
    inertia: principal(0.02, 0.03, 0.04)[kg * m ^ 2],
    params: [arm = 0.2[m]],
    inputs: [left[N], right[N], torque[N * m]],
    moments: [roll = body(left + arm * (right - left) + torque, 0, 0)],
});

fn main() {}
