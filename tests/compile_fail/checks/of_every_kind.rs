use newton_euler::{rigid_body, rigid_system};

rigid_body!(Disc {
    motion: planar,
    mass: 2[kg],
    inertia: 1[kg * m ^ 2],
    checks: [
        heavy = mass == 3[kg],
        fast = nonsense > 1,
        light = mass < 1[kg] && mass > 1[m],
        slow = (energy < 0[J]).given(position = world(0, 0), velocity = world(0, 0), angle = 0, angular_velocity = 1[rad / s]),
    ],
});

rigid_system!(Pair {
    motion: planar,
    bodies: [a { mass: 2[kg], inertia: 1[kg * m ^ 2] }],
    joints: [orbit = free(a)],
    checks: [
        heavy = a.mass == 3[kg],
        fast = a.nonsense > 1,
        light = a.mass < 1[kg],
    ],
});

fn main() {}
