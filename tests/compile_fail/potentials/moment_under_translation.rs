use newton_euler::rigid_body;

rigid_body!(Drone {
    motion: translation,
    mass: 2[kg],
    points: [tip = (1, 0, 0)],
    potentials: [spring = 2[N / m] * tip.position().norm_squared()],
});

fn main() {}
