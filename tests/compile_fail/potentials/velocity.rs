use newton_euler::rigid_body;

rigid_body!(Drone {
    motion: spatial,
    mass: 2[kg],
    inertia: principal(2, 3, 4)[kg * m ^ 2],
    potentials: [motion = mass / 2 * velocity.norm_squared()],
});

fn main() {}
