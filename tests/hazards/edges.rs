//! H2: moments of nearly equal edges.

use dashu_ratio::RBig;
use nalgebra::Vector3;
use newton_euler::Scalar;
use newton_euler::prelude::*;
use newton_euler::state::generic;

use crate::exact::{ULP, ULP32, decimal, nearest, rational, relative, worse};
use crate::table::Record;

/// Boxes 1 x 0.3 x c, with c next to 0.3: with ω = (0, 1, 1), `ω_x' = (J_y - J_z)/J_x = (c² - b²)/(b² + c²)`.
macro_rules! boxes {
    ($($module:ident: $c:tt),+) => {
        $(mod $module {
            newton_euler::rigid_body!(Bar::<T> {
                motion: rotation,
                mass: 1.7[kg],
                inertia: cuboid(1, 0.3, $c),
            });
        })+

        /// The edge as it is written, and what the body says.
        fn baked() -> Vec<(&'static str, f64, f64)> {
            vec![$((
                stringify!($c),
                coupling(&$module::Bar::<f64>::default()),
                f64::from(coupling(&$module::Bar::<f32>::default())),
            )),+]
        }
    };
}

boxes! {
    box_3: 0.3003,
    box_6: 0.3000003,
    box_9: 0.3000000003,
    box_12: 0.3000000000003,
    box_14: 0.300000000000003
}

rigid_body!(Bar::<T> {
    motion: rotation,
    params: [m[kg], a[m], b[m], c[m]],
    mass: m,
    inertia: cuboid(a, b, c),
});

/// Edges of numbers beside one that is a parameter, of numbers that doubles are not.
mod beside {
    newton_euler::rigid_body!(Bar {
        motion: rotation,
        params: [c = 0.4[m]],
        mass: 1.7[kg],
        inertia: cuboid(1, 0.3, c),
    });
}

/// The same with a multiple of it.
mod multiple {
    newton_euler::rigid_body!(Bar {
        motion: rotation,
        params: [c = 0.1[m]],
        mass: 1.7[kg],
        inertia: ellipsoid(1, 0.3, 3 * c),
    });
}

fn coupling<T: Scalar, B>(body: &B) -> T
where
    B: RigidBody<Scalar = T, State = generic::Rotation<T>, Input = ()>,
{
    let [zero, one] = [T::default(), T::default().constant(1.0, 1.0)];
    let state = generic::Rotation {
        angular_velocity: Vector3::new(zero, one, one),
        ..generic::Rotation::default()
    };
    body.acceleration(zero, &state, &()).x
}

/// `(c² - b²)/(b² + c²)`
fn exact_coupling(b: &RBig, c: &RBig) -> RBig {
    (c * c - b * b) / (b * b + c * c)
}

/// Moments first, then their difference.
fn straightforward_coupling([m, a, b, c]: [f64; 4]) -> f64 {
    let moment = |x: f64, y: f64| m / 12.0 * (x * x + y * y);
    (moment(a, c) - moment(a, b)) / moment(b, c)
}

pub fn nearly_equal() -> Vec<Record> {
    let (mut records, mut in_single) = (Vec::new(), 0.0);
    for (digits, double, single) in baked() {
        let c = decimal(digits);
        let expected = exact_coupling(&decimal("0.3"), &c);
        let plain = straightforward_coupling([1.7, 1.0, 0.3, nearest(&c)]);
        let error = relative(plain, &expected);
        let (of, by) = (
            format!("numbers, c - b = {:.0e}", nearest(&c) - 0.3),
            ULP * 0.1 / (nearest(&c) - 0.3),
        );
        records.push(Record::fails(of, error, by).ours(relative(double, &expected), 4.0 * ULP));
        in_single = worse(in_single, relative(single, &expected));
    }
    records.push(Record::alone("numbers, all of these, f32").ours(in_single, 4.0 * ULP32));
    let edges = [
        0.3003,
        0.300_000_3,
        0.300_000_000_3,
        0.300_000_000_000_3,
        0.300_000_000_000_003,
    ];
    for c in edges {
        let [m, a, b] = [1.7, 1.0, 0.3];
        let expected = exact_coupling(&rational(b), &rational(c));
        let plain = relative(straightforward_coupling([m, a, b, c]), &expected);
        let bar = Bar::new(BarParams { m, a, b, c }).expect("a bar");
        let ours = relative(coupling(&bar), &expected);
        let by = ULP * 0.1 / (c - b);
        records.push(
            Record::fails(format!("params, c - b = {:.0e}", c - b), plain, by)
                .ours(ours, 4.0 * ULP),
        );
    }
    let b = decimal("0.3");
    for c in edges {
        let plain = straightforward_coupling([1.7, 1.0, 0.3, c]);
        let by = ULP * 0.1 / (c - 0.3);
        let expected = exact_coupling(&b, &rational(c));
        let bar = beside::Bar::new(beside::BarParams { c }).expect("a bar");
        let ours = relative(coupling(&bar), &expected);
        // a third of it, of which 3 c is not rounded
        let third = c / 3.0;
        let exact_third = exact_coupling(&b, &(rational(third) * rational(3.0)));
        let egg = multiple::Bar::new(multiple::BarParams { c: third }).expect("an egg");
        let of_third = relative(coupling(&egg), &exact_third);
        let name = format!("a number and a param, c - b = {:.0e}", c - 0.3);
        records.push(
            Record::fails(name, relative(plain, &expected), by)
                .ours(worse(ours, of_third), 4.0 * ULP),
        );
    }
    records
}
