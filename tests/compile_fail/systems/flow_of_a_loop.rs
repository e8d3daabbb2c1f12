use newton_euler::rigid_system;

rigid_system!(Drawer {
    motion: planar,
    bodies: [slab { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [left = (-1, 0), right = (1, 0)] }],
    joints: [
        first = revolute(world(-1, 0), slab.left),
        second = pin_in_slot(world(1, 0), slab.right, body(1, 0)),
    ],
    outputs: [flow],
});

fn main() {}
