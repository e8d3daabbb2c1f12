//! Descriptions in which states prescribe a motion.

use newton_euler::prelude::*;

macro_rules! crane {
    ($name:ident [$($scalar:tt)*], $motion:expr, [$($of_its_own:tt)*], [$($outputs:ident),*]) => {
        rigid_system!($name $($scalar)* {
            motion: planar,
            $($of_its_own)*
            bodies: [
                mast {
                    mass: 90[kg],
                    inertia: 40[kg * m ^ 2],
                    points: [foot = (0, -2)[m], top = (0.3, 2)[m]],
                },
                boom { mass: 30[kg], inertia: 12[kg * m ^ 2], points: [tip = (1.2, 0.1)[m]] },
                load { mass: 50[kg], inertia: 4[kg * m ^ 2], points: [eye = (0, 3)[m]] },
            ],
            joints: [
                tower = revolute(world(0, 0), mast.foot),
                rail = prismatic(mast.top, boom.G, body(1, 0.2)).driven($motion),
                hook = revolute(boom.tip, load.eye),
            ],
            fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
            drives: [stiffness = (-2000[N * m] * tower.angle).on(tower)],
            outputs: [$($outputs),*],
        });
    };
}

crane!(
    Crane [::<T>],
    reach + 0.1[m] * (reach / 1[m]).sin(),
    [
        params: [lag = 0.4[s]],
        inputs: [command[m / s]],
        states: [reach[m], speed[m / s]],
        rates: [reach = speed, speed = (command - speed) / lag],
    ],
    [energy, reactions, taylor, linearization]
);
crane!(Given [], place, [inputs: [place[m].moving],], [energy, reactions]);

rigid_system!(Turret {
    doc: "Nothing moves but what states prescribe.",
    inputs: [torque[N * m]],
    states: [angle[rad], speed[rad / s]],
    rates: [angle = speed, speed = torque / 3[kg * m ^ 2]],
    bodies: [
        base {
            mass: 9[kg],
            inertia: principal(1, 1, 2)[kg * m ^ 2]
        },
        barrel {
            mass: 2[kg],
            inertia: principal(0.1, 0.2, 0.3)[kg * m ^ 2],
            points: [pin = (-0.3, 0, 0)[m]],
        },
    ],
    joints: [
        yaw = revolute(world(0, 0, 0), base.G, world(0, 0, 1)).driven(angle),
        pitch = revolute(base.G, barrel.pin, body(0, 1, 0)).driven(0.3[rad] * angle.sin()),
    ],
    outputs: [reactions],
});

rigid_body!(Slider::<T> {
    doc: "A rail moves sideways as a state does, and a motor prescribes the speed of turning.",
    motion: planar,
    inputs: [command[m / s], pace[rad / s]],
    states: [place[m], speed[m / s], spin[rad / s]],
    rates: [
        place = speed + 0.2[1 / s] * position.in_world().y,
        speed = (command - speed) / 0.3[s] - 0.1[1 / s] * velocity.in_world().y,
        spin = (pace - spin) / 0.1[s],
    ],
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    constraints: [
        rail = position.in_world().x - place,
        motor = angular_velocity - spin,
    ],
    reactions: [side = world(_, 0), torque = moment(_)],
    outputs: [reactions, taylor, linearization],
});

macro_rules! arm {
    ($name:ident, [$($joint:tt)*], [$($constraints:tt)*]) => {
        rigid_system!($name::<T> {
            inputs: [command[rad / s]],
            states: [target[rad], speed[rad / s]],
            rates: [target = speed, speed = (command - speed) / 0.2[s]],
            bodies: [
                upper {
                    mass: 3[kg],
                    inertia: principal(0.2, 0.3, 0.4)[kg * m ^ 2],
                    points: [pin = (-0.4, 0, 0)[m], tip = (0.4, 0.1, 0)[m]],
                },
                lower {
                    mass: 2[kg],
                    inertia: principal(0.1, 0.3, 0.2)[kg * m ^ 2],
                    points: [pin = (-0.3, 0, 0.1)[m]],
                },
            ],
            joints: [
                shoulder = revolute(world(0, 0, 0), upper.pin, body(0, 1, 0.2))$($joint)*,
                elbow = spherical(upper.tip, lower.pin),
            ],
            $($constraints)*
            fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
            outputs: [reactions, linearization],
        });
    };
}

arm!(Led, [], [constraints: [follow = shoulder.angle - 2 * target],]);
arm!(Driven, [.driven(2 * target)], []);
