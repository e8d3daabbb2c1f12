//! The modes of the example `level_turn`, from the textbook's linear equations of an aeroplane.
//! Their derivatives are computed from the coefficients by hand (Nelson, Flight Stability and
//! Automatic Control, tables 3.5 and 3.6), and share nothing with the compiler.

use nalgebra::{Matrix4, Vector4};

/// US customary units, as the data.
const SPEED: f64 = 176.0;
const GRAVITY: f64 = 32.174;
const MASS: f64 = 2750.0 / GRAVITY;
const ROLL: f64 = 1048.0;
const PITCH: f64 = 3000.0;
const YAW: f64 = 3530.0;
const SPAN: f64 = 33.4;
const CHORD: f64 = 5.7;

/// The force of the dynamic pressure on the wing.
fn load() -> f64 {
    0.5 * 0.002_377 * SPEED * SPEED * 184.0
}

/// Of speeds ahead and down, pitch rate and pitch.
fn longitudinal() -> Matrix4<f64> {
    let (force, moment) = (load() / (MASS * SPEED), load() * CHORD / PITCH);
    let (lift, drag) = (0.41, 0.05);
    let [x_u, z_u] = [-2.0 * drag * force, -2.0 * lift * force];
    let [x_w, z_w] = [-(0.33 - lift) * force, -(4.44 + drag) * force];
    let late = CHORD / (2.0 * SPEED);
    let m_w = -0.683 * moment / SPEED;
    let m_w_rate = -4.36 * late * moment / SPEED;
    let m_q = -9.96 * late * moment;
    Matrix4::new(
        x_u,
        x_w,
        0.0,
        -GRAVITY, //
        z_u,
        z_w,
        SPEED,
        0.0, //
        m_w_rate * z_u,
        m_w + m_w_rate * z_w,
        m_q + m_w_rate * SPEED,
        0.0, //
        0.0,
        0.0,
        1.0,
        0.0,
    )
}

/// Of sideslip, roll rate, yaw rate and bank.
fn lateral() -> Matrix4<f64> {
    let late = SPAN / (2.0 * SPEED);
    let y_beta = -0.564 * load() / (MASS * SPEED);
    let [l_beta, l_p, l_r] = [-0.074, -0.41 * late, 0.107 * late].map(|c| c * load() * SPAN / ROLL);
    let [n_beta, n_p, n_r] =
        [0.071, -0.0575 * late, -0.125 * late].map(|c| c * load() * SPAN / YAW);
    Matrix4::new(
        y_beta,
        0.0,
        -1.0,
        GRAVITY / SPEED, //
        l_beta,
        l_p,
        l_r,
        0.0, //
        n_beta,
        n_p,
        n_r,
        0.0, //
        0.0,
        1.0,
        0.0,
        0.0,
    )
}

/// Real parts and absolute imaginary parts, the fastest first.
fn eigenvalues(matrix: &Matrix4<f64>) -> Vec<[f64; 2]> {
    let found: Vector4<_> = matrix.complex_eigenvalues();
    let mut list: Vec<[f64; 2]> = found.iter().map(|one| [one.re, one.im.abs()]).collect();
    list.sort_by(|a, b| b[0].hypot(b[1]).total_cmp(&a[0].hypot(a[1])));
    list
}

fn close(found: [f64; 2], expected: [f64; 2], share: f64) {
    let off = (found[0] - expected[0]).hypot(found[1] - expected[1]);
    let size = expected[0].hypot(expected[1]);
    assert!(off < share * size, "{found:?}, not {expected:?}");
}

/// The numbers that the example quotes.
#[test]
fn the_textbook_has_the_modes_that_are_quoted() {
    let [short, _, long, _] = eigenvalues(&longitudinal())[..] else {
        panic!("four");
    };
    close(short, [-2.51, 2.59], 2e-3);
    close(long, [-0.0171, 0.213], 2e-3);
    let [roll, dutch, _, spiral] = eigenvalues(&lateral())[..] else {
        panic!("four");
    };
    close(roll, [-8.435, 0.0], 1e-3);
    close(dutch, [-0.487, 2.335], 6e-3);
    close(spiral, [-0.00877, 0.0], 0.07);
}
