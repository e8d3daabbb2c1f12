use newton_euler::rigid_body;

rigid_body!(Mobile {
    motion: spatial,
    points: [low = (0, 0, -depth)],
    locals: [depth = mass * 0.1[m / kg]],
    inertia: compose([sphere(0.1[m]).mass(2[kg]), point(1[kg]).at(low)]),
});

fn main() {}
