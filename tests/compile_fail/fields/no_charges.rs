use newton_euler::rigid_body;

rigid_body!(Drone {
    motion: spatial,
    mass: 2[kg],
    inertia: principal(2, 3, 4)[kg * m ^ 2],
    fields: [electric = world(0, 0, 3)[V / m].on([])],
});

fn main() {}
