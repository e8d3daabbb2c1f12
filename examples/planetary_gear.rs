//! A planetary gear: sun, planet, ring and the arm that carries the planet, meshed by constraints.
//!
//! Both meshes are written in lengths, so the loads that keep them are the forces between teeth.
//! The motor turns the sun, the arm drives a fan, and a brake slows the ring to a stop: the fan
//! then turns at the gear ratio.
//!
//! Asserts: the acceleration agrees with that of the inertias reduced to sun and ring, in closed
//! form; the forces between teeth agree with the balance of each wheel; the ratio with the ring
//! held is 1 + ring / sun; and the constraints hold after the run.

use newton_euler::prelude::*;

rigid_system!(Planetary {
    doc: "Sun, planet, ring and arm; the planet turns against the arm.",
    motion: planar,
    params: [sun_radius = 0.02[m], planet_radius = 0.015[m]],
    inputs: [motor[N * m], brake[N * m * s]],
    bodies: [
        sun {
            mass: 0.2[kg],
            inertia: 4e-5[kg * m ^ 2]
        },
        arm {
            mass: 0.5[kg],
            inertia: 3e-4[kg * m ^ 2],
            points: [pin = (sun_radius + planet_radius, 0)],
        },
        planet {
            mass: 0.1[kg],
            inertia: 1.2e-5[kg * m ^ 2]
        },
        ring {
            mass: 0.8[kg],
            inertia: 2e-3[kg * m ^ 2]
        },
    ],
    joints: [
        input = revolute(world(0, 0), sun.G),
        output = revolute(world(0, 0), arm.G),
        pin = revolute(arm.pin, planet.G),
        outer = revolute(world(0, 0), ring.G),
    ],
    locals: [ring_radius = sun_radius + 2 * planet_radius],
    constraints: [
        inside = sun_radius * (input.angle - output.angle) + planet_radius * pin.angle,
        outside = ring_radius * (outer.angle - output.angle) - planet_radius * pin.angle,
    ],
    drives: [
        torque = motor.on(input),
        fan = (-1e-4[N * m * s ^ 2] * output.angular_velocity * output.angular_velocity.abs())
            .on(output),
        shoe = (-brake * outer.angular_velocity).on(outer),
    ],
    outputs: [reactions, energy],
});

const SUN: f64 = 0.02;
const PLANET: f64 = 0.015;
const RING: f64 = SUN + 2.0 * PLANET;

/// The accelerations of sun and ring by a torque on the sun, from rest, with all inertias reduced
/// to these two.
fn reduced(torque: f64) -> [f64; 2] {
    let [sun, arm, planet, ring] = [4e-5, 3e-4 + 0.1 * (SUN + PLANET).powi(2), 1.2e-5, 2e-3];
    // arm = s sun + r ring; the planet turns against the ground by p (ring - sun) + arm
    let (s, r) = (SUN / (SUN + RING), RING / (SUN + RING));
    let whole = (SUN * RING) / ((SUN + RING) * PLANET);
    let (ps, pr) = (s - whole, r + whole);
    let a = sun + arm * s * s + planet * ps * ps;
    let b = arm * s * r + planet * ps * pr;
    let c = ring + arm * r * r + planet * pr * pr;
    let determinant = a * c - b * b;
    [c * torque / determinant, -b * torque / determinant]
}

fn main() {
    let gear = Planetary::default();
    let rest = PlanetaryState::default();
    let input = PlanetaryInput {
        motor: 0.5,
        brake: 0.0,
    };
    let found = gear.acceleration(0.0, &rest, &input);
    let [sun, ring] = reduced(0.5);
    for (found, expected) in [(found.input, sun), (found.outer, ring)] {
        assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
    }
    let teeth = gear.reactions(0.0, &rest, &input);
    let of_sun = (4e-5 * found.input - 0.5) / SUN;
    let of_ring = 2e-3 * found.outer / RING;
    assert!((teeth.inside / of_sun - 1.0).abs() < 1e-12);
    assert!((teeth.outside / of_ring - 1.0).abs() < 1e-12);
    println!(
        "from rest: sun {sun:.0} rad/s², ring {ring:.0} rad/s²; teeth {of_sun:.1} N and {of_ring:.1} N"
    );

    let run = gear
        .integrate(&rest)
        .control(0.01, |time, _| PlanetaryInput {
            motor: 0.5,
            brake: if time < 1.0 { 0.0 } else { 50.0 },
        })
        .to(4.0);
    let end = run.expect("the gear runs");
    let ratio = end.input.angular_velocity / end.output.angular_velocity;
    println!(
        "braked: fan {:.1} rad/s, motor {:.1} rad/s: ratio {ratio:.4}",
        end.output.angular_velocity, end.input.angular_velocity
    );
    // the shoe slips a little under the torque of the ring
    assert!((ratio - (1.0 + RING / SUN)).abs() < 2e-3);
    for violation in gear.violations(4.0, &end, &input) {
        assert!(
            violation.position.unwrap_or(0.0).abs() < 1e-12 && violation.velocity.abs() < 1e-13
        );
    }
}
