use newton_euler::rigid_body;

rigid_body!(Kite {
    motion: spatial,
    mass: 1[kg],
    inertia: principal(1, 1, 1)[kg * m ^ 2],
    params: [c = 0.2[kg / m]],
    forces: [drag = -c * abs(velocity) * velocity],
});

fn main() {}
