use newton_euler::rigid_body;

rigid_body!(Top {
    motion: rotation,
    mass: 1[kg],
    points: [tip = (0, 0, -0.05)[m]],
    inertia: cone(0.1[m], 0.2[m]).about(tip),
});

rigid_body!(Roller {
    motion: planar,
    mass: 1[kg],
    inertia: cylinder(0.1[m], 0.2[m]).along(body(1, 0)).about((0.1, 0)),
});

fn main() {}
