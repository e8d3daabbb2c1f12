//! A probe that lands among rapier's contacts: newton-euler gives its loads, rapier the ground.
//!
//! At each step rapier receives the force and the moment of the description (`outputs: [balance]`),
//! and adds the contacts. A description can have any load that rapier lacks, with checked units and
//! frames; contacts and other bodies are rapier's part.
//!
//! Asserts: in free flight rapier's motion is that of the description, within the error of its
//! method, which is of order one; at the end the probe stands on the ground at rest.
//!
//! `cargo run --release --manifest-path examples/rapier_probe/Cargo.toml`

use newton_euler::nalgebra::{Quaternion, UnitQuaternion, Vector3};
use newton_euler::prelude::*;
use rapier3d_f64::math::{Matrix, Rotation as Turn};
use rapier3d_f64::prelude::{
    ColliderBuilder, IntegrationParameters, MassProperties, PhysicsWorld, RigidBodyBuilder,
    RigidBodyHandle, Vector,
};

rigid_body!(Probe {
    doc: "A probe that brakes: its engine is off its axis, and the air damps its turns.",
    motion: spatial,
    inputs: [thrust[N]],
    mass: 85[kg],
    inertia: principal(12, 14, 20)[kg * m ^ 2],
    points: [nozzle = (0.001, 0, -0.5)[m]],
    forces: [
        engine = body(0, 0, thrust).at(nozzle),
        drag = -0.4[kg / m] * velocity.norm() * velocity,
    ],
    moments: [damping = -3[N * m * s] * angular_velocity],
    fields: [weight = mass * world(0, 0, -3.71[m / s ^ 2])],
    outputs: [balance],
});

/// The length of a step \[s\].
const STEP: f64 = 1e-3;
/// Half the height of the probe, a cuboid \[m\].
const HALF: f64 = 0.5;

/// The engine brakes to a descent at 1 m/s, and stops shortly above the ground.
fn thrust(state: &Spatial) -> ProbeInput {
    let descent = 315.0 - 120.0 * (state.velocity.z + 1.0);
    let is_high = state.position.z > 0.7;
    ProbeInput {
        thrust: if is_high { descent.max(0.0) } else { 0.0 },
    }
}

fn vector(v: &Vector3<f64>) -> Vector {
    Vector::new(v.x, v.y, v.z)
}

/// A world with a ground at height zero and the probe.
fn world(start: &Spatial) -> (PhysicsWorld, RigidBodyHandle) {
    let mut world = PhysicsWorld {
        // the weight is a load of the description
        gravity: Vector::ZERO,
        integration_parameters: IntegrationParameters {
            dt: STEP,
            ..IntegrationParameters::default()
        },
        ..PhysicsWorld::default()
    };
    let ground =
        ColliderBuilder::cuboid(100.0, 100.0, 1.0).translation(Vector::new(0.0, 0.0, -1.0));
    world.insert_collider(ground, None);
    let [i, j, k, real]: [f64; 4] = start.attitude.coords.into();
    let inertia = Matrix::from_diagonal(Vector::new(12.0, 14.0, 20.0));
    let mass = MassProperties::with_inertia_matrix(Vector::ZERO, 85.0, inertia);
    let body = RigidBodyBuilder::dynamic()
        .translation(vector(&start.position))
        .rotation(Turn::from_xyzw(i, j, k, real).to_scaled_axis())
        .linvel(vector(&start.velocity))
        .angvel(vector(&(start.attitude * start.angular_velocity)))
        .can_sleep(false)
        .additional_mass_properties(mass);
    let hull = ColliderBuilder::cuboid(0.6, 0.6, HALF).density(0.0);
    let (body, _) = world.insert(body, hull);
    (world, body)
}

/// The state of the probe in rapier's world.
fn state(body: &rapier3d_f64::prelude::RigidBody) -> Spatial {
    let [i, j, k, real] = body.rotation().to_array();
    let attitude = UnitQuaternion::new_normalize(Quaternion::new(real, i, j, k));
    let angular_velocity = Vector3::from(body.angvel().to_array());
    Spatial {
        position: body.translation().to_array().into(),
        attitude,
        velocity: body.linvel().to_array().into(),
        angular_velocity: attitude.inverse() * angular_velocity,
    }
}

/// Moves the world by a step, under the loads of the description.
fn advance(world: &mut PhysicsWorld, handle: RigidBodyHandle, probe: &Probe) {
    let body = &mut world.bodies[handle];
    let now = state(body);
    let loads = probe.applied(0.0, &now, &thrust(&now));
    body.reset_forces(true);
    body.reset_torques(true);
    body.add_force(vector(&loads.force), true);
    body.add_torque(vector(&loads.moment), true);
    world.step();
}

fn main() {
    let (probe, start) = (
        Probe::default(),
        Spatial {
            position: [0.0, 0.0, 5.0].into(),
            velocity: [0.2, 0.0, -2.0].into(),
            angular_velocity: [0.02, 0.01, 0.3].into(),
            ..Spatial::default()
        },
    );
    let (mut world, handle) = world(&start);

    let flight = probe.integrate(&start).control(STEP, |_, now| thrust(now));
    let alone = flight.to(2.0).expect("a smooth motion");
    for _ in 0..2000 {
        advance(&mut world, handle, &probe);
    }
    let flown = state(&world.bodies[handle]);
    println!("after 2 s: {flown:.3}");
    assert!((flown.position - alone.position).norm() < 0.02);
    assert!(flown.attitude.angle_to(&alone.attitude) < 1e-3);

    for _ in 0..10_000 {
        advance(&mut world, handle, &probe);
    }
    let landed = state(&world.bodies[handle]);
    println!("after 12 s: {landed:.3}");
    assert!((landed.position.z - HALF).abs() < 0.01);
    assert!(landed.velocity.norm() < 1e-2 && landed.angular_velocity.norm() < 1e-2);
    assert!((landed.attitude * Vector3::z()).z > 0.999);
}
