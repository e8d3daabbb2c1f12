use newton_euler::rigid_system;

// generic, so that the struct of its drives has a scalar
rigid_system!(Arm::<T> {
    motion: planar,
    bodies: [upper { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [o = (-0.05, 0)] }],
    joints: [o = revolute(world(0, 0), upper.o)],
    outputs: [inverse],
});

fn main() {}
