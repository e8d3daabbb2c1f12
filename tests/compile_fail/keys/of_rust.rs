use newton_euler::rigid_body;

rigid_body!(Constants {
    motion: translation,
    mass: 1[kg],
    const K: f64 = 3.0,
    static L: f64 = 3.0,
    let weight = 9.81,
});

rigid_body!(Functions {
    motion: translation,
    mass: 1[kg],
    fn lift(x) { x },
});

rigid_body!(Thousands {
    motion: translation,
    mass: 1,200[g],
});

rigid_body!(Comment {
    motion: translation,
    mass: 1[kg],
    <!-- of a feather -->
});

rigid_body!(Angles {
    motion: rotation,
    inertia: principal(1, 2, 3)[kg * m ^ 2],
    locals: [bank = roll, spin = wz],
});

fn main() {}
