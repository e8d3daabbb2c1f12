//! The Apollo command and service module, tumbling freely, under both readings of its products of
//! inertia.
//!
//! Numbers: NASA NESC flight simulation check-cases, model page. It gives Ixy, Iyz, Izx without
//! saying whether they are entries of the tensor, `-∫xy dm`, or products of inertia, `+∫xy dm`.
//! `rigid_body!` requires a choice; this program shows its effect.
//!
//! Body axes are those of the publication; world axes coincide with them at the start. There is no
//! load, and with `motion: rotation` the motion of G is not modeled. The module starts with 5
//! deg/s about y, whose moment of inertia is the largest.
//!
//! Asserts: energy and angular momentum are conserved; the principal moments; the largest moment
//! belongs to an axis ½ atan(2 · 1152.4 / (38372.4 - 36514.9)) = 25.6° from y, nearly in the y-z
//! plane, on one side or the other.

use newton_euler::inertia::{InertiaTensor, InvalidInertia};
use newton_euler::nalgebra::Vector3;
use newton_euler::{integrate, prelude::*};

rigid_body!(AsTensor {
    doc: "The off-diagonals read as entries of the tensor.",
    motion: rotation,
    inertia: tensor {
        xx: 36502.7,
        yy: 38372.4,
        zz: 36514.9,
        xy: -27.1,
        yz: 1152.4,
        zx: 233.2,
    }[kg * m ^ 2],
    outputs: [energy, momentum],
});

rigid_body!(AsProducts {
    doc: "The off-diagonals read as products of inertia.",
    motion: rotation,
    inertia: products {
        xx: 36502.7,
        yy: 38372.4,
        zz: 36514.9,
        xy: -27.1,
        yz: 1152.4,
        zx: 233.2,
    }[kg * m ^ 2],
    outputs: [energy, momentum],
});

fn principal_axes(name: &str, inertia: &InertiaTensor) {
    let principal = inertia.principal_axes();
    let [a, b, c]: [f64; 3] = principal.moments.into();
    let axis = principal.axes * Vector3::z();
    let axis = axis * axis.y.signum();
    println!(
        "  {name:<9} {a:.3}  {b:.3}  {c:.3}  along {:+.4} {:+.4} {:+.4}",
        axis.x, axis.y, axis.z
    );
}

fn conserved<B>(name: &str, body: &B, [start, end]: [&Rotation; 2])
where
    B: Energy<State = Rotation, Scalar = f64> + Momentum<Angular = Vector3<f64>>,
{
    let [before, after] = [start, end].map(|state| body.kinetic_energy(state));
    let [momentum, later] = [start, end].map(|state| body.angular_momentum(state));
    let turned = (later - momentum).norm() / momentum.norm();
    println!(
        "  {name:<9} energy {:.1e}, angular momentum {turned:.1e}",
        (after / before - 1.0).abs()
    );
}

fn main() -> Result<(), InvalidInertia> {
    let (xx, yy, zz, xy, yz, zx) = (36502.7, 38372.4, 36514.9, -27.1, 1152.4, 233.2);
    println!("principal moments / kg m², and the axis of the largest");
    principal_axes("tensor", &InertiaTensor::tensor(xx, yy, zz, xy, yz, zx)?);
    principal_axes(
        "products",
        &InertiaTensor::products(xx, yy, zz, xy, yz, zx)?,
    );

    let start = Rotation {
        angular_velocity: Vector3::new(0.0, 5_f64.to_radians(), 0.0),
        ..Rotation::default()
    };
    let (tensor, products) = (AsTensor::default(), AsProducts::default());
    let (mut one, mut other) = (start, start);
    println!("\nbetween the two motions, in degrees");
    println!("  t/s   attitudes  angular velocities  |  y axis from its start: tensor, products");
    for minute in 1..=10_u32 {
        let times = f64::from(minute - 1) * 60.0..f64::from(minute) * 60.0;
        one = integrate::cf4(&tensor, &one, &(), times.clone(), 600);
        other = integrate::cf4(&products, &other, &(), times.clone(), 600);
        let attitudes = one.attitude.angle_to(&other.attitude).to_degrees();
        let [w, v] = [one, other].map(|state| state.attitude * state.angular_velocity);
        let tilts = [one, other].map(|state| (state.attitude * Vector3::y()).y.acos().to_degrees());
        println!(
            "  {:>3}   {attitudes:9.4}  {:18.4}  |  {:22.4}  {:8.4}",
            times.end,
            w.angle(&v).to_degrees(),
            tilts[0],
            tilts[1],
        );
    }
    println!("\nrelative change in ten minutes");
    conserved("tensor", &tensor, [&start, &one]);
    conserved("products", &products, [&start, &other]);
    println!("\nas tensor:\n{}", AsTensor::EQUATIONS);
    Ok(())
}
