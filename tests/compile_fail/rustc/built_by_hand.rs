use newton_euler::prelude::*;

rigid_body!(Sled::<T> {
    motion: planar_translation,
    params: [stiffness = 40[N / m]],
    mass: 2[kg],
    forces: [spring = -stiffness * position],
});

fn main() {
    let params = SledParams { stiffness: 3.0 };
    let _sled = Sled::<f64> { params, ..Sled::default() };
}
