use newton_euler::rigid_body;

rigid_body!(Buoy {
    motion: spatial,
    mass: 2,
    inertia: principal(1, 2, 2.5),
    points: [tip = (0.5, 0, 0), wall = world(3, 2, -1)],
    forces: [rope = (-4 * (tip.position() - wall)).at(tip)],
});

fn main() {}
