//! The bodies of the examples, which are mounted here, each with a state.

use std::fs;

use newton_euler::prelude::*;

use crate::counted::evaluate;
use crate::somewhere::Somewhere;

/// Mounts example programs for their descriptions.
macro_rules! examples {
    ($($name:ident $path:literal;)*) => {$(
        #[allow(dead_code)]
        #[path = $path]
        mod $name;
    )*};
}

examples! {
    apollo "../../examples/apollo.rs";
    attitude_filter "../../examples/attitude_filter.rs";
    auv "../../examples/auv.rs";
    compound_pendulum "../../examples/compound_pendulum.rs";
    crane "../../examples/crane.rs";
    crazyflie "../../examples/crazyflie.rs";
    cylinder "../../examples/cylinder.rs";
    dipole "../../examples/dipole.rs";
    double_pendulum "../../examples/double_pendulum.rs";
    engine "../../examples/engine.rs";
    four_bar "../../examples/four_bar.rs";
    furuta "../../examples/furuta.rs";
    hover "../../examples/hover.rs";
    identification "../../examples/identification.rs";
    lagrange_top "../../examples/lagrange_top.rs";
    level_turn "../../examples/level_turn.rs";
    lqr "../../examples/lqr.rs";
    planetary_gear "../../examples/planetary_gear.rs";
    plank "../../examples/plank.rs";
    quadrotor "../../examples/quadrotor.rs";
    reaction_wheels "../../examples/reaction_wheels.rs";
    rigid_body_benchmarks "../../examples/rigid_body_benchmarks.rs";
    robot_arm "../../examples/robot_arm.rs";
    rocket "../../examples/rocket.rs";
    rotor "../../examples/rotor.rs";
    satellite "../../examples/satellite.rs";
    shuttlecock "../../examples/shuttlecock.rs";
    stance "../../examples/stance.rs";
    suspension "../../examples/suspension.rs";
    swarm "../../examples/swarm.rs";
    t_handle "../../examples/t_handle.rs";
    tumbling_brick "../../examples/tumbling_brick.rs";
    urdf_arm "../../examples/urdf_arm.rs";
}

/// A body that can be evaluated once.
pub struct Body {
    pub name: &'static str,
    pub evaluate: fn(),
}

/// The bodies, named by their paths.
macro_rules! bodies {
    ($($body:ty,)*) => {
        &[$(Body { name: stringify!($body), evaluate: evaluate::<$body> }),*]
    };
}

pub const BODIES: &[Body] = bodies![
    apollo::AsProducts,
    apollo::AsTensor,
    attitude_filter::Satellite,
    auv::Auv,
    compound_pendulum::Pendulum,
    crane::Crane,
    crazyflie::Crazyflie,
    cylinder::Slipping,
    cylinder::Sticking,
    dipole::Dipole,
    dipole::canceled::Quadrupole,
    double_pendulum::DoublePendulum,
    engine::Engine,
    four_bar::FourBar,
    furuta::Furuta,
    hover::Hover,
    identification::Craft,
    identification::Hull,
    lagrange_top::Top,
    level_turn::Navion,
    lqr::Quadrotor,
    planetary_gear::Planetary,
    plank::Plank,
    quadrotor::Quadrotor,
    reaction_wheels::Satellite,
    rigid_body_benchmarks::Detest,
    rigid_body_benchmarks::Driven,
    rigid_body_benchmarks::Turning,
    robot_arm::Arm,
    rocket::Rocket,
    rotor::Rotor,
    satellite::Satellite,
    shuttlecock::Shuttlecock,
    stance::Driven,
    stance::Standing,
    suspension::Car,
    swarm::CubeSat<f64>,
    t_handle::Handle,
    tumbling_brick::Brick,
    urdf_arm::Arm,
];

/// The examples without a body in the list. Folders are not counted: they are measurements
/// themselves.
pub fn missing() -> Vec<String> {
    let examples = fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/examples"));
    let paths = examples
        .expect("the folder of examples")
        .map(|entry| entry.expect("an example").path());
    let programs = paths.filter(|path| path.extension().is_some_and(|extension| extension == "rs"));
    let names = programs.map(|path| {
        let name = path.file_stem().expect("a name").to_string_lossy();
        name.into_owned()
    });
    let is_there = |name: &String| {
        let path = format!("{name}::");
        BODIES.iter().any(|body| body.name.starts_with(&path))
    };
    names.filter(|name| !is_there(name)).collect()
}

impl Somewhere for attitude_filter::SatelliteState {
    fn somewhere() -> Self {
        Self {
            motion: Rotation::somewhere(),
            bias_x: 1e-3,
            bias_y: -2e-3,
            bias_z: 3e-3,
        }
    }
}

impl Somewhere for hover::HoverState {
    fn somewhere() -> Self {
        Self {
            motion: Spatial::somewhere(),
            thrust_1: 2.5,
            thrust_2: 3.1,
            thrust_3: 2.9,
            thrust_4: 3.3,
            roll_sum: 0.02,
            pitch_sum: -0.03,
            height_sum: 0.4,
        }
    }
}

impl Somewhere for rocket::RocketState {
    fn somewhere() -> Self {
        Self {
            motion: Spatial::somewhere(),
            fuel: 12.5,
        }
    }
}

/// The states of systems, joint by joint.
macro_rules! systems {
    ($($state:path { $($joint:ident),* })*) => {$(
        impl Somewhere for $state {
            fn somewhere() -> Self {
                Self { $($joint: Somewhere::somewhere()),* }
            }
        }
    )*};
}

systems! {
    crane::CraneState { rail, hang, rope }
    double_pendulum::DoublePendulumState { shoulder, elbow }
    engine::EngineState { big_end, small_end }
    four_bar::FourBarState { a, b }
    furuta::FurutaState { yaw, swing }
    planetary_gear::PlanetaryState { input, output, pin, outer }
    reaction_wheels::SatelliteState { orbit, spin_x, spin_y, spin_z }
    robot_arm::ArmState { pan, lift, elbow, roll_1, roll_2, roll_3 }
    stance::DrivenState { base, hip_fl, hip_fr, hip_hl, hip_hr, knee_fl, knee_fr, knee_hl, knee_hr }
    stance::StandingState { base, hip_fl, hip_fr, hip_hl, hip_hr, knee_fl, knee_fr, knee_hl, knee_hr }
    suspension::CarState { heave, pitch, strut_front, strut_rear }
    urdf_arm::ArmState { pan, lift, elbow, roll }
}
