use newton_euler::rigid_system;

rigid_system!(Satellite {
    inputs: [push[N], turn[N * m]],
    bodies: [hub { mass: 120[kg], inertia: principal(12, 14, 9)[kg * m ^ 2] }],
    joints: [orbit = free(hub)],
    drives: [
        one = push.on(orbit.position),
        two = world(0, 0, push).on(orbit.attitude),
        three = world(0, 0, turn).on(orbit.angle),
        four = moment(world(0, 0, turn)).on(orbit.attitude),
    ],
});

fn main() {}
