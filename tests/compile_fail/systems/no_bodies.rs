use newton_euler::rigid_system;

rigid_system!(Nothing { bodies: [], joints: [] });

fn main() {}
