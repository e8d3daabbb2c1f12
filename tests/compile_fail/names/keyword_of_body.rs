use newton_euler::rigid_body;

rigid_body!(struct { motion: translation, mass: 1[kg] });

fn main() {}
