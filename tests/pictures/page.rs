//! Pages.

use std::f64::consts::TAU;

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::integrate::Sample;
use newton_euler::pictures::{Page, Plot, Pose, Solid};
use newton_euler::prelude::*;
use roxmltree::Node;

use crate::{hinge, of_class, parsed};

/// A body that turns about a slanted axis and moves along x.
fn screw(count: u32) -> Vec<Sample<Spatial>> {
    let axis = nalgebra::Unit::new_normalize(Vector3::new(1.0, 2.0, -0.5));
    let times = (0..count).map(|k| 0.05 * f64::from(k));
    times
        .map(|time| Sample {
            time,
            state: Spatial {
                position: Vector3::new(time, 0.0, 0.0),
                attitude: UnitQuaternion::from_axis_angle(&axis, TAU * time),
                ..Spatial::default()
            },
        })
        .collect()
}

/// The quaternions of the frames of a rule.
fn turns(page: &str, rule: &str) -> Vec<[f64; 4]> {
    let (_, rest) = page
        .split_once(&format!("@keyframes {rule}{{"))
        .expect("a rule");
    let (frames, _) = rest.split_once("}}").expect("it ends");
    let frames = frames.split("rotate3d(").skip(1);
    frames
        .map(|frame| {
            let (numbers, _) = frame.split_once("rad)").expect("an angle");
            let numbers: Vec<f64> = numbers
                .split(',')
                .map(|text| text.parse().expect("a number"))
                .collect();
            // browsers normalize the axis
            let axis = Vector3::new(numbers[0], numbers[1], numbers[2]).normalize();
            let (sine, cosine) = (0.5 * numbers[3]).sin_cos();
            [axis.x * sine, axis.y * sine, axis.z * sine, cosine]
        })
        .collect()
}

#[test]
fn solids_turn_as_the_samples_do_and_never_the_long_way() {
    let samples = screw(81);
    let page = Page::of(&samples)
        .solid(Solid::cuboid([0.3, 0.2, 0.1]))
        .to_string();
    let turns = turns(&page, "b0");
    assert_eq!(turns.len(), samples.len());
    for (turn, sample) in turns.iter().zip(&samples) {
        let expected = sample.state.attitude.coords;
        let along: f64 = turn.iter().zip(expected.iter()).map(|(a, b)| a * b).sum();
        assert!((along.abs() - 1.0).abs() < 1e-6, "{sample:?}");
    }
    // four turns: neighbors are next to each other even where the sign of a quaternion changes
    for pair in turns.windows(2) {
        let along: f64 = pair[0].iter().zip(pair[1]).map(|(a, b)| a * b).sum();
        assert!(along > 0.98);
    }
}

#[test]
fn a_page_needs_nothing_else() {
    let samples = screw(241);
    let page = Page::of(&samples)
        .title("A <screw>")
        .solid(Solid::cuboid([0.3, 0.2, 0.1]))
        .curves(&["position", "attitude"])
        .expect("columns")
        .to_string();
    let tree = parsed(&page);
    let tags = || {
        tree.descendants()
            .filter(Node::is_element)
            .map(|node| node.tag_name().name().to_owned())
    };
    assert!(
        tags().all(|tag| !["script", "link", "img", "iframe", "object"].contains(&tag.as_str()))
    );
    let addresses = page.matches("://").count();
    assert_eq!(
        addresses,
        page.matches("xmlns=\"http://www.w3.org/2000/svg\"").count()
    );
    assert!(!page.contains("url(") && !page.contains("@import"));
    assert_eq!(of_class(&tree, "body").len(), 1);
    assert_eq!(of_class(&tree, "cursor").len(), 1);
    assert_eq!(tags().filter(|tag| tag == "i").count(), 6);
    assert!(page.contains("A &lt;screw&gt;"));
    assert!(page.len() < 60_000, "{} bytes", page.len());
}

#[test]
fn gaps_are_not_shown() {
    let mut samples = screw(20);
    for sample in &mut samples[5..8] {
        sample.state.position.y = f64::NAN;
    }
    let page = Page::of(&samples).solid(Solid::ball(0.2)).to_string();
    assert!(!page.contains("NaN"));
    // at three samples, and right beside their neighbors
    assert_eq!(page.matches("{visibility:hidden}").count(), 5);
    assert_eq!(page.matches("visibility:visible}").count(), 17);
    // nowhere finite: no solid
    for sample in &mut samples {
        sample.state.position.y = f64::INFINITY;
    }
    let page = Page::of(&samples).solid(Solid::ball(0.2)).to_string();
    assert!(!page.contains("inf,") && !page.contains("NaN"));
    assert!(of_class(&parsed(&page), "body").is_empty());
    // times that are none
    for place in [0, 3, 19] {
        for time in [f64::NAN, f64::INFINITY] {
            let mut samples = screw(20);
            samples[place].time = time;
            let page = Page::of(&samples)
                .solid(Solid::ball(0.2))
                .seen_from(f64::NAN, time)
                .curves(&["position"])
                .expect("columns")
                .to_string();
            assert!(!page.contains("NaN") && !page.contains("infs"), "{place}");
            assert_eq!(of_class(&parsed(&page), "body").len(), 1);
        }
    }
    for count in [0, 1] {
        let samples = screw(count);
        let page = Page::of(&samples)
            .solid(Solid::ball(0.0))
            .curves(&["position"])
            .expect("columns");
        parsed(&page.to_string());
    }
}

#[test]
fn bodies_of_systems_are_placed_by_functions() {
    let samples = hinge(50, |time| time);
    let bar = || Solid::bar([0.0; 3], [1.0, 0.0, 0.0], 0.05);
    let page = Page::of(&samples)
        .solid_at(bar(), |_, state| Pose::planar([0.0, 0.0], state.angle))
        .solid_at(bar(), |_, state| {
            Pose::planar([state.angle.cos(), state.angle.sin()], 2.0 * state.angle)
        })
        .from_front()
        .plot(
            Plot::empty(&samples)
                .against("angle", "rad", |_, state| 0.5 * state.angle)
                .curve("rate", "rad/s", |_, state| state.angular_velocity),
        )
        .speed(2.0)
        .to_string();
    let tree = parsed(&page);
    assert_eq!(of_class(&tree, "body").len(), 2);
    // against the angle there is no cursor in time
    assert!(of_class(&tree, "cursor").is_empty());
    assert!(page.contains("2.45s linear"), "half of 4.9 s");
    let [first, second] = ["b0", "b1"].map(|rule| turns(&page, rule));
    for (one, two) in first.iter().zip(&second) {
        let angle = |turn: &[f64; 4]| 2.0 * turn[2].atan2(turn[3]);
        let off = (angle(two) - 2.0 * angle(one)).rem_euclid(TAU);
        assert!(off.min(TAU - off) < 1e-3);
    }
}

/// CSS does not play an animation of `0s`.
#[test]
fn short_motions_play() {
    let at = |time: f64| Sample {
        time,
        state: Planar {
            angle: 1e4 * time,
            ..Planar::default()
        },
    };
    let samples = [at(0.0), at(1e-4), at(2e-4)];
    let page = Page::of(&samples).solid(Solid::cuboid([1.0, 0.1, 0.1]));
    let page = page.curves(&["angle"]).unwrap().to_string();
    assert!(page.contains("animation:b0 0.0002s linear"));
    assert!(page.contains("animation:k0 0.0002s linear"));
}

#[test]
fn faces_that_are_not_finite_are_left_out() {
    let samples = screw(3);
    let page = Page::of(&samples)
        .solid(Solid::cuboid([0.3, f64::NAN, 0.1]).and(Solid::ball(0.1)))
        .solid(Solid::cylinder(f64::INFINITY, 1.0))
        .to_string();
    let page = page.replace("linear infinite", "");
    assert!(!page.contains("NaN") && !page.contains("inf"));
    assert!(page.contains("@keyframes b0"), "the ball is left");
}
