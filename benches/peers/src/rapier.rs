//! rapier3d: a step of a world with one free body, and of a world with a multibody of two arms.

use std::hint::black_box;

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use newton_euler::{integrate, prelude::*};
use rapier3d_f64::prelude::{
    IntegrationParameters, MassProperties, PhysicsWorld, RevoluteJointBuilder, RigidBodyBuilder,
    RigidBodyHandle, Vector,
};

use crate::bodies::{General, GeneralInput};
use crate::by_hand::full;
use crate::paired::paired;
use crate::table::Table;
use crate::{distance, state};

/// A world that contains the general body, under its weight.
struct World {
    world: PhysicsWorld,
    body: RigidBodyHandle,
}

/// An empty world, each step of which consists of several substeps.
fn empty(gravity: Vector, step: f64, substeps: usize) -> PhysicsWorld {
    PhysicsWorld {
        gravity,
        integration_parameters: IntegrationParameters {
            dt: step,
            num_solver_iterations: substeps,
            ..IntegrationParameters::default()
        },
        ..PhysicsWorld::default()
    }
}

impl World {
    fn new(start: &Spatial, step: f64, substeps: usize) -> Self {
        let mut world = empty(Vector::new(0.0, 0.0, -9.80665), step, substeps);
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
    one_body(table);
    two_arms(table);
}

fn one_body(table: &mut Table) {
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
        // the method is of order one, so this is the same motion
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

rigid_system!(Arms {
    doc: "The double pendulum of the examples.",
    motion: planar,
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: 0.04[kg * m ^ 2],
            points: [hinge = (-0.28, 0)[m], tip = (0.32, 0)[m]],
        },
        lower {
            mass: 0.8[kg],
            inertia: 0.015[kg * m ^ 2],
            points: [hinge = (-0.22, 0)[m]]
        },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.hinge),
        elbow = revolute(upper.tip, lower.hinge),
    ],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
});

/// The same arms as a multibody, which starts with all angles zero.
struct Multibody {
    world: PhysicsWorld,
    arms: [RigidBodyHandle; 2],
}

impl Multibody {
    fn new(step: f64, substeps: usize) -> Self {
        let mut world = empty(Vector::new(0.0, -9.80665, 0.0), step, substeps);
        let mut carrier = world.insert_body(RigidBodyBuilder::fixed());
        let mut anchor = 0.0;
        // the mass, the inertia, and the places of the hinge and the tip
        let arms = [
            (1.2, 0.04, -0.28, 0.32, 0.28),
            (0.8, 0.015, -0.22, 0.0, 0.82),
        ];
        let arms = arms.map(|(mass, inertia, hinge, tip, center)| {
            let moments = Vector::new(inertia, inertia, inertia);
            let arm = RigidBodyBuilder::dynamic()
                .translation(Vector::new(center, 0.0, 0.0))
                .can_sleep(false)
                .additional_mass_properties(MassProperties::new(Vector::ZERO, mass, moments));
            let arm = world.insert_body(arm);
            let joint = RevoluteJointBuilder::new(Vector::Z)
                .local_anchor1(Vector::new(anchor, 0.0, 0.0))
                .local_anchor2(Vector::new(hinge, 0.0, 0.0));
            let joint = world.insert_multibody_joint(carrier, arm, joint);
            let joint = joint.expect("the arms are a chain");
            let (multibody, _) = world
                .multibody_joints
                .get_mut(joint)
                .expect("the joint just made");
            // by default a hinge has friction
            multibody.damping_mut().fill(0.0);
            (carrier, anchor) = (arm, tip);
            arm
        });
        Self { world, arms }
    }

    /// The angles of the arms in the world, and their rates.
    fn state(&self) -> [f64; 4] {
        let [upper, lower] = self.arms.map(|arm| &self.world.bodies[arm]);
        let angle = |arm: &rapier3d_f64::prelude::RigidBody| arm.rotation().to_scaled_axis().z;
        [
            angle(upper),
            angle(lower),
            upper.angvel().z,
            lower.angvel().z,
        ]
    }
}

fn in_world(state: &ArmsState) -> [f64; 4] {
    let (shoulder, elbow) = (state.shoulder, state.elbow);
    [
        shoulder.angle,
        shoulder.angle + elbow.angle,
        shoulder.angular_velocity,
        shoulder.angular_velocity + elbow.angular_velocity,
    ]
}

/// The largest difference. Angles are compared up to whole turns.
fn between(one: [f64; 4], other: [f64; 4]) -> f64 {
    let turn = core::f64::consts::TAU;
    let differences = (0..4).map(|k| {
        let difference = one[k] - other[k];
        let turns = if k < 2 {
            (difference / turn).round()
        } else {
            0.0
        };
        (difference - turns * turn).abs()
    });
    differences.fold(0.0, f64::max)
}

fn two_arms(table: &mut Table) {
    let arms = Arms::default();
    let start = ArmsState::default();
    let exact = in_world(
        &arms
            .integrate(&start)
            .tolerance(1e-13)
            .to(1.0)
            .expect("it moves"),
    );
    println!("errors of two arms after 1 s: rad, rad/s, the largest");
    for (steps, step) in [(100, 1e-2), (1000, 1e-3), (10_000, 1e-4)] {
        let cf4 = integrate::cf4(&arms, &start, &(), 0.0..1.0, steps);
        let errors = [1, 4].map(|substeps| {
            let mut multibody = Multibody::new(step, substeps);
            for _ in 0..steps {
                multibody.world.step();
            }
            between(multibody.state(), exact)
        });
        println!(
            "  steps of {step:.0e} s: cf4 {:.1e}, rapier with 1 substep {:.1e}, with 4 {:.1e}",
            between(in_world(&cf4), exact),
            errors[0],
            errors[1]
        );
        // the method is of order one, so this is the same motion
        assert!(errors.into_iter().all(|error| error < 40.0 * step));
    }
    for substeps in [1, 4] {
        let step = black_box(1e-3);
        let mut state = start;
        let mut multibody = Multibody::new(step, substeps);
        let times = paired(
            1,
            || state = integrate::cf4_step(&arms, 0.0, &state, &(), step),
            || multibody.world.step(),
        );
        black_box((&state, multibody.state()));
        let what =
            format!("two arms, a step of cf4, against rapier's multibody, substeps: {substeps}");
        table.row(what, times, None);
    }
}
