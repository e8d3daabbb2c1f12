use newton_euler::rigid_body;

rigid_body!(Drone {
    motion: rotation,
    mass: 2[kg],
    inertia: principal(2, 3, 4)[kg * m ^ 2],
    potentials: [spring = 2[N / m] * position.norm_squared()],
});

fn main() {}
