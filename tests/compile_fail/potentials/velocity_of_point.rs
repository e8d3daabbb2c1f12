use newton_euler::rigid_body;

rigid_body!(Drone {
    motion: spatial,
    mass: 2[kg],
    inertia: principal(2, 3, 4)[kg * m ^ 2],
    points: [tip = (1, 0, 0)],
    potentials: [slide = world(0, 0, 3[N * s]).dot(tip.velocity())],
});

fn main() {}
