use newton_euler::rigid_system;

rigid_system!({ bodies: [] });

fn main() {}
