//! Systems that have a closed form, and bodies that are parts of them.

use newton_euler::prelude::*;

rigid_system!(Boom {
    doc: "A dual-spin satellite with its rotor on a boom, and a motor that spins it up.",
    bodies: [
        hub {
            mass: 50[kg],
            inertia: principal(11.6, 11.6, 9),
            points: [end = (0, 0, 0.7)]
        },
        rotor {
            mass: 3[kg],
            inertia: principal(0.4, 0.4, 0.6)
        },
    ],
    joints: [
        orbit = free(hub),
        spin = revolute(hub.end, rotor.G, body(0, 0, 1))
    ],
    fields: [pull = mass * world(0, 0.5, -9.80665[m / s ^ 2])],
    drives: [motor = 0.02[N * m].on(spin)],
    outputs: [flow, taylor, momentum, energy],
});

rigid_system!(Free {
    bodies: [
        hub {
            mass: 8[kg],
            inertia: principal(0.5, 0.9, 0.9),
            points: [seat = (-0.2, 0, 0)]
        },
        rotor {
            mass: 2[kg],
            inertia: principal(0.03, 0.02, 0.02)
        },
    ],
    joints: [
        orbit = free(hub),
        spin = revolute(hub.seat, rotor.G, body(1, 0, 0))
    ],
    outputs: [flow, taylor, momentum, energy],
});

rigid_system!(Spun {
    doc: "A satellite that thrusters spin up while a motor spins its rotor down.",
    params: [thrust = 0.3[N * m]],
    bodies: [
        hub {
            mass: 5[kg],
            inertia: principal(2, 2, 1),
            moments: [thrusters = body(0, 0, thrust)]
        },
        rotor {
            mass: 3[kg],
            inertia: principal(0.4, 0.4, 0.6)
        },
    ],
    joints: [
        orbit = free(hub),
        spin = revolute(hub.G, rotor.G, body(0, 0, 1))
    ],
    drives: [motor = (-0.05[N * m]).on(spin)],
    outputs: [flow, taylor],
});

rigid_system!(Tilted {
    doc: "A ball with two rotors along a slant, one behind the other.",
    params: [moment = 0.75[kg * m ^ 2], speed_up = 0.001[N * m]],
    bodies: [
        hub {
            mass: 4[kg],
            inertia: principal(moment, moment, moment)
        },
        first {
            mass: 0.5[kg],
            inertia: cylinder(0.2, 0.01).along(body(0, 3, 4))
        },
        second {
            mass: 0.5[kg],
            inertia: cylinder(0.3, 0.02).along(body(0, 3, 4))
        },
    ],
    joints: [
        socket = rotation(hub),
        near = revolute(hub.G, first.G, body(0, 3, 4)),
        far = revolute(hub.G, second.G, body(0, 3, 4)),
    ],
    drives: [motor = speed_up.on(far)],
    outputs: [flow, taylor, momentum],
});

rigid_system!(Apart {
    doc: "Bodies that have nothing to do with each other.",
    params: [m = 2[kg]],
    bodies: [
        brick {
            mass: 2[kg],
            inertia: principal(0.01, 0.02, 0.026)
        },
        drum {
            mass: 2[kg],
            inertia: cylinder(0.1[m], 0.7[m]).along(body(0, 3, 4))
        },
        stage {
            mass: 5[kg],
            inertia: principal(2, 2, 1),
            moments: [motor = body(0, 0, 0.1[N * m])]
        },
        top {
            mass: m,
            inertia: principal(0.02, 0.02, 0.03),
            points: [tip = (0, 0, -0.3)]
        },
        bob {
            mass: m,
            inertia: principal(0.02, 0.02, 0.03),
            points: [hinge = (0, 0, 0.4)]
        },
        cart {
            mass: 3[kg],
            inertia: principal(1, 1, 1),
            forces: [push = world(6[N], 0, 0)]
        },
        nut {
            mass: 1[kg],
            inertia: principal(1e-3, 1e-3, 1e-3)
        },
    ],
    joints: [
        flight = free(brick),
        tumble = free(drum),
        spin_up = rotation(stage),
        foot = spherical(world(0, 0, 0), top.tip),
        swing = revolute(world(0, 0, 0), bob.hinge, world(0, 1, 0)),
        rail = prismatic(world(0, 0, 0), cart.G, world(1, 0, 0)),
        thread = screw(world(0, 0, 0), nut.G, world(0, 0, 1), 0.01[m / rad]),
    ],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [flow, taylor],
});

rigid_body!(Brick {
    motion: spatial,
    mass: 2[kg],
    inertia: principal(0.01, 0.02, 0.026),
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [flow],
});

rigid_body!(Drum {
    motion: spatial,
    mass: 2[kg],
    inertia: cylinder(0.1[m], 0.7[m]).along(body(0, 3, 4)),
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [flow],
});

rigid_body!(Stage {
    motion: rotation,
    inertia: principal(2, 2, 1),
    moments: [motor = body(0, 0, 0.1[N * m])],
    outputs: [flow],
});

rigid_body!(Top {
    motion: fixed_point(tip),
    params: [m = 2[kg]],
    mass: m,
    inertia: principal(0.02, 0.02, 0.03),
    points: [tip = (0, 0, -0.3)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [flow],
});

rigid_body!(Bob {
    motion: fixed_axis(hinge, world(0, 1, 0)),
    params: [m = 2[kg]],
    mass: m,
    inertia: principal(0.02, 0.02, 0.03),
    points: [hinge = (0, 0, 0.4)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [flow],
});

rigid_system!(Generic::<T> {
    doc: "Over any scalar: its closed form is that of `f64`. A panel is welded on beside the center.",
    params: [
        moment = 2[kg * m ^ 2],
        offset = 0.3[m],
        g = world(0, 0, -1.62)[m / s ^ 2]
    ],
    bodies: [
        hub {
            mass: 4[kg],
            inertia: principal(moment, 3, 1),
            points: [side = (offset, 0, 0)]
        },
        panel {
            mass: 1.5[kg],
            inertia: principal(0.1, 0.2, 0.3)
        },
    ],
    joints: [flight = free(hub), fixed = weld(hub.side, panel.G)],
    fields: [weight = mass * g],
    outputs: [flow, taylor],
});

rigid_system!(Flat {
    doc: "In the plane: a plate with a flywheel beside its center of mass, a pendulum and a sled.",
    motion: planar,
    bodies: [
        plate {
            mass: 2[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [seat = (0.2, 0.1)]
        },
        wheel {
            mass: 1[kg],
            inertia: 0.02[kg * m ^ 2]
        },
        bob {
            mass: 1[kg],
            inertia: 0.02[kg * m ^ 2],
            points: [pin = (0, 0.5)]
        },
        sled {
            mass: 1[kg],
            inertia: 0.02[kg * m ^ 2]
        },
        ball { mass: 1[kg] },
    ],
    joints: [
        flight = free(plate),
        spin = revolute(plate.seat, wheel.G),
        swing = revolute(world(0, 0), bob.pin),
        slide = pin_in_slot(world(0, 0), sled.G, world(1, 1)),
        throw = translation(ball),
    ],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    drives: [motor = 0.05[N * m].on(spin)],
    outputs: [flow, taylor],
});

rigid_system!(Aimed {
    doc: "A ball whose rotor turns about an axis of params, one component of which is zero.",
    params: [a = 1, b = 0],
    bodies: [
        hub {
            mass: 4[kg],
            inertia: principal(0.3, 0.3, 0.3)
        },
        rotor {
            mass: 0.5[kg],
            inertia: principal(0.1, 0.1, 0.1)
        },
    ],
    joints: [
        socket = rotation(hub),
        spin = revolute(hub.G, rotor.G, body(a, 0, b))
    ],
    drives: [motor = 0.02[N * m].on(spin)],
    outputs: [flow, taylor],
});

rigid_system!(Slanted {
    doc: "A pendulum about a slanted axis, as the body `Leaning`.",
    bodies: [bob {
        mass: 2[kg],
        inertia: principal(0.02, 0.025, 0.03),
        points: [pin = (0.1, 0, 0.4)]
    },],
    joints: [swing = revolute(world(0, 0, 0), bob.pin, world(1, 2, 2))],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [flow],
});

rigid_body!(Leaning {
    motion: fixed_axis(pin, world(1, 2, 2)),
    mass: 2[kg],
    inertia: principal(0.02, 0.025, 0.03),
    points: [pin = (0.1, 0, 0.4)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [flow],
});

rigid_system!(Bolted {
    doc: "A rotor on a mount that is welded to the hub, and one behind a turn.",
    bodies: [
        hub {
            mass: 8[kg],
            inertia: principal(0.5, 0.9, 0.9),
            points: [seat = (-0.2, 0, 0), far = (0.3, 0, 0)]
        },
        mount {
            mass: 1[kg],
            inertia: principal(0.03, 0.02, 0.02)
        },
        rotor {
            mass: 2[kg],
            inertia: principal(0.03, 0.02, 0.02)
        },
        wheel {
            mass: 1[kg],
            inertia: principal(0.01, 0.01, 0.015)
        },
    ],
    joints: [
        orbit = free(hub),
        bolt = weld(hub.seat, mount.G),
        spin = revolute(mount.G, rotor.G, body(1, 0, 0)),
        roll = revolute(hub.far, wheel.G, body(0, 0, 1)).turned(body(0, 1, 0), 90[deg]),
    ],
    drives: [motor = 0.02[N * m].on(roll)],
    outputs: [flow, taylor],
});

rigid_system!(Leaned {
    doc: "A ball with a rotor whose axis is turned by 30 deg.",
    bodies: [
        hub {
            mass: 8[kg],
            inertia: principal(0.3, 0.3, 0.3)
        },
        rotor {
            mass: 2[kg],
            inertia: principal(0.02, 0.02, 0.03)
        },
    ],
    joints: [
        orbit = free(hub),
        spin = revolute(hub.G, rotor.G, body(0, 0, 1)).turned(body(0, 1, 0), 30[deg]),
    ],
    outputs: [flow, taylor],
});

rigid_system!(Pulled {
    doc: "A plate that a force pulls, with a wheel on a pin beside its center of mass.",
    motion: planar,
    bodies: [
        plate {
            mass: 2[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [seat = (0.2, 0.1)],
            forces: [pull = world(1[N], 0.5[N])]
        },
        wheel {
            mass: 1[kg],
            inertia: 0.02[kg * m ^ 2]
        },
    ],
    joints: [flight = free(plate), spin = revolute(plate.seat, wheel.G)],
    outputs: [flow, taylor],
});

rigid_system!(Clock {
    doc: "A pendulum whose bob carries two wheels, one about the opposite direction, with a motor.",
    bodies: [
        rod {
            mass: 1[kg],
            inertia: principal(0.1, 0.1, 0.01),
            points: [top = (0, 0, 0.5), foot = (0, 0, -0.5)]
        },
        bob {
            mass: 2[kg],
            inertia: principal(0.02, 0.03, 0.02)
        },
        wheel {
            mass: 1[kg],
            inertia: principal(0.01, 0.02, 0.01)
        },
    ],
    joints: [
        swing = revolute(world(0, 0, 0), rod.top, world(0, 1, 0)),
        hang = revolute(rod.foot, bob.G, body(0, 1, 0)),
        back = revolute(rod.foot, wheel.G, body(0, -1, 0)),
    ],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [flow, taylor],
});
