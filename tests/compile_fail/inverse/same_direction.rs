use newton_euler::rigid_body;

rigid_body!(Hoisted {
    motion: planar,
    mass: 3[kg],
    inertia: 0.2[kg * m ^ 2],
    points: [tip = (0.3, 0.1)],
    forces: [a = world(0, _).at(tip), b = (_ * world(0, 2)).at(tip)],
    outputs: [inverse],
});

fn main() {}
