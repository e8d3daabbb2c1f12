//! Smooth supports: reactions along the gradients of their constraints, compared with closed forms
//! and with the same directions written by hand.

use nalgebra::Vector2;
use newton_euler::prelude::*;

const GRAVITY: f64 = 9.81;

newton_euler::rigid_body!(Bead {
    doc: "A bead on the parabola y = k x^2.",
    motion: planar_translation,
    params: [k = 1.5[1 / m]],
    mass: 0.1[kg],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    locals: [p = position.in_world()],
    constraints: [wire = p.y - k * p.x.powi(2)],
    reactions: [normal = _ * wire.gradient()],
    outputs: [energy, reactions],
});

#[test]
fn a_bead_on_a_parabola() {
    let (bead, k) = (Bead::default(), 1.5);
    for (x, rate) in [(0.5, 0.0), (-0.3, 1.7), (0.0, 2.0), (4.0, -0.6)] {
        let state = PlanarTranslation {
            position: Vector2::new(x, k * x * x),
            velocity: Vector2::new(rate, 2.0 * k * x * rate),
        };
        // Lagrange's equation of x, with the slope s = 2 k x
        let slope: f64 = 2.0 * k * x;
        let along = -(4.0 * k * k * x * rate * rate + GRAVITY * slope) / (1.0 + slope * slope);
        let found = bead.acceleration(0.0, &state, &());
        assert!((found.x - along).abs() < 1e-13 * along.abs().max(1.0));
        // across the wire: N = m (g cos + v^2 / R)
        let run = slope.hypot(1.0);
        let curvature = 2.0 * k / run.powi(3);
        let across = 0.1 * (GRAVITY / run + state.velocity.norm_squared() * curvature);
        let expected = Vector2::new(-slope, 1.0) * (across / run);
        let normal = bead.reactions(0.0, &state, &()).unwrap().normal;
        assert!((normal - expected).norm() < 1e-13 * across);
    }
}

#[test]
fn it_keeps_its_energy() {
    let bead = Bead::default();
    let start = PlanarTranslation {
        position: Vector2::new(0.5, 0.375),
        ..Default::default()
    };
    let energy = |state: &_| bead.kinetic_energy(state) + bead.potential_energy(0.0, state, &());
    let end = bead.integrate(&start).to(5.0).unwrap();
    assert!((energy(&end) - energy(&start)).abs() < 1e-9);
    assert!(end.velocity.norm() > 0.1 || end.position.x < -0.4);
}

/// A bar whose tip slides on a wave.
mod wave {
    newton_euler::rigid_body!(Smooth {
        motion: planar,
        mass: 2[kg],
        inertia: 0.3[kg * m ^ 2],
        points: [tip = (0.4, 0.1)[m]],
        fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
        locals: [q = tip.position().in_world()],
        constraints: [wire = q.y - 1[m] * (q.x / 1[m]).sin()],
        reactions: [normal = (_ * wire.gradient()).at(tip)],
        outputs: [reactions],
    });

    newton_euler::rigid_body!(Scaled {
        motion: planar,
        mass: 2[kg],
        inertia: 0.3[kg * m ^ 2],
        points: [tip = (0.4, 0.1)[m]],
        fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
        locals: [q = tip.position().in_world()],
        constraints: [wire = q.y - 1[m] * (q.x / 1[m]).sin()],
        reactions: [normal = (_ * (-2 * wire.gradient().normalize())).at(tip)],
        outputs: [reactions],
    });

    newton_euler::rigid_body!(ByHand {
        motion: planar,
        mass: 2[kg],
        inertia: 0.3[kg * m ^ 2],
        points: [tip = (0.4, 0.1)[m]],
        fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
        locals: [q = tip.position().in_world()],
        constraints: [wire = q.y - 1[m] * (q.x / 1[m]).sin()],
        reactions: [normal = (_ * world(-(q.x / 1[m]).cos(), 1)).at(tip)],
        outputs: [reactions],
    });
}

/// The sign and the length of a direction do not matter.
#[test]
fn a_tip_on_a_wave() {
    let state = Planar {
        position: Vector2::new(0.7, 0.2),
        angle: 0.6,
        velocity: Vector2::new(1.2, -0.4),
        angular_velocity: 2.5,
    };
    let by_hand = wave::ByHand {};
    let expected = by_hand.acceleration(0.0, &state, &());
    let (smooth, scaled) = (wave::Smooth {}, wave::Scaled {});
    for found in [
        smooth.acceleration(0.0, &state, &()),
        scaled.acceleration(0.0, &state, &()),
    ] {
        assert!((found.linear - expected.linear).norm() < 1e-14 * expected.linear.norm());
        assert!((found.angular - expected.angular).abs() < 1e-14 * expected.angular.abs());
    }
    let expected = by_hand.reactions(0.0, &state, &()).unwrap().normal;
    for found in [
        smooth.reactions(0.0, &state, &()).unwrap().normal,
        scaled.reactions(0.0, &state, &()).unwrap().normal,
    ] {
        assert!((found - expected).norm() < 1e-14 * expected.norm());
    }
}

/// A body whose tip slides on a sphere; a skate on ice.
mod others {
    newton_euler::rigid_body!(OnSphere {
        motion: spatial,
        mass: 2[kg],
        inertia: principal(0.3, 0.4, 0.5)[kg * m ^ 2],
        points: [tip = (0.4, 0.1, 0.3)[m]],
        locals: [q = tip.position()],
        constraints: [sphere = q.norm_squared() - 4[m ^ 2]],
        reactions: [normal = (_ * sphere.gradient()).at(tip)],
    });

    newton_euler::rigid_body!(OnSphereByHand {
        motion: spatial,
        mass: 2[kg],
        inertia: principal(0.3, 0.4, 0.5)[kg * m ^ 2],
        points: [tip = (0.4, 0.1, 0.3)[m]],
        locals: [q = tip.position()],
        constraints: [sphere = q.norm_squared() - 4[m ^ 2]],
        reactions: [normal = (_ * (q / 1[m])).at(tip)],
    });

    newton_euler::rigid_body!(Skate {
        motion: planar,
        mass: 2[kg],
        inertia: 0.3[kg * m ^ 2],
        points: [blade = (0.4, 0)[m]],
        constraints: [edge = blade.velocity().in_body().y],
        reactions: [ice = (_ * edge.gradient()).at(blade)],
    });

    newton_euler::rigid_body!(SkateByHand {
        motion: planar,
        mass: 2[kg],
        inertia: 0.3[kg * m ^ 2],
        points: [blade = (0.4, 0)[m]],
        constraints: [edge = blade.velocity().in_body().y],
        reactions: [ice = body(0, _).at(blade)],
    });
}

#[test]
fn in_space_and_of_velocities() {
    let state = Spatial {
        position: [1.5, 0.2, -0.4].into(),
        angular_velocity: [0.3, -1.2, 0.8].into(),
        velocity: [0.1, 0.5, -0.2].into(),
        ..Default::default()
    };
    let found = others::OnSphere {}.acceleration(0.0, &state, &());
    let expected = others::OnSphereByHand {}.acceleration(0.0, &state, &());
    assert!((found.linear - expected.linear).norm() < 1e-13 * expected.linear.norm());
    assert!((found.angular - expected.angular).norm() < 1e-13 * expected.angular.norm());

    let state = Planar {
        angle: 0.6,
        velocity: Vector2::new(1.2, -0.4),
        angular_velocity: 2.5,
        ..Default::default()
    };
    let found = others::Skate {}.acceleration(0.0, &state, &());
    let expected = others::SkateByHand {}.acceleration(0.0, &state, &());
    assert!((found.linear - expected.linear).norm() < 1e-13 * expected.linear.norm());
    assert!((found.angular - expected.angular).abs() < 1e-13 * expected.angular.abs());
}
