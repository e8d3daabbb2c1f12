//! `outputs: [flow]`: every motion that has a closed form, compared with an integrator in small
//! steps, and with itself.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

mod counters;
mod oblique_tops;
mod scenes;

use newton_euler::integrate;
use newton_euler::nalgebra::{UnitQuaternion, Vector3};
use newton_euler::prelude::*;
use scenes::*;

/// What two states of a kind differ by.
trait Apart {
    fn apart(&self, other: &Self) -> f64;
}

fn between(a: &UnitQuaternion<f64>, b: &UnitQuaternion<f64>) -> f64 {
    (a.coords - b.coords).amax() // with its sign: that is continuous
}

impl Apart for Spatial {
    fn apart(&self, other: &Self) -> f64 {
        let parts = [
            (self.position - other.position).amax(),
            (self.velocity - other.velocity).amax(),
            between(&self.attitude, &other.attitude),
            (self.angular_velocity - other.angular_velocity).amax(),
        ];
        parts.into_iter().fold(0.0, f64::max)
    }
}

impl Apart for Rotation {
    fn apart(&self, other: &Self) -> f64 {
        let rates = (self.angular_velocity - other.angular_velocity).amax();
        between(&self.attitude, &other.attitude).max(rates)
    }
}

impl Apart for Planar {
    fn apart(&self, other: &Self) -> f64 {
        let parts = [
            (self.position - other.position).amax(),
            (self.velocity - other.velocity).amax(),
            (self.angle - other.angle).abs(),
            (self.angular_velocity - other.angular_velocity).abs(),
        ];
        parts.into_iter().fold(0.0, f64::max)
    }
}

impl Apart for Hinge {
    fn apart(&self, other: &Self) -> f64 {
        let rates = (self.angular_velocity - other.angular_velocity).abs();
        (self.angle - other.angle).abs().max(rates)
    }
}

impl Apart for Rod {
    fn apart(&self, other: &Self) -> f64 {
        let parts = [
            (self.position - other.position).amax(),
            (self.velocity - other.velocity).amax(),
            (self.axis.into_inner() - other.axis.into_inner()).amax(),
            (self.axis_rate - other.axis_rate).amax(),
        ];
        parts.into_iter().fold(0.0, f64::max)
    }
}

impl Apart for Translation {
    fn apart(&self, other: &Self) -> f64 {
        let velocity = (self.velocity - other.velocity).amax();
        (self.position - other.position).amax().max(velocity)
    }
}

impl Apart for PlanarTranslation {
    fn apart(&self, other: &Self) -> f64 {
        let velocity = (self.velocity - other.velocity).amax();
        (self.position - other.position).amax().max(velocity)
    }
}

/// Against the equations of motion that were derived from the same description, forwards and backwards; whole against two
/// halves; and no time at all.
fn check<B: Flow<Scalar = f64>>(body: &B, start: &B::State)
where
    B::State: Apart + State<Scalar = f64>,
{
    let input = B::Input::default();
    let path = body.path(start);
    for time in [2.0, -1.5] {
        let stepped = integrate::cf4(body, start, &input, 0.0..time, 4000);
        let apart = path.at(time).apart(&stepped);
        assert!(apart < 2e-11, "{apart:e} from the steps");
        let between = body.flow(start, 0.3 * time);
        let apart = body.flow(&between, 0.7 * time).apart(&path.at(time));
        assert!(apart < 1e-13, "{apart:e} in two parts");
    }
    let apart = path.at(0.0).apart(start);
    assert!(apart < 2e-15, "{apart:e} at once");
}

fn attitude() -> UnitQuaternion<f64> {
    UnitQuaternion::from_euler_angles(0.4, -0.7, 1.2)
}

fn thrown(rates: [f64; 3]) -> Spatial {
    Spatial {
        position: Vector3::new(1.0, -2.0, 0.5),
        attitude: attitude(),
        velocity: Vector3::new(0.3, 4.0, -1.0),
        angular_velocity: rates.into(),
    }
}

fn spun(rates: [f64; 3]) -> Rotation {
    Rotation {
        attitude: attitude(),
        angular_velocity: rates.into(),
    }
}

const RATES: [[f64; 3]; 5] = [
    [1.0, -1.6, 0.7],
    [0.01, 2.0, -0.02],
    [0.0, 0.0, 1.5],
    [-1.2, 0.0, 0.0],
    [0.0; 3],
];

#[test]
fn bodies_in_space() {
    for rates in RATES {
        let start = thrown(rates);
        check(&Brick::default(), &start);
        check(&Drum::default(), &start);
        check(&Ball::default(), &start);
        check(&Probe::<f64>::default(), &start);
        check(&Tilted::default(), &start);
        check(&Loaded::default(), &start);
    }
}

#[test]
fn bodies_that_turn() {
    for rates in RATES {
        check(&Handle::default(), &spun(rates));
        check(&Balanced::default(), &spun(rates));
        check(&Slanted::default(), &spun(rates));
    }
}

#[test]
fn tops() {
    for rates in RATES {
        check(&Top::default(), &spun(rates));
        check(&Gyroscope::default(), &spun(rates));
        check(&Magnet::default(), &spun(rates));
        check(&Weighted::default(), &thrown(rates));
    }
}

#[test]
fn bodies_that_spin_up() {
    for rates in RATES {
        check(&Stage::default(), &thrown(rates));
        check(&Pinwheel::<f64>::default(), &spun(rates));
        check(&Drill::default(), &spun(rates));
        check(&Sphere::default(), &thrown(rates));
        check(&Globe::default(), &spun(rates));
    }
}

/// Series are another solution of the same equations: here the spin reverses on the way.
#[test]
fn a_body_that_spins_up_by_series() {
    let start = thrown([1.0, -1.6, -4.0]);
    let end = Stage::default().flow(&start, 5.0);
    let series = integrate::taylor(&Stage::default(), &start, &(), 0.0..5.0, 1e-15).unwrap();
    assert!(end.apart(&series) < 1e-12, "{:e}", end.apart(&series));
    let start = spun([1.0, 4.0, -1.6]);
    let end = Pinwheel::<f64>::default().flow(&start, -9.0);
    let series =
        integrate::taylor(&Pinwheel::<f64>::default(), &start, &(), 0.0..-9.0, 1e-15).unwrap();
    assert!(end.apart(&series) < 1e-12, "{:e}", end.apart(&series));
}

/// It turns faster and faster: by `t²` in a minute, with an axis level at every half turn.
#[test]
fn events_of_a_body_that_spins_up() {
    let start = Spatial::default();
    let level = |_: f64, state: &Spatial| (state.attitude * Vector3::x()).x;
    let mut events = 0;
    for event in Stage::default().integrate(&start).events(60.0, level) {
        let turned = event.unwrap().time.powi(2) / std::f64::consts::PI - 0.5;
        assert!((turned - f64::from(events)).abs() < 1e-10, "{events}");
        events += 1;
    }
    assert_eq!(events, 1146); // 3600 rad
}

/// Parameters that are the constants, about another axis: the same motion.
#[test]
fn a_top_of_parameters() {
    let start = spun([1.0, -1.6, 30.0]);
    let turn = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), std::f64::consts::FRAC_PI_2);
    let other = Rotation {
        attitude: start.attitude * turn.inverse(),
        angular_velocity: turn * start.angular_velocity,
    };
    for time in [-3.0, 0.1, 8.0] {
        let expected = Top::default().flow(&start, time);
        let end = Gyroscope::default().flow(&other, time);
        assert!(between(&(end.attitude * turn), &expected.attitude) < 1e-12);
    }
}

#[test]
fn bodies_in_the_plane() {
    let start = Planar {
        position: [1.0, 2.0].into(),
        angle: 7.0,
        velocity: [-0.5, 3.0].into(),
        angular_velocity: -1.3,
    };
    check(&Plank::default(), &start);
    check(&Wheel::default(), &start);
    check(&Towed::default(), &start);
    let start = PlanarTranslation {
        position: [1.0, 2.0].into(),
        velocity: [-0.5, 3.0].into(),
    };
    check(&Puck::default(), &start);
}

#[test]
fn bodies_that_do_not_turn() {
    let start = Translation {
        position: [1.0, 2.0, 3.0].into(),
        velocity: [-0.5, 3.0, 0.1].into(),
    };
    check(&Parcel::default(), &start);
}

#[test]
fn bodies_about_an_axis() {
    for (angle, angular_velocity) in [(0.4, 0.0), (-2.9, 0.3), (8.0, -7.0), (0.0, 0.0)] {
        let start = Hinge {
            angle,
            angular_velocity,
        };
        check(&Swing::default(), &start);
        check(&Door::default(), &start);
        check(&Winch::default(), &start);
    }
}

#[test]
fn rods() {
    let start = Rod {
        position: [1.0, 2.0, 3.0].into(),
        velocity: [-0.5, 3.0, 0.1].into(),
        axis_rate: [0.0, 1.2, -0.7].into(),
        ..Rod::default()
    };
    check(&Baton::default(), &start);
    check(
        &Baton::default(),
        &Rod {
            axis_rate: Vector3::zeros(),
            ..start
        },
    );
}

/// A constant tensor is brought to its principal axes at expansion, one of parameters when the body is built.
#[test]
fn constants_and_parameters_agree() {
    let start = thrown([1.0, -1.6, 0.7]);
    let (constant, open) = (Tilted::default(), Loaded::default());
    let (skewed, turning) = (Skewed::<f64>::default(), spun([1.0, -1.6, 0.7]));
    for time in [-40.0, 0.1, 40.0] {
        assert!(constant.flow(&start, time).apart(&open.flow(&start, time)) < 2e-13);
        let attitude = skewed.flow(&turning, time).attitude;
        assert!(between(&attitude, &constant.flow(&start, time).attitude) < 2e-13);
    }
}

/// Components that are zero stay exactly zero.
#[test]
fn zeros_stay() {
    let start = Spatial {
        angular_velocity: Vector3::new(0.0, 1.7, 0.0),
        velocity: Vector3::new(0.0, 1.0, 0.0),
        ..Spatial::default()
    };
    let end = Brick::default().flow(&start, 1e6);
    assert_eq!((end.position.x, end.velocity.x), (0.0, 0.0));
    assert_eq!(end.angular_velocity, start.angular_velocity);
    assert_eq!((end.attitude.i, end.attitude.k), (0.0, 0.0));
}

/// The type of the path says which motion it is.
#[test]
fn the_motion_is_chosen_at_expansion() {
    use newton_euler::exact::{
        AxialTorque, Flight, FreeRotation, GreatCircle, LagrangeTop, Parabola, Pendulum,
    };
    let _: fn(&Brick, &Spatial) -> Flight<FreeRotation, 3> = Flow::path;
    let _: fn(&Handle, &Rotation) -> FreeRotation = Flow::path;
    let _: fn(&Top, &Rotation) -> LagrangeTop = Flow::path;
    let _: fn(&Weighted, &Spatial) -> Flight<LagrangeTop, 3> = Flow::path;
    let _: fn(&Pinwheel<f64>, &Rotation) -> AxialTorque = Flow::path;
    let _: fn(&Stage, &Spatial) -> Flight<AxialTorque, 3> = Flow::path;
    let _: fn(&Plank, &Planar) -> Flight<Parabola<1>, 2> = Flow::path;
    let _: fn(&Towed, &Planar) -> Flight<Pendulum, 2> = Flow::path;
    let _: fn(&Swing, &Hinge) -> Pendulum = Flow::path;
    let _: fn(&Winch, &Hinge) -> Parabola<1> = Flow::path;
    let _: fn(&Baton, &Rod) -> Flight<GreatCircle, 3> = Flow::path;
    let _: fn(&Puck, &PlanarTranslation) -> Parabola<2> = Flow::path;
}
