//! A four-bar with a driven crank: torque and pin forces over a turn.
//!
//! A `driven` joint turns the crank at constant speed, and the rocker works against a moment. At
//! each angle `project` closes the loop; the balances give the torque and the forces of
//! all pins.
//!
//! Asserts: all of them agree with hand-derived kinetostatics. Angles come from the triangle of the
//! diagonal, rates and accelerations from the derivatives of the loop, forces from Newton's and
//! Euler's laws of the three bodies, nine equations with the torque and four forces as unknowns.

use newton_euler::nalgebra::{Matrix, Matrix2, SMatrix, SVector, Vector2};
use newton_euler::prelude::*;

rigid_system!(FourBar {
    doc: "Crank, coupler and rocker; angles counterclockwise.",
    motion: planar,
    params: [speed = 12[rad / s]],
    bodies: [
        crank {
            mass: 0.4[kg],
            inertia: 4e-4[kg * m ^ 2],
            points: [o = (-0.04, 0), a = (0.06, 0)],
        },
        coupler {
            mass: 1.1[kg],
            inertia: 0.012[kg * m ^ 2],
            points: [a = (-0.16, 0), b = (0.19, 0)],
        },
        rocker {
            mass: 0.8[kg],
            inertia: 4.5e-3[kg * m ^ 2],
            points: [c = (-0.11, 0), b = (0.14, 0)],
        },
    ],
    joints: [
        o = revolute(world(0, 0), crank.o).driven(speed * t),
        a = revolute(crank.a, coupler.a),
        b = revolute(coupler.b, rocker.b),
        c = revolute(world(0.3, 0), rocker.c),
    ],
    moments: [load = moment(-0.6[N * m]).on(rocker)],
    outputs: [reactions],
});

/// Along an angle, and across it.
fn unit(angle: f64) -> [Vector2<f64>; 2] {
    let (sine, cosine) = angle.sin_cos();
    [Vector2::new(cosine, sine), Vector2::new(-sine, cosine)]
}

/// Angles, rates and accelerations of crank, coupler and rocker, by hand: `0.1 e1 + 0.35 e2 = C +
/// 0.25 e3`.
fn moved(angle: f64, rate: f64) -> [[f64; 3]; 3] {
    let diagonal = Vector2::new(0.3, 0.0) - 0.1 * unit(angle)[0];
    let long = diagonal.norm();
    let opening = ((0.35_f64.powi(2) + long * long - 0.25_f64.powi(2)) / (0.7 * long)).acos();
    let coupler = diagonal.y.atan2(diagonal.x) + opening;
    let arm = 0.35 * unit(coupler)[0] - diagonal;
    let angles = [angle, coupler, arm.y.atan2(arm.x)];
    let [[e1, n1], [e2, n2], [e3, n3]] = angles.map(unit);
    let slopes = Matrix2::from_columns(&[0.35 * n2, -0.25 * n3]).lu();
    let rates = slopes.solve(&(-0.1 * rate * n1)).expect("no dead point");
    let [w2, w3] = [rates.x, rates.y];
    let inwards = 0.1 * rate * rate * e1 + 0.35 * w2 * w2 * e2 - 0.25 * w3 * w3 * e3;
    let bent = slopes.solve(&inwards).expect("no dead point");
    [angles, [rate, w2, w3], [0.0, bent.x, bent.y]]
}

/// The torque, and the forces of o, a, b and c on the bodies that they carry, by hand.
fn by_hand([angles, rates, bent]: [[f64; 3]; 3]) -> SVector<f64, 9> {
    let turned = |body: usize, arm: f64| {
        let [e, n] = unit(angles[body]);
        arm * (bent[body] * n - rates[body] * rates[body] * e)
    };
    let centers = [
        turned(0, 0.04),
        turned(0, 0.1) + turned(1, 0.16),
        turned(2, 0.11),
    ];
    let (mut balances, mut right) = (SMatrix::<f64, 9, 9>::zeros(), SVector::<f64, 9>::zeros());
    let bodies = [(0.4, 4e-4), (1.1, 0.012), (0.8, 4.5e-3)];
    // for each body: its pins, by number, the sign of the force on it, and their distances along it
    let pins = [
        [(0, 1.0, -0.04), (1, -1.0, 0.06)],
        [(1, 1.0, -0.16), (2, -1.0, 0.19)],
        [(2, 1.0, 0.14), (3, 1.0, -0.11)],
    ];
    for (body, (mass, inertia)) in bodies.into_iter().enumerate() {
        for (pin, sign, place) in pins[body] {
            let arm = place * unit(angles[body])[0];
            let (row, column) = (3 * body, 1 + 2 * pin);
            balances[(row, column)] = sign;
            balances[(row + 1, column + 1)] = sign;
            balances[(row + 2, column)] = -sign * arm.y;
            balances[(row + 2, column + 1)] = sign * arm.x;
        }
        let force = mass * centers[body];
        right.fixed_rows_mut::<2>(3 * body).copy_from(&force);
        right[3 * body + 2] = inertia * bent[body];
    }
    balances[(2, 0)] = 1.0;
    right[8] += 0.6;
    balances.lu().solve(&right).expect("no dead point")
}

fn main() {
    let (linkage, speed) = (FourBar::default(), 12.0);
    let mut state = FourBarState::default();
    println!("crank   torque, N m    |o|, N    |a|, N    |b|, N    |c|, N");
    for step in 0..=24 {
        let angle = f64::from(step) * core::f64::consts::TAU / 24.0;
        let hand = moved(angle, speed);
        if step == 0 {
            let [[first, second, third], ..] = hand;
            state.a.angle = second - first;
            state.b.angle = third - second;
        }
        linkage
            .project(angle / speed, &mut state, &())
            .expect("the loop closes at each angle");
        let found = linkage.reactions(angle / speed, &state, &());
        let forces = [found.o, found.a, found.b, found.c].map(|pin| pin.force);
        let all = core::iter::once(&found.o_drive).chain(forces.iter().flat_map(Matrix::as_slice));
        let expected = by_hand(hand);
        let off = all
            .zip(&expected)
            .map(|(one, other)| (one - other).abs())
            .fold(0.0, f64::max);
        assert!(off < 1e-12 * expected.amax(), "{off:e}");
        let [o, a, b, c] = forces.map(|force| force.norm());
        println!(
            "{:4}°  {:11.4} {o:9.3} {a:9.3} {b:9.3} {c:9.3}",
            15 * step,
            found.o_drive
        );
    }
}
