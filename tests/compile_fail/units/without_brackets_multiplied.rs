use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: translation,
    params: [drag = 0.2 kg/m, height = 1.5 * ft, speed = 3 m/s2],
    mass: 2 * kg,
    fields: [weight = mass * world(0, 0, -9.81) m s^-2],
    potentials: [spring = 3 N / m * height.powi(2)],
});

fn main() {}
