use newton_euler::rigid_system;

rigid_system!(Arm {
    motion: planar,
    bodies: [
        rod {
            mass: 1[kg],
            inertia: 1[kg * m ^ 2],
            points: [end = (1, 0)[m]],
            constraints: [wire = end.position().in_world().y],
            forces: [push = (2[N] * wire.gradient()).at(end)],
        },
    ],
    joints: [away = free(rod)],
});

fn main() {}
