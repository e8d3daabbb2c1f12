//! Rust functions that descriptions call, with their derivatives.

use crate::wide::Wide;

/// How they are declared.
pub const DECLARED: &str = "bump(x) = own::bump.derivatives(own::bump_1.derivatives(own::bump_2)),
        wave(x, y) = own::wave.derivatives(own::wave_x.derivatives(own::wave_xx, own::wave_xy), \
                            own::wave_y.derivatives(_, own::wave_yy))";

/// `1 / (1 + x^2)`, so often differentiated.
pub fn bump(order: u32, x: Wide) -> Wide {
    let square = x * x;
    let value = Wide::ONE / (Wide::ONE + square);
    match order {
        0 => value,
        1 => -(x * value * value * 2.0),
        2 => (square * 6.0 - 2.0.into()) * value * value * value,
        _ => f64::NAN.into(),
    }
}

/// `sin(x) cos(2 y)`, so often differentiated by each.
pub fn wave([by_x, by_y]: [u32; 2], x: Wide, y: Wide) -> Wide {
    let turned = |[value, slope]: [Wide; 2], order: u32| {
        let steps = 0..order;
        steps.fold([value, slope], |[value, slope], _| [slope, -value])
    };
    let (sine, cosine) = x.sin_cos();
    let [along, _] = turned([sine, cosine], by_x);
    let (sine, cosine) = (y * 2.0).sin_cos();
    let [across, _] = turned([cosine, -sine], by_y);
    if by_x + by_y > 2 {
        return f64::NAN.into();
    }
    along * across * f64::from(1_i32 << by_y)
}

/// By its name.
pub fn called(name: &str, orders: [u32; 3], [x, y, _]: [Wide; 3]) -> Wide {
    match name {
        "bump" => bump(orders[0], x),
        "wave" => wave([orders[0], orders[1]], x, y),
        _ => f64::NAN.into(),
    }
}
