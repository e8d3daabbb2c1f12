//! Eigenvalues and eigenvectors of constant tensors: residuals in exact arithmetic.

use mounted::symbolic::{Function, Number, PrincipalAxes, Spectrum, Symmetry};

type Matrix = [[Number; 3]; 3];

fn number(digits: &str) -> Number {
    let (negative, digits) = match digits.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, digits),
    };
    let value = Number::parse(digits).expect("a number");
    if negative { -value } else { value }
}

/// From `xx yy zz xy yz zx`.
fn tensor(entries: &str) -> Matrix {
    let n: Vec<Number> = entries.split_whitespace().map(number).collect();
    let [xx, yy, zz, xy, yz, zx] = n.try_into().expect("six entries");
    [
        [xx, xy.clone(), zx.clone()],
        [xy, yy, yz.clone()],
        [zx, yz, zz],
    ]
}

fn dot(a: &[Number; 3], b: &[Number; 3]) -> Number {
    (0..3).fold(Number::zero(), |sum, i| sum + a[i].clone() * b[i].clone())
}

fn cross(a: &[Number; 3], b: &[Number; 3]) -> [Number; 3] {
    core::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a[j].clone() * b[k].clone() - a[k].clone() * b[j].clone()
    })
}

fn is_small(value: &Number, scale: &Number, digits: i64) {
    let bound = scale.abs() * Number::power_of_ten(-digits);
    assert!(
        value.abs() <= bound,
        "{} of {}",
        value.to_f64(),
        scale.to_f64()
    );
}

/// `J n = lambda n` to 1e-60 of the largest entry.
fn is_eigenvector(j: &Matrix, lambda: &Number, n: &[Number; 3]) {
    let size = (0..3).map(|i| j[i][i].abs()).max().expect("three moments");
    for (row, component) in j.iter().zip(n) {
        let residual = dot(row, n) - lambda.clone() * component.clone();
        is_small(&residual, &size, 60);
    }
}

/// Three different moments, right-handed unit axes.
fn is_general(j: &Matrix) -> ([Number; 3], [[Number; 3]; 3]) {
    let Spectrum::General(principal) = Spectrum::of(j) else {
        panic!("three different moments")
    };
    let PrincipalAxes { moments, axes } = *principal;
    let one = Number::one();
    for k in 0..3 {
        is_eigenvector(j, &moments[k], &axes[k]);
        is_small(&(dot(&axes[k], &axes[k]) - one.clone()), &one, 60);
        let third = cross(&axes[(k + 1) % 3], &axes[(k + 2) % 3]);
        for (a, b) in third.iter().zip(&axes[k]) {
            is_small(&(a.clone() - b.clone()), &one, 60);
        }
    }
    (moments, axes)
}

#[test]
fn full_tensors() {
    for entries in [
        // the tensor of tests/reference/statements.json, F10
        "1.3 1.7 2.1 -0.12 -0.05 0.07",
        // of a Crazyflie 2.0, as its system identification published it
        "1.657171e-5 1.6655602e-5 2.9261652e-5 8.30806e-7 1.800197e-6 7.18277e-7",
        "2 2 3 0.5 0.25 -0.25",
        "1e-9 1.1e-9 1.2e-9 1e-11 2e-11 3e-11",
        "1.3 1.7 2.1 0.12 0 0",
        "1.3 1.7 2.1 0.12 0 0.1",
        "2 2 3 0 0 0.9",
    ] {
        let (moments, axes) = is_general(&tensor(entries));
        for (place, axis) in axes.iter().enumerate() {
            assert!(axis[place].is_positive(), "{entries}: axis {place}");
        }
        let trace = moments
            .into_iter()
            .fold(Number::zero(), |sum, moment| sum + moment);
        let j = tensor(entries);
        let expected = (0..3).fold(Number::zero(), |sum, i| sum + j[i][i].clone());
        is_small(&(trace - expected.clone()), &expected, 60);
    }
}

/// A unit matrix and something small beside it: the axes are those of what is small.
#[test]
fn nearly_equal_moments() {
    let small = tensor("1.3 1.7 2.1 -0.12 -0.05 0.07");
    let (expected, axes) = is_general(&small);
    for exponent in [3, 6, 10, 13, 16, 30] {
        let scale = Number::power_of_ten(-exponent);
        let mut near = small.clone();
        for (i, row) in near.iter_mut().enumerate() {
            for (k, entry) in row.iter_mut().enumerate() {
                *entry = Number::integer(i64::from(i == k)) + scale.clone() * entry.clone();
            }
        }
        let (moments, found) = is_general(&near);
        for k in 0..3 {
            let excess = (moments[k].clone() - Number::one()) / scale.clone();
            is_small(&(excess - expected[k].clone()), &expected[k], 40);
            for (a, b) in found[k].iter().zip(&axes[k]) {
                is_small(&(a.clone() - b.clone()), &Number::one(), 40);
            }
        }
    }
}

/// `across 1 + delta n n`, of any length of n.
fn dyadic(across: &str, delta: &str, n: [&str; 3]) -> Matrix {
    let n = n.map(number);
    core::array::from_fn(|i| {
        core::array::from_fn(|k| {
            let unit = Number::integer(i64::from(i == k));
            number(across) * unit + number(delta) * n[i].clone() * n[k].clone()
        })
    })
}

/// Rational all the way: moments and directions are exact.
#[test]
fn repeated_moments_are_exact() {
    for (n, scaled) in [
        (["1", "2", "-2"], ["0.5", "1", "-1"]),
        (["3", "0", "4"], ["0.75", "0", "1"]),
        (["0", "1", "1"], ["0", "1", "1"]),
        (["1", "1", "1"], ["1", "1", "1"]),
        (["1", "0.001", "0"], ["1", "0.001", "0"]),
    ] {
        for delta in ["0.03", "-0.04", "1e-13"] {
            let j = dyadic("1.7", delta, n);
            let Spectrum::Symmetric(symmetry) = Spectrum::of(&j) else {
                panic!("{n:?} is an axis of symmetry")
            };
            let Symmetry {
                across,
                along,
                axis,
            } = *symmetry;
            assert_eq!(across, number("1.7"));
            let n = n.map(number);
            assert_eq!(along, number("1.7") + number(delta) * dot(&n, &n));
            assert_eq!(
                axis.map(|component| component.abs()),
                scaled.map(|one| number(one).abs())
            );
            let n = scaled.map(number);
            is_eigenvector(&j, &along, &n);
        }
    }
    assert!(matches!(
        Spectrum::of(&tensor("2 2 2 0 0 0")),
        Spectrum::Spherical(_)
    ));
}

/// A gap is seen, however small it is.
#[test]
fn equal_means_proved_to_be_equal() {
    for exponent in [50, 64, 90, 300] {
        let mut j = dyadic("1.7", "0.03", ["1", "2", "3"]);
        j[0][0] = j[0][0].clone() + Number::power_of_ten(-exponent);
        assert!(
            matches!(Spectrum::of(&j), Spectrum::General(_)),
            "{exponent}"
        );
        let mut j = tensor("2 2 3 0 0 0");
        j[0][0] = j[0][0].clone() + Number::power_of_ten(-exponent);
        assert!(
            matches!(Spectrum::of(&j), Spectrum::General(_)),
            "{exponent}"
        );
    }
}

/// Symmetric, turned by an angle that is not rational: an identity of sine and cosine says so.
#[test]
fn turned_and_symmetric() {
    let turned = |by: &Number, across: &str| {
        let [c, s] = [Function::Cos, Function::Sin]
            .map(|function| Number::apply(function, core::slice::from_ref(by)).expect("a value"));
        let zero = Number::zero;
        let [xx, yy, zz] = ["2", across, "3"].map(number);
        let off = (yy.clone() - zz.clone()) * c.clone() * s.clone();
        let (c, s) = (c.clone() * c, s.clone() * s);
        [
            [xx, zero(), zero()],
            [
                zero(),
                yy.clone() * c.clone() + zz.clone() * s.clone(),
                off.clone(),
            ],
            [zero(), off, yy * s + zz * c],
        ]
    };
    for angle in ["0.3", "17", "1e-20"] {
        for by in [number(angle), number(angle) * Number::pi() / number("180")] {
            assert!(matches!(
                Spectrum::of(&turned(&by, "2")),
                Spectrum::Symmetric(_)
            ));
            assert!(matches!(
                Spectrum::of(&turned(&by, "2.0000000000000000000000000000000000000001")),
                Spectrum::General(_)
            ));
        }
    }
}

/// Components that are zero, or equal, are exactly so, and those that are not are kept.
#[test]
fn exact_components() {
    let (_, axes) = is_general(&tensor("2 2 2.5 1 0 0"));
    for [x, y, z] in [&axes[0], &axes[1]] {
        assert!(z.is_zero() && (x.abs() - y.abs()).is_zero());
    }
    let (_, axes) = is_general(&tensor("2 2 2.5 0.5 0.2 0.2"));
    let zeros = axes.iter().flatten().filter(|part| part.is_zero()).count();
    assert_eq!(zeros, 1);
    let equal = |axis: &&[Number; 3]| (axis[0].abs() - axis[1].abs()).is_zero();
    assert_eq!(axes.iter().filter(equal).count(), 3);
    let (_, axes) = is_general(&tensor("2 3 4 1e-90 1e-90 0"));
    assert!(axes.iter().flatten().all(|part| !part.is_zero()));
}

#[test]
fn principal_axes_stay_as_they_are() {
    let (moments, axes) = is_general(&tensor("3 1 2 0 0 0"));
    assert_eq!(moments, ["3", "1", "2"].map(number));
    for (i, axis) in axes.iter().enumerate() {
        for (k, component) in axis.iter().enumerate() {
            assert_eq!(*component, Number::integer(i64::from(i == k)));
        }
    }
    let Spectrum::Symmetric(symmetry) = Spectrum::of(&tensor("3 1 3 0 0 0")) else {
        panic!("two moments are equal")
    };
    let Symmetry {
        across,
        along,
        axis,
    } = *symmetry;
    assert_eq!([across, along], ["3", "1"].map(number));
    assert_eq!(axis, ["0", "1", "0"].map(number));
}

/// The vector turned about an axis by an angle.
fn rotated(vector: [f64; 3], axis: [f64; 3], angle: f64) -> [f64; 3] {
    let vector = nalgebra::Vector3::from(vector);
    let axis = nalgebra::Unit::new_normalize(nalgebra::Vector3::from(axis));
    (nalgebra::Rotation3::from_axis_angle(&axis, angle) * vector).into()
}

/// A solid that is symmetric keeps its axis, turned by any angles, however long the numbers get: its
/// free rotation is known, and its spin.
#[test]
fn turned_solids_keep_their_axis() {
    let solids = [
        "cylinder(0.1[m], 0.7[m])",
        "torus(1.6371[m], 0.36[m])",
        "disc(0.2[m])",
    ];
    let turns: [&[([f64; 3], f64)]; 6] = [
        &[([1.0, 1.0, -1.0], 1.035)],
        &[([1.0, 1.0, -1.0], -0.393)],
        &[([0.0, 1.0, 0.0], 0.7)],
        &[([3.0, -2.0, 0.7], 2.22)],
        &[([1.0, 2.0, 3.0], 0.3), ([0.5, 0.0, -1.0], 1.9)],
        &[
            ([1.0, 2.0, 3.0], 0.3),
            ([7.0, 1.0, -1.0], 5.1),
            ([2.0, 1.0, 1.0], -0.8),
        ],
    ];
    for (solid, turns) in solids
        .iter()
        .flat_map(|solid| turns.map(|turns| (solid, turns)))
    {
        let mut inertia = (*solid).to_owned();
        let mut expected = [0.0, 0.0, 1.0];
        for (axis @ [x, y, z], angle) in turns {
            inertia = format!("{inertia}.turned(body({x:?}, {y:?}, {z:?}), {angle:?})");
            expected = rotated(expected, *axis, *angle);
        }
        let description = format!(
            "Body {{ motion: rotation, mass: 3[kg], inertia: {inertia}, outputs: [flow] }}"
        );
        let tokens = description.parse().expect("tokens");
        let text = crate::expand_description(tokens)
            .to_string()
            .replace(' ', "");
        let rotation = text.split("symmetric_rotation([").nth(1).expect(&inertia);
        let axis = rotation.split(['[', ']']).nth(2).expect("an axis");
        let axis: Vec<f64> = axis.split(',').map(|x| x.parse().expect(&text)).collect();
        let cosine: f64 = axis.iter().zip(expected).map(|(a, b)| a * b).sum();
        assert!(
            (cosine.abs() - 1.0).abs() < 1e-14,
            "{inertia}: {axis:?}, {expected:?}"
        );
        assert!(text.contains("keeps_spin:true"), "{inertia}");
        assert!(
            text.contains("nothingturnsthebodyaboutitsaxis"),
            "{inertia}"
        );
    }
}
