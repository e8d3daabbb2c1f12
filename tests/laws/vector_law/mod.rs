//! A body in space under loads of every kind, compared with the vector law written by hand with
//! nalgebra.

use nalgebra::Vector3;
use newton_euler::prelude::*;
use proptest::prelude::*;

use crate::oracle::{Sum, is, is_scalar, spatial, vectors};

mod craft;
mod hand;
use hand::{MASS, given, inertia, inertial, loads, moment, resultant};

proptest! {
    #[test]
    fn acceleration(given in given()) {
        let (state, loads) = (given.state, loads(&given));
        let (force, moment) = (resultant(&loads), moment(&loads));
        let linear = Sum { value: force.value / MASS, largest: force.largest / MASS };
        let inverse = inertia().try_inverse().unwrap();
        let torque = inertial(&state, &Vector3::zeros(), moment);
        let angular = Sum {
            value: inverse * (state.attitude.inverse() * torque.value),
            largest: inverse.norm() * torque.largest,
        };
        let baked = craft::Baked {}.acceleration(0.0, &state, &given.baked());
        let body = craft::Parametric::default();
        let parametric = body.acceleration(0.0, &state, &given.parametric());
        for computed in [baked, parametric] {
            is(&computed.linear, &linear)?;
            is(&computed.angular, &angular)?;
        }
        // Baked or not, the same to rounding.
        is(&baked.linear, &Sum { value: parametric.linear, ..linear })?;
        is(&baked.angular, &Sum { value: parametric.angular, ..angular })?;
    }

    #[test]
    fn applied(given in given()) {
        let loads = loads(&given);
        let (force, moment) = (resultant(&loads), moment(&loads));
        let body = craft::Parametric::default();
        for computed in [
            craft::Baked {}.applied(0.0, &given.state, &given.baked()),
            body.applied(0.0, &given.state, &given.parametric()),
        ] {
            is(&computed.force, &force)?;
            is(&computed.moment, &moment)?;
        }
    }

    #[test]
    fn residual(given in given(), linear in vectors(9.0), angular in vectors(9.0)) {
        let (state, loads) = (given.state, loads(&given));
        let force = resultant(&loads).and(linear * -MASS, linear.norm() * MASS);
        let about_g = inertial(&state, &angular, moment(&loads));
        // About the pole O, a point of the body: (G - O) × R on top, R a sum of fifteen terms.
        let pole = Vector3::new(-0.6, 0.1, -0.2);
        let transport = (state.attitude * -pole).cross(&force.value);
        let about_pole = about_g.and(transport, pole.norm() * force.largest * 15.0);
        let acceleration = SpatialAcceleration { linear, angular };
        let body = craft::Parametric::default();
        for computed in [
            craft::Baked {}.residual(0.0, &state, &acceleration, &(), &given.baked()),
            body.residual(0.0, &state, &acceleration, &(), &given.parametric()),
        ] {
            is(&computed.force, &force)?;
            is(&computed.moment, &about_pole)?;
        }
    }

    #[test]
    fn each_load(given in given()) {
        let expected = loads(&given);
        let body = craft::Parametric::default();
        for computed in [
            craft::Baked {}.loads(0.0, &given.state, &given.baked()),
            body.loads(0.0, &given.state, &given.parametric()),
        ] {
            prop_assert_eq!(computed.len(), expected.len());
            for load in &expected {
                let found = computed.iter().find(|found| found.name == load.name).unwrap();
                prop_assert_eq!(found.family, load.family);
                is(&found.force, &Sum::new().and(load.force.0, load.force.1))?;
                is(&found.moment, &Sum::new().and(load.couple.0, load.couple.1))?;
                if load.force.1 > 0.0 {
                    let g = given.state.position;
                    let point = Sum::new().and(g, g.norm()).and(load.arm.0, load.arm.1);
                    is(&found.point, &point)?;
                }
            }
        }
    }

    #[test]
    fn momenta(state in spatial()) {
        let (q, v, w) = (state.attitude, state.velocity, state.angular_velocity);
        let linear = Sum::new().and(v * MASS, v.norm() * MASS);
        let spin = Sum::new().and(q * (inertia() * w), inertia().norm() * w.norm());
        let from_pole = q * Vector3::new(0.6, -0.1, 0.2);
        let carried = from_pole.cross(&(v * MASS));
        let about_pole = spin.and(carried, from_pole.norm() * linear.largest);
        let (baked, parametric) = (craft::Baked {}, craft::Parametric::default());
        is(&baked.linear_momentum(&state), &linear)?;
        is(&baked.angular_momentum(&state), &spin)?;
        is(&baked.angular_momentum_about_pole(0.0, &state), &about_pole)?;
        is(&parametric.linear_momentum(&state), &linear)?;
        is(&parametric.angular_momentum(&state), &spin)?;
        is(&parametric.angular_momentum_about_pole(0.0, &state), &about_pole)?;
    }

    #[test]
    fn energies(given in given()) {
        let state = given.state;
        let (v, w) = (state.velocity, state.angular_velocity);
        let kinetic = 0.5 * (MASS * v.norm_squared() + w.dot(&(inertia() * w)));
        // Uniform fields: -m g · r_G and -F · r_hook. Both terms of the energy are positive: it is the largest.
        let hook = state.position + state.attitude * Vector3::new(0.3, 0.0, 0.5);
        let weight = MASS * 9.80665 * state.position.z;
        let field = Vector3::new(0.5, 0.0, 2.0);
        let potential = weight - field.dot(&hook);
        let largest = MASS * 9.80665 * state.position.norm() + field.norm() * 0.6;
        let body = craft::Parametric::default();
        is_scalar(craft::Baked {}.kinetic_energy(&state), kinetic, kinetic)?;
        is_scalar(body.kinetic_energy(&state), kinetic, kinetic)?;
        let baked = craft::Baked {}.potential_energy(0.0, &state, &given.baked());
        is_scalar(baked, potential, largest)?;
        is_scalar(body.potential_energy(0.0, &state, &given.parametric()), potential, largest)?;
    }
}
