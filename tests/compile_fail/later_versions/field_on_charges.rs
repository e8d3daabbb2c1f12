use newton_euler::rigid_body;

rigid_body!(Drone {
    motion: spatial,
    mass: 1.2[kg],
    inertia: principal(0.02, 0.03, 0.04)[kg * m ^ 2],
    points: [p = (0.1, 0, 0)],
    fields: [electric = world(0, 0, 3).on([2.at(p)])],
});

fn main() {}
