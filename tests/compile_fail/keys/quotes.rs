use newton_euler::rigid_body;

rigid_body!(Stone {
    "motion": "translation",
    mass: 1[kg],
    params: ["push" = 1[N]],
    forces: [wind = world(push, 0, 0)],
});

fn main() {}
