//! A ball on a turntable moves in a circle at 2/7 of the rate of the table, if that rate is given
//! (Weckesser, *A ball rolling on a freely spinning turntable*).

use newton_euler::prelude::*;

rigid_body!(Ball {
    motion: spatial,
    params: [rate = 2[rad / s], radius = 0.1[m]],
    mass: 0.4[kg],
    inertia: sphere(0.1[m]),
    locals: [
        down = world(0, 0, -1) * radius,
        matter = (world(0, 0, 1) * rate).cross(position + down)
    ],
    points: [contact = G + down],
    fields: [weight = mass * world(0, 0, -9.81)[m / s ^ 2]],
    constraints: [rolling = contact.velocity() - matter],
    reactions: [support = world(_, _, _).at(contact)],
    outputs: [reactions],
});

/// The vertical velocity is a sum of nothing but zeros, beside which all rounding is large.
#[test]
fn a_ball_goes_round() {
    let ball = Ball::default();
    let mut start = Spatial {
        position: [0.3, 0.0, 0.1].into(),
        velocity: [0.0, 0.6, 0.0].into(),
        ..Spatial::default()
    };
    ball.project(0.0, &mut start, &()).unwrap();
    let turns = 2.0 / 7.0 * 2.0;
    let half = core::f64::consts::PI / turns;
    let end = ball.integrate(&start).tolerance(1e-12).to(half).unwrap();
    // v = turns e_z x (r - center)
    let center = [
        start.position.x - start.velocity.y / turns,
        start.position.y + start.velocity.x / turns,
    ];
    for (axis, center) in center.into_iter().enumerate() {
        let opposite = 2.0 * center - start.position[axis];
        assert!((end.position[axis] - opposite).abs() < 1e-10);
        assert!((end.velocity[axis] + start.velocity[axis]).abs() < 1e-10);
    }
    let reactions = ball.reactions(half, &end, &()).unwrap();
    assert!((reactions.support.z - 0.4 * 9.81).abs() < 1e-11);
}
