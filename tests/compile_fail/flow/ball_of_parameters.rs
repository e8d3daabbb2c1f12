use newton_euler::rigid_body;

rigid_body!(Ball {
    motion: rotation,
    params: [a = 0.3, torque = 0.1],
    inertia: principal(a, a, a),
    moments: [motor = body(torque, 2 * torque, torque)],
    outputs: [flow],
});

fn main() {}
