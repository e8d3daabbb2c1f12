//! Plots.

use newton_euler::integrate::Sample;
use newton_euler::pictures::Plot;
use newton_euler::prelude::*;

use crate::{hinge, of_class, parsed, texts};

/// The parts of a path: each a list of points.
fn parts(path: &str) -> Vec<Vec<[f64; 2]>> {
    let parts = path.split('M').skip(1);
    let point = |text: &str| {
        let mut numbers = text
            .split(' ')
            .map(|number| number.parse().expect("a number"));
        [(); 2].map(|()| numbers.next().expect("two numbers"))
    };
    parts
        .map(|part| part.trim_end_matches("h.1").split('L').map(point).collect())
        .collect()
}

#[test]
fn curves_are_where_the_samples_are() {
    let samples = hinge(11, |time| 2.0 * time - 1.0);
    let svg = Plot::of(&samples, &["angle"])
        .expect("a column")
        .to_string();
    let tree = parsed(&svg);
    let curves = of_class(&tree, "curve");
    assert_eq!(curves.len(), 1);
    let points = parts(curves[0].attribute("d").expect("a path")).concat();
    assert_eq!(points.len(), 11);
    // equal steps to the right and upwards
    for pair in points.windows(2) {
        let steps = [pair[1][0] - pair[0][0], pair[0][1] - pair[1][1]];
        let first = [points[1][0] - points[0][0], points[0][1] - points[1][1]];
        assert!((steps[0] - first[0]).abs() < 0.21 && (steps[1] - first[1]).abs() < 0.21);
        assert!(steps[0] > 0.0 && steps[1] > 0.0);
    }
    // the ticks are where the curve says: -1 and 1 are at its ends
    let tick = |text: &str| {
        let mut nodes = tree.descendants();
        let node = nodes
            .find(|node| node.text() == Some(text) && node.attribute("text-anchor") == Some("end"));
        let y: f64 = node
            .expect("a tick")
            .attribute("y")
            .expect("a place")
            .parse()
            .expect("a number");
        y - 4.0
    };
    assert!((tick("\u{2212}1.0") - points[0][1]).abs() < 0.2);
    assert!((tick("1.0") - points[10][1]).abs() < 0.2);
    let texts = texts(&tree);
    assert!(texts.contains(&"time [s]".to_owned()) && texts.contains(&"angle [rad]".to_owned()));
}

#[test]
fn units_have_panels_and_curves_have_labels() {
    let start = Spatial {
        angular_velocity: [0.1, 2.0, 0.3].into(),
        ..Spatial::default()
    };
    let samples: Vec<_> = (0..5_u8)
        .map(|k| Sample {
            time: f64::from(k),
            state: start,
        })
        .collect();
    let plot = Plot::of(&samples, &["angular_velocity", "position"]).expect("columns");
    let svg = plot.title("Spin & place").to_string();
    let tree = parsed(&svg);
    assert_eq!(of_class(&tree, "frame").len(), 2);
    assert_eq!(of_class(&tree, "curve").len(), 6);
    let texts = texts(&tree);
    for text in ["Spin & place", "angular_velocity [rad/s]", "position [m]"] {
        assert!(
            texts.iter().any(|other| other == text),
            "{text} in {texts:?}"
        );
    }
    for label in ["x", "y", "z"] {
        assert_eq!(texts.iter().filter(|text| *text == label).count(), 2);
    }
    // the labels of three equal curves stand apart
    let labels = tree.descendants().filter(|node| {
        node.tag_name().name() == "text"
            && node
                .attribute("class")
                .is_some_and(|class| class.starts_with('c'))
    });
    let places: Vec<f64> = labels
        .map(|node| {
            node.attribute("y")
                .expect("a place")
                .parse()
                .expect("a number")
        })
        .collect();
    let apart = places
        .windows(2)
        .filter(|pair| pair[1] > pair[0])
        .all(|pair| pair[1] - pair[0] >= 13.9);
    assert!(apart, "{places:?}");
}

#[test]
fn numbers_that_are_not_finite_are_gaps() {
    let angle = |time: f64| match time {
        time if (0.35..0.55).contains(&time) => f64::NAN,
        time if time > 0.85 => f64::INFINITY,
        _ => time,
    };
    let samples = hinge(12, angle);
    let svg = Plot::of(&samples, &["angle"])
        .expect("a column")
        .to_string();
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
    let tree = parsed(&svg);
    let path = of_class(&tree, "curve")[0].attribute("d").expect("a path");
    let lengths: Vec<_> = parts(path).iter().map(Vec::len).collect();
    assert_eq!(lengths, [4, 3]);
    // nothing finite, nothing drawn; a single number is a dot
    let nothing = Plot::of(&hinge(3, |_| f64::NAN), &["angle"])
        .expect("a column")
        .to_string();
    assert_eq!(
        of_class(&parsed(&nothing), "curve")[0].attribute("d"),
        Some("")
    );
    let one = Plot::of(&hinge(1, |_| 2.0), &["angle"])
        .expect("a column")
        .to_string();
    assert!(one.contains("h.1"));
    parsed(
        &Plot::of(&hinge(0, |_| 2.0), &["angle"])
            .expect("a column")
            .to_string(),
    );
}

#[test]
fn all_numbers_can_be_drawn() {
    for size in [0.0, 5e-324, 1e-200, 1.0, 1e15, 1e308, f64::MAX] {
        for offset in [0.0, 1.0, -size] {
            let svg = Plot::empty(&hinge(20, |time| offset + size * (time - 1.0)))
                .curve("a", "", |_, state| state.angle)
                .to_string();
            assert!(
                !svg.contains("NaN") && !svg.contains("inf"),
                "{size} {offset}"
            );
            parsed(&svg);
        }
    }
}

#[test]
fn words_are_escaped() {
    let samples = hinge(5, |time| time);
    let hostile = "</text><script>\u{0}\"&'";
    let svg = Plot::empty(&samples)
        .title(hostile)
        .curve(hostile, hostile, |_, state| state.angle)
        .curve("other", hostile, |_, state| state.angle)
        .to_string();
    let tree = parsed(&svg);
    assert!(
        tree.descendants()
            .all(|node| node.tag_name().name() != "script")
    );
    let shown = "</text><script>\u{fffd}\"&'";
    assert!(
        texts(&tree)
            .iter()
            .filter(|text| text.contains(shown))
            .count()
            >= 3
    );
}

#[test]
fn paths_in_a_plane_are_to_scale() {
    let samples = hinge(64, |time| time);
    let svg = Plot::empty(&samples)
        .against("x", "m", |_, state| 3.0 * state.angle.cos())
        .curve("y", "m", |_, state| 3.0 * state.angle.sin())
        .to_scale()
        .to_string();
    let tree = parsed(&svg);
    let path = of_class(&tree, "curve")[0].attribute("d").expect("a path");
    let points = parts(path).concat();
    let size = |axis: usize| {
        let all = points.iter().map(|point| point[axis]);
        all.clone().fold(f64::MIN, f64::max) - all.fold(f64::MAX, f64::min)
    };
    assert!((size(0) - size(1)).abs() < 1.5 && size(0) > 300.0);
}
