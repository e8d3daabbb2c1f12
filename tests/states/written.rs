//! States when serialized, and as columns.

use newton_euler::columns::Columns;
use newton_euler::prelude::*;
use newton_euler::state::Coordinates;
use serde_json::{from_str, from_value, json, to_string, to_value};

use crate::bodies::{
    ArmsState, DroneState, FilterState, RocketAcceleration, RocketState, ServoState,
};

#[test]
fn there_and_back() {
    let state = ServoState {
        motion: Hinge {
            angle: 0.1,
            angular_velocity: -0.7,
        },
        integral: 1.0 / 3.0,
        torque: 2.0,
    };
    let text = to_string(&state).unwrap();
    assert_eq!(from_str::<ServoState<f64>>(&text).unwrap(), state);
    assert_eq!(
        to_value(state).unwrap(),
        json!({
            "motion": { "angle": 0.1, "angular_velocity": -0.7 },
            "integral": 1.0 / 3.0,
            "torque": 2.0,
        })
    );
    let lacks = r#"{ "motion": { "angle": 0.0, "angular_velocity": 0.0 }, "integral": 0.0 }"#;
    let error = from_str::<ServoState<f64>>(lacks).unwrap_err().to_string();
    assert!(error.contains("missing field `torque`"), "{error}");
    // as the states of motions are
    let mut endless = to_value(state).unwrap();
    endless["torque"] = json!(1e39);
    let error = from_value::<ServoState<f32>>(endless)
        .unwrap_err()
        .to_string();
    assert!(error.starts_with("a state is finite"), "{error}");
    let text = to_string(&ArmsState::<f64>::default()).unwrap();
    assert_eq!(
        from_str::<ArmsState<f64>>(&text).unwrap(),
        ArmsState::default()
    );
}

/// Rates and states of one's own are last, and each is a group by itself.
#[test]
fn coordinates() {
    assert_eq!(DroneState::<f64>::GROUPS, [3, 4, 0, 0, 3, 3, 1, 1]);
    assert_eq!(FilterState::<f64>::GROUPS, [0, 0, 1, 1]);
    assert_eq!(<DroneState<f64> as Columns<f64>>::COUNT, 15);
    let state = RocketState {
        motion: Translation {
            position: [1.0, 2.0, 3.0].into(),
            velocity: [4.0, 5.0, 6.0].into(),
        },
        thrust: 7.0,
        fuel: 8.0,
    };
    let list = state.coordinates();
    assert_eq!(list.as_ref(), [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]);
    assert_eq!(RocketState::from_coordinates(&list), state);
    let rate = state.rate(&RocketAcceleration {
        motion: [0.1, 0.2, 0.3].into(),
        thrust: -1.0,
        fuel: -2.0,
    });
    assert_eq!(rate.as_ref(), [4.0, 5.0, 6.0, 0.1, 0.2, 0.3, -1.0, -2.0]);
    let later = state.moved(&(rate * 2.0));
    assert_eq!((later.thrust, later.fuel), (5.0, 4.0));
    assert_eq!(later.motion.position.x, 9.0);
}
