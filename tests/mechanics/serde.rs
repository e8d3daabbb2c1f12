//! Serialized values are read back bit for bit; impossible values are rejected.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

use nalgebra::{UnitQuaternion, Vector2, Vector3};
use newton_euler::prelude::*;
use proptest::prelude::*;
use serde::{Deserialize, Serialize, de::DeserializeOwned};
use serde_json::{Value, from_value, json};

/// Every bit of every number: `{:?}` tells -0 from 0 and prints as many digits as one double needs. (`serde_json` reads
/// doubles exactly with its feature `float_roundtrip` only.)
fn assert_round_trip<T: Serialize + DeserializeOwned + std::fmt::Debug>(value: &T) {
    let text = serde_json::to_string(value).unwrap();
    let back: T = serde_json::from_str(&text).unwrap();
    assert_eq!(format!("{back:?}"), format!("{value:?}"), "through {text}");
}

/// Of any size and sign, zeros and the smallest included.
fn finite() -> impl Strategy<Value = f64> {
    use prop::num::f64::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO
}

fn planar() -> impl Strategy<Value = Vector2<f64>> {
    prop::array::uniform2(finite()).prop_map(Vector2::from)
}

fn spatial() -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(finite()).prop_map(Vector3::from)
}

fn attitudes() -> impl Strategy<Value = UnitQuaternion<f64>> {
    prop::array::uniform3(-3.0..3.0)
        .prop_map(|v| UnitQuaternion::from_scaled_axis(Vector3::from(v)))
}

proptest! {
    #[test]
    fn in_space(
        [a, b, c, d] in [spatial(), spatial(), spatial(), spatial()],
        attitude in attitudes(),
    ) {
        let [position, velocity, angular_velocity] = [a, b, c];
        assert_round_trip(&Spatial { position, attitude, velocity, angular_velocity });
        assert_round_trip(&Rotation { attitude, angular_velocity });
        assert_round_trip(&Translation { position, velocity });
        assert_round_trip(&SpatialAcceleration { linear: c, angular: d });
        assert_round_trip(&Wrench { force: a, moment: d });
        let axis = attitude * Vector3::x_axis();
        assert_round_trip(&Rod { position, velocity, axis, axis_rate: attitude * Vector3::y() * c.x });
        assert_round_trip(&RodAcceleration { linear: c, axis: d });
    }

    #[test]
    fn in_the_plane([a, b] in [planar(), planar()], [angle, rate] in [finite(), finite()]) {
        let [position, velocity] = [a, b];
        assert_round_trip(&Planar { position, angle, velocity, angular_velocity: rate });
        assert_round_trip(&PlanarTranslation { position, velocity });
        assert_round_trip(&Hinge { angle, angular_velocity: rate });
        assert_round_trip(&PlanarAcceleration { linear: a, angular: angle });
        assert_round_trip(&PlanarWrench { force: b, moment: rate });
    }

    /// Plane bodies too, in any axes: their tensors pass their own check.
    #[test]
    fn inertia([a, b] in [0.0..1.0, 0.0..1.0], lift in prop_oneof![Just(0.0), 0.0..1.0], turn in attitudes(), decade in -100..100) {
        let [a, b, lift] = [a, b, lift].map(|value| value * 10f64.powi(decade));
        let inertia = InertiaTensor::principal(a + lift, b + lift, a + b).unwrap().rotated(&turn);
        assert_round_trip(&inertia);
    }
}

fn refusal<T: DeserializeOwned + std::fmt::Debug>(value: Value) -> String {
    from_value::<T>(value).unwrap_err().to_string()
}

#[test]
fn forms_say_their_conventions() {
    let state = Rotation::default();
    let written = json!({
        "attitude": { "w": 1.0, "x": 0.0, "y": 0.0, "z": 0.0 },
        "angular_velocity": [0.0, 0.0, 0.0],
    });
    assert_eq!(serde_json::to_value(state).unwrap(), written);
    let inertia = InertiaTensor::tensor(1.3, 1.7, 2.1, -0.12, -0.05, 0.07).unwrap();
    let entries = |sign: f64| json!({ "xx": 1.3, "yy": 1.7, "zz": 2.1, "xy": -0.12 * sign, "yz": -0.05 * sign, "zx": 0.07 * sign });
    assert_eq!(
        serde_json::to_value(inertia).unwrap(),
        json!({ "tensor": entries(1.0) })
    );
    assert_eq!(
        from_value::<InertiaTensor>(json!({ "products": entries(-1.0) })).unwrap(),
        inertia
    );
    assert!(from_value::<InertiaTensor>(entries(1.0)).is_err());
    let message = refusal::<InertiaTensor>(json!({ "matrix": entries(1.0) }));
    assert_eq!(
        message,
        "unknown variant `matrix`, expected `tensor` or `products`"
    );
    // what is expected is said in words of the crate
    assert_eq!(
        refusal::<InertiaTensor>(json!({ "tensor": 3.0 })),
        "invalid type: floating point `3.0`, expected the entries `xx`, `yy`, `zz`, `xy`, `yz`, `zx`"
    );
    assert_eq!(
        refusal::<Rotation>(json!({ "attitude": "none", "angular_velocity": [0.0, 0.0, 0.0] })),
        "invalid type: string \"none\", expected an attitude of `w`, `x`, `y`, `z`"
    );
}

#[test]
fn attitudes_that_are_not_unit() {
    let state = |w: f64| json!({ "attitude": { "w": w, "x": 0.0, "y": 0.6, "z": 0.0 }, "angular_velocity": [0.0, 0.0, 0.0] });
    for w in [0.0, 0.9, 0.8 + 1e-9, -0.8 - 1e-9, 1e200] {
        let message = refusal::<Rotation>(state(w));
        assert!(
            message.starts_with("attitude must be a unit quaternion: |q|² is "),
            "{message}"
        );
    }
    // Ten digits printed are enough, and stay what they were.
    let read: Rotation = from_value(state(-0.800_000_000_1)).unwrap();
    assert_eq!(read.attitude.w, -0.800_000_000_1);
    let nothing = json!({ "attitude": { "w": null, "x": 0.0, "y": 0.6, "z": 0.0 }, "angular_velocity": [0.0, 0.0, 0.0] });
    assert!(from_value::<Rotation>(nothing).is_err());
    assert!(from_value::<Spatial>(json!({ "position": [0.0, 0.0, 0.0] })).is_err());
}

#[test]
fn rods_that_cannot_be() {
    let rod = |axis: [f64; 3], rate: [f64; 3]| json!({ "position": [0.0, 0.0, 0.0], "velocity": [0.0, 0.0, 0.0], "axis": axis, "axis_rate": rate });
    let read: Rod = from_value(rod([0.6, 0.0, 0.8], [0.4, 1.5, -0.3])).unwrap();
    assert_eq!(read.axis.z, 0.8);
    assert_eq!(
        serde_json::to_value(read).unwrap(),
        rod([0.6, 0.0, 0.8], [0.4, 1.5, -0.3])
    );
    for z in [0.0, 0.7, 0.8 + 1e-9, 1e200] {
        let message = refusal::<Rod>(rod([0.6, 0.0, z], [0.0; 3]));
        assert!(
            message.starts_with("axis must be a unit vector: |u|² is "),
            "{message}"
        );
    }
    for size in [1e-308, 1.0, 1e308] {
        let message = refusal::<Rod>(rod([0.0, 0.0, 1.0], [0.0, size, 2e-9 * size]));
        assert!(
            message.starts_with("axis_rate must be perpendicular to axis: "),
            "{message}"
        );
        assert!(from_value::<Rod>(rod([0.0, 0.0, 1.0], [size, -size, 0.5e-9 * size])).is_ok());
    }
    assert!(
        from_value::<Rod>(json!({ "position": [0.0, 0.0, 0.0], "velocity": [0.0, 0.0, 0.0] }))
            .is_err()
    );
}

#[test]
fn inertias_that_cannot_be() {
    let tensor = |zz: f64, xy: f64| json!({ "tensor": { "xx": 1.0, "yy": 1.0, "zz": zz, "xy": xy, "yz": 0.0, "zx": 0.0 } });
    assert!(from_value::<InertiaTensor>(tensor(2.0, 0.0)).is_ok());
    assert_eq!(
        refusal::<InertiaTensor>(tensor(2.5, 0.0)),
        "triangle inequality: the moment about z is 2.5, more than the sum 2 of the other two",
    );
    assert_eq!(
        refusal::<InertiaTensor>(tensor(1.0, 0.6)),
        "the product xy is 0.6 in magnitude, more than half the moment about the third axis, 0.5",
    );
}

/// Text cannot say what is not finite, but as an overflow, which `serde_json` refuses; formats of bytes can.
#[test]
fn states_that_are_not_finite() {
    use serde::de::value::{Error, MapDeserializer};
    let hinge = |angle: f64| {
        let entries = [("angle", angle), ("angular_velocity", 2.0)];
        Hinge::deserialize(MapDeserializer::<_, Error>::new(entries.into_iter()))
    };
    assert_eq!(
        hinge(0.5).unwrap(),
        Hinge {
            angle: 0.5,
            angular_velocity: 2.0
        }
    );
    for (angle, shown) in [
        (f64::NAN, "NaN"),
        (f64::INFINITY, "inf"),
        (f64::NEG_INFINITY, "-inf"),
    ] {
        let message = hinge(angle).unwrap_err().to_string();
        assert_eq!(
            message,
            format!("a state is finite, and one of its numbers is {shown}")
        );
    }
}
