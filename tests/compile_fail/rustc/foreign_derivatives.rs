use newton_euler::{rigid_body, rigid_system};

fn lift(alpha: f64, speed: f64) -> f64 {
    alpha * speed
}

rigid_body!(Wing {
    motion: translation,
    mass: 12[kg],
    params: [gain],
    functions: [lift(alpha, speed[m / s]) = lift[N].derivatives(_, lift)],
    forces: [lift = lift(gain, velocity.norm()) * world(1, 0, 0)],
    outputs: [taylor, linearization, sensitivity],
});

rigid_body!(Tail {
    motion: translation,
    mass: 12[kg],
    params: [gain],
    functions: [lift(alpha, speed[m / s]) = lift[N].derivatives(_, lift)],
    forces: [lift = lift(gain, velocity.norm()) * world(1, 0, 0)],
    outputs: [linearization, sensitivity],
});

rigid_body!(Bowl {
    motion: translation,
    mass: 12[kg],
    functions: [
        bowl(x[m], y[m]) = lift[J],
        rim(x[m], y[m]) = lift[J].derivatives(lift, lift),
    ],
    locals: [x = position.in_world().x],
    potentials: [bowl = bowl(x, 1[m]), rim = rim(x, 1[m])],
});

rigid_body!(Rim {
    motion: translation,
    mass: 12[kg],
    functions: [rim(x[m], y[m]) = lift[J].derivatives(lift, lift)],
    potentials: [rim = rim(position.in_world().x, 1[m])],
    outputs: [linearization],
});

fn slope(x: f64, _: f64) -> f64 {
    x
}

rigid_body!(Edge {
    motion: translation,
    mass: 12[kg],
    functions: [edge(x[m], y[m]) = lift[J].derivatives(slope.derivatives(lift, _), slope)],
    locals: [place = position.in_world()],
    potentials: [edge = edge(place.x, place.y)],
    outputs: [linearization],
});

rigid_system!(Arm {
    motion: planar,
    functions: [drag(rate[rad / s], scale) = lift[N * m]],
    bodies: [rod { mass: 2[kg], inertia: 0.3[kg * m ^ 2] }],
    joints: [hinge = revolute(world(0, 0), rod.G)],
    drives: [drag = drag(hinge.angular_velocity, 1).on(hinge)],
    outputs: [taylor, linearization],
});

fn main() {}
