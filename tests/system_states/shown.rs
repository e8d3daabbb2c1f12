//! Names, units and text of states, parameters and inputs; and tables of them.

use newton_euler::columns::{Csv, Named};
use newton_euler::integrate::Sample;
use newton_euler::prelude::*;
use newton_euler::state::generic;
use serde_json::json;

use crate::systems::DoublePendulumState;
use crate::{assembled, lifted};

rigid_body!(Tug::<T> {
    motion: planar,
    params: [length = 2[m], drag = 0.5[kg / s], share],
    inputs: [push = body(_, _)[N]],
    states: [fuel[kg]],
    rates: [fuel = -0.001[kg / s] * share],
    mass: 3[kg],
    inertia: mass * length.powi(2) / 12,
    forces: [engine = push * share, drag = -drag * velocity],
});

rigid_body!(Cart {
    motion: planar_translation,
    params: [load = 2[kg]],
    inputs: [push[N]],
    mass: load,
    forces: [engine = world(push, 0)],
});

fn units(names: newton_euler::columns::Names) -> Vec<(String, &'static str)> {
    let mut units = Vec::new();
    let visited: Result<(), ()> = names.each(&mut |column| {
        units.push((column.to_string(), column.unit));
        Ok(())
    });
    visited.expect("nothing fails");
    units
}

#[test]
fn columns_have_names_and_units() {
    let named = |columns: &[(&str, &'static str)]| -> Vec<(String, &'static str)> {
        let columns = columns.iter();
        columns
            .map(|(name, unit)| ((*name).to_owned(), *unit))
            .collect()
    };
    let hinges = [
        ("shoulder.angle", "rad"),
        ("shoulder.angular_velocity", "rad/s"),
        ("elbow.angle", "rad"),
        ("elbow.angular_velocity", "rad/s"),
    ];
    assert_eq!(units(DoublePendulumState::<f64>::NAMES), named(&hinges));
    let accelerations = [("shoulder", "rad/s²"), ("elbow", "rad/s²")];
    assert_eq!(
        units(crate::systems::DoublePendulumAcceleration::<f64>::NAMES),
        named(&accelerations)
    );
    let params = [("length", "m"), ("drag", "kg / s"), ("share", "")];
    assert_eq!(units(TugParams::<f32>::NAMES), named(&params));
    assert_eq!(
        units(TugInput::<f64>::NAMES),
        named(&[("push.x", "N"), ("push.y", "N")])
    );
    assert_eq!(TugState::<f64>::NAMES.count(), 7);
    assert_eq!(units(TugState::<f64>::NAMES)[6], ("fuel".to_owned(), "kg"));
    assert_eq!(units(Sample::<Hinge>::NAMES)[0], ("time".to_owned(), "s"));
    assert_eq!(
        Sample::<Hinge>::NAMES.to_string(),
        "time,angle,angular_velocity"
    );
    assert_eq!(CartParams::NAMES.to_string(), "load");
}

#[test]
fn states_are_shown_with_units() {
    let state = Planar {
        position: [1.0, -0.25].into(),
        angle: 0.5,
        ..Planar::default()
    };
    let text = "position (1.00, -0.25) m, angle 0.50 rad, velocity (0.00, 0.00) m/s, \
                angular_velocity 0.00 rad/s";
    assert_eq!(format!("{state:.2}"), text);
    assert_eq!(
        format!("{}", lifted()),
        "shoulder: angle 1.4 rad, angular_velocity 0 rad/s; \
         elbow: angle -0.6 rad, angular_velocity 2.5 rad/s"
    );
    let single = generic::Hinge {
        angle: 0.5_f32,
        angular_velocity: f32::NAN,
    };
    assert_eq!(
        single.to_string(),
        "angle 0.5 rad, angular_velocity NaN rad/s"
    );
    let turned = Rotation::default();
    assert_eq!(
        turned.to_string(),
        "attitude (x, y, z, w) = (0, 0, 0, 1), angular_velocity (0, 0, 0) rad/s"
    );
    // each part once
    assert!(assembled().to_string().matches("; ").count() > 2);
}

#[test]
fn tables_read_back() {
    let samples: Vec<_> = [0.1, 1.0 / 3.0, 1e300, -5e-324, 0.0, f64::INFINITY, f64::NAN]
        .into_iter()
        .enumerate()
        .map(|(k, angle)| Sample {
            time: f64::from(u32::try_from(k).expect("few")),
            state: Hinge {
                angle,
                angular_velocity: -angle,
            },
        })
        .collect();
    let table = Csv::of(&samples).to_string();
    let mut lines = table.lines();
    assert_eq!(lines.next(), Some("time,angle,angular_velocity"));
    for (line, sample) in lines.by_ref().zip(&samples) {
        let numbers: Vec<f64> = line
            .split(',')
            .map(|text| text.parse().expect("a number"))
            .collect();
        let given = [
            sample.time,
            sample.state.angle,
            sample.state.angular_velocity,
        ];
        assert!(
            numbers.iter().zip(given).all(|(read, given)| {
                read.to_bits() == given.to_bits() || read.is_nan() && given.is_nan()
            }),
            "{line}"
        );
        assert_eq!(numbers.len(), 3);
    }
    assert_eq!(table.lines().count(), 8);
    let numbered = Csv::rows(samples.iter().map(|sample| sample.state)).numbered("member");
    assert!(
        numbered
            .to_string()
            .starts_with("member,angle,angular_velocity\n0,0.1,-0.1\n1,")
    );
    let rest = [Hinge::default()];
    let quoted = Csv::of(&rest).numbered("row, \"from\" 0");
    assert!(
        quoted
            .to_string()
            .starts_with("\"row, \"\"from\"\" 0\",angle")
    );
}

#[test]
fn parameters_and_inputs_are_written() {
    let params = TugParams {
        length: 2.0,
        drag: 0.25,
        share: 1.0,
    };
    let written = serde_json::to_value(params).expect("numbers");
    assert_eq!(
        written,
        json!({ "length": 2.0, "drag": 0.25, "share": 1.0 })
    );
    let read: TugParams<f64> = serde_json::from_value(written).expect("as written");
    assert_eq!(read, params);
    let input = TugInput {
        push: nalgebra::Vector2::new(0.1_f32, -2.0),
    };
    let text = serde_json::to_string(&input).expect("numbers");
    assert_eq!(text, r#"{"push":[0.1,-2.0]}"#);
    assert_eq!(
        serde_json::from_str::<TugInput<f32>>(&text).expect("as written"),
        input
    );
    let cart: CartParams = serde_json::from_value(json!({ "load": 4.0 })).expect("a number");
    assert_eq!(cart.load, 4.0);
    // a parameter that is missing has the default of the description, if there is one
    let read: TugParams<f32> = serde_json::from_value(json!({ "share": 1 })).expect("two defaults");
    assert_eq!((read.length, read.drag, read.share), (2.0, 0.5, 1.0));
    let missing = serde_json::from_value::<TugParams<f64>>(json!({ "length": 3 }));
    let missing = missing.expect_err("it has no default").to_string();
    assert_eq!(missing, "missing field `share`");
    // a misspelt one would count as missing
    let misspelt = serde_json::from_value::<TugParams<f64>>(json!({ "share": 1, "lenght": 9 }));
    let misspelt = misspelt.expect_err("no such parameter").to_string();
    let expected = "unknown field `lenght`, expected one of `length`, `drag`, `share`";
    assert_eq!(misspelt, expected);
    let missing = serde_json::from_value::<CartInput>(json!({})).expect_err("it is missing");
    assert_eq!(missing.to_string(), "missing field `push`");
}

#[test]
fn a_table_is_written_to_a_file() {
    let path = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("shown.csv");
    let states = [Hinge::default(); 3];
    Csv::of(&states).write(&path).expect("a folder for it");
    let read = std::fs::read_to_string(&path).expect("it is there");
    assert_eq!(read, Csv::of(&states).to_string());
    let nowhere = path.join("below a file");
    assert!(Csv::of(&states).write(nowhere).is_err());
}
