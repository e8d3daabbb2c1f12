use newton_euler::rigid_body;

rigid_body!(Mote {
    motion: translation,
    mass: 2[μg],
});

fn main() {}
