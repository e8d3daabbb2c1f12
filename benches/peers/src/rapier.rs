//! rapier3d: a step of a world with one free body.

use std::hint::black_box;

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use newton_euler::{integrate, prelude::*};
use rapier3d_f64::prelude::{
    IntegrationParameters, MassProperties, PhysicsWorld, RigidBodyBuilder, RigidBodyHandle, Vector,
};

use crate::bodies::{General, GeneralInput};
use crate::by_hand::full;
use crate::paired::paired;
use crate::table::Table;
use crate::{distance, state};

/// A world with the general body in it, under weight.
struct World {
    world: PhysicsWorld,
    body: RigidBodyHandle,
}

impl World {
    /// Each step is made of a number of substeps.
    fn new(start: &Spatial, step: f64, substeps: usize) -> Self {
        let mut world = PhysicsWorld {
            gravity: Vector::new(0.0, 0.0, -9.80665),
            integration_parameters: IntegrationParameters {
                dt: step,
                num_solver_iterations: substeps,
                ..IntegrationParameters::default()
            },
            ..PhysicsWorld::default()
        };
        let [i, j, k, real]: [f64; 4] = start.attitude.coords.into();
        let rotation = rapier3d_f64::math::Rotation::from_xyzw(i, j, k, real);
        let angular_velocity = start.attitude * start.angular_velocity;
        let columns: [[f64; 3]; 3] = full().into();
        let inertia = rapier3d_f64::math::Matrix::from_cols_array_2d(&columns);
        let body = RigidBodyBuilder::dynamic()
            .rotation(rotation.to_scaled_axis())
            .linvel(vector(&start.velocity))
            .angvel(vector(&angular_velocity))
            .can_sleep(false)
            .additional_mass_properties(MassProperties::with_inertia_matrix(
                Vector::ZERO,
                3.2,
                inertia,
            ));
        let body = world.insert_body(body);
        Self { world, body }
    }

    fn state(&self) -> Spatial {
        let body = &self.world.bodies[self.body];
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
}

fn vector(v: &Vector3<f64>) -> Vector {
    Vector::new(v.x, v.y, v.z)
}

pub fn measure(table: &mut Table) {
    let body = General::<f64>::default();
    let unpushed = GeneralInput::default();
    let start = state(0.7);
    let exact = integrate::cf4(&body, &start, &unpushed, 0.0..1.0, 4000);

    println!("errors after 1 s: m, m/s, rad, rad/s, the largest");
    for (steps, step) in [(100, 1e-2), (1000, 1e-3), (10_000, 1e-4)] {
        let cf4 = integrate::cf4(&body, &start, &unpushed, 0.0..1.0, steps);
        let errors = [1, 4].map(|substeps| {
            let mut world = World::new(&start, step, substeps);
            for _ in 0..steps {
                world.world.step();
            }
            distance(&world.state(), &exact)
        });
        println!(
            "  steps of {step:.0e} s: cf4 {:.1e}, rapier with 1 substep {:.1e}, with 4 {:.1e}",
            distance(&cf4, &exact),
            errors[0],
            errors[1]
        );
        // of order one, and so the same motion
        assert!(errors.into_iter().all(|error| error < 20.0 * step));
    }

    for substeps in [1, 4] {
        let step = black_box(1e-3);
        let mut state = start;
        let mut world = World::new(&start, step, substeps);
        let times = paired(
            1,
            || {
                state = integrate::cf4_step(&body, 0.0, &state, black_box(&unpushed), step);
            },
            || world.world.step(),
        );
        black_box((&state, world.state()));
        let what = format!("a step of cf4, against rapier, substeps: {substeps}");
        table.row(what, times, None);
    }
}
