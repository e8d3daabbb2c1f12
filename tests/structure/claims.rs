//! Each claim, compared with the accelerations at random states; and for each claim that is not
//! made, a state in which it fails.

use nalgebra::{UnitQuaternion, UnitVector3, Vector3};
use newton_euler::structure::{Dependence, Structure, Structured, Symmetry};

use crate::coordinates::{Coordinates, Kind, Moving, Random};

/// States for each claim.
const STATES: usize = 40;

/// A body, how its inputs are chosen, and the moment that goes with an angular acceleration.
pub struct Claims<B: Structured> {
    pub body: B,
    pub input: fn(&mut Random) -> B::Input,
    pub moment: fn(&Coordinates, Vector3<f64>) -> Vector3<f64>,
}

/// A point at which accelerations are evaluated.
#[derive(Clone, Copy)]
struct At<I> {
    time: f64,
    coordinates: Coordinates,
    input: I,
}

impl<B: Structured<Scalar = f64>> Claims<B>
where
    B::State: Moving,
    B::Input: Copy,
{
    /// The structure is this one, and it is the truth.
    pub fn are(&self, expected: Structure) {
        assert_eq!(B::STRUCTURE, expected);
        for (index, claimed) in [expected.linear, expected.angular].into_iter().enumerate() {
            self.check_reads(index, &claimed);
            let kind = <B::State as Moving>::KIND;
            self.check_symmetry(
                claimed.world,
                kind != Kind::Hinge,
                |at, turn| {
                    let turns = index == 0 || kind == Kind::Rod;
                    (turned_in_world(at, turn), turns)
                },
                index,
            );
            let has_axes = kind != Kind::Hinge && kind != Kind::Rod;
            self.check_symmetry(
                claimed.body,
                has_axes,
                |at, turn| (turned_in_body(at, turn), index == 1),
                index,
            );
        }
        let is_small = |vector: Vector3<f64>| vector.amax() < 1e-13;
        assert_eq!(
            self.always(|at, _| is_small(self.accelerations(at)[0])),
            expected.is_force_free
        );
        let moment = |at: &At<B::Input>| (self.moment)(&at.coordinates, self.accelerations(at)[1]);
        assert_eq!(
            self.always(|at, _| is_small(moment(at))),
            expected.is_torque_free
        );
        let spin = |at: &At<B::Input>| match expected.angular.body {
            Symmetry::None => Vector3::repeat(1.0),
            Symmetry::About(axis) => {
                Vector3::x() * self.accelerations(at)[1].dot(&Vector3::from(axis))
            }
            Symmetry::Every => self.accelerations(at)[1],
        };
        assert_eq!(self.always(|at, _| is_small(spin(at))), expected.keeps_spin);
        self.check_planes(expected.planes);
    }

    fn accelerations(&self, at: &At<B::Input>) -> [Vector3<f64>; 2] {
        let state = B::State::at(&at.coordinates);
        let acceleration = self.body.acceleration(at.time, &state, &at.input);
        B::State::accelerations(&acceleration)
    }

    /// Whether something holds at all points that are tried, each with another one.
    fn always(&self, holds: impl Fn(&At<B::Input>, &At<B::Input>) -> bool) -> bool {
        let mut random = Random(1);
        let mut point = || At {
            time: random.number(),
            coordinates: random.coordinates(),
            input: (self.input)(&mut random),
        };
        (0..STATES).all(|_| holds(&point(), &point()))
    }

    /// To the bit.
    fn check_reads(&self, index: usize, claimed: &Dependence) {
        type Exchange<I> = fn(&mut At<I>, &At<I>);
        let exchanges: [(bool, Exchange<B::Input>); 6] = [
            (claimed.time, |at, other| at.time = other.time),
            (claimed.position, |at, other| {
                at.coordinates.position = other.coordinates.position;
            }),
            (claimed.velocity, |at, other| {
                at.coordinates.velocity = other.coordinates.velocity;
            }),
            (claimed.attitude, |at, other| {
                at.coordinates.attitude = other.coordinates.attitude;
                at.coordinates.angle = other.coordinates.angle;
            }),
            (claimed.angular_velocity, |at, other| {
                at.coordinates.angular_velocity = other.coordinates.angular_velocity;
            }),
            (claimed.input, |at, other| at.input = other.input),
        ];
        for (is_read, exchange) in exchanges {
            let makes_no_difference = self.always(|at, other| {
                let mut exchanged = *at;
                exchange(&mut exchanged, other);
                self.accelerations(at)[index] == self.accelerations(&exchanged)[index]
            });
            assert_eq!(makes_no_difference, !is_read);
        }
    }

    /// `turned` gives the turned point, and whether the acceleration turns with it.
    fn check_symmetry(
        &self,
        claimed: Symmetry,
        has_axes: bool,
        turned: impl Fn(&At<B::Input>, &UnitQuaternion<f64>) -> (At<B::Input>, bool),
        index: usize,
    ) {
        let holds = |direction: Vector3<f64>| {
            let axis = UnitVector3::new_normalize(direction);
            self.always(|at, other| {
                let turn = UnitQuaternion::from_axis_angle(&axis, other.coordinates.angle);
                let (point, turns) = turned(at, &turn);
                let (before, after) = (
                    self.accelerations(at)[index],
                    self.accelerations(&point)[index],
                );
                let expected = if turns { turn * before } else { before };
                (after - expected).amax() < 1e-11 * (1.0 + before.norm())
            })
        };
        if !has_axes {
            assert_eq!(claimed, Symmetry::None);
            return;
        }
        let in_plane = <B::State as Moving>::KIND == Kind::Plane;
        let any = if in_plane {
            Vector3::z()
        } else {
            Vector3::new(0.3, -0.5, 0.7)
        };
        match claimed {
            Symmetry::Every => assert!(holds(any)),
            Symmetry::None => assert!(!holds(any)),
            Symmetry::About(axis) => assert!(holds(axis.into()) && (in_plane || !holds(any))),
        }
    }

    fn check_planes(&self, claimed: [bool; 3]) {
        let kind = <B::State as Moving>::KIND;
        for (axis, is_claimed) in claimed.into_iter().enumerate() {
            if matches!(kind, Kind::Plane | Kind::Hinge) {
                assert!(!is_claimed);
                continue;
            }
            let stays = self.always(|at, _| {
                let coordinates = in_plane(&at.coordinates, axis, kind == Kind::Rod);
                let [linear, angular] = self.accelerations(&At { coordinates, ..*at });
                let is_out = |i: usize| (i == axis) == (kind == Kind::Rod);
                linear[axis].abs() < 1e-13 && (0..3).all(|i| !is_out(i) || angular[i].abs() < 1e-13)
            });
            assert_eq!(stays, is_claimed);
        }
    }
}

fn turned_in_world<I: Copy>(at: &At<I>, turn: &UnitQuaternion<f64>) -> At<I> {
    let c = at.coordinates;
    let coordinates = Coordinates {
        position: turn * c.position,
        velocity: turn * c.velocity,
        attitude: turn * c.attitude,
        angle: c.angle + turn.scaled_axis().z,
        ..c
    };
    At { coordinates, ..*at }
}

fn turned_in_body<I: Copy>(at: &At<I>, turn: &UnitQuaternion<f64>) -> At<I> {
    let c = at.coordinates;
    let coordinates = Coordinates {
        attitude: c.attitude * turn.inverse(),
        angle: c.angle - turn.scaled_axis().z,
        angular_velocity: turn * c.angular_velocity,
        ..c
    };
    At { coordinates, ..*at }
}

/// Coordinates of a motion in the plane across an axis; a rod lies in it.
fn in_plane(c: &Coordinates, axis: usize, is_rod: bool) -> Coordinates {
    let across = UnitVector3::new_unchecked(Vector3::ith(axis, 1.0));
    let mut attitude = UnitQuaternion::from_axis_angle(&across, c.angle);
    if is_rod && axis == 0 {
        attitude *=
            UnitQuaternion::from_axis_angle(&Vector3::z_axis(), core::f64::consts::FRAC_PI_2);
    }
    let flat = |vector: Vector3<f64>| vector - across.into_inner() * vector[axis];
    Coordinates {
        position: flat(c.position),
        velocity: flat(c.velocity),
        attitude,
        angular_velocity: attitude.inverse() * across.into_inner() * c.angular_velocity[axis],
        ..*c
    }
}
