//! Serialized systems: structs with named fields, each of which is checked as a state is.

use serde::{Deserialize, Serialize, de::DeserializeOwned};
use serde_json::{Value, from_value, json, to_value};

use newton_euler::prelude::*;

use crate::systems::{
    Assembly, AssemblyState, DoublePendulum, DoublePendulumAcceleration, DoublePendulumInput,
    DoublePendulumState,
};
use crate::{assembled, lifted};

newton_euler::private::system_state! {
    OddState
    OddAcceleration {
        r#type: Hinge => f64,
        r#while: Slide => f64,
    }
}

fn round_trip<T: Serialize + DeserializeOwned + std::fmt::Debug>(value: &T) {
    let text = serde_json::to_string(value).unwrap();
    let back: T = serde_json::from_str(&text).unwrap();
    assert_eq!(format!("{back:?}"), format!("{value:?}"), "through {text}");
}

#[test]
fn there_and_back() {
    round_trip(&lifted());
    round_trip(&DoublePendulumState::<f32>::default());
    round_trip(&DoublePendulum::default().acceleration(
        0.0,
        &lifted(),
        &DoublePendulumInput::default(),
    ));
    round_trip(&assembled());
    round_trip(&Assembly { spin: 0.3 }.acceleration(0.7, &assembled(), &()));
    round_trip(&OddState::default());
}

#[test]
fn named_fields() {
    let hinge = |angle: f64, rate: f64| json!({ "angle": angle, "angular_velocity": rate });
    assert_eq!(
        to_value(lifted()).unwrap(),
        json!({ "shoulder": hinge(1.4, 0.0), "elbow": hinge(-0.6, 2.5) })
    );
    let falling = DoublePendulumAcceleration {
        shoulder: 1.0,
        elbow: -2.0,
    };
    assert_eq!(
        to_value(falling).unwrap(),
        json!({ "shoulder": 1.0, "elbow": -2.0 })
    );
    let odd = to_value(OddState::default()).unwrap();
    assert_eq!(odd["type"], hinge(0.0, 0.0));
    assert_eq!(odd["while"], json!({ "position": 0.0, "velocity": 0.0 }));
    // in any order, beside what is none of them, and as a sequence
    let read = |value: Value| from_value::<DoublePendulumState<f64>>(value).unwrap();
    let [shoulder, elbow] = [hinge(1.4, 0.0), hinge(-0.6, 2.5)];
    assert_eq!(
        read(json!({ "elbow": elbow, "wrist": [1], "shoulder": shoulder })),
        lifted()
    );
    assert_eq!(read(json!([shoulder, elbow])), lifted());
}

fn refusal<T: DeserializeOwned + std::fmt::Debug>(text: &str) -> String {
    serde_json::from_str::<T>(text).unwrap_err().to_string()
}

#[test]
fn what_is_refused() {
    let hinge = r#"{"angle":1.0,"angular_velocity":2.0}"#;
    let pendulum = |text: String| refusal::<DoublePendulumState<f64>>(&text);
    let missing = pendulum(format!(r#"{{"shoulder":{hinge}}}"#));
    assert!(missing.starts_with("missing field `elbow`"), "{missing}");
    let twice = pendulum(format!(
        r#"{{"shoulder":{hinge},"shoulder":{hinge},"elbow":{hinge}}}"#
    ));
    assert!(twice.starts_with("duplicate field `shoulder`"), "{twice}");
    let short = pendulum(format!("[{hinge}]"));
    assert!(
        short.starts_with("invalid length 1, expected struct DoublePendulumState"),
        "{short}"
    );
    let other = pendulum("1.5".to_string());
    assert!(
        other.contains("expected struct DoublePendulumState"),
        "{other}"
    );
    let partial = pendulum(format!(r#"{{"shoulder":{{"angle":1.0}},"elbow":{hinge}}}"#));
    assert!(
        partial.starts_with("missing field `angular_velocity`"),
        "{partial}"
    );
    let odd = refusal::<OddState>(&format!(r#"{{"type":{hinge}}}"#));
    assert!(odd.starts_with("missing field `while`"), "{odd}");

    let mut bent = to_value(assembled()).unwrap();
    bent["ball"]["attitude"]["w"] = json!(1.5);
    let message = refusal::<AssemblyState<f64>>(&bent.to_string());
    assert!(
        message.starts_with("attitude must be a unit quaternion: "),
        "{message}"
    );
    let mut long = to_value(assembled()).unwrap();
    long["needle"]["axis"] = json!([1.0, 1.0, 0.0]);
    let message = refusal::<AssemblyState<f64>>(&long.to_string());
    assert!(
        message.starts_with("axis must be a unit vector: "),
        "{message}"
    );
}

/// Formats of bytes can say what is not finite, and name fields by their places.
#[test]
fn what_is_not_finite() {
    use serde::de::value::{Error, MapDeserializer};
    let number =
        |fields: [(&'static str, f64); 2]| MapDeserializer::<_, Error>::new(fields.into_iter());
    let slide = |position| Slide::deserialize(number([("position", position), ("velocity", 1.0)]));
    assert_eq!(
        slide(2.0).unwrap(),
        Slide {
            position: 2.0,
            velocity: 1.0
        }
    );
    assert!(slide(f64::NAN).is_err() && slide(f64::INFINITY).is_err());

    // an acceleration is whatever it was
    let falling = DoublePendulumAcceleration::<f64>::deserialize(MapDeserializer::<_, Error>::new(
        [(1_u64, 2.5), (0, f64::INFINITY), (7, 1.0)].into_iter(),
    ));
    assert_eq!(
        falling.unwrap(),
        DoublePendulumAcceleration {
            shoulder: f64::INFINITY,
            elbow: 2.5
        }
    );
}
