//! An unbalanced rotor on two bearings: their loads at rest, and the increase with the square of
//! the speed.
//!
//! The center of mass is off the axis by e, and the disc is tilted, which gives a product of
//! inertia. Bearing b also holds the rotor along its axis.
//!
//! Asserts: at rest the bearings share the weight by their distances. In motion each carries, in
//! addition to its share of the weight and rotating with the rotor, `m e ω²` by the distances and
//! the couple `J_zx ω²` over the span: the amplitude over ω² is constant. The spin-up adds `m e α`
//! perpendicular to that. A balanced rotor has none of this.

use newton_euler::nalgebra::Vector3;
use newton_euler::prelude::*;

const G: f64 = 9.80665;

rigid_body!(Rotor {
    doc: "A rotor about z, level, on two bearings; x from the axis to the center of mass.",
    motion: fixed_axis(axle, body(0, 0, 1)),
    params: [
        eccentricity = 20e-6[m],
        skew = 4e-4[kg * m ^ 2],
        to_a = 0.3[m],
        to_b = 0.2[m],
    ],
    inputs: [torque[N * m]],
    mass: 12[kg],
    inertia: products {
        xx: 0.09,
        yy: 0.09,
        zz: 0.15,
        xy: 0,
        yz: 0,
        zx: skew
    }[kg * m ^ 2],
    points: [
        axle = (-eccentricity, 0, 0),
        a = (-eccentricity, 0, -to_a),
        b = (-eccentricity, 0, to_b),
    ],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2], 0)],
    moments: [drive = world(0, 0, torque)],
    reactions: [in_a = world(_, _, 0).at(a), in_b = world(_, _, _).at(b)],
    outputs: [reactions],
});

/// The loads of both bearings at a speed, averaged over one turn, and half of their range.
fn static_and_dynamic(rotor: &Rotor, speed: f64) -> [(f64, f64); 2] {
    let at = |angle: f64| {
        let state = Hinge {
            angle,
            angular_velocity: speed,
        };
        rotor.reactions(0.0, &state, &RotorInput::default())
    };
    // opposite angles: the rotating part changes its sign, the constant part does not
    let (here, there) = (at(0.0), at(std::f64::consts::PI));
    [(here.in_a, there.in_a), (here.in_b, there.in_b)].map(
        |(here, there): (Vector3<f64>, Vector3<f64>)| {
            let steady = (here + there) / 2.0;
            (steady.y, (here - there).x / 2.0)
        },
    )
}

fn main() {
    let rotor = Rotor::default();
    let RotorParams {
        eccentricity,
        skew,
        to_a,
        to_b,
    } = *rotor.params();
    let (mass, span) = (12.0, to_a + to_b);
    println!(
        "a rotor of {mass} kg, {:.0} µm off its axis, J_zx {skew} kg m²",
        eccentricity * 1e6
    );
    println!("bearings {to_a} m and {to_b} m from the center of mass\n");
    println!(
        "expected: {:.4} N and {:.4} N at rest,",
        mass * G * to_b / span,
        mass * G * to_a / span
    );
    // about b: A span = -(m e ω² to_b) + J_zx ω², about a: B span = -(m e ω² to_a) - J_zx ω²
    let per_square = [
        (-mass * eccentricity * to_b + skew) / span,
        (-mass * eccentricity * to_a - skew) / span,
    ];
    println!(
        "          {:.4e} and {:.4e} N s² times ω²\n",
        per_square[0], per_square[1]
    );

    println!(
        "    rpm     bearing a: static/N  dynamic/N   over ω²      bearing b: static/N  dynamic/N   over ω²"
    );
    for rpm in [0.0, 1000.0, 3000.0, 10_000.0, 30_000.0] {
        let speed = rpm * std::f64::consts::TAU / 60.0;
        let [(static_a, a), (static_b, b)] = static_and_dynamic(&rotor, speed);
        let over = |force: f64| {
            if speed > 0.0 {
                format!("{:11.4e}", force / speed.powi(2))
            } else {
                " ".repeat(11)
            }
        };
        println!(
            "  {rpm:6.0}    {static_a:15.4} {a:13.4} {}    {static_b:15.4} {b:13.4} {}",
            over(a),
            over(b)
        );
    }

    let spin_up = RotorInput { torque: 30.0 };
    let still = Hinge::default();
    let rate = rotor.acceleration(0.0, &still, &spin_up);
    let started = rotor.reactions(0.0, &still, &spin_up);
    let about_axis = 0.15 + mass * eccentricity.powi(2);
    let expected = (30.0 - mass * G * eccentricity) / about_axis;
    println!("\nspin-up by 30 N m: {rate:.9} rad/s² ((30 - m g e) / J = {expected:.9})");
    println!(
        "  the bearings carry {:.9} N more (m e α = {:.9})",
        started.in_a.y + started.in_b.y - mass * G,
        mass * eccentricity * rate
    );

    let balanced = Rotor::new(RotorParams {
        eccentricity: 0.0,
        skew: 0.0,
        ..*rotor.params()
    })
    .expect("the same rotor, balanced");
    let [(_, a), (_, b)] = static_and_dynamic(&balanced, 3000.0);
    println!(
        "\nbalanced: {a} N and {b} N at any speed\n\n{}",
        Rotor::EQUATIONS
    );
}
