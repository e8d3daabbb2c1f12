use newton_euler::rigid_body;

const HEIGHT: f64 = 3.0;

fn gust(height: f64) -> f64 {
    height
}

rigid_body!(Kite {
    motion: spatial,
    mass: 2[kg],
    inertia: principal(1, 2, 3)[kg * m ^ 2],
    let lift = 3[N],
    forces: [
        pull = [1, 2, 3][N],
        wind = world(gust(HEIGHT), 0, lift),
        weight = world(0, 0, -9.81[m / s2]) * mass,
        for each in 0..3,
    ],
});

rigid_body!(Door {
    motion: fixed_axis(hinge),
    mass: 2[kg],
    inertia: principal(1, 2, 3)[kg * m ^ 2],
    points: [hinge = (0, 0, 1)[m]],
    forces: [damping = -velocity * 2[N * s / m]],
});

fn main() {
    let _ = gust(HEIGHT);
}
