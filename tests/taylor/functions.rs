//! The recurrence of every function and operation, from one table: along its series, a motion
//! satisfies its equation, which is written a second time here, with the functions of std.

use newton_euler::prelude::*;

/// Coefficients of the series.
const N: usize = 18;

macro_rules! table {
    ($($name:ident, $input:ident: [$($moment:tt)*] = $function:expr;)*) => {
        mod bodies {
            $(newton_euler::rigid_body!($name {
                motion: pivot(G),
                inputs: [_u],
                mass: 1[kg],
                inertia: 1[kg * m ^ 2],
                locals: [_x = attitude, _w = angular_velocity * 1[s], _s = t / 1[s]],
                moments: [load = 1[N * m] * ($($moment)*)],
                outputs: [taylor],
            });)*
        }

        #[test]
        fn along_its_series_a_motion_obeys_its_equation() {
            $(
                let input = bodies::$input { _u: INPUT };
                check(stringify!($name), &bodies::$name::default(), &input, $function);
            )*
        }
    };
}

/// The angle and its rate at the start, and the time then: inside the domain of every function.
const START: Hinge = Hinge {
    angle: 0.4,
    angular_velocity: 0.7,
};
const TIME: f64 = 0.3;
const INPUT: f64 = 0.6;

/// Along the series, the acceleration of angle and rate is `function` of angle, rate, time and input.
fn check<B: Taylor<State = Hinge>>(
    name: &str,
    body: &B,
    input: &B::Input,
    function: fn([f64; 4]) -> f64,
) {
    let series = body.series::<N>(TIME, &START, input);
    for after in [-0.06, -0.02, 0.0, 0.03, 0.06] {
        let Hinge {
            angle,
            angular_velocity,
        } = series.after(after);
        let expected = function([angle, angular_velocity, TIME + after, INPUT]);
        let derivative = |coordinate: usize| {
            let rows = series.coefficients().iter().enumerate().skip(1).rev();
            rows.fold(0.0, |sum, (n, row)| {
                sum * after + n as f64 * row[coordinate]
            })
        };
        let [rate, acceleration] = [0, 1].map(derivative);
        // the terms left out are below 0.06^16; rounding
        assert!(
            (rate - angular_velocity).abs() < 1e-13,
            "{name}: {rate} for {angular_velocity}"
        );
        let difference = (acceleration - expected).abs();
        assert!(
            difference < 1e-13 * (1.0 + expected.abs()),
            "{name}, {after} later: {acceleration} for {expected}"
        );
    }
    // not a polynomial by mistake
    let highest = series.coefficients()[N - 1];
    assert!(
        highest.iter().all(|value| value.is_finite()),
        "{name}: {highest:?}"
    );
}

table! {
    Sum, SumInput: [_x + 2 * _w - _s / 3] = |[x, w, t, _]| x + 2.0 * w - t / 3.0;
    Product, ProductInput: [_x * _w] = |[x, w, ..]| x * w;
    Square, SquareInput: [_x * _x - _w.powi(2)] = |[x, w, ..]| x * x - w * w;
    Triple, TripleInput: [_x * _w * _s] = |[x, w, t, _]| x * w * t;
    OfSums, OfSumsInput: [(_x + _w) * (1 - _x + _s) * (_w - 2)] = |[x, w, t, _]| (x + w) * (1.0 - x + t) * (w - 2.0);
    Quotient, QuotientInput: [_x / (1 + _w)] = |[x, w, ..]| x / (1.0 + w);
    Reciprocal, ReciprocalInput: [1 / (_x + _s)] = |[x, _, t, _]| 1.0 / (x + t);
    QuotientOfHeld, QuotientOfHeldInput: [_u / (2 + _x)] = |[x, _, _, u]| u / (2.0 + x);
    OverHeld, OverHeldInput: [_x * _w / (1 + _u) - _x / _u] = |[x, w, _, u]| x * w / (1.0 + u) - x / u;
    TimesHeld, TimesHeldInput: [_u * _x - _u.sin() * _w * _x + _u] = |[x, w, _, u]| u * x - u.sin() * w * x + u;
    HeldChoice, HeldChoiceInput: [if _u < 1 { _x.sin() + _u } else { _w }] = |[x, _, _, u]| x.sin() + u;
    OtherChoice, OtherChoiceInput: [if _u > 1 { _x.sin() } else { _w * _x }] = |[x, w, ..]| w * x;
    HeldKinks, HeldKinksInput: [_u.abs() * _x + _w * _u.max(0.1) - _u.floor()] = |[x, w, _, u]| u * x + w * u;
    NegativePower, NegativePowerInput: [(1 + _x).powi(-3)] = |[x, ..]| (1.0 + x).powi(-3);
    Power, PowerInput: [_x.powf(1.7)] = |[x, ..]| x.powf(1.7);
    PowerOfSum, PowerOfSumInput: [(_x + _w * _s).powf(-0.4)] = |[x, w, t, _]| (x + w * t).powf(-0.4);
    HeldPower, HeldPowerInput: [(_x + 1).powf(_u)] = |[x, _, _, u]| (x + 1.0).powf(u);
    MovingPower, MovingPowerInput: [(1 + _x).powf(_w)] = |[x, w, ..]| (1.0 + x).powf(w);
    MovingExponent, MovingExponentInput: [_u.powf(_x)] = |[x, _, _, u]| u.powf(x);
    Root, RootInput: [(_x + _w * _w).sqrt()] = |[x, w, ..]| (x + w * w).sqrt();
    Cube, CubeInput: [(_x + _w).cbrt()] = |[x, w, ..]| (x + w).cbrt();
    Exponential, ExponentialInput: [(-_x * _w).exp()] = |[x, w, ..]| (-x * w).exp();
    Logarithm, LogarithmInput: [(_x + _s * _w).ln()] = |[x, w, t, _]| (x + t * w).ln();
    Sine, SineInput: [_x.sin()] = |[x, ..]| x.sin();
    Cosine, CosineInput: [(_x - _w).cos()] = |[x, w, ..]| (x - w).cos();
    Both, BothInput: [_x.sin() * _x.cos()] = |[x, ..]| x.sin() * x.cos();
    Tangent, TangentInput: [_x.tan()] = |[x, ..]| x.tan();
    ArcSine, ArcSineInput: [(_x * _w).asin()] = |[x, w, ..]| (x * w).asin();
    ArcCosine, ArcCosineInput: [_x.acos()] = |[x, ..]| x.acos();
    ArcTangent, ArcTangentInput: [(3 * _x).atan()] = |[x, ..]| (3.0 * x).atan();
    Angle, AngleInput: [_x.atan2(_w)] = |[x, w, ..]| x.atan2(w);
    AngleOverHeld, AngleOverHeldInput: [_x.atan2(_u)] = |[x, _, _, u]| x.atan2(u);
    AngleOfHeld, AngleOfHeldInput: [_u.atan2(_w - _x)] = |[x, w, _, u]| u.atan2(w - x);
    HyperbolicSine, HyperbolicSineInput: [_w.sinh()] = |[_, w, ..]| w.sinh();
    HyperbolicCosine, HyperbolicCosineInput: [(_x * 2).cosh()] = |[x, ..]| (2.0 * x).cosh();
    HyperbolicTangent, HyperbolicTangentInput: [(_x - _s).tanh()] = |[x, _, t, _]| (x - t).tanh();
    Length, LengthInput: [_x.hypot(_w)] = |[x, w, ..]| x.hypot(w);
    LengthOverHeld, LengthOverHeldInput: [_x.hypot(_u) - _u.hypot(_w)] = |[x, w, _, u]| x.hypot(u) - u.hypot(w);
    OfTimeAlone, OfTimeAloneInput: [_s.sin() / (1 + _s)] = |[_, _, t, _]| t.sin() / (1.0 + t);
    Nested, NestedInput: [(_x.sin() / (2 + (_w * _s).cos())).exp().sqrt()] = |[x, w, t, _]| (x.sin() / (2.0 + (w * t).cos())).exp().sqrt();
    Shared, SharedInput: [_x.sin() + _x.sin().powi(2) / _x.cos() + 1 / (1 + _x.sin())] = |[x, ..]| x.sin() + x.sin().powi(2) / x.cos() + 1.0 / (1.0 + x.sin());
}
