use newton_euler::rigid_system;

rigid_system!(Arm {
    params: [lost = -2[kg * m ^ 2]],
    bodies: [
        base { mass: 1[kg], inertia: sphere(1[m]) },
        arm { mass: 1[kg], inertia: sphere(1[m]) },
        fore { mass: 1[kg], inertia: sphere(1[m]) },
        hand { mass: 1[kg], inertia: sphere(1[m]) },
        tip { mass: 1[kg], inertia: sphere(1[m]) },
        nail { mass: 1[kg], inertia: sphere(1[m]) },
    ],
    joints: [
        a = revolute(world(0, 0, 0), base.G, body(0, 0, 1)).armature(1[kg]),
        b = spherical(base.G, arm.G).armature(1[kg * m ^ 2]),
        c = prismatic(arm.G, fore.G, body(0, 0, 1)).armature(-1[kg]),
        d = revolute(fore.G, hand.G, body(0, 0, 1)).armature(t * 1[kg * m ^ 2 / s]),
        e = revolute(hand.G, tip.G, body(0, 0, 1)).armature(),
        f = revolute(tip.G, nail.G, body(0, 0, 1)).armature(1[kg * m ^ 2] + lost),
    ],
});

fn main() {}
