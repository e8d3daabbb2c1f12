use newton_euler::rigid_system;

rigid_system!(Pendulum {
    motion: planar,
    inputs: [torque[N * m]],
    fields: [gravity = mass * world(0, -9.81[m / s ^ 2])],
    joints: [
        shoulder = revolute(world(0, 0), upper.hinge),
        elbow = revolute(upper.tip, lower.hinge),
    ],
    locals: [span = lower.G.position() - upper.G.position()],
    drives: [motor = torque.on(elbow)],
    forces: [spring = 2[N].between(upper.tip, lower.hinge)],
    moments: [load = moment(2[N * m]).on(upper)],
    potentials: [coil = 3[N / m] * (lower.G.position() - world(1, 0)[m]).norm_squared()],
    constraints: [level = lower.tip.position().in_world().y],
});

fn main() {}
