use newton_euler::rigid_body;

rigid_body!(Drone {
    motion: spatial,
    mass: 2[kg],
    inertia: principal(2, 3, 4)[kg * m ^ 2],
    points: [tip = (1, 0, 0)],
    potentials: [spring = (2[N / m] * position.norm_squared()).at(tip)],
});

fn main() {}
