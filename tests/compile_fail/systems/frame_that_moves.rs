use newton_euler::prelude::*;

rigid_system!(Crane {
    bodies: [
        trolley {
            mass: 0[kg],
            points: [hook = (0, 0, -1)[m]]
        },
        load {
            mass: 0[kg],
            inertia: sphere(0.1[m])
        },
        eye { mass: 0[m] },
    ],
    joints: [
        rail = prismatic(world(0, 0, 0), trolley.G, body(1, 0, 0)),
        rope = spherical(trolley.hook, load.G),
        ring = weld(trolley.hook, eye.G),
    ],
});

rigid_system!(Gantry {
    bodies: [
        bridge {
            mass: 0[kg],
            points: [rail = (0, 1, 0)[m]]
        },
        hook { mass: 0[kg] },
        load {
            mass: 2[kg],
            inertia: sphere(0.1[m])
        },
    ],
    joints: [
        long = prismatic(world(0, 0, 0), load.G, body(1, 0, 0)),
        across = prismatic(world(0, 0, 0), bridge.rail, body(0, 1, 0)),
        up = prismatic(bridge.rail, hook.G, body(0, 0, 1)),
    ],
});

fn main() {}
