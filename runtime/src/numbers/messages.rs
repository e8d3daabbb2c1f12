//! Messages of errors, and numbers in them.

use core::fmt;

/// Prints the sentence of `Display` as `Debug`, too: a program shows it if its `main` returns the
/// error.
macro_rules! debug_as_display {
    ($error:ident $(<$state:ident>)?) => {
        impl$(<$state>)? core::fmt::Debug for $error$(<$state>)? {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                core::fmt::Display::fmt(self, f)
            }
        }
    };
}
pub(crate) use debug_as_display;

/// A number in a message, with the fewest digits that read back to the same bits. Very large and
/// very small numbers have a power of ten.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Number(pub(crate) f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(number) = *self;
        let size = number.abs();
        if size == 0.0 || !size.is_finite() || (1e-4..1e7).contains(&size) {
            write!(f, "{number}")
        } else {
            write!(f, "{number:e}")
        }
    }
}

/// The same to six significant digits; with all its digits beyond 1e22 and below 1e-17.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Brief(pub(crate) f64);

impl fmt::Display for Brief {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(number) = *self;
        let size = number.abs();
        if size == 0.0 || !size.is_finite() {
            return Number(number).fmt(f);
        }
        let digits = 5.0 - libm::floor(libm::log10(size));
        // these powers of ten are exact, so that the quotient prints with its six digits
        let scale = libm::pow(10.0, digits.abs());
        let rounded = match digits {
            0.0..=22.0 => libm::round(number * scale) / scale,
            -17.0..0.0 => libm::round(number / scale) * scale,
            _ => number,
        };
        Number(rounded).fmt(f)
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::string::ToString;

    use super::{Brief, Number};

    #[test]
    fn six_digits() {
        for (number, text) in [
            (0.0, "0"),
            (-13.442_302_613_965_246, "-13.4423"),
            (9.806_65, "9.80665"),
            (0.1, "0.1"),
            (1_234.567_89, "1234.57"),
            (999_999.7, "1000000"),
            (1.0 / 3e9, "3.33333e-10"),
            (1e-9, "1e-9"),
            (-2e9 / 3.0, "-6.66667e8"),
            (5e-324, "5e-324"),
            (f64::NAN, "NaN"),
            (f64::NEG_INFINITY, "-inf"),
        ] {
            assert_eq!(Brief(number).to_string(), text);
        }
    }

    #[test]
    fn all_digits() {
        for (number, text) in [
            (0.0, "0"),
            (0.1 + 0.2, "0.30000000000000004"),
            (86_400.125, "86400.125"),
            (-1e300, "-1e300"),
            (1.25e9, "1.25e9"),
            (f64::MAX, "1.7976931348623157e308"),
            (1e-5, "1e-5"),
            (f64::NAN, "NaN"),
            (f64::INFINITY, "inf"),
        ] {
            assert_eq!(Number(number).to_string(), text);
        }
    }
}
