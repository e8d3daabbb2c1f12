use newton_euler::rigid_body;

rigid_body!(Barge {
    motion: spatial,
    params: [far = 1e8[m], about_far = 1000000000000000.185[kg * m ^ 2]],
    mass: 0.1[kg],
    inertia: principal(0.37[kg * m ^ 2], about_far, about_far).about((far, 0, 0)),
});

fn main() {}
