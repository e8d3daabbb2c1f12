//! H3, H3b: bodies far from the point that they are described from.

use dashu_ratio::RBig;
use nalgebra::{Matrix3, Vector3};
use newton_euler::prelude::*;
use newton_euler::state::generic;

use crate::exact::{
    Tensor, ULP, ULP32, decimal, nearest, of_points, rational, relative, symmetric, to_f32, worse,
};
use crate::table::Record;

/// The numbers of a ball of 2 kg, `J_G = 0.004`, given about a point that is far away, and of three mass points drawn from there.
macro_rules! far {
    ($($module:ident: $far:tt),+) => {
        $(mod $module {
            newton_euler::rigid_body!(Ball {
                motion: rotation,
                mass: 2[kg],
                inertia: principal(0.004, 2 * $far * $far + 0.004, 2 * $far * $far + 0.004)
                    .about(($far, 0, 0)[m]),
                outputs: [momentum],
            });
            newton_euler::rigid_body!(Frame {
                motion: rotation,
                inertia: compose([
                    point(1).at(($far, 0, 0)),
                    point(2).at(($far + 0.03, 0.04, 0)),
                    point(1.5).at(($far, 0, 0.05)),
                ]),
                outputs: [momentum],
            });
        })+

        /// The distance, and the tensors of both.
        fn far() -> Vec<(f64, [Matrix3<f64>; 2])> {
            vec![$(($far, [tensor(&$module::Ball {}), tensor(&$module::Frame {})])),+]
        }
    };
}

far! { far_3: 1e3, far_5: 1e5, far_7: 1e7 }

/// The tensor of a body, column by column.
fn tensor<B>(body: &B) -> Matrix3<f64>
where
    B: Momentum<Scalar = f64, State = Rotation, Angular = Vector3<f64>>,
{
    let column = |angular_velocity| {
        body.angular_momentum(&Rotation {
            angular_velocity,
            ..Rotation::default()
        })
    };
    Matrix3::from_columns(&[Vector3::x(), Vector3::y(), Vector3::z()].map(column))
}

/// The largest error of an entry over the largest entry.
fn off_tensor(computed: &Matrix3<f64>, exact: &Tensor) -> f64 {
    let rows = exact.iter().enumerate();
    let errors = rows.flat_map(|(i, row)| {
        let entries = row.iter().enumerate();
        entries.map(move |(k, entry)| nearest(&(rational(computed[(i, k)]) - entry)).abs())
    });
    let largest = exact.iter().flatten().map(nearest).fold(0.0, f64::max);
    errors.fold(0.0, worse) / largest
}

/// `m (r^2 1 - r r)`, entry by entry.
fn displaced(m: f64, r: &Vector3<f64>) -> Matrix3<f64> {
    (Matrix3::identity() * r.norm_squared() - r * r.transpose()) * m
}

/// The tensor about the origin, less that of all mass in G.
fn one_pass(points: &[(f64, Vector3<f64>)]) -> Matrix3<f64> {
    let mass: f64 = points.iter().map(|(m, _)| m).sum();
    let moment: Vector3<f64> = points.iter().map(|(m, at)| at * *m).sum();
    let about_origin: Matrix3<f64> = points.iter().map(|(m, at)| displaced(*m, at)).sum();
    about_origin - displaced(mass, &(moment / mass))
}

pub fn parallel_axes() -> Vec<Record> {
    let ball = symmetric(["0.004", "0.004", "0.004", "0", "0", "0"].map(decimal));
    let near = [
        (1.0, Vector3::zeros()),
        (2.0, Vector3::new(0.03, 0.04, 0.0)),
        (1.5, Vector3::new(0.0, 0.0, 0.05)),
    ];
    // of the decimals: in whole centimeters
    let (_, _, centimeters) =
        of_points(&near.map(|(m, at)| (m, at.map(|x: f64| (100.0 * x).round()))));
    let frame = centimeters.map(|row| row.map(|entry| entry / RBig::from(10_000)));
    let mut records = Vec::new();
    for (far, [of_ball, of_frame]) in far() {
        let at = Vector3::new(far, 0.0, 0.0);
        let about_point = Matrix3::identity() * 0.004 + displaced(2.0, &at);
        let plain = off_tensor(&(about_point - displaced(2.0, &at)), &ball);
        let case = format!("numbers, `.about(P)` at {far:.0e} m");
        records.push(
            Record::fails(case, plain, 1e-17 * far * far)
                .ours(off_tensor(&of_ball, &ball), 4.0 * ULP),
        );
        let plain = off_tensor(&one_pass(&near.map(|(m, r)| (m, r + at))), &frame);
        let case = format!("numbers, `compose([..])` at {far:.0e} m");
        records.push(
            Record::fails(case, plain, 1e-15 * far).ours(off_tensor(&of_frame, &frame), 4.0 * ULP),
        );
    }
    records.push(subtracted());
    records
}

/// From a point to G the runtime subtracts, and says so: as many digits are lost as `m d²` has more than `J_G`.
fn subtracted() -> Record {
    let (at, ball) = (Vector3::new(10.0, 0.0, 0.0), [0.004; 3]);
    let about_point = Matrix3::from_diagonal(&ball.into()) + displaced(2.0, &at);
    let exact = symmetric(["0.004", "0.004", "0.004", "0", "0", "0"].map(decimal));
    let tensor = InertiaTensor::from_matrix(&about_point).expect("a body");
    let moved = tensor.shifted_to_center(2.0, &at).expect("a body");
    let plain = off_tensor(&(about_point - displaced(2.0, &at)), &exact);
    Record::holds(
        "runtime, `shifted_to_center` from 10 m, which subtracts",
        plain,
    )
    .ours(
        off_tensor(&moved.matrix(), &exact),
        ULP * 2.0 * 100.0 / 0.004,
    )
}

rigid_body!(Cloud::<T> {
    motion: rotation,
    params: [
        a = body(_, _, _)[m],
        b = body(_, _, _)[m],
        c = body(_, _, _)[m],
        d = body(_, _, _)[m],
    ],
    points: [at_a = a, at_b = b, at_c = c, at_d = d],
    inertia: compose([
        point(1).at(at_a),
        point(2).at(at_b),
        point(1.5).at(at_c),
        point(0.5).at(at_d),
    ]),
    outputs: [momentum],
});

/// Within a centimeter of a far origin, as doubles are there.
fn cloud(far: f64) -> Vec<(f64, Vector3<f64>)> {
    let grid = |k: i32, step: i32| f64::from((k * step) % 97 - 48) * 1e-4;
    let places = (0..40).map(|k| Vector3::new(grid(k, 31), grid(k, 57), grid(k, 83)));
    let masses = [1.0, 2.0, 1.5, 0.5].into_iter().cycle();
    masses
        .zip(places.map(|at| at + Vector3::new(far, -far, far)))
        .collect()
}

pub fn far_clouds() -> Vec<Record> {
    let mut records = Vec::new();
    for far in [1e6, 1e7] {
        let points = cloud(far);
        let (_, _, exact) = of_points(&points);
        let plain = off_tensor(&one_pass(&points), &exact);
        let found = InertiaTensor::from_points(points.iter().copied()).expect("a body");
        let case = format!("runtime, 40 points at {far:.0e} m");
        records.push(
            Record::fails(case, plain, 1.0)
                .ours(off_tensor(&found.inertia.matrix(), &exact), 1e-13),
        );

        let four = &points[..4];
        let (_, _, exact) = of_points(four);
        let plain = off_tensor(&one_pass(four), &exact);
        let [a, b, c, d] = [0, 1, 2, 3].map(|k: usize| four[k].1);
        let body = Cloud::new(CloudParams { a, b, c, d }).expect("a body");
        let case = format!("params, 4 points at {far:.0e} m");
        records
            .push(Record::fails(case, plain, 1.0).ours(off_tensor(&tensor(&body), &exact), 1e-13));
    }
    records.push(single_cloud());
    records
}

/// A hundred meters away, where single precision has grains of 8 μm.
fn single_cloud() -> Record {
    let places = [0, 1, 2, 3].map(|k: usize| cloud(100.0)[k].1.map(to_f32));
    let [a, b, c, d] = places;
    let masses = [1.0_f32, 2.0, 1.5, 0.5];
    let double = |m: f32, at: Vector3<f32>| (f64::from(m), at.map(f64::from));
    let points: Vec<_> = masses
        .into_iter()
        .zip(places)
        .map(|(m, at)| double(m, at))
        .collect();
    let (_, _, exact) = of_points(&points);
    let moment: Vector3<f32> = masses.iter().zip(&places).map(|(m, at)| at * *m).sum();
    let second: f32 = masses
        .iter()
        .zip(&places)
        .map(|(m, at)| m * (at.x * at.x + at.y * at.y))
        .sum();
    let center = moment / 5.0;
    let plain = second - 5.0 * (center.x * center.x + center.y * center.y);
    let body = Cloud::new(CloudParams { a, b, c, d }).expect("a body");
    let momentum = body.angular_momentum(&generic::Rotation {
        angular_velocity: Vector3::z(),
        ..generic::Rotation::default()
    });
    let plain = relative(f64::from(plain), &exact[2][2]);
    let ours = relative(f64::from(momentum.z), &exact[2][2]);
    Record::fails("params, 4 points at 1e2 m, f32", plain, 1.0).ours(ours, 8.0 * ULP32)
}
