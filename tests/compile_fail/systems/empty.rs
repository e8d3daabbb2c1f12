use newton_euler::rigid_system;

rigid_system!(Nothing {});

fn main() {}
