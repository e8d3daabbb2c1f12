//! Motions of driven joints: those that are known to jump are errors, and no others.

use crate::expand_system;

/// What is said of a joint that moves so.
fn said(motion: &str) -> String {
    let params = "p1, p2[s], p3[s], w, lead[s], speed[1 / s], acc[1 / s ^ 2], v[1 / s]";
    let bodies = "arm { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [a = (-0.5, 0), b = (0.5, 0)] }, \
                  bob { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [top = (0, 0.4)] }";
    let text = format!(
        "Driven {{ motion: planar, params: [{params}], bodies: [{bodies}], joints: [ \
         turn = revolute(world(0, 0), arm.a).driven({motion}), swing = revolute(arm.b, bob.top)] }}"
    );
    let expansion = expand_system(text.parse().expect("tokens")).to_string();
    let error = expansion.split_once("compile_error ! {");
    error.map_or(String::new(), |(_, said)| said.chars().take(200).collect())
}

#[test]
fn continuous_motions_are_accepted() {
    for motion in [
        "if t < 3[s] { table(t, [0, 3][s], [0, 0.6]) } else { 0.6 + 0.2 * (t / 1[s] - 3) }",
        "table(t, [0, 1][s], [0, 1]) + (t / 1[s] - 1).max(0)",
        "if t < 2[s] { 0 } else if t < 3[s] { 3 * (t/1[s] - (t/1[s]).floor()).powi(2) - 2 * (t/1[s] - (t/1[s]).floor()).powi(3) } else { 1 }",
        "if t < p1*(p2+p3) { 0 } else { 1 } + if t < p1*p2 + p1*p3 { 0 } else { -1 }",
        "if t < 2[s] { 0 } else { 1 } + if t*t < 4[s^2] { 0 } else { -1 }",
        "0.1[rad/s^2]*(t*t).min(4[s^2]) - if t < 2[s] { 0 } else { 0.1[rad/s^2]*(4[s^2] - t*t) }",
        "(t + lead.abs()).max(0) / 1[s]",
        "0.1[1 / s ^ 2] * t * (t - 2[s]) * table(t, [0, 1, 3][s], [0, 1, 0.5], cubic)",
        "if t < 1[s] { (w*t/1[s]).sin() * (w*t/1[s]).cos() } else { 0.5 * (2*w*t/1[s]).sin() }",
        "if t < 1[s] { (t/1[s]).sin() } else { 0.8414709848 + 0.5403023059*(t/1[s]-1) }",
        "(t/1[s]-1)*((t/1[s]-1).max(0))",
        "if t < 1[s] { 0 } else if t < 2[s] { (t/1[s]-1).powi(2) } else { 1 + 2*(t/1[s]-2) }",
        "table(t, [0, 1, 2, 3][s], [0, 0.2, 0.8, 1], cubic)",
        "if t < 1[s] { 0.5*acc*t.powi(2) } else { 0.5*acc*1[s^2] + v*(t-1[s]) }",
        "if t < 2[s] { 0 } else if t < 4[s] { (t/2[s] - (t/2[s]).floor()).powi(2) } else { 1 + (t/2[s] - 2)*2 }",
    ] {
        assert_eq!(said(motion), "", "{motion}");
    }
}

#[test]
fn jumps_are_errors() {
    for motion in [
        "table(t, [0, 1, 2][s], [0, 0, 1], extrapolated)",
        "if t < 2[s] { 0 } else { 0.3[1/s] * (t - 2[s]) }",
        "speed * (t - 2[s]).max(0)",
        "table(t, [0, 1, 2][s], [0, 0.2, 0.8])",
        "(t/1[s]).floor()",
        "0.1*(t/1[s]-1).signum()",
        "(t/1[s]-1).abs()",
        "if 2[s] - t > 0 { 0 } else { 1 }",
        "if t < 1[s] && t > 0[s] { 0 } else { 1 }",
        "if t < 1[s] { 1 } else { 0 } * speed * 1[s]",
    ] {
        assert!(said(motion).contains("jumps"), "{motion}: {}", said(motion));
    }
}
