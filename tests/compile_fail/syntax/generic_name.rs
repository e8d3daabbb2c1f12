use newton_euler::rigid_body;

rigid_body!(T::<T> {
    motion: translation,
    mass: 1[kg],
});

fn main() {}
