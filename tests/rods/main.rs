//! Rods: published numbers, the vector law by hand, conservation laws, and the limit of thin
//! bodies.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

use nalgebra::{Unit, UnitQuaternion, Vector3};
use newton_euler::integrate::{cf4, cf4_projected};
use newton_euler::prelude::*;
use proptest::prelude::*;

#[path = "../oracle/mod.rs"]
mod oracle;
#[path = "../reference/mod.rs"]
mod reference;
mod scenes;

use oracle::{Sum, is, is_scalar, rod, vectors};
use reference::{statement, vector};

fn state(axis: [f64; 3], rate: [f64; 3]) -> Rod {
    Rod {
        axis: Unit::new_unchecked(axis.into()),
        axis_rate: rate.into(),
        ..Rod::default()
    }
}

/// D, by a force on the axis and by a moment.
#[test]
fn slender_rod() {
    let expected = statement("degenerate slender rod J=(0,J,J), J=mL^2/12");
    let [u, rate, moment, bent] =
        ["u", "udot", "K=ux(.7,-.2,.1)", "uddot"].map(|name| vector(&expected[name]));
    let state = state(u.into(), rate.into());
    let pull = Vector3::new(0.7, -0.2, 0.1);
    let pulled = scenes::Pulled::default();
    let by_force = pulled.acceleration(0.0, &state, &scenes::PulledInput { pull });
    assert!((by_force.axis - bent).amax() < 4e-15, "{by_force:?}");
    assert!((by_force.linear - pull / 1.2).amax() < 1e-15);
    let twisted = scenes::Twisted::default();
    // what of it is along the axis drops out
    let k = moment + u * 0.3;
    let by_moment = twisted.acceleration(0.0, &state, &scenes::TwistedInput { k });
    assert!((by_moment.axis - bent).amax() < 8e-15, "{by_moment:?}");
    assert_eq!(by_moment.linear, Vector3::zeros());
}

/// ü = -|u̇|² u of a free rod.
#[test]
fn free_rods_move_along_great_circles() {
    let state = state([0.6, 0.0, 0.8], [0.0, 1.5, 0.0]);
    let computed = scenes::Free::default().acceleration(0.0, &state, &());
    assert!((computed.axis + state.axis.into_inner() * 2.25).amax() < 1e-15);
    assert_eq!(computed.linear, Vector3::zeros());
    assert!(scenes::Free::SKIPPED[0].starts_with("the moment balance about the axis:"));
}

const MASS: f64 = 2.5;
const INERTIA: f64 = 0.3;
const TIP: f64 = 0.4;
const TAIL: f64 = -0.5;
const WALL: Vector3<f64> = Vector3::new(-1.0, 0.5, 0.25);

#[derive(Clone, Debug)]
struct Given {
    state: Rod,
    push: Vector3<f64>,
    wind: Vector3<f64>,
    k: Vector3<f64>,
    thrust: f64,
}

fn given() -> impl Strategy<Value = Given> {
    (rod(), vectors(8.0), vectors(8.0), vectors(4.0), -8.0..8.0).prop_map(
        |(state, push, wind, k, thrust)| Given {
            state,
            push,
            wind,
            k,
            thrust,
        },
    )
}

/// Resultant and moment about G.
fn loads(given: &Given) -> (Sum<3>, Sum<3>) {
    let Rod {
        position: g,
        axis,
        velocity: v,
        axis_rate: rate,
    } = given.state;
    let u = axis.into_inner();
    let w = u.cross(&rate);
    let [hook, mast] = [[1.5, 2.0, -1.0], [-1.0, 0.5, 2.0]].map(Vector3::from);
    let air = v + rate * TAIL - given.wind;
    let airspeed = v.norm() + rate.norm() * 0.5 + given.wind.norm();
    let reach = g.norm() + TIP;
    let stretch = g + u * TIP - hook;
    let pull = 20.0 * (1.0 - 0.5 / stretch.norm());
    let field = Vector3::new(3.0, -2.0, 4.0);
    let forces = [
        (given.push * 2.0, given.push.norm() * 2.0, TAIL),
        (given.push, given.push.norm(), TIP),
        (air * -0.8 * air.norm(), 0.8 * airspeed.powi(2), TAIL),
        (
            (mast - g - u * TIP) * 12.5,
            12.5 * (mast.norm() + reach),
            TIP,
        ),
        (u * given.thrust, given.thrust.abs(), TIP),
        (
            w.cross(&given.push) * 0.5,
            w.norm() * given.push.norm(),
            TIP,
        ),
        (u, 1.0, TIP + 0.25),
        (Vector3::z() * -MASS * 9.80665, MASS * 9.81, 0.0),
        (Vector3::new(0.5, 2.0, -1.0), 2.5, TIP),
        (field, field.norm(), TIP),
        (field * -0.5, field.norm(), TAIL),
        // the relative error of a short length is that of the positions over it
        (
            stretch * -pull,
            (pull.abs() + 20.0 + 10.0 / stretch.norm()) * (hook.norm() + reach),
            TIP,
        ),
    ];
    let lean = Vector3::new(0.6, 0.0, 0.8);
    let couples = [
        (u.cross(&given.k), given.k.norm()),
        (w * -0.3, w.norm()),
        (w * -0.2, w.norm()),
        (u.cross(&lean) * (-8.0 * u.dot(&lean)), 8.0),
    ];
    let (mut force, mut moment) = (Sum::new(), Sum::new());
    for (f, size, s) in forces {
        force = force.and(f, size);
        moment = moment.and((u * s).cross(&f), size * s.abs());
    }
    for (k, size) in couples {
        moment = moment.and(k, size);
    }
    (force, moment)
}

fn over(sum: &Sum<3>, divisor: f64) -> Sum<3> {
    Sum {
        value: sum.value / divisor,
        largest: sum.largest / divisor,
    }
}

macro_rules! by_hand {
    ($test:ident, $body:expr, $input:ident) => {
        proptest! {
            #[test]
            fn $test(given in given(), linear in vectors(9.0), bent in vectors(9.0), time in 0.0..9.0) {
                let (body, state) = ($body, given.state);
                let Given { push, wind, k, thrust, .. } = given;
                let input = scenes::$input { push, wind, k, thrust };
                let (force, moment) = loads(&given);
                let (u, rate) = (state.axis.into_inner(), state.axis_rate);
                let computed = body.acceleration(time, &state, &input);
                is(&computed.linear, &over(&force, MASS))?;
                let turned = Sum { value: moment.value.cross(&u), largest: moment.largest };
                let held = u * -rate.norm_squared();
                is(&computed.axis, &over(&turned, INERTIA).and(held, held.norm()))?;

                let wrench = body.applied(time, &state, &input);
                is(&wrench.force, &force)?;
                is(&wrench.moment, &moment)?;
                let loads = body.loads(time, &state, &input);
                prop_assert_eq!(loads.len(), 15);
                let listed: Vector3<f64> = loads.iter().map(|load| load.force).sum();
                is(&listed, &force)?;
                let about_g = |load: &Load| (load.point - state.position).cross(&load.force) + load.moment;
                let listed: Vector3<f64> = loads.iter().map(about_g).sum();
                let largest = moment.largest + force.largest * (state.position.norm() + 1.0);
                is(&listed, &Sum { value: moment.value, largest })?;

                // the residual of any motion, and of the true one
                let force = force.and(linear * -MASS, MASS * linear.norm());
                let spin = u.cross(&bent) * -INERTIA;
                let moment = moment.and(spin, INERTIA * bent.norm());
                let from_pole = state.position - WALL;
                let moment = Sum {
                    value: moment.value + from_pole.cross(&force.value),
                    largest: moment.largest + 12.0 * from_pole.norm() * force.largest,
                };
                let acceleration = RodAcceleration { linear, axis: bent };
                let residual = body.residual(time, &state, &acceleration, &(), &input);
                is(&residual.force, &force)?;
                is(&residual.moment, &moment)?;

                let v = state.velocity;
                is(&body.linear_momentum(&state), &Sum::new().and(v * MASS, MASS * v.norm()))?;
                let spin = u.cross(&rate) * INERTIA;
                let spin = Sum::new().and(spin, INERTIA * rate.norm() * 1.001);
                is(&body.angular_momentum(&state), &spin)?;
                let orbital = from_pole.cross(&v) * MASS;
                let whole = spin.and(orbital, MASS * from_pole.norm() * v.norm());
                is(&body.angular_momentum_about_pole(time, &state), &whole)?;
                let kinetic = 0.5 * (MASS * v.norm_squared() + INERTIA * rate.norm_squared());
                is_scalar(body.kinetic_energy(&state), kinetic, kinetic)?;
                let [tip, tail] = [TIP, TAIL].map(|s| state.position + u * s);
                let field = Vector3::new(3.0, -2.0, 4.0);
                let stretch = (tip - Vector3::new(1.5, 2.0, -1.0)).norm();
                let terms = [
                    MASS * 9.80665 * state.position.z,
                    -tip.dot(&Vector3::new(0.5, 2.0, -1.0)),
                    -tip.dot(&field),
                    tail.dot(&field) * 0.5,
                    10.0 * (stretch - 0.5).powi(2),
                    4.0 * u.dot(&Vector3::new(0.6, 0.0, 0.8)).powi(2),
                ];
                let largest = 40.0 * (1.0 + state.position.norm()) + 10.0 * (stretch + 4.0).powi(2);
                is_scalar(body.potential_energy(time, &state, &input), terms.iter().sum(), largest)?;
            }
        }
    };
}

by_hand!(numbers, scenes::Baked {}, BakedInput);
by_hand!(parameters, scenes::Parametric::default(), ParametricInput);

fn thrown() -> Rod {
    Rod {
        position: Vector3::new(0.2, -0.1, 0.0),
        velocity: Vector3::new(0.5, 1.0, -0.3),
        ..state([0.6, 0.0, 0.8], [0.4, 1.5, -0.3])
    }
}

/// A step of fourth order: in 600 steps 4e-8 J of some 10 J are lost, and ten times as many steps lose 1e4 times less.
#[test]
fn energy() {
    let body = scenes::Swinging::default();
    let start = thrown();
    let energy = |state: &Rod| body.kinetic_energy(state) + body.potential_energy(0.0, state, &());
    let lost = |steps: usize| energy(&cf4(&body, &start, &(), 0.0..3.0, steps)) - energy(&start);
    assert!(lost(6000).abs() < 1e-10, "{}", lost(6000));
    assert!(lost(300).abs() > 10.0 * lost(600).abs());
}

/// Without loads both momenta stay, about G and about a fixed point.
#[test]
fn momenta() {
    let body = scenes::Floating::default();
    let (start, later) = (thrown(), cf4(&body, &thrown(), &(), 0.0..10.0, 100));
    assert!((later.axis.dot(&start.axis) - 1.0).abs() > 0.1, "it turns");
    let change = body.angular_momentum(&later) - body.angular_momentum(&start);
    assert!(change.amax() < 1e-15, "{change}");
    let about_pole = |state| body.angular_momentum_about_pole(0.0, state);
    assert!((about_pole(&later) - about_pole(&start)).amax() < 1e-13);
    assert_eq!(body.linear_momentum(&later), body.linear_momentum(&start));
}

/// dL/dt = K about G, by differences in time.
#[test]
fn momentum_law() {
    let body = scenes::Baked {};
    let input = scenes::BakedInput {
        push: Vector3::new(1.0, -2.0, 0.5),
        wind: Vector3::new(3.0, 1.0, 0.0),
        k: Vector3::new(0.2, 0.4, -0.6),
        thrust: 2.0,
    };
    let start = thrown();
    let h = 1e-4;
    let momentum = |time: f64| {
        let later = cf4(&body, &start, &input, 0.0..time, 1);
        body.angular_momentum(&later)
    };
    let rate = (momentum(h) - momentum(-h)) / (2.0 * h);
    let moment = body.applied(0.0, &start, &input).moment;
    // the third derivative, some 1e3, by h²/6, and rounding over h
    assert!((rate - moment).amax() < 1e-5, "{rate} {moment}");
}

/// A cylinder of 20 µm that does not spin moves like a rod: J differs by 3 r²/l² of itself, 8e-10.
#[test]
fn thin_bodies() {
    let rod = thrown();
    let attitude = UnitQuaternion::rotation_between(&Vector3::z(), &rod.axis).unwrap();
    let thin = Spatial {
        position: rod.position,
        velocity: rod.velocity,
        attitude,
        angular_velocity: attitude.inverse() * rod.angular_velocity(),
    };
    let computed = scenes::Thin::default().acceleration(0.0, &thin, &());
    let expected = scenes::Slender::default().acceleration(0.0, &rod, &());
    let w = thin.angular_velocity;
    let bent =
        attitude * (computed.angular.cross(&Vector3::z()) + w.cross(&w.cross(&Vector3::z())));
    assert!((computed.linear - expected.linear).amax() < 1e-12);
    assert!((bent - expected.axis).amax() < 1e-7 * expected.axis.amax());

    let thin = cf4(&scenes::Thin::default(), &thin, &(), 0.0..1.0, 4000);
    let rod = cf4(&scenes::Slender::default(), &rod, &(), 0.0..1.0, 4000);
    assert!((thin.position - rod.position).amax() < 1e-9);
    let axis = thin.attitude * Vector3::z();
    assert!(
        (axis - rod.axis.into_inner()).amax() < 1e-9,
        "{axis} {:?}",
        rod.axis
    );
}

/// About a pin at s u from G, where the moment of inertia is J + m s²: ü = (K × u)/(J + m s²) - |u̇|² u, and G follows.
#[test]
fn pinned_at_its_end() {
    let body = scenes::Hung::default();
    let (m, s, g) = (1.2, -0.4, Vector3::z() * -9.80665);
    let (u, rate) = (Vector3::new(0.6, 0.0, 0.8), Vector3::new(0.4, 1.5, -0.3));
    let hung = Rod {
        position: u * -s,
        velocity: rate * -s,
        ..state(u.into(), rate.into())
    };
    let about_pin = m * 0.8 * 0.8 / 3.0;
    let weight = (u * -s).cross(&(g * m));
    let bent = weight.cross(&u) / about_pin - u * rate.norm_squared();
    let computed = body.acceleration(0.0, &hung, &());
    assert!((computed.axis - bent).amax() < 1e-13, "{computed:?} {bent}");
    assert!((computed.linear - bent * -s).amax() < 1e-13);
    let scenes::HungReactions { pin } = body.reactions(0.0, &hung, &()).unwrap();
    assert!((pin - (computed.linear - g) * m).amax() < 1e-12);
    let reactions = scenes::HungReactions { pin };
    let residual = body.residual(0.0, &hung, &computed, &reactions, &());
    assert!(residual.force.amax() < 1e-12 && residual.moment.amax() < 1e-12);

    // the constraints, and the energy that is left
    let energy = |state: &Rod| body.kinetic_energy(state) + body.potential_energy(0.0, state, &());
    let later = cf4_projected(&body, &hung, &(), 0.0..2.0, 2000).unwrap();
    for violation in body.violations(2.0, &later, &()) {
        assert!(violation.position.unwrap().abs() < 1e-13 && violation.velocity.abs() < 1e-13);
    }
    assert!((energy(&later) - energy(&hung)).abs() < 1e-7);
    assert!(later.axis.dot(&later.axis_rate).abs() < 1e-13);
}

/// A ladder on smooth floor and wall: θ'' = (3 g / 2 l) sin θ from the wall (textbook), in the plane of both.
#[test]
fn ladder() {
    let body = scenes::Ladder::default();
    let (sin, cos) = (0.5_f64.sin(), 0.5_f64.cos());
    // the axis from the foot to the top; the foot is away from the wall along x
    let leaning = Rod {
        position: Vector3::new(2.0 * sin, 0.0, 2.0 * cos),
        ..state([-sin, 0.0, cos], [0.0; 3])
    };
    let computed = body.acceleration(0.0, &leaning, &());
    let faster = 1.5 * 9.80665 / 4.0 * sin;
    let bent = Vector3::new(-cos, 0.0, -sin) * faster;
    assert!((computed.axis - bent).amax() < 1e-13, "{computed:?} {bent}");
    let reactions = body.reactions(0.0, &leaning, &()).unwrap();
    let push = 9.0 * 2.0 * faster * cos;
    assert!((reactions.wall - Vector3::x() * push).amax() < 1e-12);
    assert!((reactions.floor.z - 9.0 * (9.80665 - 2.0 * faster * sin)).abs() < 1e-12);
}

/// A local that the direction is made of is a vector along the axis afterwards: 6 N of a vector of length 5/4, on 2 kg.
#[test]
fn direction_by_a_local() {
    let state = state([0.6, 0.0, 0.8], [0.0; 3]);
    let computed = scenes::Named::default().acceleration(0.0, &state, &());
    assert!((computed.linear - state.axis.into_inner() * 3.75).amax() < 1e-15);
    assert_eq!(computed.axis, Vector3::zeros());
}

/// Kept level by a couple, a rod turns like a planar body.
#[test]
fn kept_level() {
    let body = scenes::Level::default();
    let level = state([0.6, 0.8, 0.0], [-0.8, 0.6, 0.0]);
    let (u, push) = (level.axis.into_inner(), Vector3::new(1.0, 2.0, 3.0));
    let computed = body.acceleration(0.0, &level, &());
    let about_z = 0.5 * (0.6 * 2.0 - 0.8 * 1.0) / 0.1;
    let expected = Vector3::new(-0.8, 0.6, 0.0) * about_z - u;
    assert!((computed.axis - expected).amax() < 1e-14, "{computed:?}");
    let guide = body.reactions(0.0, &level, &()).unwrap().guide;
    let given = (u * 0.5).cross(&push);
    assert!((guide + given - Vector3::z() * given.z).amax() < 1e-14);
}

/// What has no moment on one branch has one on another.
#[test]
fn branches() {
    let body = scenes::Branched::default();
    for (time, speed) in [(1.0, 2.0), (4.0, 2.0), (1.0, 9.0), (4.0, 9.0)] {
        let moving = Rod {
            velocity: Vector3::y() * speed,
            ..state([0.6, 0.0, 0.8], [0.4, 1.5, -0.3])
        };
        let (u, rate) = (moving.axis.into_inner(), moving.axis_rate);
        let fast = Vector3::new(1.0, 0.0, 3.0) * f64::max(speed - 5.0, 0.0);
        let (late, couple) = if time > 3.0 {
            (Vector3::new(0.0, 1.0, 2.0), u.cross(&rate) * -0.2)
        } else {
            (u * 2.0, u.cross(&Vector3::new(0.0, 2.0, 0.0)))
        };
        let moment = (u * 0.5).cross(&(late + fast)) + couple;
        let expected = moment.cross(&u) / 0.1 - u * rate.norm_squared();
        let computed = body.acceleration(time, &moving, &());
        assert!(
            (computed.axis - expected).amax() < 1e-13,
            "{computed:?} {expected}"
        );
        assert!((computed.linear - late - fast).amax() < 1e-14);
    }
}

/// L = J u × u̇ of the same rod, whichever way its inertia is written; the axis across which it turns is x or y.
#[test]
fn forms_of_inertia() {
    let turning = state([0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
    macro_rules! check {
        ($($name:ident),*) => {
            $(
                let momentum = scenes::$name::default().angular_momentum(&turning);
                let expected = Vector3::y() * 0.064;
                assert!((momentum - expected).amax() < 1e-16, "{}: {momentum}", stringify!($name));
            )*
        };
    }
    check!(
        Number,
        Param,
        AboutEnd,
        Principal,
        Open,
        Tensor,
        TensorAboutEnd,
        Solid
    );
}

/// Parts on a line beside the drawing origin: G at 1.15 l of it, J by the parallel-axis theorem.
#[test]
fn dumbbell() {
    let turning = state([0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
    let l: f64 = 0.5;
    let center = (0.3 + 0.5 * 1.5 + 0.2 * 0.5) * l;
    let square = |s: f64| (s * l - center).powi(2);
    let moment =
        0.3 * l * l / 12.0 + 0.001 + 0.3 * square(1.0) + 0.5 * square(1.5) + 0.2 * square(0.5);
    let computed = scenes::Dumbbell::default().angular_momentum(&turning);
    assert!((computed.y - moment).abs() < 1e-16, "{computed} {moment}");
    let params = scenes::DumbbellParams { l: -1.0 };
    assert!(scenes::Dumbbell::new(params).is_ok());
}

#[test]
fn moments_of_inertia_are_positive() {
    let params = scenes::ParametricParams {
        j: -0.3,
        ..*scenes::Parametric::default().params()
    };
    assert!(scenes::Parametric::new(params).is_err());
}

#[test]
fn other_motions_have_other_names() {
    let computed = scenes::Lever::default().acceleration(0.0, &Planar::default(), &());
    assert!((computed.angular - 0.5 / 0.2).abs() < 1e-15);
}
