//! Constraints in the plane: published numbers, closed forms and second derivations.
//!
//! Accelerations and reactions are compared in consistent states, to 1e-13 of their size: a chain
//! of about twenty roundings, through divisors that are not near zero. No expected number comes
//! from generated code, except for the pendulum. That is derived in two ways: with a pin as a
//! constraint, and with a pin as a support.

use nalgebra::{Rotation2, Vector2};
use newton_euler::operations::{Operations, Stage};
use newton_euler::{integrate, prelude::*};

use crate::reference::{body, number, numbers};

const GRAVITY: f64 = 9.80665;

/// M3: a cylinder on an incline, in axes along it, and in world axes that are horizontal.
mod cylinder {
    newton_euler::rigid_body!(Stick {
        motion: planar,
        params: [m, r, ratio, slope],
        mass: m,
        inertia: ratio * m * r.powi(2),
        points: [contact = G - r * world(0, 1)],
        fields: [weight = mass * 9.80665[m / s ^ 2] * world(slope.sin(), -slope.cos())],
        constraints: [
            touching = position.in_world().y - r,
            rolling = contact.velocity().in_world().x,
        ],
        reactions: [
            normal = world(0, _).at(contact),
            friction = world(_, 0).at(contact)
        ],
        outputs: [reactions, balance],
    });

    newton_euler::rigid_body!(Horizontal {
        motion: planar,
        params: [m, r, ratio, slope],
        mass: m,
        inertia: ratio * m * r.powi(2),
        locals: [
            down = world(slope.cos(), -slope.sin()),
            up = world(slope.sin(), slope.cos()),
        ],
        points: [contact = G - r * up],
        fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
        constraints: [
            rolling = contact.velocity().dot(down),
            touching = position.dot(up) - r
        ],
        reactions: [
            friction = (_ * down).at(contact),
            normal = (_ * up).at(contact)
        ],
        outputs: [reactions, balance],
    });

    newton_euler::rigid_body!(Slip {
        motion: planar,
        params: [m, r, ratio, slope, mu],
        mass: m,
        inertia: ratio * m * r.powi(2),
        points: [contact = G - r * world(0, 1)],
        locals: [slip = contact.velocity().in_world().x],
        fields: [weight = mass * 9.80665[m / s ^ 2] * world(slope.sin(), -slope.cos())],
        constraints: [touching = position.in_world().y - r],
        reactions: [
            normal = world(0, _).at(contact),
            friction = world(-mu * normal.in_world().y * slip.signum(), 0).at(contact),
        ],
        outputs: [reactions, balance],
    });
}

#[test]
fn a_cylinder_on_an_incline_sticks() {
    let (given, expect) = (&body("M3")["given"], &body("M3")["expect"]);
    let [m, r, ratio, slope] = ["m", "r", "J_over_mr2", "beta"].map(|key| number(&given[key]));
    let along = number(&expect["a down-slope"]);
    let (normal, friction) = (number(&expect["N"]), number(&expect["friction up-slope"]));
    let state = Planar {
        position: [0.3, r].into(),
        angle: 1.2,
        velocity: [0.5, 0.0].into(),
        angular_velocity: -0.5 / r,
    };

    let params = cylinder::StickParams { m, r, ratio, slope };
    let stick = cylinder::Stick::new(params).unwrap();
    let acceleration = stick.acceleration(0.0, &state, &());
    let reactions = stick.reactions(0.0, &state, &()).unwrap();
    assert!((acceleration.linear.x - along).abs() < 1e-15 * 4.0);
    assert!(acceleration.linear.y.abs() < 1e-14);
    let roll = number(&expect["alpha (roll rate, magnitude)"]);
    assert!((acceleration.angular + roll).abs() < 1e-14);
    assert!((reactions.normal.y - normal).abs() < 1e-13);
    assert!((reactions.friction.x + friction).abs() < 1e-14);
    let least = number(&expect["min mu for no slip"]);
    assert!((-reactions.friction.x / reactions.normal.y - least).abs() < 1e-15);
    let residual = stick.residual(0.0, &state, &acceleration, &reactions, &());
    assert!(residual.force.norm() < 1e-13 && residual.moment.abs() < 1e-13);

    // the same in other axes, and with the unknowns in another order
    let turn = Rotation2::new(-slope);
    let turned = Planar {
        position: turn * state.position,
        velocity: turn * state.velocity,
        ..state
    };
    let params = cylinder::HorizontalParams { m, r, ratio, slope };
    let horizontal = cylinder::Horizontal::new(params).unwrap();
    let again = horizontal.acceleration(0.0, &turned, &());
    assert!((again.linear - turn * acceleration.linear).norm() < 1e-14);
    assert!((again.angular - acceleration.angular).abs() < 1e-14);
    let again = horizontal.reactions(0.0, &turned, &()).unwrap();
    assert!((again.normal - turn * reactions.normal).norm() < 1e-13);
    assert!((again.friction - turn * reactions.friction).norm() < 1e-13);
}

#[test]
fn a_cylinder_on_an_incline_slips() {
    let (given, expect) = (&body("M3")["given"], &body("M3")["expect"]);
    let [m, r, ratio, slope, mu] =
        ["m", "r", "J_over_mr2", "beta", "mu_slip"].map(|key| number(&given[key]));
    let [along, roll, friction] = numbers(&expect["slip mode mu=0.08: a,alpha,Ft"]);
    let params = cylinder::SlipParams {
        m,
        r,
        ratio,
        slope,
        mu,
    };
    let slip = cylinder::Slip::new(params).unwrap();
    let state = Planar {
        position: [0.0, r].into(),
        velocity: [1.0, 0.0].into(),
        ..Planar::default()
    };
    let acceleration = slip.acceleration(0.0, &state, &());
    assert!((acceleration.linear.x - along).abs() < 1e-15 * 4.0);
    assert!((acceleration.angular + roll).abs() < 1e-14);
    let reactions = slip.reactions(0.0, &state, &()).unwrap();
    let [weight, sliding] = slip.loads(0.0, &state, &());
    assert!((sliding.force.x + friction).abs() < 1e-14 && weight.name == "weight");
    let residual = slip.residual(0.0, &state, &acceleration, &reactions, &());
    assert!(residual.force.norm() < 1e-13 && residual.moment.abs() < 1e-13);
}

newton_euler::rigid_body!(Ladder {
    doc: "A rod that slides down a wall, x = 0, and along the floor, y = 0.",
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    points: [top = (0.6, 0)[m], foot = (-0.6, 0)[m]],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    constraints: [
        wall = top.position().in_world().x,
        floor = foot.position().in_world().y
    ],
    reactions: [
        at_floor = world(0, _).at(foot),
        at_wall = world(_, 0).at(top)
    ],
    outputs: [reactions, energy],
});

/// Consistent: `G = l (-cos, sin)`.
fn leaning(angle: f64, rate: f64) -> Planar {
    let (sine, cosine) = angle.sin_cos();
    Planar {
        position: Vector2::new(-cosine, sine) * 0.6,
        angle,
        velocity: Vector2::new(sine, cosine) * 0.6 * rate,
        angular_velocity: rate,
    }
}

/// What is known early is solved in the constructor; the ladder takes two divisors and one sine.
#[test]
fn operations_are_few() {
    let row = |rows: &[Operations], function: &str| {
        let mut rows = rows.iter().filter(|row| row.stage == Stage::State);
        let row = rows.find(|row| row.function == function).unwrap();
        [row.mul + row.add, row.div, row.trig]
    };
    assert_eq!(row(cylinder::Stick::OPERATIONS, "acceleration"), [0, 0, 0]);
    assert_eq!(row(cylinder::Stick::OPERATIONS, "reactions"), [0, 0, 0]);
    let [bead, ladder] =
        [Bead::OPERATIONS, Ladder::OPERATIONS].map(|rows| row(rows, "acceleration"));
    assert!(bead[0] <= 13 && bead[1..] == [1, 0], "{bead:?}");
    assert!(ladder[0] <= 33 && ladder[1..] == [2, 2], "{ladder:?}");
}

/// Lagrange: `(J + m l^2) angle'' = -m g l cos(angle)`; the reactions are m times the acceleration of G.
#[test]
fn a_ladder_slides_on_wall_and_floor() {
    let ladder = Ladder::default();
    let (m, l) = (2.0, 0.6);
    for (angle, rate) in [(1.3_f64, 0.0), (0.9, -1.1), (0.3, 2.0), (2.0, 0.5)] {
        let state = leaning(angle, rate);
        let (sine, cosine) = angle.sin_cos();
        let angular = -m * GRAVITY * l * cosine / (0.3 + m * l * l);
        let linear = Vector2::new(
            sine * angular + cosine * rate * rate,
            cosine * angular - sine * rate * rate,
        ) * l;
        let acceleration = ladder.acceleration(0.0, &state, &());
        assert!((acceleration.angular - angular).abs() < 1e-13 * 10.0);
        assert!((acceleration.linear - linear).norm() < 1e-13 * 10.0);
        let reactions = ladder.reactions(0.0, &state, &()).unwrap();
        assert!((reactions.at_wall.x - m * linear.x).abs() < 1e-12);
        assert!((reactions.at_floor.y - m * (linear.y + GRAVITY)).abs() < 1e-12);
    }
}

/// The wall can only push towards -x. From rest at the angle a, the rod leaves the wall where its sine is two thirds of that of a: the reaction changes sign.
#[test]
fn the_sign_of_a_reaction_says_where_contact_breaks() {
    let (ladder, start) = (Ladder::default(), 1.2_f64.sin());
    let push = |sine: f64| {
        let rate = -(2.0 * 2.0 * GRAVITY * 0.6 * (start - sine) / (0.3 + 2.0 * 0.36)).sqrt();
        let state = leaning(sine.asin(), rate);
        ladder.reactions(0.0, &state, &()).unwrap().at_wall.x
    };
    assert!(push(0.9 * start) < -0.5 && push(0.5 * start) > 0.5);
    assert!(push(2.0 / 3.0 * start).abs() < 1e-12);
}

newton_euler::rigid_body!(Bead {
    motion: planar_translation,
    params: [curvature = 0.8[1 / m]],
    mass: 0.1[kg],
    locals: [x = position.in_world().x],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    constraints: [wire = position.in_world().y - curvature / 2 * x.powi(2)],
    reactions: [push = _ * world(-curvature * x, 1)],
    outputs: [reactions, energy],
});

/// `(1 + y'^2) x'' = -y' (g + y'' v^2)`, and the push is m (g + y'' v^2) / (1 + y'^2) times (-y', 1).
#[test]
fn a_bead_slides_on_a_wire() {
    let bead = Bead::default();
    for (x, v) in [(0.0, 1.0), (1.5, -2.0), (-0.4, 0.3)] {
        let slope = 0.8 * x;
        let state = PlanarTranslation {
            position: [x, 0.4 * x * x].into(),
            velocity: [v, slope * v].into(),
        };
        let pushed = (GRAVITY + 0.8 * v * v) / (1.0 + slope * slope);
        let acceleration = bead.acceleration(0.0, &state, &());
        assert!((acceleration.x + slope * pushed).abs() < 1e-13 * 10.0);
        let reactions = bead.reactions(0.0, &state, &()).unwrap();
        let expected = Vector2::new(-slope, 1.0) * pushed * 0.1;
        assert!((reactions.push - expected).norm() < 1e-13);
    }
}

newton_euler::rigid_body!(Spinning {
    doc: "A bead on a straight wire that turns at a given rate: a constraint that depends on time.",
    motion: planar_translation,
    mass: 0.1[kg],
    params: [rate = 3[1 / s]],
    locals: [across = world(-(rate * t).sin(), (rate * t).cos())],
    constraints: [wire = position.dot(across)],
    reactions: [push = _ * across],
    outputs: [reactions],
});

/// In the axes of the wire: `r'' = rate^2 r`, and the wire pushes with `2 m rate r'`.
#[test]
fn a_wire_that_turns_drives_its_bead() {
    let (time, r, v, rate) = (0.7, 0.4, -0.9, 3.0);
    let turn = Rotation2::new(rate * time);
    let state = PlanarTranslation {
        position: turn * Vector2::new(r, 0.0),
        velocity: turn * Vector2::new(v, rate * r),
    };
    let spinning = Spinning::default();
    // relative to the wire: r'' - rate^2 r along it, 2 rate r' across
    let expected = turn * Vector2::new(0.0, 2.0 * rate * v);
    assert!((spinning.acceleration(time, &state, &()) - expected).norm() < 1e-13 * 10.0);
    let reactions = spinning.reactions(time, &state, &()).unwrap();
    assert!((reactions.push - expected * 0.1).norm() < 1e-13 * 10.0);
    let [wire] = spinning.violations(time, &state, &());
    assert!(wire.position.unwrap().abs() < 1e-15 && wire.velocity.abs() < 1e-15 * 10.0);
}

newton_euler::rigid_body!(Skate {
    doc: "A skate on an inclined plane: no position is forbidden, and at each a direction is.",
    motion: planar,
    mass: 70[kg],
    inertia: 2[kg * m ^ 2],
    points: [blade = (-0.1, 0)[m]],
    fields: [weight = mass * world(0, -1[m / s ^ 2])],
    constraints: [grip = blade.velocity().in_body().y],
    reactions: [edge = body(0, _).at(blade)],
    outputs: [reactions, energy],
});

/// Along and across the skate: `m (d w' + w v) = N - m g cos`, `J w' = -d N`, with the blade d behind G.
#[test]
fn a_skate_grips_across_its_blade() {
    let (skate, angle, ahead, rate) = (Skate::default(), 0.7_f64, 3.0, 1.3);
    let turn = Rotation2::new(angle);
    let state = Planar {
        position: [4.0, -2.0].into(),
        angle,
        velocity: turn * Vector2::new(ahead, 0.1 * rate),
        angular_velocity: rate,
    };
    let angular = -0.1 * 70.0 * (rate * ahead + angle.cos()) / (70.0 * 0.01 + 2.0);
    let acceleration = skate.acceleration(0.0, &state, &());
    assert!((acceleration.angular - angular).abs() < 1e-13 * 10.0);
    let edge = turn.inverse() * skate.reactions(0.0, &state, &()).unwrap().edge;
    assert!(edge.x.abs() < 1e-12 && (edge.y + 2.0 * angular / 0.1).abs() < 1e-11);

    let energy =
        |state: &Planar| skate.kinetic_energy(state) + skate.potential_energy(0.0, state, &());
    let later = integrate::cf4_projected(&skate, &state, &(), 0.0..2.0, 400).unwrap();
    assert!((energy(&later) - energy(&state)).abs() < 1e-6 * energy(&state).abs());
    let [grip] = skate.violations(0.0, &later, &());
    assert!(grip.position.is_none() && grip.velocity.abs() < 1e-15 * 10.0);
}
