//! The erratum of (1.9): all of its numbers, for the completed equation and for the equation as
//! printed.
//!
//! The printed equation exists only here.

use std::f64::consts::PI;

use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use newton_euler::{gyroscopic, integrate, prelude::*};
use proptest::prelude::*;

use crate::reference::{attitude, completed, distance, number, numbers, statement, vector};

fn squares_of(w: &Vector3<f64>) -> Vector3<f64> {
    w.component_mul(w)
}

fn products_of(w: &Vector3<f64>) -> Vector3<f64> {
    Vector3::new(w.y * w.z, w.z * w.x, w.x * w.y)
}

/// (1.9) as printed: the moment of the inertial forces without the matrix on the products.
fn printed(j: &InertiaTensor, w: &Vector3<f64>, dw: &Vector3<f64>) -> Vector3<f64> {
    gyroscopic::squares(j) * squares_of(w) - j.times(dw)
}

/// The acceleration that balances a moment by the printed (1.9).
fn printed_acceleration(
    j: &InertiaTensor,
    w: &Vector3<f64>,
    moment: &Vector3<f64>,
) -> Vector3<f64> {
    j.inverse().unwrap() * (moment + printed(j, w, &Vector3::zeros()))
}

/// The acceleration of a free body from the vector law.
fn free_acceleration(j: &InertiaTensor, w: &Vector3<f64>) -> Vector3<f64> {
    -(j.inverse().unwrap() * w.cross(&(j.matrix() * w)))
}

/// The classical Runge-Kutta method on body rates alone: the attitude does not enter a free body's.
fn rates(
    f: impl Fn(&Vector3<f64>) -> Vector3<f64>,
    mut w: Vector3<f64>,
    span: f64,
    steps: u32,
) -> Vector3<f64> {
    let h = span / f64::from(steps);
    for _ in 0..steps {
        let k1 = f(&w);
        let k2 = f(&(w + k1 * (h / 2.0)));
        let k3 = f(&(w + k2 * (h / 2.0)));
        let k4 = f(&(w + k3 * h));
        w += (k1 + (k2 + k3) * 2.0 + k4) * (h / 6.0);
    }
    w
}

fn close(computed: &Vector3<f64>, expected: &Vector3<f64>, tolerance: f64) {
    let error = (computed - expected).amax();
    assert!(
        error <= tolerance,
        "{computed} is not {expected}: off by {error:e}"
    );
}

/// The worked example: tensor, ω, ω̇.
fn worked() -> (InertiaTensor, Vector3<f64>, Vector3<f64>) {
    let inputs = completed()["worked example"]["inputs"].take();
    let [xx, yy, zz, xy, yz, zx] =
        ["Jxx", "Jyy", "Jzz", "Jxy", "Jyz", "Jxz"].map(|name| number(&inputs[name]));
    let [w, dw] = [["wx", "wy", "wz"], ["ax", "ay", "az"]]
        .map(|names| names.map(|name| number(&inputs[name])).into());
    (
        InertiaTensor::products(xx, yy, zz, xy, yz, zx).unwrap(),
        w,
        dw,
    )
}

#[test]
fn worked_example_term_by_term() {
    let (j, w, dw) = worked();
    let expected = completed()["worked example"].take();
    // All terms are below 16 and take at most five roundings: 2e-15.
    let is = |computed: Vector3<f64>, name: &str| close(&computed, &vector(&expected[name]), 2e-15);
    is(-j.times(&dw), "-I wdot");
    is(gyroscopic::squares(&j) * squares_of(&w), "G_sq sq");
    is(gyroscopic::products(&j) * products_of(&w), "G_prod prod");
    is(gyroscopic::inertial_moment(&j, &w, &dw), "M_i full");
    is(gyroscopic::inertial_moment(&j, &w, &dw), "M_i full decimal");
    is(printed(&j, &w, &dw), "M_i printed(1.9)");
    is(printed(&j, &w, &dw), "M_i printed decimal");
}

#[test]
fn matrices_are_those_of_the_text() {
    let [xx, yy, zz, xy, yz, zx] = [11.0, 13.0, 17.0, 1.0, 2.0, 3.0];
    let j = InertiaTensor::products(xx, yy, zz, xy, yz, zx).unwrap();
    assert_eq!(
        gyroscopic::squares(&j),
        Matrix3::new(0.0, yz, -yz, -zx, 0.0, zx, xy, -xy, 0.0)
    );
    assert_eq!(
        gyroscopic::products(&j),
        Matrix3::new(yy - zz, -xy, zx, xy, zz - xx, -yz, -zx, yz, xx - yy)
    );
    // Read with (1.5) as the tensor, the whole matrix on the squares changes sign (E3).
    let tensor = InertiaTensor::tensor(xx, yy, zz, xy, yz, zx).unwrap();
    assert_eq!(gyroscopic::squares(&tensor), -gyroscopic::squares(&j));
}

/// Moment of the inertial forces of mass points, -Σ m r × (ω̇ × r + ω × (ω × r)).
fn point_moment(
    points: &[(f64, Vector3<f64>)],
    w: &Vector3<f64>,
    dw: &Vector3<f64>,
) -> Vector3<f64> {
    points
        .iter()
        .map(|(m, r)| -r.cross(&(dw.cross(r) + w.cross(&w.cross(r)))) * *m)
        .sum()
}

/// The positive products and moments of mass points about the origin of their coordinates.
fn point_inertia(points: &[(f64, Vector3<f64>)]) -> InertiaTensor {
    let sum = |f: fn(&Vector3<f64>) -> f64| points.iter().map(|(m, r)| m * f(r)).sum();
    InertiaTensor::products(
        sum(|r| r.y * r.y + r.z * r.z),
        sum(|r| r.z * r.z + r.x * r.x),
        sum(|r| r.x * r.x + r.y * r.y),
        sum(|r| r.x * r.y),
        sum(|r| r.y * r.z),
        sum(|r| r.z * r.x),
    )
    .unwrap()
}

fn some_vector() -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-2.0..2.0).prop_map(Vector3::from)
}

proptest! {
    #[test]
    fn completed_equation_is_the_sum_over_mass_points(
        points in prop::collection::vec((0.1..3.0, some_vector()), 6),
        w in some_vector(),
        dw in some_vector(),
    ) {
        let j = point_inertia(&points);
        let expected = point_moment(&points, &w, &dw);
        let split = gyroscopic::squares(&j) * squares_of(&w)
            + gyroscopic::products(&j) * products_of(&w) - j.times(&dw);
        // Terms up to 6 · 3 · 12 · 12 = 2600, some thirty roundings of 1e-16.
        close(&split, &expected, 1e-11);
        close(&gyroscopic::inertial_moment(&j, &w, &dw), &expected, 1e-11);
    }

    #[test]
    fn printed_equation_holds_about_one_axis_only(
        points in prop::collection::vec((0.1..3.0, some_vector()), 6),
        rate in -2.0..2.0,
        axis in 0usize..3,
        dw in some_vector(),
    ) {
        let j = point_inertia(&points);
        let mut w = Vector3::zeros();
        w[axis] = rate;
        close(&printed(&j, &w, &dw), &point_moment(&points, &w, &dw), 1e-11);
    }

    #[test]
    fn full_term_does_no_work_and_the_printed_part_does(
        points in prop::collection::vec((0.1..3.0, some_vector()), 6),
        w in some_vector(),
    ) {
        let j = point_inertia(&points);
        let [xy, yz, zx] = j.positive_products();
        let spurious = xy * w.z * (w.x * w.x - w.y * w.y)
            + zx * w.y * (w.z * w.z - w.x * w.x)
            + yz * w.x * (w.y * w.y - w.z * w.z);
        // Terms up to 72 · 2 · 12, a dozen roundings.
        prop_assert!(w.dot(&gyroscopic::torque(&j, &w)).abs() < 1e-11);
        let power = w.dot(&printed(&j, &w, &Vector3::zeros()));
        prop_assert!((power - spurious).abs() < 1e-11);
    }

    #[test]
    fn linearization_is_the_derivative(
        points in prop::collection::vec((0.1..3.0, some_vector()), 6),
        w in some_vector(),
        d in some_vector(),
    ) {
        let j = point_inertia(&points);
        // The term is quadratic, so its central difference is exact: rounding only.
        let difference = (gyroscopic::torque(&j, &(w + d)) - gyroscopic::torque(&j, &(w - d))) / 2.0;
        close(&(gyroscopic::linearization(&j, &w) * d), &difference, 1e-11);
        close(&(gyroscopic::matrix(&j, &w) * w), &gyroscopic::torque(&j, &w), 1e-11);
    }
}

#[test]
fn printed_equation_depends_on_the_frame() {
    let plate = InertiaTensor::principal(1.0, 2.0, 3.0).unwrap();
    let w = Vector3::new(1.0, 1.0, 0.0);
    let eighth = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), PI / 4.0);
    let none = Vector3::zeros();
    let in_turned_axes = |law: fn(&InertiaTensor, &Vector3<f64>, &Vector3<f64>) -> Vector3<f64>| {
        let back = eighth.inverse();
        eighth * law(&plate.rotated(&back), &(back * w), &none)
    };
    let truth = Vector3::new(0.0, 0.0, -1.0);
    assert_eq!(printed(&plate, &w, &none), none);
    // Turning there and back costs a few roundings of numbers up to 3.
    close(&in_turned_axes(printed), &truth, 4e-15);
    assert_eq!(gyroscopic::inertial_moment(&plate, &w, &none), truth);
    close(&in_turned_axes(gyroscopic::inertial_moment), &truth, 4e-15);
}

#[test]
fn printed_equation_swings_the_angular_momentum() {
    let expected = statement("section 1.2 literal (1.9), torque-free J=(1,2,3), w=(1,1,1)");
    let j = InertiaTensor::principal(1.0, 2.0, 3.0).unwrap();
    let w = Vector3::new(1.0, 1.0, 1.0);
    // In principal axes the printed rates are constant, so that the body turns steadily about ω.
    assert_eq!(
        printed_acceleration(&j, &w, &Vector3::zeros()),
        Vector3::zeros()
    );
    assert_eq!(
        gyroscopic::inertial_moment(&j, &w, &Vector3::zeros()),
        vector(&expected["true gyroscopic torque -wxJw"]),
    );
    let momentum = j.times(&w);
    let [swing, time] = numbers(&expected["max spurious swing of L_world = 2*angle, at t=pi/|w|"]);
    assert!((time - PI / w.norm()).abs() < 1e-15);
    let later = UnitQuaternion::from_scaled_axis(w * time) * momentum;
    // Angles by arc tangent: a few roundings.
    assert!((w.angle(&momentum) - number(&expected["angle(w,L) rad"])).abs() < 1e-15);
    assert!((momentum.angle(&later) - swing).abs() < 2e-15);
    let change = (later - momentum).norm() / momentum.norm();
    assert!((change - number(&expected["|dL| max / |L|"])).abs() < 1e-15);
    // It is the largest.
    for k in 0..100 {
        let at =
            UnitQuaternion::from_scaled_axis(w * (2.0 * time * f64::from(k) / 100.0)) * momentum;
        assert!(momentum.angle(&at) < swing + 2e-15);
    }
}

#[test]
fn printed_equation_loses_energy_and_momentum() {
    let expected = statement("section 1.2 literal (1.9) torque free, generic J, t=10");
    let (j, _, _) = worked();
    let start = vector(&expected["w0"]);
    // At steps of 1 ms the error is below 1e-11 (sixteen times less at half the step).
    let truth = rates(|w| free_acceleration(&j, w), start, 10.0, 10_000);
    let literal = rates(
        |w| printed_acceleration(&j, w, &Vector3::zeros()),
        start,
        10.0,
        10_000,
    );
    close(&truth, &vector(&expected["true w"]), 1e-10);
    close(&literal, &vector(&expected["literal w"]), 1e-10);
    let energies = [start, truth, literal].map(|w| 0.5 * w.dot(&j.times(&w)));
    let momenta = [start, truth, literal].map(|w| j.times(&w).norm());
    close(
        &energies.into(),
        &vector(&expected["T0,T_true,T_literal"]),
        1e-10,
    );
    close(
        &momenta.into(),
        &vector(&expected["|L|0,true,literal"]),
        1e-10,
    );
}

#[test]
fn yawed_rotor() {
    let [polar, diametral, spin, yaw] = [0.09, 0.05, 200.0, 2.0];
    let rotor = InertiaTensor::principal(polar, diametral, diametral).unwrap();
    // Axes of the rotor at the instant when its z is vertical: the vertical turns against the spin.
    let w = Vector3::new(spin, 0.0, yaw);
    let dw = -Vector3::x().cross(&Vector3::z()) * (spin * yaw);
    // The couple on the rotor is minus the inertial one: J_p ω_s Ω, exact up to the roundings of 0.09 and 0.05.
    close(
        &gyroscopic::inertial_moment(&rotor, &w, &dw),
        &Vector3::new(0.0, -36.0, 0.0),
        1e-14,
    );
    close(
        &printed(&rotor, &w, &dw),
        &Vector3::new(0.0, -20.0, 0.0),
        1e-14,
    );
}

#[test]
fn the_flip_and_its_absence() {
    let expected = statement("F11 torque-free (Dzhanibekov), J=(1,2,3), w0=(.01,1,.01)");
    let j = InertiaTensor::principal(1.0, 2.0, 3.0).unwrap();
    let start = Vector3::new(0.01, 1.0, 0.01);
    let free = |w: &Vector3<f64>| free_acceleration(&j, w);
    // At steps of about 2 ms the method errs by less than 1e-11.
    let [period, crossing] = ["period", "first w2=0 at t"].map(|name| number(&expected[name]));
    let there = rates(free, start, crossing, 6000);
    close(&there, &vector(&expected["w there"]), 1e-10);
    let half = rates(free, start, period / 2.0, 10_000);
    close(&half, &Vector3::new(-0.01, -1.0, 0.01), 1e-10); // cn and sn have changed sign, dn has not
    close(&rates(free, start, period, 20_000), &start, 1e-10);
    // The printed equation keeps ω for ever.
    assert_eq!(
        rates(
            |w| printed_acceleration(&j, w, &Vector3::zeros()),
            start,
            period,
            100
        ),
        start
    );
}

/// A body on a fixed point, in principal axes, under the torque k Γ × e₃ with Γ the vertical; free for k = 0.
struct Top {
    inertia: InertiaTensor,
    torque: f64,
    literal: bool,
}

impl RigidBody for Top {
    type Scalar = f64;
    type State = Rotation;
    type Input = ();

    fn acceleration(&self, _: f64, state: &Rotation, (): &()) -> Vector3<f64> {
        let vertical = state.attitude.inverse() * Vector3::z();
        let moment = vertical.cross(&Vector3::z()) * self.torque;
        let w = &state.angular_velocity;
        if self.literal {
            printed_acceleration(&self.inertia, w, &moment)
        } else {
            self.inertia.inverse().unwrap() * (moment - w.cross(&(self.inertia.matrix() * w)))
        }
    }
}

#[test]
fn regular_precession_and_the_cone_printed_instead() {
    let expected = statement("F12 regular precession");
    let [i1, i3, momentum, tilt] = ["I1", "I3", "M", "theta"].map(|name| number(&expected[name]));
    // (33.4), (33.5): products and quotients of doubles.
    let [spin, precession] = [momentum * tilt.cos() / i3, momentum / i1];
    assert!((spin - number(&expected["Omega3 (33.4)"])).abs() < 1e-14);
    assert!((precession - number(&expected["Omega_pr (33.5)"])).abs() < 1e-14);
    let inertia = InertiaTensor::principal(i1, i1, i3).unwrap();
    let transverse = number(&expected["Omega1=(M/I1) sin th"]);
    let start = Rotation {
        attitude: UnitQuaternion::from_axis_angle(&Vector3::x_axis(), tilt),
        angular_velocity: Vector3::new(0.0, transverse, spin),
    };
    let free = |literal| Top {
        inertia,
        torque: 0.0,
        literal,
    };
    // M lies along the vertical.
    close(
        &(start.attitude * inertia.times(&start.angular_velocity)),
        &Vector3::new(0.0, 0.0, momentum),
        1e-15,
    );
    let end = integrate::cf4(&free(false), &start, &(), 0.0..0.2, 4000);
    // h = 50 µs at rates of 37 rad/s: (1.9e-3)⁴ · 7 rad · about 1/100
    close(
        &(end.attitude * Vector3::z()),
        &vector(&expected["axis(t=0.2) closed"]),
        1e-11,
    );
    let closed = "q(0.2) closed = qz(Wpr t) qx(th) qz(psi t)";
    assert!(distance(&end.attitude, &attitude(&expected[closed])) < 1e-11);

    // As printed, the axis cones about ω, which stays where it was, at the rate |ω|.
    let w = start.attitude * start.angular_velocity;
    let note = "printed (1.9) predicts precession rate in the world of the axis about L";
    let words: Vec<f64> = expected[note]
        .as_str()
        .unwrap()
        .split_whitespace()
        .filter_map(|word| word.trim_end_matches(',').parse().ok())
        .collect();
    assert_eq!(words.len(), 2);
    assert!((w.angle(&(start.attitude * Vector3::z())) - words[0]).abs() < 1e-15);
    assert!((w.norm() - words[1]).abs() < 1e-14);
    let end = integrate::cf4(&free(true), &start, &(), 0.0..0.2, 10);
    let coned = UnitQuaternion::from_scaled_axis(w * 0.2) * start.attitude;
    assert!(distance(&end.attitude, &coned) < 1e-14); // steady rotation is exact
}

/// A heavy top printed is a heavy spherical top: ω̇ = K/J₁ since K has no component along the axis.
#[test]
fn printed_top_precesses_as_a_spherical_one() {
    let [i1, i3, torque, spin, tilt]: [f64; 5] = [1.0, 0.5, 5.0, 40.0, 1.0];
    let top = |i3, literal| Top {
        inertia: InertiaTensor::principal(i1, i1, i3).unwrap(),
        torque,
        literal,
    };
    let start = Rotation {
        attitude: UnitQuaternion::from_axis_angle(&Vector3::x_axis(), tilt),
        angular_velocity: Vector3::new(0.0, 0.0, spin),
    };
    let end = |top: &Top| integrate::cf4(top, &start, &(), 0.0..3.0, 6000);
    let [truth, literal, spherical] =
        [top(i3, false), top(i3, true), top(i1, false)].map(|t| end(&t));
    assert!(distance(&literal.attitude, &spherical.attitude) < 1e-12); // the same equations
    // The mean rate of a fast top is k/(J₃ ω₃) in the limit; here within nutation, k J₁/(J₃ ω₃)² = 1.3 %, twice.
    let azimuth = |state: &Rotation| {
        let axis = state.attitude * Vector3::z();
        axis.y.atan2(axis.x) + PI / 2.0
    };
    assert!((azimuth(&truth) / (torque / (i3 * spin) * 3.0) - 1.0).abs() < 0.03);
    assert!((azimuth(&literal) / (torque / (i1 * spin) * 3.0) - 1.0).abs() < 0.03);
}
