//! The same systems by hand: what one would write for each of them.

use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};
use newton_euler::prelude::*;

use super::described::{
    ArmAcceleration, ArmState, DoublePendulumAcceleration, DoublePendulumState, WheelsAcceleration,
    WheelsState,
};

/// Lagrange's equations of a double pendulum, solved by hand.
pub struct DoublePendulum;

impl RigidBody for DoublePendulum {
    type Scalar = f64;
    type State = DoublePendulumState;
    type Input = ();

    #[inline(always)]
    fn acceleration(
        &self,
        _: f64,
        state: &DoublePendulumState,
        (): &(),
    ) -> DoublePendulumAcceleration {
        const UPPER: f64 = 0.04 + 1.2 * 0.28 * 0.28 + 0.8 * 0.6 * 0.6;
        const LOWER: f64 = 0.015 + 0.8 * 0.22 * 0.22;
        const ACROSS: f64 = 0.8 * 0.6 * 0.22;
        const GRAVITY: f64 = 9.80665;
        let (one, two) = (&state.shoulder, &state.elbow);
        let (sine, cosine) = two.angle.sin_cos();
        let (v, w) = (one.angular_velocity, two.angular_velocity);
        let outer = 0.8 * 0.22 * GRAVITY * (one.angle + two.angle).cos();
        let inner = (1.2 * 0.28 + 0.8 * 0.6) * GRAVITY * one.angle.cos();
        let (mixed, swept) = (LOWER + ACROSS * cosine, ACROSS * sine);
        let first = swept * w * (2.0 * v + w) - inner - outer;
        let second = -swept * v * v - outer;
        let whole = UPPER + LOWER + 2.0 * ACROSS * cosine;
        let inverse = 1.0 / (whole * LOWER - mixed * mixed);
        DoublePendulumAcceleration {
            shoulder: (LOWER * first - mixed * second) * inverse,
            elbow: (whole * second - mixed * first) * inverse,
        }
    }
}

/// A gyrostat: the angular momentum of all about the center of all, as the hub sees it.
pub struct Wheels {
    /// Of all, about the center of all, the wheels locked \[kg m²\].
    inertia: Matrix3<f64>,
    /// What turns with the hub if the wheels are free to spin, inverted.
    inverse: Matrix3<f64>,
    /// From the center of the hub to that of all \[m\].
    center: Vector3<f64>,
}

impl Wheels {
    const SPIN: f64 = 0.035;

    pub fn new() -> Self {
        let (wheel, across) = (4.0, 0.02);
        let mass = 120.0 + 3.0 * wheel;
        let center = Vector3::repeat(0.3 * wheel / mass);
        let about =
            |arm: Vector3<f64>| Matrix3::identity() * arm.norm_squared() - arm * arm.transpose();
        let mut inertia = Matrix3::from_diagonal(&Vector3::new(12.0, 14.0, 9.0));
        inertia -= about(center) * mass;
        for axis in 0..3 {
            let mut arm = Vector3::zeros();
            arm[axis] = 0.3;
            let mut own = Vector3::repeat(across);
            own[axis] = Self::SPIN;
            inertia += Matrix3::from_diagonal(&own) + about(arm) * wheel;
        }
        let rest = inertia - Matrix3::identity() * Self::SPIN;
        Self {
            inertia,
            inverse: rest.try_inverse().expect("an inertia"),
            center,
        }
    }
}

impl RigidBody for Wheels {
    type Scalar = f64;
    type State = WheelsState;
    type Input = ();

    #[inline(always)]
    fn acceleration(&self, _: f64, state: &WheelsState, (): &()) -> WheelsAcceleration {
        let torque = Vector3::new(0.05, -0.02, 0.03);
        let w = &state.orbit.angular_velocity;
        let spins = [&state.spin_x, &state.spin_y, &state.spin_z].map(|spin| spin.angular_velocity);
        let momentum = self.inertia * w + Vector3::from(spins) * Self::SPIN;
        let angular = self.inverse * (-w.cross(&momentum) - torque);
        let swept = angular.cross(&self.center) + w.cross(&w.cross(&self.center));
        let spin = torque / Self::SPIN - angular;
        WheelsAcceleration {
            orbit: SpatialAcceleration {
                linear: -(state.orbit.attitude * swept),
                angular,
            },
            spin_x: spin.x,
            spin_y: spin.y,
            spin_z: spin.z,
        }
    }
}

/// A link of an arm: its joint as it is on the link before, and its inertia at the joint.
struct Link {
    turn: Matrix3<f64>,
    place: Vector3<f64>,
    axis: Vector3<f64>,
    inertia: Matrix6<f64>,
    torque: f64,
}

/// The articulated-body algorithm in vectors of six components, angular ones first: R. Featherstone, Rigid Body Dynamics
/// Algorithms, Springer (2008), table 7.1.
pub struct Arm([Link; 6]);

/// Whether the joint is turned by a right angle about y; its place on the link before \[m\]; its axis, y or z; mass \[kg\]; where
/// the center is along z \[m\]; moments of inertia \[kg m²\]; torque \[N m\].
type Row = (bool, [f64; 3], char, f64, f64, [f64; 3], f64);

const SHOULDER: [f64; 3] = [0.010_267_495_893, 0.010_267_495_893, 0.00666];
const UPPER_ARM: [f64; 3] = [0.226_890_675_91, 0.226_890_675_91, 0.015_107_4];
const FOREARM: [f64; 3] = [0.049_443_313_556, 0.049_443_313_556, 0.004_095];
const WRIST: [f64; 3] = [0.111_172_755_531, 0.111_172_755_531, 0.219_42];
const HAND: [f64; 3] = [0.017_136_473_145_4, 0.017_136_473_145_4, 0.033_822];

const ROWS: [Row; 6] = [
    (false, [0.0, 0.0, 0.089_159], 'z', 3.7, 0.0, SHOULDER, 10.0),
    (
        true,
        [0.0, 0.135_85, 0.0],
        'y',
        8.393,
        0.28,
        UPPER_ARM,
        -20.0,
    ),
    (
        false,
        [0.0, -0.1197, 0.425],
        'y',
        2.275,
        0.25,
        FOREARM,
        15.0,
    ),
    (true, [0.0, 0.0, 0.392_25], 'y', 1.219, 0.0, WRIST, 2.0),
    (false, [0.0, 0.093, 0.0], 'z', 1.219, 0.0, WRIST, -1.0),
    (false, [0.0, 0.0, 0.094_65], 'y', 0.1879, 0.0, HAND, 0.5),
];

impl Arm {
    pub fn new() -> Self {
        Self(
            ROWS.map(|(is_turned, place, axis, mass, along, moments, torque)| {
                let turned = Matrix3::new(0.0, 0.0, 1.0, 0.0, 1.0, 0.0, -1.0, 0.0, 0.0);
                let arm = (Vector3::z() * along).cross_matrix();
                let about = Matrix3::from_diagonal(&moments.into()) - arm * arm * mass;
                Link {
                    turn: if is_turned {
                        turned
                    } else {
                        Matrix3::identity()
                    },
                    place: place.into(),
                    axis: if axis == 'y' {
                        Vector3::y()
                    } else {
                        Vector3::z()
                    },
                    inertia: six(about, arm * mass, -arm * mass, Matrix3::identity() * mass),
                    torque,
                }
            }),
        )
    }
}

/// A matrix of four blocks.
#[inline(always)]
fn six(a: Matrix3<f64>, b: Matrix3<f64>, c: Matrix3<f64>, d: Matrix3<f64>) -> Matrix6<f64> {
    let mut whole = Matrix6::zeros();
    for (place, block) in [((0, 0), a), ((0, 3), b), ((3, 0), c), ((3, 3), d)] {
        whole
            .fixed_view_mut::<3, 3>(place.0, place.1)
            .copy_from(&block);
    }
    whole
}

/// Angular and linear components.
#[inline(always)]
fn parts(v: &Vector6<f64>) -> (Vector3<f64>, Vector3<f64>) {
    (v.fixed_rows::<3>(0).into(), v.fixed_rows::<3>(3).into())
}

#[inline(always)]
fn both(angular: &Vector3<f64>, linear: &Vector3<f64>) -> Vector6<f64> {
    Vector6::new(
        angular.x, angular.y, angular.z, linear.x, linear.y, linear.z,
    )
}

impl RigidBody for Arm {
    type Scalar = f64;
    type State = ArmState;
    type Input = ();

    #[inline(always)]
    fn acceleration(&self, _: f64, state: &ArmState, (): &()) -> ArmAcceleration {
        let hinges = [
            &state.pan,
            &state.lift,
            &state.elbow,
            &state.wrist_1,
            &state.wrist_2,
            &state.wrist_3,
        ];
        let mut transforms = [Matrix6::zeros(); 6];
        let [mut freedoms, mut swept, mut biases] = [[Vector6::zeros(); 6]; 3];
        let mut inertias = [Matrix6::zeros(); 6];
        let mut velocity = Vector6::zeros();
        for (k, (link, hinge)) in self.0.iter().zip(hinges).enumerate() {
            let (sine, cosine) = hinge.angle.sin_cos();
            let axis = &link.axis;
            let turn = Matrix3::identity() * cosine
                + axis.cross_matrix() * sine
                + axis * axis.transpose() * (1.0 - cosine);
            let back = (link.turn * turn).transpose();
            let arm = back * link.place.cross_matrix();
            transforms[k] = six(back, Matrix3::zeros(), -arm, back);
            freedoms[k] = both(axis, &Vector3::zeros());
            let joint = freedoms[k] * hinge.angular_velocity;
            velocity = transforms[k] * velocity + joint;
            let (w, v) = parts(&velocity);
            let (spin, _) = parts(&joint);
            swept[k] = both(&w.cross(&spin), &v.cross(&spin));
            inertias[k] = link.inertia;
            let (angular, linear) = parts(&(link.inertia * velocity));
            biases[k] = both(&(w.cross(&angular) + v.cross(&linear)), &w.cross(&linear));
        }
        let [mut columns, mut found] = [[Vector6::zeros(); 6], [Vector6::zeros(); 6]];
        let (mut diagonal, mut rest) = ([0.0; 6], [0.0; 6]);
        for k in (0..6).rev() {
            columns[k] = inertias[k] * freedoms[k];
            diagonal[k] = freedoms[k].dot(&columns[k]);
            rest[k] = self.0[k].torque - freedoms[k].dot(&biases[k]);
            if k > 0 {
                let inertia = inertias[k] - columns[k] * columns[k].transpose() / diagonal[k];
                let bias = biases[k] + inertia * swept[k] + columns[k] * (rest[k] / diagonal[k]);
                let back = transforms[k].transpose();
                inertias[k - 1] += back * inertia * transforms[k];
                biases[k - 1] += back * bias;
            }
        }
        let mut carrier = both(&Vector3::zeros(), &(Vector3::z() * 9.81));
        let mut joints = [0.0; 6];
        for k in 0..6 {
            let acceleration = transforms[k] * carrier + swept[k];
            joints[k] = (rest[k] - columns[k].dot(&acceleration)) / diagonal[k];
            found[k] = acceleration + freedoms[k] * joints[k];
            carrier = found[k];
        }
        let [pan, lift, elbow, wrist_1, wrist_2, wrist_3] = joints;
        ArmAcceleration {
            pan,
            lift,
            elbow,
            wrist_1,
            wrist_2,
            wrist_3,
        }
    }
}
