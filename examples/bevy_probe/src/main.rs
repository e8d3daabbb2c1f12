//! A body as a component of Bevy: a system moves it at a fixed rate, and writes its `Transform`.
//!
//! Only the parts of Bevy without a window are used; with `DefaultPlugins` and a mesh on the entity,
//! the same two systems move what is drawn.
//!
//! Asserts: after two seconds the probe is where it is without Bevy, to the bit, and the transform
//! is its pose in single precision.
//!
//! `cargo run --manifest-path examples/bevy_probe/Cargo.toml`

use bevy_app::{App, Update};
use bevy_ecs::prelude::*;
use bevy_math::{DQuat, DVec3};
use bevy_transform::components::Transform;
use newton_euler::prelude::*;

rigid_body!(Probe {
    doc: "A spinning probe with an off-axis engine.",
    motion: spatial,
    params: [offset = 2[cm]],
    inputs: [thrust[N]],
    mass: 85[kg],
    inertia: principal(12, 12, 20)[kg * m ^ 2],
    points: [nozzle = (offset, 0, -0.6[m])],
    forces: [engine = body(0, 0, thrust).at(nozzle)],
    fields: [weight = mass * world(0, 0, -1.62[m / s ^ 2])],
});

/// The length of a step \[s\].
const STEP: f64 = 0.01;

/// A body in motion.
#[derive(Component)]
struct Body {
    probe: Probe,
    state: Spatial,
    thrust: f64,
}

/// Moves the bodies by a step.
fn advance(mut bodies: Query<&mut Body>) {
    for mut body in &mut bodies {
        let input = ProbeInput {
            thrust: body.thrust,
        };
        let moved = body.probe.integrate(&body.state).input(input).to(STEP);
        // a body that cannot go on stays where it is
        body.state = moved.unwrap_or_else(|error| *error.state());
    }
}

/// Places what is drawn.
fn place(mut bodies: Query<(&Body, &mut Transform)>) {
    for (body, mut transform) in &mut bodies {
        transform.translation = DVec3::from(body.state.position).as_vec3();
        transform.rotation = DQuat::from(body.state.attitude).as_quat();
    }
}

fn main() {
    let spinning = Spatial {
        angular_velocity: [0.0, 0.0, 6.0].into(),
        ..Spatial::default()
    };
    let mut app = App::new();
    app.add_systems(Update, (advance, place).chain());
    let body = Body {
        probe: Probe::default(),
        state: spinning,
        thrust: 400.0,
    };
    let entity = app.world_mut().spawn((body, Transform::default())).id();
    for _ in 0..200 {
        app.update();
    }

    let (probe, mut alone) = (Probe::default(), spinning);
    for _ in 0..200 {
        let motion = probe.integrate(&alone).input(ProbeInput { thrust: 400.0 });
        alone = motion.to(STEP).expect("a smooth motion");
    }
    let state = app.world().get::<Body>(entity).expect("it is there").state;
    let transform = app.world().get::<Transform>(entity).expect("it is there");
    println!("after 2 s: {state:.3}\n{transform:?}");
    assert_eq!(state, alone);
    let height = f64::from(transform.translation.z);
    assert!((height - state.position.z).abs() < 1e-6 * state.position.z.abs());
}
