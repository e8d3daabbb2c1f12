//! Which values are possible, by exact arithmetic on the doubles.

use dashu_ratio::RBig;

use super::Verdict;

/// The exact value of a finite double.
pub fn rational(value: f64) -> RBig {
    RBig::try_from(value).expect("a finite number")
}

/// Whether a tensor (xx, yy, zz, xy, yz, zx) is that of a body: ½ tr(J) 1 - J, the second moments, are positive semidefinite.
/// In between is what rounding may add, 64 units in the last place of the largest moment.
pub fn tensor(entries: &[f64; 6]) -> Verdict {
    if entries.iter().any(|entry| !entry.is_finite()) {
        return Verdict::Impossible;
    }
    let exact = entries.map(rational);
    if second_moments(&exact, &RBig::ZERO) {
        return Verdict::Possible;
    }
    let [xx, yy, zz, ..] = &exact;
    let largest = xx.max(yy).max(zz).clone();
    let slack = largest * rational(64.0 * f64::EPSILON);
    if second_moments(&exact, &slack) {
        Verdict::Marginal
    } else {
        Verdict::Impossible
    }
}

/// Whether a tensor, less this on its diagonal, is positive definite.
pub fn turns(entries: &[f64; 6], less: f64) -> bool {
    let [xx, yy, zz, xy, yz, zx] = entries.map(rational);
    let less = rational(less);
    let diagonal = [xx, yy, zz].map(|moment| moment - less.clone());
    minors(&diagonal, &[xy, yz, zx])
        .iter()
        .all(|minor| *minor > RBig::ZERO)
}

fn second_moments([xx, yy, zz, xy, yz, zx]: &[RBig; 6], more: &RBig) -> bool {
    let half = (xx + yy + zz) * rational(0.5) + more;
    let diagonal = [xx, yy, zz].map(|moment| half.clone() - moment);
    let off_diagonals = [xy, yz, zx].map(|product| -product.clone());
    minors(&diagonal, &off_diagonals)
        .iter()
        .all(|minor| *minor >= RBig::ZERO)
}

/// All principal minors of a symmetric matrix.
fn minors([a, b, c]: &[RBig; 3], [d, e, f]: &[RBig; 3]) -> [RBig; 7] {
    let two = |a: &RBig, b: &RBig, d: &RBig| a * b - d * d;
    let two_def = rational(2.0) * d * e * f;
    let all = a * b * c + two_def - a * (e * e) - b * (f * f) - c * (d * d);
    [
        a.clone(),
        b.clone(),
        c.clone(),
        two(a, b, d),
        two(b, c, e),
        two(c, a, f),
        all,
    ]
}

/// Whether the sum of squares is 1 to 1e-9.
pub fn unit(components: &[f64]) -> Verdict {
    if components.iter().any(|component| !component.is_finite()) {
        return Verdict::Impossible;
    }
    let squares = components.iter().map(|component| rational(*component));
    let square = squares.fold(RBig::ZERO, |sum, x| sum + x.clone() * x);
    let off = square - RBig::ONE;
    let off = if off < RBig::ZERO { -off } else { off };
    within(&off, 1e-9)
}

/// Whether `|a·b| <= 1e-9 |b|`, of a unit vector a.
pub fn perpendicular(a: &[f64; 3], b: &[f64; 3]) -> Verdict {
    if a.iter().chain(b).any(|component| !component.is_finite()) {
        return Verdict::Impossible;
    }
    let [a, b] = [a, b].map(|vector| vector.map(rational));
    let dot = |a: &[RBig; 3], b: &[RBig; 3]| &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2];
    let square = dot(&b, &b);
    if square.is_zero() {
        return Verdict::Possible;
    }
    let cosine = dot(&a, &b);
    within(&(cosine.clone() * cosine / square), 1e-18)
}

/// Beside the bound by more than rounding.
fn within(value: &RBig, bound: f64) -> Verdict {
    if *value <= rational(bound * (1.0 - 1e-5)) {
        Verdict::Possible
    } else if *value >= rational(bound * (1.0 + 1e-5)) {
        Verdict::Impossible
    } else {
        Verdict::Marginal
    }
}

/// Of several, the worst.
pub fn all(verdicts: impl IntoIterator<Item = Verdict>) -> Verdict {
    let mut worst = Verdict::Possible;
    for verdict in verdicts {
        match verdict {
            Verdict::Impossible => return verdict,
            Verdict::Marginal => worst = verdict,
            Verdict::Possible => {}
        }
    }
    worst
}

/// Whether these are numbers.
pub fn finite(numbers: &[f64]) -> Verdict {
    if numbers.iter().all(|number| number.is_finite()) {
        Verdict::Possible
    } else {
        Verdict::Impossible
    }
}
