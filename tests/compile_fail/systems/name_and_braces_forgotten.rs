use newton_euler::rigid_system;

rigid_system!(motion: planar, bodies: [disk { mass: 1[kg], inertia: 0.1[kg * m ^ 2] }], joints: [loose = free(disk)]);

fn main() {}
