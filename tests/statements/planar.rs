//! The planar statements F01 to F05 of the theory, through the macro.
//!
//! The expected numbers are those of the reference, or sums over mass points. None comes from
//! generated code.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

use nalgebra::{Rotation2, Vector2};
use newton_euler::prelude::*;

use crate::reference::{body, number, numbers, planar, statement};

/// F01, F03: the plate made of the four mass points.
mod plate {
    newton_euler::rigid_body!(AboutCenter {
        motion: planar,
        params: [m, j_g],
        mass: m,
        inertia: j_g,
        outputs: [balance, momentum],
    });

    newton_euler::rigid_body!(AboutPole {
        motion: planar,
        params: [m, j_g],
        mass: m,
        inertia: j_g,
        pole: world(3.2, -1.1)[m],
        outputs: [balance],
    });

    newton_euler::rigid_body!(Baked {
        motion: planar,
        mass: 5[kg],
        inertia: 1.46265[kg * m ^ 2],
        pole: world(3.2, -1.1)[m],
        outputs: [balance],
    });

    newton_euler::rigid_body!(Sliding {
        motion: planar_translation,
        mass: 5[kg],
        outputs: [balance],
    });
}

/// One-shot algebra: 1e-13 of the largest term.
fn is(computed: f64, expected: f64, largest: f64) {
    let error = (computed - expected).abs();
    assert!(
        error <= 1e-13 * largest,
        "{computed} is not {expected}: off by {error:e}"
    );
}

/// Mass points turned with the plate: mass, place from the drawing origin in the axes of the plate.
struct Points(Vec<(f64, Vector2<f64>)>);

impl Points {
    fn given() -> Self {
        let list = statement("F01-03 planar inertia wrench")["points (m,x,y)"].take();
        let points = list.as_array().unwrap().iter().map(|point| {
            let [m, x, y] = numbers(point);
            (m, Vector2::new(x, y))
        });
        Self(points.collect())
    }

    fn mass(&self) -> f64 {
        self.0.iter().map(|(m, _)| m).sum()
    }

    fn center(&self) -> Vector2<f64> {
        self.0.iter().map(|(m, r)| r * *m).sum::<Vector2<f64>>() / self.mass()
    }

    fn inertia(&self) -> f64 {
        let from_center = |r: &Vector2<f64>| (r - self.center()).norm_squared();
        self.0.iter().map(|(m, r)| m * from_center(r)).sum()
    }

    /// Resultant and moment about O of -m a over the points, `a_P = a_G + α × r - ω² r`; G at `g`.
    fn inertial(&self, g: Vector2<f64>, o: Vector2<f64>, motion: &Motion) -> (Vector2<f64>, f64) {
        let turn = Rotation2::new(motion.angle);
        let loads = self.0.iter().map(|(m, r)| {
            let r = turn * (r - self.center());
            let swung = Vector2::new(-r.y, r.x) * motion.angular;
            let force = -(motion.linear + swung - r * motion.rate.powi(2)) * *m;
            (force, (g + r - o).perp(&force))
        });
        loads.fold((Vector2::zeros(), 0.0), |(force, moment), (f, k)| {
            (force + f, moment + k)
        })
    }
}

struct Motion {
    angle: f64,
    rate: f64,
    linear: Vector2<f64>,
    angular: f64,
}

impl Motion {
    fn given() -> Self {
        let given = statement("F01-03 planar inertia wrench");
        let [angle, rate, angular] = ["theta", "omega", "alpha"].map(|name| number(&given[name]));
        let linear = planar(&given["aG"]);
        Self {
            angle,
            rate,
            linear,
            angular,
        }
    }

    fn state(&self, position: Vector2<f64>) -> Planar {
        Planar {
            position,
            angle: self.angle,
            velocity: Vector2::new(0.3, -2.0),
            angular_velocity: self.rate,
        }
    }

    fn acceleration(&self) -> PlanarAcceleration {
        PlanarAcceleration {
            linear: self.linear,
            angular: self.angular,
        }
    }
}

#[test]
fn f03_inertial_wrench_is_the_sum_over_points() {
    let expected = statement("F01-03 planar inertia wrench");
    let (points, motion) = (Points::given(), Motion::given());
    let [m, j_g] = [points.mass(), points.inertia()];
    is(m, number(&expected["m"]), m);
    is(j_g, number(&expected["JG"]), m);
    is(points.center().x, number(&expected["G body"][0]), 1.0);
    is(points.center().y, number(&expected["G body"][1]), 1.0);

    let [g, o] = [Vector2::new(0.5, 0.25), Vector2::new(3.2, -1.1)];
    let state = motion.state(g);
    // Without loads the residual is the inertial wrench.
    let about_g = plate::AboutCenter::new(plate::AboutCenterParams { m, j_g })
        .unwrap()
        .residual(0.0, &state, &motion.acceleration(), &(), &());
    let (force, moment) = points.inertial(g, g, &motion);
    is(about_g.force.x, force.x, 20.0);
    is(about_g.force.y, force.y, 20.0);
    is(about_g.moment, moment, 20.0);
    let stated = planar(&expected["F_iG by summation"]);
    is(about_g.force.x, stated.x, 20.0);
    is(about_g.force.y, stated.y, 20.0);
    is(about_g.moment, number(&expected["M_iG by summation"]), 20.0);

    let stated = "pole O=(3.2,-1.1), G=(0.5,0.25): M_iO = M_iG + (G-O)xF_iG";
    let about_o = [
        plate::AboutPole::new(plate::AboutPoleParams { m, j_g })
            .unwrap()
            .residual(0.0, &state, &motion.acceleration(), &(), &()),
        plate::Baked {}.residual(0.0, &state, &motion.acceleration(), &(), &()),
    ];
    for wrench in about_o {
        is(wrench.force.y, 15.5, 20.0);
        is(wrench.moment, number(&expected[stated]), 45.0);
        is(wrench.moment, points.inertial(g, o, &motion).1, 45.0);
    }
}

#[test]
fn f01_translation_has_no_inertial_moment() {
    let expected = statement("F01-03 planar inertia wrench");
    let motion = Motion {
        rate: 0.0,
        angular: 0.0,
        ..Motion::given()
    };
    let g = Vector2::new(0.5, 0.25);
    let turning = plate::AboutCenter::new(plate::AboutCenterParams {
        m: 5.0,
        j_g: 1.46265,
    })
    .unwrap()
    .residual(0.0, &motion.state(g), &motion.acceleration(), &(), &());
    let sliding = PlanarTranslation {
        position: g,
        velocity: Vector2::new(0.3, -2.0),
    };
    let sliding = plate::Sliding {}.residual(0.0, &sliding, &motion.linear, &(), &());
    let stated = planar(&expected["translation: F_iG, M_iG (w=alpha=0)"][0]);
    for wrench in [turning, sliding] {
        is(wrench.force.x, stated.x, 20.0);
        is(wrench.force.y, stated.y, 20.0);
        assert_eq!(wrench.moment, 0.0); // no term is left
    }
}

/// F02 on M1: a plate on a pin, whose reaction is given.
mod pinned {
    newton_euler::rigid_body!(AboutPin {
        motion: planar,
        params: [m = 2.7[kg], d = 0.35[m], j_g = 0.18[kg * m ^ 2]],
        inputs: [rx[N], ry[N], torque[N * m]],
        mass: m,
        inertia: j_g,
        points: [o = (-d, 0)],
        reactions: [pin = world(rx, ry).at(o)],
        fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
        moments: [drive = torque],
        pole: o,
        outputs: [balance, momentum],
    });
}

#[test]
fn f02_rotation_about_a_fixed_point() {
    let m1 = body("M1");
    let (given, expected) = (&m1["given"], &m1["expect"]);
    let [m, d, j_g, theta, rate, torque] =
        ["m", "d", "JG", "theta", "omega", "torque"].map(|name| number(&given[name]));
    let [alpha, rx, ry] = ["alpha", "Rx", "Ry"].map(|name| number(&expected[name]));

    // Body x from the pin, at the world origin, to G; theta from the downward vertical.
    let g = Vector2::new(theta.sin(), -theta.cos()) * d;
    let across = Vector2::new(-g.y, g.x);
    let state = Planar {
        position: g,
        angle: theta - std::f64::consts::FRAC_PI_2,
        velocity: across * rate,
        angular_velocity: rate,
    };
    let plate = pinned::AboutPin::default();
    let input = pinned::AboutPinInput { rx, ry, torque };
    let computed = plate.acceleration(0.0, &state, &input);
    // a_G = ω̇ × (G - O) - ω² (G - O)
    let swung = across * alpha - g * rate.powi(2);
    is(computed.linear.x, swung.x, 21.0 / m);
    is(computed.linear.y, swung.y, 26.0 / m);
    is(computed.angular, alpha, 21.0 * d / j_g);

    let true_motion = PlanarAcceleration {
        linear: swung,
        angular: alpha,
    };
    let wrench = plate.residual(0.0, &state, &true_motion, &(), &input);
    is(wrench.force.x, 0.0, 26.0);
    is(wrench.force.y, 0.0, 26.0);
    is(wrench.moment, 0.0, 26.0 * d);
    // About the pin the reaction drops out: with another one, the moment still balances.
    let other = pinned::AboutPinInput {
        rx: 100.0,
        ry: -300.0,
        torque,
    };
    is(
        plate
            .residual(0.0, &state, &true_motion, &(), &other)
            .moment,
        0.0,
        300.0 * d,
    );
    // L_O = J_O ω, J_O = J_G + m d².
    let j_o = number(&expected["J_O"]);
    is(j_o, j_g + m * d * d, 1.0);
    is(
        plate.angular_momentum_about_pole(0.0, &state),
        j_o * rate,
        1.0,
    );
}

/// F05: `M_O` contains no velocity of the pole, `dL_O/dt` does.
mod poled {
    newton_euler::rigid_body!(Poled {
        motion: planar,
        params: [o_x, o_y],
        mass: 2[kg],
        inertia: 0.35[kg * m ^ 2],
        pole: world(o_x, o_y),
        outputs: [balance, momentum],
    });
}

#[test]
fn f05_moving_pole() {
    let expected = statement("F05 moving pole");
    let [v_g, a_g, v_o] =
        [[1.5, -0.4], [0.7, 2.1], [-2.0, 0.8]].map(|pair: [f64; 2]| Vector2::from(pair));
    let [center, pole] = [[0.6, 0.2], [-0.3, 0.9]].map(|pair: [f64; 2]| Vector2::from(pair));
    let [rate, alpha] = [0.8, 1.9]; // the rate itself does not matter
    let about =
        |o: Vector2<f64>| poled::Poled::new(poled::PoledParams { o_x: o.x, o_y: o.y }).unwrap();
    let at = |t: f64| Planar {
        position: center + v_g * t + a_g * (t * t / 2.0),
        angle: 0.0,
        velocity: v_g + a_g * t,
        angular_velocity: rate + alpha * t,
    };
    let acceleration = PlanarAcceleration {
        linear: a_g,
        angular: alpha,
    };
    let moment = -about(pole)
        .residual(0.0, &at(0.0), &acceleration, &(), &())
        .moment;
    let m_o = number(&expected["M_O (=-inertial moment about O)"]);
    is(moment, m_o, 5.0);

    // L_O is a cubic of time here, for which this difference is exact: rounding of 6 · 1e-16 / (h/6) only.
    let momentum = |t: f64| about(pole + v_o * t).angular_momentum_about_pole(0.0, &at(t));
    let h = 0.25;
    let rate_of_l = (8.0 * (momentum(h) - momentum(-h)) - (momentum(2.0 * h) - momentum(-2.0 * h)))
        / (12.0 * h);
    is(rate_of_l, number(&expected["dL_O/dt"]), 50.0);
    let p = about(pole).linear_momentum(&at(0.0));
    is(rate_of_l + v_o.perp(&p), m_o, 50.0);
}
