use newton_euler::rigid_body;

rigid_body!();

fn main() {}
