//! Elementary functions, each accurate to about 1e-30, relative to its value or to what rounding
//! its argument would change.

#![allow(clippy::unreadable_literal, reason = "doubles as they are printed")]

use super::Wide;

impl Wide {
    /// `2^k e^r`, `r` below ln 2 / 2, by the series at r / 256 and eight squarings.
    pub fn exp(self) -> Self {
        let k = (self.high / Self::LN_2.high).round();
        let r = (self - Self::LN_2 * k) * (1.0 / 256.0);
        // e^r - 1, so that squaring does not lose what is small
        let mut rest = Self::ZERO;
        for n in (1..=11).rev() {
            rest = (rest + Self::ONE) * r / f64::from(n).into();
        }
        for _ in 0..8 {
            rest = rest * rest + rest * 2.0;
        }
        (rest + Self::ONE) * k.exp2()
    }

    /// One step of Halley's method from the logarithm of the leading part.
    pub fn ln(self) -> Self {
        let start = Self::from(self.high.ln());
        let there = start.exp();
        start + (self - there) / (self + there) * 2.0
    }

    /// The series of the sine within an eighth of a turn about zero.
    pub fn sin_cos(self) -> (Self, Self) {
        let quarter = Self::PI * 0.5;
        let mut turns = (self.high / quarter.high).round();
        let mut r = self - quarter * turns;
        // a number of turns beyond 2^53 is rounded, and leaves some of them
        while r.high.abs() > quarter.high {
            let further = (r.high / quarter.high).round();
            r = r - quarter * further;
            turns = turns.rem_euclid(4.0) + further;
        }
        let square = r * r;
        let mut sum = Self::ZERO;
        for factor in &SINE {
            sum = (sum + Self::ONE) * square * *factor;
        }
        let sine = r + r * sum;
        let cosine = (Self::ONE - sine * sine).sqrt();
        match turns.rem_euclid(4.0) {
            0.0 => (sine, cosine),
            1.0 => (cosine, -sine),
            2.0 => (-sine, -cosine),
            _ => (-cosine, sine),
        }
    }

    /// What is left after a turn by the angle of the leading parts.
    pub fn atan2(self, x: Self) -> Self {
        let start = Self::from(self.high.atan2(x.high));
        let (sine, cosine) = start.sin_cos();
        start + (self * cosine - x * sine) / (x * cosine + self * sine)
    }

    pub fn sinh(self) -> Self {
        let e = self.exp();
        (e - Self::ONE / e) * 0.5
    }

    pub fn cosh(self) -> Self {
        let e = self.exp();
        (e + Self::ONE / e) * 0.5
    }

    /// One, to all digits, from 40 on: where the others are too large for doubles, too.
    pub fn tanh(self) -> Self {
        if self.high.abs() > 40.0 {
            return self.high.signum().into();
        }
        self.sinh() / self.cosh()
    }

    /// Halley's method.
    pub fn cbrt(self) -> Self {
        let root = Self::from(self.high.cbrt());
        if root == Self::ZERO {
            return root;
        }
        let cube = root * root * root;
        root + root * (self - cube) / (cube * 2.0 + self)
    }
}

/// `-1 / (2n (2n + 1))`, n from 13 down to 1.
const SINE: [Wide; 13] = [
    Wide::new(-0.0014245014245014246, 7.104458680104445e-20),
    Wide::new(-0.0016666666666666668, 1.0697461435190311e-19),
    Wide::new(-0.001976284584980237, -1.3370398332627564e-19),
    Wide::new(-0.002380952380952381, 2.147752875018904e-19),
    Wide::new(-0.0029239766081871343, -1.6231330769373633e-19),
    Wide::new(-0.003676470588235294, -5.102127870520021e-20),
    Wide::new(-0.004761904761904762, 4.295505750037808e-19),
    Wide::new(-0.00641025641025641, -2.2240044563805217e-19),
    Wide::new(-0.00909090909090909, -4.415659757031872e-19),
    Wide::new(-0.013888888888888888, -7.709882115452476e-19),
    Wide::new(-0.023809523809523808, -1.32169407693471e-18),
    Wide::new(-0.05, 2.7755575615628915e-18),
    Wide::new(-0.16666666666666666, -9.25185853854297e-18),
];

#[cfg(test)]
mod tests {
    use super::Wide;

    type Function = fn(Wide) -> Wide;

    /// Values of mpmath 1.3 at 400 bits, each split into two doubles.
    const TABLE: [(Function, f64, [f64; 2]); 25] = [
        (
            Wide::exp,
            0.7,
            [2.0137527074704766, -2.0058243549764793e-16],
        ),
        (
            Wide::exp,
            -31.25,
            [2.6810038677818034e-14, -1.3268581611364822e-30],
        ),
        (Wide::exp, 3e-09, [1.000000003, -2.167650808769019e-17]),
        (Wide::ln, 0.7, [-0.35667494393873245, 4.82556379937662e-18]),
        (Wide::ln, 1e-07, [-16.11809565095832, 5.860990484933356e-16]),
        (
            Wide::ln,
            12345.678,
            [9.421061321291832, -1.9085650743481053e-16],
        ),
        (
            |x| x.sin_cos().0,
            0.7,
            [0.644217687237691, 2.8740567927338755e-18],
        ),
        (
            |x| x.sin_cos().0,
            -879.63632,
            [0.009622856624219966, 5.408570465232891e-19],
        ),
        (|x| x.sin_cos().0, 3e-09, [3e-09, -4.5e-27]),
        (
            |x| x.sin_cos().0,
            2.5,
            [0.5984721441039565, -5.521403334082375e-17],
        ),
        (
            |x| x.sin_cos().1,
            0.7,
            [0.7648421872844885, -4.013780434022238e-17],
        ),
        (
            |x| x.sin_cos().1,
            1000.5,
            [0.09710690144438526, 3.9534046844460945e-18],
        ),
        (
            |x| x.sin_cos().1,
            -3.1,
            [-0.9991351502732795, 1.3850578802683375e-17],
        ),
        (
            |x| x.atan2(Wide::ONE),
            0.7,
            [0.6107259643892086, 2.2418914462967458e-17],
        ),
        (
            |x| x.atan2(Wide::ONE),
            -44.0,
            [-1.5480729659532555, -5.633780946415682e-17],
        ),
        (
            Wide::sinh,
            0.7,
            [0.7585837018395335, -4.9693841630321686e-17],
        ),
        (
            Wide::sinh,
            -5.5,
            [-122.34392274639096, -3.0463153468293817e-15],
        ),
        (Wide::cosh, 0.7, [1.255169005630943, -3.986629140481058e-17]),
        (
            Wide::cbrt,
            0.7,
            [0.8879040017426006, 4.3733757090121296e-17],
        ),
        (
            Wide::tanh,
            -0.7,
            [-0.6043677771171635, 2.7916180015425346e-17],
        ),
        (Wide::tanh, 39.0, [1.0, -2.6672296310045227e-34]),
        (Wide::tanh, -400000.0, [-1.0, 0.0]),
        (Wide::cbrt, 1e-09, [0.001, -5.615122579506676e-23]),
        (
            |x| (-x).atan2(-Wide::ONE),
            0.7,
            [-2.5308666892005847, 1.0976537010747796e-17],
        ),
        (
            |x| Wide::ONE / x,
            0.7,
            [1.4285714285714286, 5.890979314337566e-17],
        ),
    ];

    #[test]
    fn values() {
        for (function, x, [high, low]) in TABLE {
            let computed = function(x.into());
            let error = (computed - Wide::new(high, low)).high / high;
            assert!(error.abs() < 1e-27, "at {x}: {error:e}");
        }
    }

    /// Beyond 2^53 turns their number is rounded; that of the angle is a part in 1e32.
    #[test]
    fn sines_of_large_numbers() {
        for x in [1e14, -3.7e16, 1.55e18, 9.9e20] {
            let (sine, cosine) = Wide::from(x).sin_cos();
            let off = [sine.high - f64::sin(x), cosine.high - f64::cos(x)];
            let off = off[0].abs().max(off[1].abs());
            assert!(off < 1e-31 * x.abs() + 1e-15, "at {x:e}: {off:e}");
        }
    }
}
