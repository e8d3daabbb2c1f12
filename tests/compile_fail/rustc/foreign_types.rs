use newton_euler::{Scalar, rigid_body};

const COUNT: u32 = 3;

fn lift(alpha: f64) -> f64 {
    alpha
}

fn drag<T: Scalar>(alpha: T) -> T {
    alpha
}

rigid_body!(Wing {
    motion: translation,
    mass: 12[kg],
    constants: [count = COUNT[N]],
    functions: [lift(alpha, beta) = lift[N], lost(alpha) = crate::curves::lost[N]],
    forces: [
        lift = (count + lift(1, 2) + lost(t / 1[s])) * world(1, 0, 0),
        again = lift(1, 3) * world(1, 0, 0),
    ],
});

// a body over any scalar needs functions over any
rigid_body!(Sail::<T> {
    motion: translation,
    mass: 12[kg],
    functions: [lift(alpha) = lift[N], drag(alpha) = drag[N]],
    forces: [lift = (lift(t / 1[s]) + drag(t / 1[s])) * world(1, 0, 0)],
});

fn main() {}
