//! Almost everything that a description can contain, in one system: user-defined states, changing
//! mass, functions, tables, loads that depend on accelerations, cables, potentials, armatures. Its
//! derivatives are compared with finite differences.

use newton_euler::prelude::*;
use newton_euler::state::Coordinates;

fn bump(x: f64) -> f64 {
    x / (1.0 + x * x)
}

fn bump_slope(x: f64) -> f64 {
    (1.0 - x * x) / (1.0 + x * x).powi(2)
}

rigid_system!(Together {
    params: [
        stiff = 30[N * m / rad],
        len = 0.4[m],
        pull = 12[N / m],
        heavy = 0.7[kg],
        lag = 0.3[s],
        pitch = 0.05[m],
        rotor = 0.02[kg * m ^ 2],
    ],
    inputs: [command[N * m], wind = world(_, _, _)[m / s]],
    states: [torque[N * m], fuel[kg]],
    functions: [bump(x) = crate::together::bump.derivatives(crate::together::bump_slope)],
    rates: [
        torque = (command - torque) / lag,
        fuel = -0.1[kg / s] * bump(torque / 1[N * m]) - 0.01[1 / s] * fuel,
    ],
    bodies: [
        a {
            mass: 1.2[kg] + fuel,
            inertia: principal(0.1, 0.2, 0.25)[kg * m ^ 2],
            points: [p = (0.1, 0.2, -len), q = (len, 0, 0)],
            locals: [air = q.velocity() - wind],
            forces: [drag = -0.4[kg / m] * air.norm() * air],
        },
        b {
            mass: heavy,
            inertia: principal(0.05, 0.06, 0.03)[kg * m ^ 2],
            points: [p = (0, len / 2, 0)],
            locals: [along = velocity.in_body().x / 1[m / s]],
            forces: [lift = body(
                0,
                0,
                table(along, [-2, -1, 0, 1, 3], [-1, -1.5, 0.2, 1, 2][N], cubic)
            )],
        },
        c {
            mass: 0.3[kg],
            inertia: sphere(0.1[m]),
            points: [e = (0.1, 0, 0.2)],
        },
    ],
    joints: [
        s = revolute(world(0, 0, 1), a.p, body(0, 1, 1)).turned(body(1, 0, 0), 45[deg]),
        n = screw(a.q, b.p, body(1, 0, 1), pitch)
            .turned(body(0, 0, 1), 30[deg])
            .armature(rotor),
        r = prismatic(b.G, c.e, body(1, 1, 0))
            .turned(body(0, 1, 0), 45[deg])
            .turned(body(1, 0, 0), 60[deg]),
        rope = cable(world(1, 2, 3), c.G, 0.2[m], pull),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    potentials: [
        coil = stiff / 2 * (1 - s.angle.cos()),
        cogging = table(n.angle, [-4, -1, 0, 2, 4], [1, 2, 1, 3, 2][J], cubic),
    ],
    drives: [
        motor = torque.on(s),
        fed_back = (-0.3[kg * m ^ 2] * n.angular_acceleration).on(n),
        damper = (-0.2[kg / s] * r.velocity).on(r),
    ],
    outputs: [linearization, sensitivity],
});

const TIME: f64 = 0.3;
const PARAMS: TogetherParams = TogetherParams {
    stiff: 30.0,
    len: 0.4,
    pull: 12.0,
    heavy: 0.7,
    lag: 0.3,
    pitch: 0.05,
    rotor: 0.02,
};

fn given() -> (TogetherState, TogetherInput) {
    let hinge = |angle, angular_velocity| Hinge {
        angle,
        angular_velocity,
    };
    let state = TogetherState {
        s: hinge(0.4, 1.1),
        n: hinge(-0.7, 0.6),
        r: Slide {
            position: 0.2,
            velocity: -0.8,
        },
        torque: 0.9,
        fuel: 0.5,
    };
    let input = TogetherInput {
        command: 0.7,
        wind: [0.3, -0.2, 0.1].into(),
    };
    (state, input)
}

fn rates(params: TogetherParams, state: &TogetherState, input: &TogetherInput) -> [f64; 5] {
    let together = Together::new(params).expect("possible bodies");
    let found = together.acceleration(TIME, state, input);
    [found.s, found.n, found.r, found.torque, found.fuel]
}

/// By a difference of fourth order.
fn slope(of: impl Fn(f64) -> [f64; 5]) -> [f64; 5] {
    let h = 1e-4;
    let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|steps| of(steps * h));
    [0, 1, 2, 3, 4].map(|i| (8.0 * (c[i] - b[i]) - (d[i] - a[i])) / (12.0 * h))
}

fn hold(name: &str, found: [f64; 5], known: [f64; 5]) {
    for (found, known) in found.iter().zip(known) {
        let off = (found - known).abs();
        assert!(off < 1e-8 * (1.0 + known.abs()), "{name}: {found} {known}");
    }
}

#[test]
fn by_states_and_inputs() {
    let (state, input) = given();
    let together = Together::new(PARAMS).expect("possible bodies");
    let found = together.linearize(TIME, &state, &input);
    let (a, b) = (found.a(), found.b());
    for (column, name) in TogetherLinearization::STATES.iter().enumerate() {
        let known = slope(|by| {
            let mut list = state.coordinates();
            list.as_mut()[column] += by;
            rates(PARAMS, &TogetherState::from_coordinates(&list), &input)
        });
        hold(name, [3, 4, 5, 6, 7].map(|row| a[(row, column)]), known);
    }
    for column in 0..4 {
        let known = slope(|by| {
            let mut input = input;
            match column {
                0 => input.command += by,
                _ => input.wind[column - 1] += by,
            }
            rates(PARAMS, &state, &input)
        });
        let found = [3, 4, 5, 6, 7].map(|row| b[(row, column)]);
        hold(&format!("input {column}"), found, known);
    }
}

#[test]
fn by_parameters() {
    let (state, input) = given();
    let together = Together::new(PARAMS).expect("possible bodies");
    let found = together.sensitivity(TIME, &state, &input);
    let by = |of: fn(&mut TogetherParams) -> &mut f64| {
        slope(|by| {
            let mut params = PARAMS;
            *of(&mut params) += by;
            rates(params, &state, &input)
        })
    };
    let moved = |s, n, r| [s, n, r, 0.0, 0.0];
    let stiff = moved(
        found.s_angular_by_stiff,
        found.n_angular_by_stiff,
        found.r_linear_by_stiff,
    );
    hold("stiff", stiff, by(|params| &mut params.stiff));
    let len = moved(
        found.s_angular_by_len,
        found.n_angular_by_len,
        found.r_linear_by_len,
    );
    hold("len", len, by(|params| &mut params.len));
    let pull = moved(
        found.s_angular_by_pull,
        found.n_angular_by_pull,
        found.r_linear_by_pull,
    );
    hold("pull", pull, by(|params| &mut params.pull));
    let heavy = moved(
        found.s_angular_by_heavy,
        found.n_angular_by_heavy,
        found.r_linear_by_heavy,
    );
    hold("heavy", heavy, by(|params| &mut params.heavy));
    let pitch = moved(
        found.s_angular_by_pitch,
        found.n_angular_by_pitch,
        found.r_linear_by_pitch,
    );
    hold("pitch", pitch, by(|params| &mut params.pitch));
    let rotor = moved(
        found.s_angular_by_rotor,
        found.n_angular_by_rotor,
        found.r_linear_by_rotor,
    );
    hold("rotor", rotor, by(|params| &mut params.rotor));
    let lag = [0.0, 0.0, 0.0, found.torque_rate_by_lag, 0.0];
    hold("lag", lag, by(|params| &mut params.lag));
}
