//! What must not depend on the observer: rotated worlds, rotated body axes, moving frames, distant
//! origins.

use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use newton_euler::prelude::*;
use proptest::prelude::*;

use crate::oracle::{self, Sum, attitudes, is, planar, spatial, vectors};

/// All that has a direction is a parameter or an input, so that it can be turned.
mod craft {
    newton_euler::rigid_body!(Craft {
        motion: spatial,
        params: [
            xx,
            yy,
            zz,
            xy,
            yz,
            zx,
            tip = body(_, _, _),
            mast = world(_, _, _),
            gravity = world(_, _, _),
        ],
        inputs: [
            push = body(_, _, _),
            pull = world(_, _, _),
            turn = body(_, _, _),
            twist = world(_, _, _),
            wind = world(_, _, _),
        ],
        mass: 2.5,
        inertia: tensor {
            xx: xx,
            yy: yy,
            zz: zz,
            xy: xy,
            yz: yz,
            zx: zx
        },
        points: [hook = tip, anchor = mast],
        locals: [air = hook.velocity() - wind],
        forces: [
            pushed = push.at(hook),
            pulled = pull.at(anchor),
            drag = (-0.8 * air.norm() * air).at(hook),
            spring = (12 * (anchor.position() - hook.position())).at(hook),
        ],
        moments: [turned = turn, twisted = twist],
        fields: [weight = mass * gravity],
    });
}

/// What the craft is made of and what acts on it; turned about as one wishes.
#[derive(Clone, Copy, Debug)]
struct Scene {
    inertia: Matrix3<f64>,
    tip: Vector3<f64>,
    mast: Vector3<f64>,
    gravity: Vector3<f64>,
    input: craft::CraftInput,
    state: Spatial,
}

impl Scene {
    fn acceleration(&self) -> SpatialAcceleration {
        let j = &self.inertia;
        let params = craft::CraftParams {
            xx: j.m11,
            yy: j.m22,
            zz: j.m33,
            xy: j.m12,
            yz: j.m23,
            zx: j.m31,
            tip: self.tip,
            mast: self.mast,
            gravity: self.gravity,
        };
        craft::Craft::new(params)
            .unwrap()
            .acceleration(0.0, &self.state, &self.input)
    }

    /// The sizes of the largest terms of the accelerations.
    fn sizes(&self) -> [f64; 2] {
        let Spatial {
            position,
            velocity,
            angular_velocity: w,
            ..
        } = self.state;
        let craft::CraftInput {
            push,
            pull,
            turn,
            twist,
            wind,
        } = self.input;
        let airspeed = velocity.norm() + w.norm() * self.tip.norm() + wind.norm();
        let stretch = self.mast.norm() + position.norm() + self.tip.norm();
        let force = [
            push.norm(),
            pull.norm(),
            0.8 * airspeed.powi(2),
            12.0 * stretch,
            25.0,
        ]
        .into_iter()
        .fold(0.0, f64::max);
        let gyroscopic = self.inertia.norm() * w.norm_squared();
        let moment = [force * stretch, turn.norm(), twist.norm(), gyroscopic]
            .into_iter()
            .fold(0.0, f64::max);
        [
            force / 2.5,
            moment * self.inertia.try_inverse().unwrap().norm(),
        ]
    }
}

fn scene() -> impl Strategy<Value = Scene> {
    let v = || vectors(8.0);
    (
        attitudes(),
        spatial(),
        vectors(0.5),
        v(),
        v(),
        v(),
        v(),
        v(),
        v(),
    )
        .prop_map(|(axes, state, tip, mast, push, pull, turn, twist, wind)| {
            let axes = axes.to_rotation_matrix();
            let principal = Matrix3::from_diagonal(&Vector3::new(1.3, 1.7, 2.1));
            let inertia = axes * principal * axes.transpose();
            let inertia = (inertia + inertia.transpose()) / 2.0;
            let input = craft::CraftInput {
                push,
                pull,
                turn,
                twist,
                wind,
            };
            let gravity = Vector3::new(0.0, 0.0, -9.8);
            Scene {
                inertia,
                tip,
                mast,
                gravity,
                input,
                state,
            }
        })
}

/// The same, where both sides were computed in another frame: twice the roundings, and those of turning the data.
fn same(computed: &Vector3<f64>, expected: Vector3<f64>, size: f64) -> Result<(), TestCaseError> {
    is(
        computed,
        &Sum {
            value: expected,
            largest: 4.0 * size,
        },
    )
}

proptest! {
    #[test]
    fn turned_world(scene in scene(), turn in attitudes()) {
        let input = craft::CraftInput {
            pull: turn * scene.input.pull,
            twist: turn * scene.input.twist,
            wind: turn * scene.input.wind,
            ..scene.input
        };
        let state = Spatial {
            position: turn * scene.state.position,
            attitude: turn * scene.state.attitude,
            velocity: turn * scene.state.velocity,
            ..scene.state
        };
        let (mast, gravity) = (turn * scene.mast, turn * scene.gravity);
        let turned = Scene { mast, gravity, input, state, ..scene }.acceleration();
        let (before, [linear, angular]) = (scene.acceleration(), scene.sizes());
        same(&turned.linear, turn * before.linear, linear)?;
        same(&turned.angular, before.angular, angular)?; // components in the body
    }

    #[test]
    fn turned_axes_of_the_body(scene in scene(), turn in attitudes()) {
        // Components in the old axes are `turn` times those in the new.
        let back = turn.inverse();
        let matrix = back.to_rotation_matrix();
        let inertia = matrix * scene.inertia * matrix.transpose();
        let input = craft::CraftInput {
            push: back * scene.input.push,
            turn: back * scene.input.turn,
            ..scene.input
        };
        let state = Spatial {
            attitude: scene.state.attitude * turn,
            angular_velocity: back * scene.state.angular_velocity,
            ..scene.state
        };
        let inertia = (inertia + inertia.transpose()) / 2.0;
        let turned = Scene { inertia, tip: back * scene.tip, input, state, ..scene }.acceleration();
        let (before, [linear, angular]) = (scene.acceleration(), scene.sizes());
        same(&turned.linear, before.linear, linear)?;
        same(&turned.angular, back * before.angular, angular)?;
    }

    #[test]
    fn moving_frame(scene in scene(), boost in vectors(50.0)) {
        // The wind moves along: nothing changes.
        let input = craft::CraftInput { wind: scene.input.wind + boost, ..scene.input };
        let state = Spatial { velocity: scene.state.velocity + boost, ..scene.state };
        let boosted = Scene { input, state, ..scene };
        let (after, before) = (boosted.acceleration(), scene.acceleration());
        let [linear, angular] = boosted.sizes(); // the speeds that cancel are those of the moving frame
        same(&after.linear, before.linear, linear)?;
        same(&after.angular, before.angular, angular)?;
    }

    #[test]
    fn displaced_world(scene in scene(), by in vectors(50.0)) {
        let state = Spatial { position: scene.state.position + by, ..scene.state };
        let displaced = Scene { state, mast: scene.mast + by, ..scene };
        let (after, before) = (displaced.acceleration(), scene.acceleration());
        let [linear, angular] = displaced.sizes();
        same(&after.linear, before.linear, linear)?;
        same(&after.angular, before.angular, angular)?;
    }
}

/// Loads that know neither where they are nor how fast: bitwise the same anywhere.
mod local {
    newton_euler::rigid_body!(Local {
        motion: spatial,
        inputs: [push = body(_, _, _), pull = world(_, _, _)],
        mass: 2.5,
        inertia: tensor {
            xx: 1.3,
            yy: 1.7,
            zz: 2.1,
            xy: -0.12,
            yz: -0.05,
            zx: 0.07
        },
        points: [tip = (1e-3, -2e-3, 5e-4), tail = (-3e-3, 1e-3, 2e-3)],
        forces: [pushed = push.at(tip), pulled = pull.at(tail)],
        moments: [tugged = (tip.position() - tail.position()).cross(pull)],
        fields: [weight = mass * world(0, 0, -9.80665)],
    });

    newton_euler::rigid_body!(Flat {
        motion: planar,
        inputs: [push = body(_, _), pull = world(_, _)],
        mass: 2.5,
        inertia: 1.3,
        points: [tip = (1e-3, -2e-3), tail = (-3e-3, 1e-3)],
        forces: [pushed = push.at(tip), pulled = pull.at(tail)],
        fields: [weight = mass * world(0, -9.80665)],
    });
}

proptest! {
    #[test]
    fn far_away_and_fast_is_bitwise_the_same(
        state in spatial(),
        push in vectors(8.0),
        pull in vectors(8.0),
        place in vectors(1e9),
        boost in vectors(1e5),
    ) {
        let input = local::LocalInput { push, pull };
        let far = Spatial {
            position: state.position + place,
            velocity: state.velocity + boost,
            ..state
        };
        let accelerations = [state, far].map(|state| local::Local {}.acceleration(0.0, &state, &input));
        prop_assert_eq!(accelerations[0], accelerations[1]);
        prop_assert!(accelerations[0].angular != Vector3::zeros());
    }

    #[test]
    fn far_away_and_fast_in_the_plane(
        state in planar(),
        push in oracle::plane_vectors(8.0),
        pull in oracle::plane_vectors(8.0),
        place in oracle::plane_vectors(1e9),
        boost in oracle::plane_vectors(1e5),
    ) {
        let input = local::FlatInput { push, pull };
        let far = Planar {
            position: state.position + place,
            velocity: state.velocity + boost,
            ..state
        };
        let accelerations = [state, far].map(|state| local::Flat {}.acceleration(0.0, &state, &input));
        prop_assert_eq!(accelerations[0], accelerations[1]);
        prop_assert!(accelerations[0].angular != 0.0);
    }
}

/// The double cover: q and -q are one attitude.
#[test]
fn both_signs_of_the_quaternion() {
    let state = Spatial {
        attitude: UnitQuaternion::from_scaled_axis(Vector3::new(0.3, -1.0, 2.0)),
        angular_velocity: Vector3::new(1.0, 2.0, 3.0),
        ..Spatial::default()
    };
    let other = Spatial {
        attitude: UnitQuaternion::new_unchecked(-state.attitude.into_inner()),
        ..state
    };
    let input = local::LocalInput {
        push: Vector3::new(1.0, -2.0, 4.0),
        pull: Vector3::new(3.0, 0.5, -1.0),
    };
    let [one, two] = [state, other].map(|state| local::Local {}.acceleration(0.0, &state, &input));
    assert_eq!(one, two);
}
