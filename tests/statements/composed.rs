//! F08, H3: bodies composed of parts, compared with mass points and with the runtime's tensors.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

use std::f64::consts::PI;

use nalgebra::{Matrix3, Unit, UnitQuaternion, Vector3};
use newton_euler::inertia::InertiaTensor;
use newton_euler::prelude::*;
use proptest::prelude::*;

use crate::reference::{body, number, numbers, statement};
use crate::tensor::{is, tensor, turn};

/// The numbers of two descriptions of one body, with the parts at the offset `$far`.
macro_rules! far_away {
    ($($module:ident: $far:tt);+ $(;)?) => {
        $(mod $module {
            newton_euler::rigid_body!(Composed {
                motion: rotation,
                inputs: [push[N]],
                inertia: compose([
                    sphere(0.1[m]).mass(2[kg]).at(($far, 0, -$far)),
                    point(0.5[kg]).at(($far + 0.01, 0.02, 0.03 - $far)),
                    cuboid(0.1[m], 0.2[m], 0.3[m]).mass(1[kg]).at(($far - 0.03, 0.01, -$far)),
                ]),
                points: [tip = ($far, 0.1, -$far)],
                forces: [push = body(push, 0, 0).at(tip)],
                outputs: [momentum],
            });

            newton_euler::rigid_body!(Moved {
                motion: rotation,
                mass: 2[kg],
                inertia: tensor { xx: 0.004, yy: 2 * $far * $far + 0.004, zz: 2 * $far * $far + 0.004 }
                    .about(($far, 0, 0)[m]),
                outputs: [momentum],
            });
        })+
    };
}

far_away! {
    here: 0;
    near: 1e3;
    farther: 1e5;
    farthest: 1e7;
}

#[test]
fn h3_distance_from_the_origin_changes_no_bit() {
    let expected = tensor(&here::Composed {});
    assert_eq!(tensor(&near::Composed {}), expected);
    assert_eq!(tensor(&farther::Composed {}), expected);
    assert_eq!(tensor(&farthest::Composed {}), expected);
    let state = Rotation {
        angular_velocity: [0.3, -0.2, 0.1].into(),
        ..Rotation::default()
    };
    assert_eq!(
        farthest::Composed {}.acceleration(0.0, &state, &farthest::ComposedInput { push: 2.0 }),
        here::Composed {}.acceleration(0.0, &state, &here::ComposedInput { push: 2.0 }),
    );
    let ball = Matrix3::identity() * 0.004;
    assert_eq!(tensor(&near::Moved {}), ball);
    assert_eq!(tensor(&farther::Moved {}), ball);
    assert_eq!(tensor(&farthest::Moved {}), ball);
}

mod rotor {
    newton_euler::rigid_body!(Rotor {
        motion: spatial,
        inertia: compose([
            point(4[kg]).at((0.001, 0.0005, 0.02)),
            point(3[kg]).at((0.08, -0.03, -0.05)),
            point(2.5[kg]).at((-0.06, 0.09, 0.07)),
            point(2[kg]).at((-0.05, -0.07, 0.11)),
            point(1.5[kg]).at((0.03, 0.02, -0.16)),
        ]),
        points: [origin = (0, 0, 0)],
        locals: [seen = origin.position()],
        forces: [spring = (-1[N / m] * seen).at(origin)],
        pole: origin,
        outputs: [momentum, energy, balance],
    });
}

#[test]
fn m6_five_points() {
    let given = body("M6");
    let expected = &given["expect"];
    let center: Vector3<f64> = numbers(&expected["G"]).into();
    let [xz, yz] = numbers::<2>(&expected["Jxz,Jyz (about S)"]);
    let zz = number(&expected["Jzz(axis)"]);
    // about the axis of the drawing: G moves with w x G, and the origin stands still
    let angular_velocity = Vector3::z();
    let state = Spatial {
        position: center,
        velocity: angular_velocity.cross(&center),
        angular_velocity,
        ..Spatial::default()
    };
    let rotor = rotor::Rotor {};
    let mass = rotor.linear_momentum(&state).norm() / state.velocity.norm();
    assert!((mass - number(&expected["m"])).abs() <= 4e-15);
    let about_origin = rotor.angular_momentum_about_pole(0.0, &state);
    let error = (about_origin - Vector3::new(-xz, -yz, zz)).amax();
    assert!(error <= 2e-17, "{error:e}"); // terms to 0.07, a few roundings each
    assert!((2.0 * rotor.kinetic_energy(&state) - zz).abs() <= 2e-17);
    // the spring holds the origin, which is where it wants it
    let [spring] = rotor.loads(0.0, &state, &());
    assert!(spring.point.norm() <= 1e-17 && spring.force.norm() <= 1e-17);
}

mod bearings {
    newton_euler::rigid_body!(Bearings {
        motion: fixed_axis(origin, body(0, 0, 1)),
        points: [origin = (0, 0, 0), a = (0, 0, -0.3), b = (0, 0, 0.25)],
        inertia: compose([
            point(4[kg]).at((0.001, 0.0005, 0.02)),
            point(3[kg]).at((0.08, -0.03, -0.05)),
            point(2.5[kg]).at((-0.06, 0.09, 0.07)),
            point(2[kg]).at((-0.05, -0.07, 0.11)),
            point(1.5[kg]).at((0.03, 0.02, -0.16)),
        ]),
        fields: [weight = mass * world(0, -9.80665, 0)],
        moments: [drive = body(0, 0, 2.4)],
        reactions: [at_a = body(_, _, 0).at(a), at_b = body(_, _, 0).at(b)],
        outputs: [reactions],
    });
}

#[test]
fn m6_bearings() {
    let expected = &body("M6")["expect"];
    let state = Hinge {
        angle: 0.35,
        angular_velocity: 157.0,
    };
    let rotor = bearings::Bearings {};
    let alpha = rotor.acceleration(0.0, &state, &());
    assert!((alpha - number(&expected["alpha"])).abs() <= 1e-13); // terms to 35
    let reactions = rotor.reactions(0.0, &state, &());
    for (computed, key) in [(reactions.at_a, "A world"), (reactions.at_b, "B world")] {
        let [x, y] = numbers::<2>(&expected[key]);
        let error = (computed - Vector3::new(x, y, 0.0)).amax();
        assert!(error <= 2e-12, "{key}: {error:e}"); // terms to 2300, some ten roundings
    }
}

/// A body of many kinds of parts, with parameters.
mod satellite {
    newton_euler::rigid_body!(Satellite {
        motion: rotation,
        params: [
            hull[kg],
            wing[kg],
            bob[kg],
            a[m],
            r[m],
            angle[rad],
            direction = body(_, _, _),
            mount = body(_, _, _)[m],
        ],
        inputs: [push = body(_, _, _)[N]],
        points: [joint = mount, tip = (0, half, -1)],
        locals: [half = a / 2],
        inertia: compose([
            cuboid(a, 2 * a, 0.3[m]).turned(direction, angle).mass(hull),
            tube(half * r / a, r, half)
                .mass(wing)
                .along(direction)
                .at(joint),
            point(bob).at(tip),
            tensor {
                xx: 0.3,
                yy: 0.4,
                zz: 0.5,
                xy: 0.05
            }[kg * m ^ 2]
                .at((1, 1, 0))
                .mass(0.5[kg]),
        ]),
        forces: [push = push.at(joint)],
        outputs: [momentum],
    });
}

fn some_vector() -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-1.0..1.0).prop_map(Vector3::from)
}

proptest! {
    /// The runtime's way: every part turned, moved to the drawing origin, and all of them back to G.
    #[test]
    fn parts_are_turned_placed_and_added(
        (hull, wing, bob) in (1.0..3.0, 0.5..2.0, 0.1..1.0),
        (a, r, angle) in (0.5..1.5, 0.1..0.4, -3.0..3.0),
        direction in some_vector().prop_filter("no direction", |v| v.norm() > 0.1),
        mount in some_vector(),
        push in some_vector(),
    ) {
        let params = satellite::SatelliteParams { hull, wing, bob, a, r, angle, direction, mount };
        let satellite = satellite::Satellite::new(params).unwrap();

        let unit = Unit::new_normalize(direction);
        let h = a / 2.0;
        let box_ = [4.0 * a * a + 0.09, a * a + 0.09, 5.0 * a * a].map(|squares| hull / 12.0 * squares);
        let box_ = InertiaTensor::principal(box_[0], box_[1], box_[2]).unwrap();
        let box_ = box_.rotated(&UnitQuaternion::from_axis_angle(&unit, angle));
        let squares = 1.25 * r * r;
        let [across, axial] = [wing / 12.0 * (3.0 * squares + h * h), wing / 2.0 * squares];
        let tube = InertiaTensor::principal(across, across, axial).unwrap();
        let upright = UnitQuaternion::rotation_between(&Vector3::z(), &unit);
        let tube = tube.rotated(&upright.unwrap_or_else(|| turn([1.0, 0.0, 0.0], PI)));
        let point = InertiaTensor::principal(0.0, 0.0, 0.0).unwrap();
        let written = InertiaTensor::tensor(0.3, 0.4, 0.5, 0.05, 0.0, 0.0).unwrap();
        let parts = [
            (hull, box_, Vector3::zeros()),
            (wing, tube, mount),
            (bob, point, Vector3::new(0.0, h, -1.0)),
            (0.5, written, Vector3::new(1.0, 1.0, 0.0)),
        ];
        let mass: f64 = parts.iter().map(|(mass, ..)| mass).sum();
        let center = parts.iter().map(|(mass, _, place)| place * *mass).sum::<Vector3<f64>>() / mass;
        let about_center = parts.iter().map(|(mass, inertia, place)| {
            inertia.shifted_from_center(*mass, &(place - center)).unwrap().matrix()
        });
        let expected = about_center.sum::<Matrix3<f64>>();
        // moments to 20, some thirty roundings of terms of that size
        is(&tensor(&satellite), &expected, 20.0 * 4e-15);

        let input = satellite::SatelliteInput { push };
        let acceleration = satellite.acceleration(0.0, &Rotation::default(), &input);
        let moment = (mount - center).cross(&push);
        prop_assert!((expected * acceleration - moment).amax() <= 1e-12); // J J^-1, conditions to 100
    }
}

mod holes {
    newton_euler::rigid_body!(Drilled {
        motion: rotation,
        inertia: compose([
            cylinder(0.3[m], 0.5[m]).mass(9[kg]).at((1, 0, 0)),
            cylinder(0.2[m], 0.5[m]).mass(-4[kg]).at((1, 0, 0)),
        ]),
        outputs: [momentum],
    });

    newton_euler::rigid_body!(Tube {
        motion: rotation,
        mass: 5[kg],
        inertia: tube(0.2[m], 0.3[m], 0.5[m]),
        outputs: [momentum],
    });
}

#[test]
fn a_hole_has_negative_mass() {
    assert_eq!(tensor(&holes::Drilled {}), tensor(&holes::Tube {}));
}

mod plane {
    newton_euler::rigid_body!(Rod {
        motion: planar,
        mass: 2[kg],
        inertia: rod(0.5[m]),
        outputs: [momentum],
    });

    newton_euler::rigid_body!(Lying {
        motion: planar,
        mass: 2[kg],
        inertia: cylinder(0.3[m], 0.5[m]).along(body(1, 2)),
        outputs: [momentum],
    });

    newton_euler::rigid_body!(Pendulum {
        doc: "A rod with a disc at its end, drawn from its hinge.",
        motion: planar,
        points: [end = (0, -0.5)[m], hinge = (0, 0)],
        locals: [reach = (end.position() - hinge.position()).in_body().y],
        inertia: compose([
            rod(-reach).mass(0.6[kg]).at((0, reach / 2)),
            disc(0.1[m]).mass(2[kg]).at(end),
            point(0.4[kg]).at(end),
            0.01[kg * m ^ 2].mass(1[kg]).at(end),
        ]),
        forces: [pull = body(1, 0)[N].at(hinge)],
        fields: [weight = mass * world(0, -10)],
        moments: [twist = 2[N] * reach],
        pole: hinge,
        outputs: [momentum, balance],
    });
}

#[test]
fn solids_in_the_plane() {
    let spin = Planar {
        angular_velocity: 1.0,
        ..Planar::default()
    };
    let solids = statement("solids");
    let rod = number(&solids["slender rod m=2 L=.5"]);
    assert!((plane::Rod {}.angular_momentum(&spin) - rod).abs() <= f64::EPSILON * rod);
    let [_, across] = numbers::<2>(&solids["solid cylinder m=2,r=.3,h=.5 (Jz,Jx)"]);
    assert!((plane::Lying {}.angular_momentum(&spin) - across).abs() <= f64::EPSILON * across);
    // about the hinge: m l^2 / 3 + m r^2 / 2 + m d^2 ..
    let about_hinge = 0.6 * 0.25 / 3.0 + 2.0 * (0.005 + 0.25) + 0.4 * 0.25 + 0.01 + 0.25;
    let below = -(0.6 * 0.25 + 3.4 * 0.5) / 4.0;
    let swing = Planar {
        velocity: [-below, 0.0].into(),
        position: [0.0, below].into(),
        ..spin
    };
    let pendulum = plane::Pendulum {};
    let momentum = pendulum.angular_momentum_about_pole(0.0, &swing);
    assert!(
        (momentum - about_hinge).abs() <= 4e-16,
        "{momentum} {about_hinge}"
    );
    let loads = pendulum.loads(0.0, &swing, &());
    let load = |name: &str| loads.iter().find(|load| load.name == name).unwrap();
    assert!(load("pull").point.norm() <= 1e-16);
    assert_eq!(
        (load("weight").force.y, load("twist").moment),
        (-40.0, -1.0)
    );
}

mod pulled {
    newton_euler::rigid_body!(Sledge {
        motion: translation,
        inertia: compose([point(3[kg]), point(1[kg]).at((0, 0, 2))]),
        points: [middle = (0, 0, 0.5)],
        forces: [pull = body(8, 0, 0)[N].at(middle)],
    });
}

/// What does not turn has no inertia, and a moment about G would be an error: 0.5 m up is G.
#[test]
fn parts_of_a_body_that_does_not_turn() {
    let acceleration = pulled::Sledge {}.acceleration(0.0, &Translation::default(), &());
    assert_eq!(acceleration, Vector3::new(2.0, 0.0, 0.0));
}

/// A body without its own mass: only what is known when it is built tells that it is impossible.
mod built {
    newton_euler::rigid_body!(Dumbbell {
        motion: spatial,
        params: [load[kg], apart[m], width = 0.1[m]],
        inertia: compose([
            point(load).at((apart, 0, 0)),
            point(load).at((-apart, 0, 0)),
            point(0.5[kg]).at((0, width, 0)),
        ]),
        outputs: [energy],
    });
}

#[test]
fn what_the_constructor_checks() {
    let new =
        |load, apart, width| built::Dumbbell::new(built::DumbbellParams { load, apart, width });
    let dumbbell = new(1.0, 0.5, 0.1).unwrap();
    let state = Spatial {
        angular_velocity: Vector3::y(),
        ..Spatial::default()
    };
    assert!((dumbbell.kinetic_energy(&state) - 0.25).abs() <= 2e-16);
    assert_eq!(
        new(-1.0, 0.5, 0.1).unwrap_err(),
        InvalidBody::Mass { value: -1.5 }
    );
    assert!(matches!(new(1.0, 0.5, 0.0), Err(InvalidBody::Inertia(_))));
}
