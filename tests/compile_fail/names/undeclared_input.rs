use newton_euler::rigid_body;

rigid_body!(Rocket {
    motion: spatial,
    mass: 1[kg],
    inertia: principal(1, 1, 1)[kg * m ^ 2],
    moments: [gimbal = gimbal_torque * body(1, 0, 0)],
});

fn main() {}
