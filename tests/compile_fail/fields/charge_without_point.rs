use newton_euler::rigid_body;

rigid_body!(Drone {
    motion: spatial,
    mass: 2[kg],
    inertia: principal(2, 3, 4)[kg * m ^ 2],
    points: [p = (0.1, 0, 0)],
    fields: [electric = world(0, 0, 3)[V / m].on([2[C].at(p), 1[C]])],
});

fn main() {}
