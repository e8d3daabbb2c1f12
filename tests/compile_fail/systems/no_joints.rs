use newton_euler::rigid_system;

rigid_system!(Alone { bodies: [arm { mass: 1[kg], inertia: sphere(1[m]) }] });

fn main() {}
