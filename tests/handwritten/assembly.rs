//! One joint of every kind, with accelerations that are arbitrary smooth functions of all
//! coordinates.

use newton_euler::Scalar;
use newton_euler::columns::{Columns, Generic, Sink, Source};
use newton_euler::integrate::DormandPrince;
use newton_euler::nalgebra::{UnitQuaternion, Vector2, Vector3};
use newton_euler::prelude::*;
use newton_euler::private::generic;

use super::number;

newton_euler::private::system_state! {
    /// The state of an [`Assembly`]: sixty coordinates.
    AssemblyState
    /// The acceleration of an [`Assembly`].
    AssemblyAcceleration <T> {
        orbit: Spatial => generic::SpatialAcceleration<T>,
        wheel: Hinge => T,
        ball: Rotation => Vector3<T>,
        slide: Slide => T,
        piston: Cylinder => generic::CylinderAcceleration<T>,
        gimbal: Universal => Vector2<T>,
        raft: Planar => generic::PlanarAcceleration<T>,
        load: Translation => Vector3<T>,
        tray: PlanarTranslation => Vector2<T>,
        needle: Rod => generic::RodAcceleration<T>,
    }
}

#[derive(Clone, Copy, Debug, Default)]
pub struct Assembly<T: Scalar> {
    /// Of the wheel, by a moment about its axis \[rad/s²\].
    pub spin: T,
}

/// A spring that pulls an attitude to where it is zero.
#[inline(always)]
fn pull<T: Scalar>(attitude: &UnitQuaternion<T>) -> Vector3<T> {
    let q = attitude.as_ref().coords;
    Vector3::new(q.x * q.w, q.y * q.w, q.z * q.w) * number(q.x, -3.0)
}

impl<T: Scalar> RigidBody for Assembly<T> {
    type Scalar = T;
    type State = AssemblyState<T>;
    type Input = ();

    #[inline(always)]
    fn acceleration(&self, time: T, state: &Self::State, (): &()) -> AssemblyAcceleration<T> {
        let half = number(time, 0.5);
        let (orbit, ball, needle) = (&state.orbit, &state.ball, &state.needle);
        let (piston, gimbal) = (&state.piston, &state.gimbal);
        let (raft, tray) = (&state.raft, &state.tray);
        let wheel_rate = state.wheel.angular_velocity;
        let [w, v] = [orbit.angular_velocity, ball.angular_velocity];
        let turn = Vector3::new(w.y * v.z - w.z * v.y, w.z * v.x - w.x * v.z, w.x * v.y);
        let u = needle.axis.into_inner();
        let rate = needle.axis_rate;
        let speed = rate.x * rate.x + rate.y * rate.y + rate.z * rate.z;
        let tilt = u.z * half;
        AssemblyAcceleration {
            orbit: generic::SpatialAcceleration {
                linear: v * state.wheel.angle.sin() - orbit.position * half - orbit.velocity * half,
                angular: turn * half + Vector3::new(state.slide.position, tilt, w.x * w.y) * half
                    - w,
            },
            wheel: self.spin + w.x - state.wheel.angle.sin() - half * wheel_rate,
            ball: pull(&ball.attitude) + turn - w * half - v,
            slide: v.y - state.slide.position - state.slide.velocity - half * piston.velocity,
            piston: generic::CylinderAcceleration {
                linear: state.slide.velocity - piston.position - piston.velocity,
                angular: (piston.angle + time).cos() - half * piston.angular_velocity,
            },
            gimbal: Vector2::new(
                gimbal.angle_2.sin() - gimbal.angular_velocity_1,
                wheel_rate - gimbal.angle_2 - gimbal.angular_velocity_2,
            ),
            raft: generic::PlanarAcceleration {
                linear: tray.velocity * half - raft.position - raft.velocity,
                angular: gimbal.angle_1.cos() - raft.angle - raft.angular_velocity,
            },
            load: orbit.position - state.load.position - state.load.velocity,
            tray: raft.position * half - tray.position - tray.velocity,
            needle: generic::RodAcceleration {
                linear: state.load.velocity - needle.position - needle.velocity,
                axis: Vector3::new(-tilt * u.x, -tilt * u.y, half - tilt * u.z) - u * speed,
            },
        }
    }
}

impl Integrate for Assembly<f64> {
    type Best = DormandPrince;
}

impl<T: Scalar> Columns<T> for Assembly<T> {
    const COUNT: usize = 1;

    #[inline(always)]
    fn read(source: &mut impl Source<T>) -> Self {
        Self {
            spin: source.take(),
        }
    }

    #[inline(always)]
    fn write(&self, sink: &mut impl Sink<T>) {
        sink.put(self.spin);
    }
}

impl Generic for Assembly<f64> {
    type With<T: Scalar> = Assembly<T>;
    type Params = f64;

    fn build(spin: f64) -> Result<Self, InvalidBody> {
        Ok(Self { spin })
    }

    fn parameters(&self) -> f64 {
        self.spin
    }
}
