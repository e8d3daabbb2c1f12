//! The arm, by the recursion of articulated bodies over a list of links: what one would write by hand.
//!
//! R. Featherstone, Rigid Body Dynamics Algorithms, Springer (2008), 7.3, in the axes of each body.

use nalgebra::{Matrix3, Matrix6, Rotation3, UnitVector3, Vector3, Vector6};
use newton_euler::prelude::*;

use super::described::*;

/// A link, in axes of its joint and from the origin there.
struct Link {
    axis: UnitVector3<f64>,
    /// Of the joint in the axes of the carrier, and where it is.
    turn: Rotation3<f64>,
    place: Vector3<f64>,
    inertia: Matrix6<f64>,
    drive: f64,
}

pub struct Arm([Link; 6]);

/// `a x`
fn across(a: &Vector3<f64>) -> Matrix3<f64> {
    a.cross_matrix()
}

/// Of motions, angular first: from the axes and origin of the carrier to those of the link.
fn moved(turn: &Matrix3<f64>, place: &Vector3<f64>) -> Matrix6<f64> {
    let mut found = Matrix6::zeros();
    let back = turn.transpose();
    found.fixed_view_mut::<3, 3>(0, 0).copy_from(&back);
    found.fixed_view_mut::<3, 3>(3, 3).copy_from(&back);
    found
        .fixed_view_mut::<3, 3>(3, 0)
        .copy_from(&(-back * across(place)));
    found
}

/// The rate of a motion that turns with another.
fn carried(v: &Vector6<f64>, other: &Vector6<f64>) -> Vector6<f64> {
    let (w, u) = (v.fixed_rows::<3>(0), v.fixed_rows::<3>(3));
    let (a, b) = (other.fixed_rows::<3>(0), other.fixed_rows::<3>(3));
    joined(w.cross(&a), w.cross(&b) + u.cross(&a))
}

/// The same of a load.
fn pushed(v: &Vector6<f64>, load: &Vector6<f64>) -> Vector6<f64> {
    let (w, u) = (v.fixed_rows::<3>(0), v.fixed_rows::<3>(3));
    let (m, f) = (load.fixed_rows::<3>(0), load.fixed_rows::<3>(3));
    joined(w.cross(&m) + u.cross(&f), w.cross(&f))
}

fn joined(a: Vector3<f64>, b: Vector3<f64>) -> Vector6<f64> {
    Vector6::new(a.x, a.y, a.z, b.x, b.y, b.z)
}

impl Link {
    fn new(
        axis: Vector3<f64>,
        quarters: f64,
        place: [f64; 3],
        (mass, center): (f64, f64),
        [x, y, z]: [f64; 3],
        drive: f64,
    ) -> Self {
        let center = Vector3::z() * center;
        let mut inertia = Matrix6::zeros();
        let first = across(&center) * mass;
        let about = Matrix3::from_diagonal(&Vector3::new(x, y, z)) - first * across(&center);
        inertia.fixed_view_mut::<3, 3>(0, 0).copy_from(&about);
        inertia.fixed_view_mut::<3, 3>(0, 3).copy_from(&first);
        inertia.fixed_view_mut::<3, 3>(3, 0).copy_from(&-first);
        inertia
            .fixed_view_mut::<3, 3>(3, 3)
            .copy_from(&Matrix3::from_diagonal_element(mass));
        Self {
            axis: UnitVector3::new_normalize(axis),
            turn: Rotation3::new(Vector3::y() * (quarters * std::f64::consts::FRAC_PI_2)),
            place: place.into(),
            inertia,
            drive,
        }
    }
}

impl Arm {
    pub fn new() -> Self {
        let (y, z) = (Vector3::y(), Vector3::z());
        let (large, small) = (0.111_172_755_531, 0.017_136_473_145_4);
        let shoulder = [0.010_267_495_893, 0.010_267_495_893, 0.006_66];
        let upper_arm = [0.226_890_675_91, 0.226_890_675_91, 0.015_107_4];
        let forearm = [0.049_443_313_556, 0.049_443_313_556, 0.004_095];
        let wrist = [large, large, 0.219_42];
        let hand = [small, small, 0.033_822];
        Self([
            Link::new(z, 0.0, [0.0, 0.0, 0.089_159], (3.7, 0.0), shoulder, 10.0),
            Link::new(
                y,
                1.0,
                [0.0, 0.135_85, 0.0],
                (8.393, 0.28),
                upper_arm,
                -20.0,
            ),
            Link::new(y, 0.0, [0.0, -0.1197, 0.425], (2.275, 0.25), forearm, 15.0),
            Link::new(y, 1.0, [0.0, 0.0, 0.392_25], (1.219, 0.0), wrist, 2.0),
            Link::new(z, 0.0, [0.0, 0.093, 0.0], (1.219, 0.0), wrist, -1.0),
            Link::new(y, 0.0, [0.0, 0.0, 0.094_65], (0.1879, 0.0), hand, 0.5),
        ])
    }
}

impl RigidBody for Arm {
    type Scalar = f64;
    type State = Ur5State;
    type Input = ();

    #[inline(always)]
    fn acceleration(&self, _: f64, state: &Ur5State, (): &()) -> Ur5Acceleration {
        let joints = [
            &state.pan,
            &state.lift,
            &state.elbow,
            &state.wrist_1,
            &state.wrist_2,
            &state.wrist_3,
        ];
        let mut moves = [Matrix6::zeros(); 6];
        let (mut biases, mut loads) = ([Vector6::zeros(); 6], [Vector6::zeros(); 6]);
        let mut inertias = [Matrix6::zeros(); 6];
        let mut v = Vector6::zeros();
        for (k, (link, joint)) in self.0.iter().zip(joints).enumerate() {
            let turn = link.turn * Rotation3::from_axis_angle(&link.axis, joint.angle);
            moves[k] = moved(turn.matrix(), &link.place);
            let spin = joined(*link.axis * joint.angular_velocity, Vector3::zeros());
            v = moves[k] * v + spin;
            biases[k] = carried(&v, &spin);
            inertias[k] = link.inertia;
            loads[k] = pushed(&v, &(link.inertia * v));
        }
        // U, 1/D and u
        let mut solved = [(Vector6::zeros(), 0.0, 0.0); 6];
        for k in (0..6).rev() {
            let axis = joined(*self.0[k].axis, Vector3::zeros());
            let u = inertias[k] * axis;
            let inverse = 1.0 / axis.dot(&u);
            let left = self.0[k].drive - axis.dot(&loads[k]);
            solved[k] = (u, inverse, left);
            if let Some(carrier) = k.checked_sub(1) {
                let inertia = inertias[k] - u * u.transpose() * inverse;
                let load = loads[k] + inertia * biases[k] + u * (inverse * left);
                inertias[carrier] += moves[k].transpose() * inertia * moves[k];
                loads[carrier] += moves[k].transpose() * load;
            }
        }
        let mut a = Vector6::new(0.0, 0.0, 0.0, 0.0, 0.0, 9.81);
        let mut found = [0.0; 6];
        for k in 0..6 {
            let (u, inverse, left) = solved[k];
            a = moves[k] * a + biases[k];
            found[k] = inverse * (left - u.dot(&a));
            a += joined(*self.0[k].axis * found[k], Vector3::zeros());
        }
        let [pan, lift, elbow, wrist_1, wrist_2, wrist_3] = found;
        Ur5Acceleration {
            pan,
            lift,
            elbow,
            wrist_1,
            wrist_2,
            wrist_3,
        }
    }
}
