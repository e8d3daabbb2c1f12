//! Constant tensors whose principal axes are not the body axes, compared with Euler's equations
//! solved in exact rational arithmetic.

use dashu_ratio::RBig;
use nalgebra::Vector3;
use newton_euler::prelude::*;
use proptest::prelude::*;

use crate::oracle::{Sum, is, is_scalar, rotation, vectors};

type Exact = [RBig; 3];
/// By rows.
type Tensor = [Exact; 3];

fn exact(vector: Vector3<f64>) -> Exact {
    [vector.x, vector.y, vector.z].map(|component| RBig::try_from(component).unwrap())
}

fn rounded(vector: &Exact) -> Vector3<f64> {
    Vector3::from(vector.each_ref().map(nearest))
}

fn nearest(number: &RBig) -> f64 {
    number.to_f64().value()
}

/// A decimal, or a fraction of two.
fn number(digits: &str) -> RBig {
    if let Some((above, below)) = digits.split_once('/') {
        return number(above) / number(below);
    }
    let (mantissa, exponent) = digits.split_once('e').unwrap_or((digits, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let integer: RBig = format!("{whole}{fraction}").parse().unwrap();
    let exponent = exponent.parse::<isize>().unwrap() - fraction.len().cast_signed();
    integer * RBig::from(10).pow(exponent)
}

fn tensor([xx, yy, zz, xy, yz, zx]: [&str; 6]) -> Tensor {
    let [xx, yy, zz, xy, yz, zx] = [xx, yy, zz, xy, yz, zx].map(number);
    [
        [xx, xy.clone(), zx.clone()],
        [xy, yy, yz.clone()],
        [zx, yz, zz],
    ]
}

/// `across 1 + (along - across) n n / n.n`
fn symmetric(across: &str, along: &str, n: [&str; 3]) -> Tensor {
    let (across, along, n) = (number(across), number(along), n.map(number));
    let square = dot(&n, &n);
    core::array::from_fn(|i| {
        core::array::from_fn(|k| {
            let dyad = &n[i] * &n[k] / &square;
            let unit = if i == k { RBig::ONE } else { RBig::ZERO };
            &across * (unit - &dyad) + &along * dyad
        })
    })
}

/// Of a body with these principal moments along (1, 2, 2), (2, 1, -2) and (-2, 2, -1), over 3.
fn turned(moments: [&str; 3]) -> Tensor {
    let axes = [["1", "2", "2"], ["2", "1", "-2"], ["-2", "2", "-1"]].map(|axis| axis.map(number));
    let moments = moments.map(number);
    core::array::from_fn(|i| {
        core::array::from_fn(|k| {
            (0..3).fold(RBig::ZERO, |sum, axis| {
                sum + &moments[axis] * &axes[axis][i] * &axes[axis][k] / RBig::from(9)
            })
        })
    })
}

fn dot(a: &Exact, b: &Exact) -> RBig {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

fn cross(a: &Exact, b: &Exact) -> Exact {
    [(1, 2), (2, 0), (0, 1)].map(|(i, k)| &a[i] * &b[k] - &a[k] * &b[i])
}

fn times(j: &Tensor, a: &Exact) -> Exact {
    j.each_ref().map(|row| dot(row, a))
}

/// By cofactors.
fn solved(j: &Tensor, right: &Exact) -> Exact {
    let cofactors = [
        cross(&j[1], &j[2]),
        cross(&j[2], &j[0]),
        cross(&j[0], &j[1]),
    ];
    let determinant = dot(&j[0], &cofactors[0]);
    times(&cofactors, right).map(|component| component / &determinant)
}

/// `J w' = M - w x J w`. The gyroscopic term is as large as `coupling w^2`, the other as `M` over the least moment.
fn euler(j: &Tensor, w: Vector3<f64>, moment: Vector3<f64>, [coupling, least]: [f64; 2]) -> Sum<3> {
    let (rate, driving) = (exact(w), exact(moment));
    let gyroscopic = cross(&rate, &times(j, &rate));
    let net = core::array::from_fn(|i| &driving[i] - &gyroscopic[i]);
    Sum {
        value: rounded(&solved(j, &net)),
        largest: (coupling * w.norm_squared()).max(moment.norm() / least),
    }
}

/// A body left alone and one under a couple, at 1000 random states each; coupling is the largest of
/// `(J_2 - J_3) / J_1`, least the least moment.
macro_rules! bodies {
    ($module:ident, { $($body:tt)* }, $tensor:expr, coupling: $coupling:expr, least: $least:expr) => {
        mod $module {
            use super::*;

            mod described {
                newton_euler::rigid_body!(Free {
                    motion: rotation,
                    $($body)*
                    outputs: [energy, momentum],
                });
                newton_euler::rigid_body!(Driven {
                    motion: rotation,
                    inputs: [couple = body(_, _, _)],
                    $($body)*
                    moments: [drive = couple],
                });
            }

            proptest! {
                #![proptest_config(ProptestConfig::with_cases(1000))]

                #[test]
                fn turns(state in rotation(), couple in vectors(8.0)) {
                    let (w, q, j): (_, _, Tensor) = (state.angular_velocity, state.attitude, $tensor);
                    let sizes = [$coupling, $least];
                    let free = described::Free::default();
                    let expected = euler(&j, w, Vector3::zeros(), sizes);
                    is(&free.acceleration(0.0, &state, &()), &expected)?;
                    let driven = described::Driven::default();
                    let expected = euler(&j, w, couple, sizes);
                    is(&driven.acceleration(0.0, &state, &described::DrivenInput { couple }), &expected)?;

                    let rate = exact(w);
                    let momentum = times(&j, &rate);
                    let largest = j.iter().flatten().map(|entry| nearest(entry).abs()).fold(0.0, f64::max);
                    let spin = Sum { value: q * rounded(&momentum), largest: largest * w.norm() };
                    is(&free.angular_momentum(&state), &spin)?;
                    let energy = nearest(&dot(&rate, &momentum)) / 2.0;
                    is_scalar(free.kinetic_energy(&state), energy, largest * w.norm_squared())?;
                }
            }
        }
    };
}

// m (3 r^2 + h^2) / 12 and m r^2 / 2
bodies!(
    tilted_cylinder,
    { mass: 3, inertia: cylinder(0.1, 0.7).along(body(1, 2, 2)), },
    symmetric("0.13", "0.015", ["1", "2", "2"]),
    coupling: 0.115 / 0.13,
    least: 0.015
);
bodies!(
    tilted_disc,
    { mass: 3, inertia: disc(0.5).along(body(-3, 1, 0.2)), },
    symmetric("0.1875", "0.375", ["-3", "1", "0.2"]),
    coupling: 1.0,
    least: 0.1875
);
bodies!(
    thin_cylinder,
    { mass: 1, inertia: cylinder(0.001, 1).along(body(1, 2, 2)), },
    symmetric("1.000003/12", "0.0000005", ["1", "2", "2"]),
    coupling: 1.0,
    least: 5e-7
);
// two balls: 2/5 m r^2 each, and m d^2 / 4 of both across
bodies!(
    dumbbell,
    {
        inertia: compose([
            sphere(0.1).mass(1).at((0, 0, 0)),
            sphere(0.1).mass(1).at((0.1, 0.2, 0.2)),
        ]),
    },
    symmetric("0.053", "0.008", ["1", "2", "2"]),
    coupling: 0.045 / 0.053,
    least: 0.008
);
bodies!(
    full,
    { inertia: tensor { xx: 1.3, yy: 1.7, zz: 2.1, xy: -0.12, yz: -0.05, zx: 0.07 }, },
    tensor(["1.3", "1.7", "2.1", "-0.12", "-0.05", "0.07"]),
    coupling: 0.5,
    least: 1.2
);
bodies!(
    plane_of_symmetry,
    { inertia: tensor { xx: 1.3, yy: 1.7, zz: 2.1, xy: -0.12 }, },
    tensor(["1.3", "1.7", "2.1", "-0.12", "0", "0"]),
    coupling: 0.5,
    least: 1.2
);
// of a Crazyflie 2.0, as its system identification published it
bodies!(
    crazyflie,
    {
        inertia: tensor {
            xx: 1.657171e-5, yy: 1.6655602e-5, zz: 2.9261652e-5,
            xy: 8.30806e-7, yz: 1.800197e-6, zx: 7.18277e-7,
        },
    },
    tensor(["1.657171e-5", "1.6655602e-5", "2.9261652e-5", "8.30806e-7", "1.800197e-6", "7.18277e-7"]),
    coupling: 0.9,
    least: 1.5e-5
);

/// H7: a ball with a small tensor of another form beside it; the coupling is as small as that, and so are the errors
/// of a body left alone.
macro_rules! nearly_spherical {
    ($($module:ident: $epsilon:literal $digits:literal);+ $(;)?) => {
        $(bodies!(
            $module,
            {
                inertia: tensor {
                    xx: 1 + 1.3 * $epsilon, yy: 1 + 1.7 * $epsilon, zz: 1 + 2.1 * $epsilon,
                    xy: -0.12 * $epsilon, yz: -0.05 * $epsilon, zx: 0.07 * $epsilon,
                },
            },
            near_one($digits, ["1.3", "1.7", "2.1", "-0.12", "-0.05", "0.07"]),
            coupling: $epsilon,
            least: 1.0
        );)+
    };
}

/// `1 + epsilon S`
fn near_one(epsilon: &str, s: [&str; 6]) -> Tensor {
    let s = tensor(s);
    core::array::from_fn(|i| {
        core::array::from_fn(|k| {
            let unit = if i == k { RBig::ONE } else { RBig::ZERO };
            unit + number(epsilon) * &s[i][k]
        })
    })
}

nearly_spherical! {
    near_3: 1e-3 "1e-3";
    near_6: 1e-6 "1e-6";
    near_10: 1e-10 "1e-10";
    near_13: 1e-13 "1e-13";
    near_16: 1e-16 "1e-16";
}

/// H1: free, a thin body of three moments turns with errors of a few ulp of `w^2`, however thin.
mod blade {
    newton_euler::rigid_body!(Blade {
        motion: rotation,
        inertia: tensor {
            xx: (1e-7 + 4 + 4 * 0.99999995) / 9,
            yy: (4 * 1e-7 + 1 + 4 * 0.99999995) / 9,
            zz: (4 * 1e-7 + 4 + 0.99999995) / 9,
            xy: (2 * 1e-7 + 2 - 4 * 0.99999995) / 9,
            yz: (4 * 1e-7 - 2 - 2 * 0.99999995) / 9,
            zx: (2 * 1e-7 - 4 + 2 * 0.99999995) / 9
        },
    });
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn a_thin_body_keeps_its_digits(state in rotation()) {
        let w = state.angular_velocity;
        let expected = euler(&turned(["1e-7", "1", "0.99999995"]), w, Vector3::zeros(), [1.0, 1e-7]);
        is(&blade::Blade::default().acceleration(0.0, &state, &()), &expected)?;
    }
}
