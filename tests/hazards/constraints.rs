//! H15, H17, H18: constraints over time, constraints that cannot be solved, and constraints in
//! mixed scales.

use std::f64::consts::FRAC_PI_2;

use nalgebra::Vector2;
use newton_euler::body::Singular;
use newton_euler::integrate::{self, Classical4, Fixed, Projected};
use newton_euler::prelude::*;

use crate::exact::{Real, ULP, real, relative_to, worse};
use crate::steps;
use crate::table::Record;

/// A pendulum of given numbers, its pin as a constraint.
mod pendulum {
    newton_euler::rigid_body!(Constrained {
        motion: planar,
        mass: 2.7[kg],
        inertia: 0.18[kg * m ^ 2],
        points: [pin = (0, 0.35)[m]],
        fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
        constraints: [held = pin.position()],
        reactions: [hinge = world(_, _).at(pin)],
    });
}

fn hanging(angle: f64, rate: f64, length: f64) -> Planar {
    let (sine, cosine) = angle.sin_cos();
    Planar {
        position: Vector2::new(length * sine, -length * cosine),
        angle,
        velocity: Vector2::new(length * cosine, length * sine) * rate,
        angular_velocity: rate,
    }
}

/// How far the pin is from the origin of the world.
fn gap(state: &Planar) -> f64 {
    let (sine, cosine) = state.angle.sin_cos();
    (state.position + Vector2::new(-sine, cosine) * 0.35).norm()
}

pub fn drift() -> Vec<Record> {
    let (body, start, h) = (pendulum::Constrained {}, hanging(0.7, -1.3, 0.35), 0.01);
    let mut records = Vec::new();
    for (count, by) in [(100, 1e-9), (1000, 1e-8), (10_000, 1e-6)] {
        let end = f64::from(count) * h;
        let free = integrate::cf4(
            &body,
            &start,
            &(),
            0.0..end,
            usize::try_from(count).expect("a number"),
        );
        let method = Projected(Fixed {
            method: Classical4,
            step: h,
        });
        let kept = body
            .integrate(&start)
            .method(method)
            .to(end)
            .expect("a motion");
        records.push(
            Record::fails(
                format!("`Projected<Fixed<Classical4>>`, {end} s"),
                gap(&free),
                by,
            )
            .ours(gap(&kept), 1e-12),
        );
    }
    let count = steps(1_000_000);
    let end = f64::from(count) * h;
    let method = Projected(Fixed {
        method: Classical4,
        step: h,
    });
    let motion = body.integrate(&start).method(method);
    let largest = motion.steps(end).fold(0.0, |largest, step| {
        worse(largest, gap(&step.expect("a motion").state))
    });
    records.push(
        Record::alone(format!("the same, {count} steps, the largest of all")).ours(largest, 1e-12),
    );
    records
}

mod toggle {
    newton_euler::rigid_body!(Toggle {
        doc: "A slider that is held on y = 0 by a push along an axis of the body: of no use where that lies along x.",
        motion: planar,
        mass: 1[kg],
        inertia: 1[kg * m ^ 2],
        fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
        constraints: [line = position.in_world().y],
        reactions: [push = body(0, _)],
        outputs: [reactions],
    });

    newton_euler::rigid_body!(Chalk {
        doc: "Painlevé's rod: it slides on its end, with friction 4/3, at which its normal force is undetermined at tan θ = 2.",
        motion: planar,
        mass: 1[kg],
        inertia: rod(1[m]),
        points: [end = (-0.5, 0)[m]],
        fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
        constraints: [ground = end.position().in_world().y],
        reactions: [contact = (_ * world(4, 3)).at(end)],
        outputs: [reactions],
    });
}

/// The force that is given, of which there is none where a configuration is refused.
fn given(force: Result<Vector2<f64>, Singular>) -> f64 {
    force.map_or(0.0, |force| force.norm())
}

/// Of the contact's normal force with friction 4/3, by `N (1 + 3 cos θ (cos θ - 4/3 sin θ)) = m g`, at rest.
fn divisor(angle: &Real) -> Real {
    let (sine, cosine) = (angle.sin(), angle.cos());
    let three = real(3.0);
    real(1.0) + &cosine * (&three * &cosine - real(4.0) * sine)
}

pub fn toggles() -> Vec<Record> {
    let slider = |angle: f64| {
        let state = Planar {
            angle,
            ..Planar::default()
        };
        toggle::Toggle {}.reactions(0.0, &state, &())
    };
    let chalk = |angle: f64| {
        let (sine, cosine) = angle.sin_cos();
        let position = Vector2::new(cosine, sine) / 2.0;
        let state = Planar {
            angle,
            position,
            ..Planar::default()
        };
        toggle::Chalk {}.reactions(0.0, &state, &())
    };
    let critical = 2.0_f64.atan();
    let (sine, cosine) = critical.sin_cos();
    let mut records = vec![
        Record::fails("slider, at 90°", 9.80665 / FRAC_PI_2.cos(), 1e15).ours(
            given(slider(FRAC_PI_2).map(|reactions| reactions.push)),
            0.0,
        ),
        Record::fails(
            "Painlevé's rod, at tan θ = 2",
            9.80665 / (1.0 + cosine * (3.0 * cosine - 4.0 * sine)),
            1e15,
        )
        .ours(
            given(chalk(critical).map(|reactions| reactions.contact)),
            0.0,
        ),
    ];
    for beside in [1e-3, 1e-6] {
        let angle = FRAC_PI_2 - beside;
        let exact = real(9.80665) / real(angle).cos();
        let ours = slider(angle).map_or(f64::NAN, |reactions| {
            relative_to(reactions.push.norm(), &exact)
        });
        let plain = relative_to(9.80665 / angle.cos(), &exact);
        records.push(
            Record::holds(format!("slider, {beside:.0e} rad before"), plain).ours(ours, 4.0 * ULP),
        );

        let angle = critical - beside;
        let exact = real(9.80665) / divisor(&real(angle));
        let ours = chalk(angle).map_or(f64::NAN, |reactions| {
            relative_to(reactions.contact.y, &exact)
        });
        let (sine, cosine) = angle.sin_cos();
        let plain = relative_to(
            9.80665 / (1.0 + cosine * (3.0 * cosine - 4.0 * sine)),
            &exact,
        );
        // the divisor is what is left of terms of order one: it touches zero at the critical angle
        let left = divisor(&real(angle)).to_f64().value();
        records.push(
            Record::holds(format!("Painlevé's rod, {beside:.0e} rad before"), plain)
                .ours(ours, 16.0 * ULP / left),
        );
    }
    records
}

mod mixed {
    newton_euler::rigid_body!(Constrained {
        motion: planar,
        params: [m[kg], j[kg * m ^ 2]],
        mass: m,
        inertia: j,
        points: [pin = (0, 0.35)[m]],
        fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
        constraints: [held = pin.position()],
        reactions: [hinge = world(_, _).at(pin)],
    });

    newton_euler::rigid_body!(Supported {
        motion: pivot(pin),
        params: [m[kg], j[kg * m ^ 2]],
        mass: m,
        inertia: j,
        points: [pin = (0, 0.35)[m]],
        fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    });
}

/// The five equations of pin and body in one matrix, by Gauss's method, with a pivot below 1e-10 taken for nothing.
fn by_absolute_pivots(m: f64, j: f64, angle: f64) -> f64 {
    let (sine, cosine) = angle.sin_cos();
    let r = Vector2::new(-0.35 * sine, 0.35 * cosine); // from G to the pin
    let mut rows = [
        [m, 0.0, 0.0, -1.0, 0.0, 0.0],
        [0.0, m, 0.0, 0.0, -1.0, -m * 9.80665],
        [0.0, 0.0, j, r.y, -r.x, 0.0],
        [1.0, 0.0, -r.y, 0.0, 0.0, 0.0],
        [0.0, 1.0, r.x, 0.0, 0.0, 0.0],
    ];
    for k in 0..5 {
        let pivot = (k..5)
            .max_by(|a, b| rows[*a][k].abs().total_cmp(&rows[*b][k].abs()))
            .expect("a row");
        rows.swap(k, pivot);
        if rows[k][k].abs() < 1e-10 {
            return f64::NAN;
        }
        for i in (0..5).filter(|i| *i != k) {
            let factor = rows[i][k] / rows[k][k];
            let above = rows[k];
            for (entry, above) in rows[i].iter_mut().zip(above) {
                *entry -= factor * above;
            }
        }
    }
    rows[2][5] / rows[2][2]
}

pub fn mixed_scales() -> Vec<Record> {
    let (angle, d): (f64, f64) = (0.7, 0.35);
    let mut records = Vec::new();
    for (m, j) in [
        (1e-9, 1e12),
        (1e12, 1e-9),
        (1e12, 1e12),
        (1.0, 1e-3),
        (1.0, 1e-8),
    ] {
        let moment = real(m) * real(d) * real(9.80665) * real(angle).sin();
        let exact = -moment / (real(j) + real(m) * real(d) * real(d));
        let plain = relative_to(by_absolute_pivots(m, j, angle), &exact);
        let hinge = Hinge {
            angle,
            angular_velocity: 0.0,
        };
        let supported = mixed::Supported::new(mixed::SupportedParams { m, j }).expect("a body");
        let ours = relative_to(supported.acceleration(0.0, &hinge, &()), &exact);
        let scales = format!("{m:.0e} kg, {j:.0e} kg m²");
        let case = format!("`motion: pivot`, {scales}");
        let record = if m > 1e11 {
            Record::fails(case, plain, 1.0)
        } else {
            Record::holds(case, plain)
        };
        records.push(record.ours(ours, 1e-14));
        // Under a constraint the digits are lost by which m d² exceeds J; beyond all of them, it is refused.
        let ratio = m * d * d / j;
        if ratio < 1e12 {
            let constrained =
                mixed::Constrained::new(mixed::ConstrainedParams { m, j }).expect("a body");
            let state = hanging(angle, 0.0, d);
            let ours = constrained.acceleration(0.0, &state, &()).angular;
            let limit = f64::max(1e-14, 16.0 * ULP * ratio);
            records.push(
                Record::holds(format!("constraint, {scales}"), plain)
                    .ours(relative_to(ours, &exact), limit),
            );
        }
    }
    records
}
