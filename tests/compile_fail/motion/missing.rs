use newton_euler::rigid_body;

rigid_body!(Stone { mass: 1[kg] });

fn main() {}
