//! Every kind of motion, derived a second time by Lagrange's method, with one Lagrangian for all.
//!
//! The body consists of five mass points, whose kinetic energies are added; no mass, center of mass
//! or tensor is used. With the quasi-velocities V, the velocity of a point P in world axes, and Ω,
//! in body axes, and with displacements δR and δφ of the same kinds, Lagrange's equations are those
//! of Poincaré (F20):
//!
//! ```text
//! d/dt ∂L/∂V = ∂L/∂R + F        d/dt ∂L/∂Ω + Ω × ∂L/∂Ω = ∂L/∂φ + K
//! ```
//!
//! where F and K are the force and moment of the loads without a potential. Along displacements
//! that the motion allows, both sides are equal. Along the others, they differ by the reactions,
//! which are compared as well. Where G moves freely, P is not G, so that V and Ω are coupled.

use nalgebra::{UnitQuaternion, Vector2, Vector3};
use newton_euler::prelude::*;
use proptest::prelude::*;

mod bodies;
mod rod;
mod scene;

use crate::oracle::{self, vectors};
use scene::{FIELD, Scene};

const FOOT: Vector3<f64> = Vector3::new(-0.4, 0.3, 0.1);
const NAIL: Vector3<f64> = Vector3::new(0.5, -1.0, 2.0);
/// P of bodies that move freely.
const OFF_CENTER: Vector3<f64> = Vector3::new(0.7, -0.3, 0.4);

fn zero() -> Vector3<f64> {
    Vector3::zeros()
}

/// A body that turns about its foot: G follows.
fn held(
    nail: Vector3<f64>,
    attitude: UnitQuaternion<f64>,
    angular_velocity: Vector3<f64>,
) -> Spatial {
    Spatial {
        position: nail - attitude * FOOT,
        attitude,
        velocity: attitude * angular_velocity.cross(&-FOOT),
        angular_velocity,
    }
}

/// The acceleration of its G.
fn swung(state: &Spatial, angular: Vector3<f64>) -> [Vector3<f64>; 2] {
    let w = state.angular_velocity;
    let body = angular.cross(&-FOOT) + w.cross(&w.cross(&-FOOT));
    [state.attitude * body, angular]
}

fn hinge() -> impl Strategy<Value = Hinge> {
    (-7.0..7.0, -3.0..3.0).prop_map(|(angle, angular_velocity)| Hinge {
        angle,
        angular_velocity,
    })
}

proptest! {
    #[test]
    fn spatial(state in oracle::spatial(), push in vectors(20.0), twist in vectors(5.0)) {
        let computed = bodies::Free::default().acceleration(0.0, &state, &bodies::FreeInput { push, twist });
        let scene = Scene { origin: OFF_CENTER, is_placed: true, push, twist };
        scene.is_balanced(&state, [computed.linear, computed.angular], [zero(), zero()])?;
    }

    #[test]
    fn rotation(state in oracle::rotation(), push in vectors(20.0), twist in vectors(5.0)) {
        let computed = bodies::Compass::default().acceleration(0.0, &state, &bodies::CompassInput { push, twist });
        let scene = Scene { origin: zero(), is_placed: false, push, twist };
        let Rotation { attitude, angular_velocity } = state;
        let state = Spatial { attitude, angular_velocity, ..Spatial::default() };
        // G stays: it is held by what balances the forces
        let force = -(FIELD + attitude * push);
        scene.is_balanced(&state, [zero(), computed], [force, zero()])?;
    }

    #[test]
    fn translation(state in oracle::translation(), push in vectors(20.0), twist in vectors(5.0)) {
        let (guided, input) = (bodies::Guided::default(), bodies::GuidedInput { push, twist });
        let linear = guided.acceleration(0.0, &state, &input);
        let guide = guided.reactions(0.0, &state, &input).guide;
        let scene = Scene { origin: OFF_CENTER, is_placed: true, push, twist };
        let state = Spatial { position: state.position, velocity: state.velocity, ..Spatial::default() };
        scene.is_balanced(&state, [linear, zero()], [zero(), guide])?;
    }

    #[test]
    fn fixed_point(state in oracle::rotation(), push in vectors(20.0), twist in vectors(5.0)) {
        let (top, input) = (bodies::Top::default(), bodies::TopInput { push, twist });
        let computed = top.acceleration(0.0, &state, &input);
        let hold = top.reactions(0.0, &state, &input).hold;
        let scene = Scene { origin: FOOT, is_placed: true, push, twist };
        let state = held(NAIL, state.attitude, state.angular_velocity);
        scene.is_balanced(&state, swung(&state, computed), [hold, zero()])?;
    }

    #[test]
    fn fixed_axis(hinge in hinge(), push in vectors(20.0), twist in vectors(5.0)) {
        let (shaft, input) = (bodies::Shaft::default(), bodies::ShaftInput { push, twist });
        let axis = Vector3::new(1.0, -2.0, 2.0) / 3.0;
        let computed = axis * shaft.acceleration(0.0, &hinge, &input);
        let reactions = shaft.reactions(0.0, &hinge, &input);
        let scene = Scene { origin: FOOT, is_placed: true, push, twist };
        let attitude = UnitQuaternion::from_scaled_axis(axis * hinge.angle);
        let state = held(NAIL, attitude, axis * hinge.angular_velocity);
        let slide = attitude.inverse() * reactions.slide;
        let moment = (axis * 0.6).cross(&slide);
        scene.is_balanced(&state, swung(&state, computed), [reactions.hold + reactions.slide, moment])?;
    }

    #[test]
    fn planar(state in oracle::planar(), push in oracle::plane_vectors(20.0), twist in -5.0..5.0) {
        let computed = bodies::Plate::default().acceleration(0.0, &state, &bodies::PlateInput { push, twist });
        let scene = flat(OFF_CENTER, push, twist);
        let state = lifted(&state);
        let [force, moment] = scene.residual(&state, computed.linear.push(0.0), Vector3::z() * computed.angular);
        scene.is_balanced(&state, [computed.linear.push(0.0), Vector3::z() * computed.angular], out_of_plane(force, moment))?;
    }

    #[test]
    fn planar_translation(state in oracle::planar_translation(), push in oracle::plane_vectors(20.0), twist in -5.0..5.0) {
        let (slide, input) = (bodies::Slide::default(), bodies::SlideInput { push, twist });
        let linear = slide.acceleration(0.0, &state, &input).push(0.0);
        let guide = slide.reactions(0.0, &state, &input).guide;
        let scene = flat(OFF_CENTER, push, twist);
        let state = Spatial { position: state.position.push(0.0), velocity: state.velocity.push(0.0), ..Spatial::default() };
        let [force, moment] = scene.residual(&state, linear, zero());
        let [force, moment] = out_of_plane(force, moment);
        scene.is_balanced(&state, [linear, zero()], [force, moment + Vector3::z() * guide])?;
    }

    #[test]
    fn pivot(hinge in hinge(), push in oracle::plane_vectors(20.0), twist in -5.0..5.0) {
        let (crank, input) = (bodies::Crank::default(), bodies::CrankInput { push, twist });
        let computed = Vector3::z() * crank.acceleration(0.0, &hinge, &input);
        let hold = crank.reactions(0.0, &hinge, &input).hold.push(0.0);
        let scene = flat(FOOT, push, twist);
        let attitude = UnitQuaternion::from_scaled_axis(Vector3::z() * hinge.angle);
        let state = held(NAIL, attitude, Vector3::z() * hinge.angular_velocity);
        let [force, moment] = scene.residual(&state, swung(&state, computed)[0], computed);
        let [force, moment] = out_of_plane(force, moment);
        scene.is_balanced(&state, swung(&state, computed), [hold + force, moment])?;
    }
}

/// A planar body is the same points, looked at along z.
fn flat(origin: Vector3<f64>, push: Vector2<f64>, twist: f64) -> Scene {
    Scene {
        origin,
        is_placed: true,
        push: push.push(0.0),
        twist: Vector3::z() * twist,
    }
}

fn lifted(state: &Planar) -> Spatial {
    Spatial {
        position: state.position.push(0.0),
        attitude: UnitQuaternion::from_scaled_axis(Vector3::z() * state.angle),
        velocity: state.velocity.push(0.0),
        angular_velocity: Vector3::z() * state.angular_velocity,
    }
}

/// What holds a body in its plane: nothing is compared there.
fn out_of_plane(force: Vector3<f64>, moment: Vector3<f64>) -> [Vector3<f64>; 2] {
    [
        Vector3::z() * force.z,
        Vector3::new(moment.x, moment.y, 0.0),
    ]
}
