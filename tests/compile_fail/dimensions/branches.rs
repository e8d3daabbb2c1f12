use newton_euler::rigid_body;

rigid_body!(Drone {
    motion: spatial,
    mass: 1.2[kg],
    inertia: principal(0.02, 0.03, 0.04)[kg * m ^ 2],
    inputs: [thrust[N]],
    forces: [lift = body(0, 0, if t < 2[s] { thrust } else { 1[kg] })],
});

fn main() {}
