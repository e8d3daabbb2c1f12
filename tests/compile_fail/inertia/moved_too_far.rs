use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2].about(end),
    points: [end = (0.5[m], 0)],
});

fn main() {}
