use newton_euler::rigid_system;

rigid_system!(Loose { S: { bodies: [disk { mass: 1[kg], inertia: 0.1[kg * m ^ 2] }], joints: [loose = free(disk)] }, motion: planar });

fn main() {}
