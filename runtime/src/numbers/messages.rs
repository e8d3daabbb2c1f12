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

/// A number to six significant digits; with all its digits beyond 1e22 and below 1e-17.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Brief(pub(crate) f64);

impl fmt::Display for Brief {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(number) = *self;
        let size = number.abs();
        if size == 0.0 || !size.is_finite() {
            return write!(f, "{number}");
        }
        let digits = 5.0 - libm::floor(libm::log10(size));
        // these powers of ten are exact, so that the quotient prints with its six digits
        let scale = libm::pow(10.0, digits.abs());
        let rounded = match digits {
            0.0..=22.0 => libm::round(number * scale) / scale,
            -17.0..0.0 => libm::round(number / scale) * scale,
            _ => number,
        };
        if (1e-4..1e7).contains(&size) {
            write!(f, "{rounded}")
        } else {
            write!(f, "{rounded:e}")
        }
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::string::ToString;

    use super::Brief;

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
}
