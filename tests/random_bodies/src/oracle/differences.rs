//! Derivatives by finite differences, in 106 bits.

use crate::wide::Wide;

use super::number::Number;

/// The first or second derivative at zero by differences over lengths that become shorter, until two agree; and by how much they do not.
pub fn settled(length: f64, mut value: impl FnMut(f64) -> Number, order: i32) -> (Wide, f64) {
    let here = value(0.0);
    let mut size = here.span();
    let here = here.value;
    let mut best = (Wide::ZERO, f64::INFINITY);
    let mut before: Option<Wide> = None;
    for part in [1e-1, 1e-3, 1e-5, 1e-7] {
        let length = part * length;
        let [(near, bend), (far, far_bend)] = [length, 2.0 * length].map(|length| {
            let (after, before) = (value(length), value(-length));
            size = size.max(after.span()).max(before.span());
            let (after, before) = (after.value, before.value);
            let (even, odd) = (after - here * 2.0 + before, after - before);
            let derivative = match order {
                1 => odd / Wide::from(2.0 * length),
                _ => even / Wide::from(length) / Wide::from(length),
            };
            (derivative, even.high.abs())
        });
        // four times as large at twice the length, but for kinks within it, and for rounding
        let is_bent = far_bend > 1e-28 * size && far_bend < 3.0 * bend;
        let now = extrapolated(near, far, 4.0);
        if let Some(before) = before {
            let rounding = 1e-30 * size / length.powi(order);
            let apart = (now - before).high.abs() + rounding;
            // a kink looks the same at all lengths
            let is_smooth = order == 2 || !is_bent;
            if is_smooth && apart < best.1 {
                best = (now, apart);
            }
            if is_smooth && apart <= 1e-14 * now.high.abs() {
                break;
            }
        }
        before = Some(now);
    }
    best
}

/// Without the term that grows by this factor from the near to the far one.
fn extrapolated(near: Wide, far: Wide, factor: f64) -> Wide {
    near + (near - far) / Wide::from(factor - 1.0)
}
