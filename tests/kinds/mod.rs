//! A body of every kind: with every motion, under loads of every kind, with all outputs.

use newton_euler::rigid_body;

rigid_body!(Craft::<T> {
    doc: "In space: full inertia, inputs, a load with `if`, a spring, a pole.",
    motion: spatial,
    params: [arm = body(0.2, 0, 0.1)[m], stiffness = 3[N / m]],
    inputs: [thrust[N], gust = world(_, _, _)[N]],
    mass: 1.5[kg],
    inertia: tensor {
        xx: 1.3,
        yy: 1.7,
        zz: 2.1,
        xy: -0.12,
        yz: -0.05,
        zx: 0.07
    }[kg * m ^ 2],
    points: [nozzle = arm, hook = (0, 0.3, 0), wall = world(2, -1, 0.5)],
    locals: [speed = velocity.norm()],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [
        push = body(0, thrust, 0.1 * thrust).at(nozzle),
        wind = gust.at(hook),
        spring = (stiffness * (wall.position() - hook.position())).at(hook),
        drag = if speed < 1.5 {
            -0.1 * velocity
        } else {
            -0.2 * speed.sqrt() * velocity
        },
    ],
    pole: nozzle,
    outputs: [energy, momentum, balance],
});

rigid_body!(Quadrotor {
    doc: "Rotors, and what they have to give for a motion.",
    motion: spatial,
    params: [reach = 0.17[m]],
    mass: 1.2[kg],
    inertia: principal(0.0123, 0.0123, 0.0224)[kg * m ^ 2],
    points: [above = (0, 0, reach)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [thrust = body(_, _, _).at(above)],
    moments: [rotors = body(_, _, _)],
    outputs: [inverse, energy, taylor],
});

rigid_body!(Brick {
    doc: "Free, in closed form and by series.",
    motion: spatial,
    mass: 2[kg],
    inertia: principal(0.01, 0.02, 0.026),
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [flow, taylor, energy, momentum],
});

rigid_body!(Turning::<T> {
    doc: "Attitude alone.",
    motion: rotation,
    params: [moment = 0.9[kg * m ^ 2]],
    inputs: [torque = body(_, _, _)[N * m]],
    inertia: principal(moment, 1.2, 1.5)[kg * m ^ 2],
    moments: [drive = torque],
    outputs: [energy, momentum],
});

rigid_body!(Top::<T> {
    doc: "Heavy and symmetric, in closed form, with the force on its foot.",
    motion: fixed_point(foot),
    mass: 0.3[kg],
    inertia: principal(0.002, 0.002, 0.001)[kg * m ^ 2],
    points: [foot = (0, 0, -0.1[m])],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    reactions: [ground = world(_, _, _).at(foot)],
    outputs: [flow, reactions, energy, momentum],
});

rigid_body!(Gyroscope {
    doc: "The same by series, in axes that do not spin with it.",
    motion: fixed_point(foot),
    mass: 0.3[kg],
    inertia: principal(0.002, 0.002, 0.001)[kg * m ^ 2],
    points: [foot = (0, 0, -0.1[m])],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [taylor],
});

rigid_body!(Rotor::<T> {
    doc: "About an axis, with the loads of its bearings.",
    motion: fixed_axis(lower, body(0, 0, 1)),
    inputs: [brake[N * m]],
    mass: 20[kg],
    inertia: principal(7, 8, 1.5)[kg * m ^ 2],
    points: [lower = (-0.4, 0, -0.8)[m], upper = (-0.4, 0, 0.8)[m]],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    moments: [friction = body(0, 0, -brake.abs())],
    reactions: [
        below = body(_, _, _).at(lower),
        beside = body(_, _, 0).at(upper)
    ],
    outputs: [reactions, energy],
});

rigid_body!(Wave::<T> {
    doc: "A point under all functions that there are, but one.",
    motion: translation,
    params: [scale = 1],
    mass: 2[kg],
    locals: [
        at = (position / 1[m]).in_world(),
        x = scale * at.x.sin(),
        y = at.y.cos() * (0.6 * x.tan()).asin() + x.acos().atan(),
        z = x.sinh() + y.cosh() - at.z.tanh() + x.exp() + (2 + x).ln(),
        roots = (2 + y).sqrt() + z.hypot(x) + (1.5 + x).powf(y) + z.atan2(x),
        steps = at.x.floor() + at.y.ceil() * at.z.signum() + x.abs() + x.min(y).max(at.z),
    ],
    forces: [pull = 1[N] * world(y, z, roots + 0.1 * steps - t / 1[s])],
});

rigid_body!(Bubble::<T> {
    doc: "The function that is missing there.",
    motion: translation,
    mass: 2[kg],
    forces: [pull = -1[N] * world((position / 1[m]).in_world().x.cbrt(), 0, 0)],
});

rigid_body!(Stone {
    doc: "A point by series, with drag.",
    motion: translation,
    mass: 2[kg],
    forces: [drag = -0.1 * velocity.norm() * velocity],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [taylor],
});

rigid_body!(Plank::<T> {
    doc: "In the plane.",
    motion: planar,
    params: [length = 2.4[m]],
    inputs: [thrust[N]],
    mass: 6[kg],
    inertia: mass * length.powi(2) / 12,
    points: [end = (length / 2, 0)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    forces: [push = body(0, thrust).at(end)],
    outputs: [energy, momentum, balance],
});

rigid_body!(Slider::<T> {
    doc: "In the plane, without turning.",
    motion: planar_translation,
    mass: 3[kg],
    forces: [
        spring = -4[N / m] * position,
        wave = 1[N] * world((t / 1[s]).sin(), 0)
    ],
});

rigid_body!(Pendulum::<T> {
    doc: "In closed form, with the force on its pin.",
    motion: pivot(pin),
    params: [length = 0.5[m]],
    mass: 2[kg],
    inertia: 0.01[kg * m ^ 2],
    points: [pin = (0, length)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    reactions: [hold = world(_, _).at(pin)],
    outputs: [flow, reactions, energy],
});

rigid_body!(Swing {
    doc: "The same by series.",
    motion: pivot(pin),
    mass: 2[kg],
    inertia: 0.01[kg * m ^ 2],
    points: [pin = (0, 0.5[m])],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    outputs: [taylor],
});

rigid_body!(Stick::<T> {
    doc: "A slender rod.",
    motion: rod(body(0, 0, 1)),
    inputs: [pull = world(_, _, _)[N]],
    mass: 0.5[kg],
    inertia: 0.06[kg * m ^ 2],
    points: [tip = (0, 0, 0.6)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [
        string = pull.at(tip),
        drag = -0.02 * velocity.norm() * velocity
    ],
    outputs: [energy, momentum],
});

rigid_body!(Needle {
    doc: "A free rod.",
    motion: rod(body(1, 0, 0)),
    mass: 0.5[kg],
    inertia: 0.06[kg * m ^ 2],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [flow],
});

rigid_body!(Dipole {
    doc: "Charges in a field, and a spring as a potential.",
    motion: spatial,
    mass: 2[kg],
    inertia: principal(1, 2, 2.5)[kg * m ^ 2],
    points: [
        p = (0.03, -0.01, 0.02),
        q = (-0.03, 0.01, -0.02),
        wall = world(1, 2, -1)
    ],
    locals: [spring = wall.position() - p.position()],
    fields: [electric = world(150, -40, 310)[V / m].on([2[mC].at(p), -2[mC].at(q)])],
    potentials: [rope = 15 * (spring.norm() - 0.7[m]).powi(2)],
    outputs: [energy],
});

rigid_body!(Bead {
    doc: "Held by a constraint, with its reaction.",
    motion: planar,
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [pin = (0, 0.5)[m]],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    constraints: [held = pin.position()],
    reactions: [hinge = world(_, _).at(pin)],
    outputs: [reactions, energy],
});

rigid_body!(Tethered {
    doc: "A constraint that may lose its hold.",
    motion: translation,
    inputs: [out[m].moving],
    mass: 1[kg],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    constraints: [taut = position.norm() - 1[m] - out],
    reactions: [string = _ * (position / 1[m])],
    outputs: [reactions],
});

rigid_body!(Stage {
    doc: "Spun up about its axis while it falls.",
    motion: spatial,
    mass: 2[kg],
    inertia: principal(0.3, 0.3, 0.1)[kg * m ^ 2],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    moments: [motor = body(0, 0, 0.2)[N * m]],
    outputs: [flow],
});
