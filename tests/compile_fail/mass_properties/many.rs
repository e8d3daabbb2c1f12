use newton_euler::rigid_body;

rigid_body!(Drone {
    motion: spatial,
    points: [arm = (0.2, 0, 0), tip = (0.3, 0, 0[s])],
    inertia: compose([
        cuboid(0.1[m], 0.1[m]).mass(1[kg]),
        rod(0.4[m]).along(body(1, 0)).mass(0.1[kg]),
        point(0.05[kg]).at(arn),
        point(0.05[kg]).at(tip),
        sphere(0.1[m]).at(arm) + 1,
        disc(0.1[m] as f64).mass(0.1[kg]),
        disc(0.1[m]).mass(0.1[s]).at(arm),
    ]),
    forces: [lift = body(0, 0, mass * 10).at(tip)],
});

fn main() {}
