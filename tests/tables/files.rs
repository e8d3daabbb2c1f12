//! Tables from files, and cubic tables of two arguments, compared with the same tables written in a
//! description and with bicubic polynomials by hand.

use newton_euler::prelude::*;

rigid_body!(FromFiles {
    motion: translation,
    mass: 1[kg],
    inputs: [alpha[rad], x, speed[m / s]],
    forces: [
        column = world(
            table(
                alpha / 1[deg],
                "tests/tables/files/polar.csv",
                "drag"[kN],
                cubic
            ),
            0,
            0
        ),
        plain = world(0, table(x, "tests/tables/files/plain.csv"[N]), 0),
        grid = world(0, 0, table(x, speed, "tests/tables/files/grid.csv"[N])),
    ],
});

rigid_body!(Written {
    motion: translation,
    mass: 1[kg],
    inputs: [alpha[rad], x, speed[m / s]],
    forces: [
        column = world(
            table(
                alpha / 1[deg],
                [-10, 0, 10, 14],
                [0.04, 0.01, 0.03, 0.09][kN],
                cubic
            ),
            0,
            0
        ),
        plain = world(0, table(x, [0, 1, 3], [1, 3, 2.5][N]), 0),
        grid = world(
            0,
            0,
            table(
                x,
                speed,
                [0, 0.1, 0.3, 0.4],
                [10, 20, 50][m / s],
                [
                    [0.1, 0.5, 0.6],
                    [0.2, 1.5, 1],
                    [0.9, 1.6, 2.5],
                    [1, 1.7, 2.5]
                ][N]
            )
        ),
    ],
});

#[test]
fn as_if_written() {
    for (n, m) in (0..20).flat_map(|n| (0..20).map(move |m| (f64::from(n), f64::from(m)))) {
        let (alpha, x, speed) = (0.04 * n - 0.4, 0.19 * m - 0.3, 3.0 * n + 0.5 * m);
        let read = FromFiles::default().acceleration(
            0.0,
            &Translation::default(),
            &FromFilesInput { alpha, x, speed },
        );
        let written = Written::default().acceleration(
            0.0,
            &Translation::default(),
            &WrittenInput { alpha, x, speed },
        );
        assert_eq!(read, written);
    }
}

rigid_body!(Smooth {
    motion: translation,
    mass: 1[kg],
    inputs: [x, y],
    forces: [grid = world(table(x, y, "tests/tables/files/grid.csv"[N], cubic), 0, 0)],
});

const X: [f64; 4] = [0.0, 0.1, 0.3, 0.4];
const Y: [f64; 3] = [10.0, 20.0, 50.0];
const Z: [[f64; 3]; 4] = [
    [0.1, 0.5, 0.6],
    [0.2, 1.5, 1.0],
    [0.9, 1.6, 2.5],
    [1.0, 1.7, 2.5],
];

fn smooth(x: f64, y: f64) -> f64 {
    let input = SmoothInput { x, y };
    Smooth::default()
        .acceleration(0.0, &Translation::default(), &input)
        .x
}

/// The slopes of a monotone cubic by the rule as it is printed, in doubles.
fn slopes(x: &[f64], z: &[f64]) -> Vec<f64> {
    let count = x.len();
    let line = |i: usize| (z[i + 1] - z[i]) / (x[i + 1] - x[i]);
    let parabola = |i: usize| {
        // through three knots, the middle one i
        let (h, k) = (x[i] - x[i - 1], x[i + 1] - x[i]);
        let curvature = (line(i) - line(i - 1)) / (h + k);
        move |at: f64, d: f64| d + curvature * (2.0 * at - x[i] - x[i - 1])
    };
    let found = (0..count).map(|i| {
        let middle = i.clamp(1, count - 2);
        let slope = parabola(middle)(x[i], line(middle - 1));
        let beside = (i.saturating_sub(1)..=i.min(count - 2)).map(line);
        beside.fold(slope, |slope, line| {
            if slope * line <= 0.0 {
                0.0
            } else {
                slope.signum() * slope.abs().min(3.0 * line.abs())
            }
        })
    });
    found.collect()
}

/// Hermite's cubic between two knots.
fn hermite([a, b]: [f64; 2], [p, q]: [f64; 2], [d, e]: [f64; 2], x: f64) -> f64 {
    let (h, s) = (b - a, (x - a) / (b - a));
    let r = 1.0 - s;
    p * r * r * (1.0 + 2.0 * s) + q * s * s * (3.0 - 2.0 * s) + h * r * s * (d * r - e * s)
}

fn curve(x: &[f64], z: &[f64], at: f64) -> f64 {
    let slopes = slopes(x, z);
    let i = (1..x.len() - 1).filter(|i| x[*i] <= at).count();
    hermite(
        [x[i], x[i + 1]],
        [z[i], z[i + 1]],
        [slopes[i], slopes[i + 1]],
        at,
    )
}

/// In x between the rows Hermite's cubic, of values and slopes that are cubics in y.
fn by_hand(x: f64, y: f64) -> f64 {
    let columns = [0, 1, 2].map(|j| slopes(&X, &Z.map(|row| row[j])));
    let i = X[1..3].iter().filter(|at| **at <= x).count();
    let rows = [i, i + 1];
    let values = rows.map(|row| curve(&Y, &Z[row], y));
    let across = rows.map(|row| curve(&Y, &[0, 1, 2].map(|j: usize| columns[j][row]), y));
    hermite(rows.map(|row| X[row]), values, across, x)
}

#[test]
fn bicubic() {
    for (n, m) in (0..=40).flat_map(|n| (0..=40).map(move |m| (n, m))) {
        let (x, y) = (0.01 * f64::from(n), 10.0 + f64::from(m));
        assert!((smooth(x, y) - by_hand(x, y)).abs() < 1e-13, "{x} {y}");
    }
}

/// It passes through the values, is monotone along the lines of the grid, and its slopes have no jumps.
#[test]
fn through_its_values_without_jumps() {
    for (x, row) in X.iter().zip(Z) {
        for (y, z) in Y.iter().zip(row) {
            assert!((smooth(*x, *y) - z).abs() < 1e-14);
        }
    }
    for y in Y {
        let along = (0..400).map(|n| smooth(0.001 * f64::from(n), y));
        let along: Vec<f64> = along.collect();
        assert!(along.windows(2).all(|pair| pair[1] >= pair[0] - 1e-14));
    }
    let h = 1e-6;
    for n in 0..40 {
        let y = 10.5 + f64::from(n);
        for x in [0.1, 0.3] {
            let before = (smooth(x, y) - smooth(x - h, y)) / h;
            let behind = (smooth(x + h, y) - smooth(x, y)) / h;
            assert!((before - behind).abs() < 1e-3, "{before} {behind}");
        }
        let x = 0.01 * f64::from(n);
        let before = (smooth(x, 20.0) - smooth(x, 20.0 - h)) / h;
        let behind = (smooth(x, 20.0 + h) - smooth(x, 20.0)) / h;
        assert!((before - behind).abs() < 1e-6, "{before} {behind}");
    }
    // held beyond the ends
    assert!((smooth(-1.0, 15.0) - smooth(0.0, 15.0)).abs() < 1e-14);
    assert!((smooth(0.2, 90.0) - smooth(0.2, 50.0)).abs() < 1e-14);
}
