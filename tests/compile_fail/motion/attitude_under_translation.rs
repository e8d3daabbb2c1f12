use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: translation,
    mass: 1[kg],
    forces: [lift = angular_velocity.cross(velocity)],
});

fn main() {}
