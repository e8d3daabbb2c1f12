//! The parts of the runtime that users call directly.

use newton_euler::exact::{
    AxialTorque, Elliptic, FreeRotation, Jacobi, LagrangeTop, Path, Pendulum, r_j,
};
use newton_euler::inertia::{InertiaTensor, InvalidInertia};
use newton_euler::nalgebra::{Matrix3, Quaternion, UnitQuaternion, UnitVector3, Vector3};
use newton_euler::prelude::*;
use newton_euler::principal::PrincipalAxes;
use newton_euler::wrench::{PlanarReduction, Reduction};
use newton_euler::{attitude, gyroscopic};

cannot_panic! {
    fn exp(rotation: &Vector3<f64>) -> UnitQuaternion<f64> {
        attitude::exp(rotation)
    }

    fn log(attitude: &UnitQuaternion<f64>) -> Vector3<f64> {
        attitude::log(attitude)
    }

    fn kinematics(attitude: &UnitQuaternion<f64>, rate: &Vector3<f64>) -> Quaternion<f64> {
        attitude::kinematics(attitude, rate)
    }

    fn normalized(quaternion: &Quaternion<f64>) -> UnitQuaternion<f64> {
        attitude::normalized(quaternion)
    }

    fn turned(attitude: &UnitQuaternion<f64>, rotation: &Vector3<f64>) -> UnitQuaternion<f64> {
        attitude::turned(attitude, rotation)
    }

    fn principal(xx: f64, yy: f64, zz: f64) -> Result<InertiaTensor, InvalidInertia> {
        InertiaTensor::principal(xx, yy, zz)
    }

    fn tensor(xx: f64, yy: f64, zz: f64, xy: f64, yz: f64, zx: f64) -> Result<InertiaTensor, InvalidInertia> {
        InertiaTensor::tensor(xx, yy, zz, xy, yz, zx)
    }

    fn products(xx: f64, yy: f64, zz: f64, xy: f64, yz: f64, zx: f64) -> Result<InertiaTensor, InvalidInertia> {
        InertiaTensor::products(xx, yy, zz, xy, yz, zx)
    }

    fn from_matrix(matrix: &Matrix3<f64>) -> Result<InertiaTensor, InvalidInertia> {
        InertiaTensor::from_matrix(matrix)
    }

    fn times(inertia: &InertiaTensor, vector: &Vector3<f64>) -> Vector3<f64> {
        inertia.times(vector)
    }

    fn rotated(inertia: &InertiaTensor, rotation: &UnitQuaternion<f64>) -> InertiaTensor {
        inertia.rotated(rotation)
    }

    fn shifted_from_center(inertia: &InertiaTensor, mass: f64, offset: &Vector3<f64>) -> Result<InertiaTensor, InvalidInertia> {
        inertia.shifted_from_center(mass, offset)
    }

    fn shifted_to_center(inertia: &InertiaTensor, mass: f64, offset: &Vector3<f64>) -> Result<InertiaTensor, InvalidInertia> {
        inertia.shifted_to_center(mass, offset)
    }

    fn principal_axes(inertia: &InertiaTensor) -> PrincipalAxes {
        inertia.principal_axes()
    }

    fn inverse(inertia: &InertiaTensor) -> Result<Matrix3<f64>, InvalidInertia> {
        inertia.inverse()
    }

    fn torque(inertia: &InertiaTensor, rate: &Vector3<f64>) -> Vector3<f64> {
        gyroscopic::torque(inertia, rate)
    }

    fn gyroscopic_matrix(inertia: &InertiaTensor, rate: &Vector3<f64>) -> Matrix3<f64> {
        gyroscopic::matrix(inertia, rate)
    }

    fn linearization(inertia: &InertiaTensor, rate: &Vector3<f64>) -> Matrix3<f64> {
        gyroscopic::linearization(inertia, rate)
    }

    fn moved(wrench: &Wrench, from: &Vector3<f64>, to: &Vector3<f64>) -> Wrench {
        wrench.moved(from, to)
    }

    fn reduce(wrench: &Wrench) -> Reduction {
        wrench.reduce()
    }

    fn reduce_in_the_plane(wrench: &PlanarWrench) -> PlanarReduction {
        wrench.reduce()
    }

    fn elliptic(complement: f64, argument: f64) -> Elliptic {
        Jacobi::new(complement).at(argument)
    }

    fn third_kind(x: f64, y: f64, z: f64, p: f64) -> f64 {
        r_j(x, y, z, p)
    }

    fn free_rotation(inertia: &InertiaTensor, state: &Rotation) -> FreeRotation {
        FreeRotation::new(inertia, state)
    }

    fn free_rotation_at(motion: &FreeRotation, time: f64) -> (Rotation, f64) {
        (motion.at(time), motion.pace(time))
    }

    fn lagrange_top(moments: [f64; 2], axis: UnitVector3<f64>, couple: Vector3<f64>, state: &Rotation) -> LagrangeTop {
        LagrangeTop::new(moments, axis, couple, state)
    }

    fn lagrange_top_at(motion: &LagrangeTop, time: f64) -> (Rotation, f64) {
        (motion.at(time), motion.pace(time))
    }

    fn axial_torque(moments: [f64; 2], axis: UnitVector3<f64>, torque: f64, state: &Rotation) -> AxialTorque {
        AxialTorque::new(moments, axis, torque, state)
    }

    fn axial_torque_at(motion: &AxialTorque, time: f64) -> (Rotation, f64) {
        (motion.at(time), motion.pace(time))
    }

    fn pendulum(rate: f64, hanging: f64, state: &Hinge) -> Pendulum {
        Pendulum::new(rate, hanging, state)
    }

    fn pendulum_at(motion: &Pendulum, time: f64) -> (Hinge, f64) {
        (motion.at(time), motion.pace(time))
    }
}
