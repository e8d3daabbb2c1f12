use newton_euler::rigid_body;

rigid_body!(Drone {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    points: [p = (0.1, 0)],
    fields: [electric = world(0, 3)[V / m].on([(attitude * 2[C]).at(p)])],
});

fn main() {}
