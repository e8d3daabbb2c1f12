//! The coordinates, rates and displacements of a system: those of its joints, with all positions
//! before all velocities.

use newton_euler::columns::{Columns, Sink, Source};
use newton_euler::prelude::*;
use newton_euler::state::Coordinates;

use crate::assembled;
use crate::systems::{
    Assembly, AssemblyAcceleration, AssemblyState, Chain, ChainState, DoublePendulumAcceleration,
    DoublePendulumState,
};

type Joints = AssemblyState<f64>;

newton_euler::private::system_state! {
    TwoTopsState
    TwoTopsAcceleration {
        hinge: Hinge => f64,
        top: Rotation => nalgebra::Vector3<f64>,
        slide: Slide => f64,
    }
}

#[test]
fn order() {
    let state = DoublePendulumState {
        shoulder: Hinge {
            angle: 1.0,
            angular_velocity: 2.0,
        },
        elbow: Hinge {
            angle: 3.0,
            angular_velocity: 4.0,
        },
    };
    let falling = DoublePendulumAcceleration {
        shoulder: 5.0,
        elbow: 6.0,
    };
    assert_eq!(state.coordinates().0, [1.0, 3.0, 2.0, 4.0]);
    assert_eq!(state.rates(&falling).0, [2.0, 4.0, 5.0, 6.0]);
    assert_eq!(state.rate(&falling).0, [2.0, 4.0, 5.0, 6.0]);
    let moved = state.moved(&(state.rate(&falling) * 0.5));
    assert_eq!(moved.coordinates().0, [2.0, 5.0, 4.5, 7.0]);
    assert_eq!(DoublePendulumState::<f64>::GROUPS, [1; 4]);
}

/// The groups of all joints, and the axes of the joint that alone has some.
#[test]
fn groups_and_axes() {
    assert_eq!(
        Joints::GROUPS,
        [
            3, 4, 1, 4, 1, 1, 1, 1, 1, 2, 1, 3, 2, 3, 3, // positions
            3, 3, 1, 3, 1, 1, 1, 1, 1, 2, 1, 3, 2, 3, 3,
        ]
    );
    assert_eq!(
        Joints::GROUPS.iter().sum::<usize>(),
        assembled().coordinates().0.len()
    );
    assert_eq!(Joints::AXES, None, "two joints have axes");
    assert_eq!(ChainState::AXES, None);
    assert_eq!(TwoTopsState::AXES, Some([1, 7]));
    let mut list = TwoTopsState::default().coordinates();
    list.0[1..5].copy_from_slice(&[0.5, 0.5, 0.5, -0.5]);
    list.0[7..10].copy_from_slice(&[1.0, 2.0, 3.0]);
    let state = TwoTopsState::from_coordinates(&list);
    assert_eq!(
        state.top.attitude.as_ref().coords.as_slice(),
        [0.5, 0.5, 0.5, -0.5]
    );
    assert_eq!(state.top.angular_velocity.as_slice(), [1.0, 2.0, 3.0]);
    assert_eq!(
        (state.hinge, state.slide),
        (Hinge::default(), Slide::default())
    );
}

/// What a system does is what each of its joints does for itself, to the bit.
macro_rules! joint_by_joint {
    ($($joint:ident: $kind:ident)*) => {
        #[test]
        fn joint_by_joint() {
            let (body, state) = (Assembly { spin: 0.3 }, assembled());
            let acceleration = body.acceleration(0.7, &state, &());
            let displacement = state.rate(&acceleration) * 0.3;
            let moved = state.moved(&displacement);
            $({
                let rate = state.$joint.rate(&acceleration.$joint);
                assert_eq!(moved.$joint, state.$joint.moved(&(rate * 0.3)));
            })*

            let (list, rates) = (state.coordinates(), state.rates(&acceleration));
            assert_eq!(Joints::from_coordinates(&list), state);
            let mut change = rates * 0.01;
            Joints::keep(&list, &mut change);
            let kept = Joints::from_coordinates(&(list + change));
            $({
                let list = state.$joint.coordinates();
                let mut change = state.$joint.rates(&acceleration.$joint);
                change.as_mut().iter_mut().for_each(|part| *part *= 0.01);
                $kind::keep(&list, &mut change);
                let mut there = list;
                there.as_mut().iter_mut().zip(change).for_each(|(there, part)| *there += part);
                assert_eq!(kept.$joint, $kind::from_coordinates(&there));
            })*
            assert!((kept.ball.attitude.as_ref().norm() - 1.0).abs() < 1e-7);
        }
    };
}

joint_by_joint! {
    orbit: Spatial
    wheel: Hinge
    ball: Rotation
    slide: Slide
    piston: Cylinder
    gimbal: Universal
    raft: Planar
    load: Translation
    tray: PlanarTranslation
    needle: Rod
}

/// Numbers one after another.
#[derive(Default)]
struct Row(std::collections::VecDeque<f64>);

impl Source<f64> for Row {
    fn take(&mut self) -> f64 {
        self.0.pop_front().expect("a number is left")
    }
}

impl Sink<f64> for Row {
    fn put(&mut self, scalar: f64) {
        self.0.push_back(scalar);
    }
}

fn there_and_back<C: Columns<f64> + PartialEq>(value: &C) {
    let mut row = Row::default();
    value.write(&mut row);
    assert_eq!(row.0.len(), C::COUNT);
    assert_eq!(C::read(&mut row), *value);
    assert!(row.0.is_empty());
}

#[test]
fn columns() {
    let state = assembled();
    there_and_back(&state);
    there_and_back(&Assembly { spin: 0.3 }.acceleration(0.7, &state, &()));
    there_and_back(&Chain.flow(&ChainState::default(), 1.0));
    assert_eq!(<Joints as Columns<f64>>::COUNT, 60);
    // a rod has one number less in its acceleration than in its rates
    assert_eq!(<AssemblyAcceleration<f64> as Columns<f64>>::COUNT, 29);
}
