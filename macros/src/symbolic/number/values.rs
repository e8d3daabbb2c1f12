//! The values of functions at numbers: exact where they are rational, otherwise known by
//! identities.

use dashu_ratio::RBig;

use super::exact::Number;
use super::float::Float;
use super::function::Function;
use super::rational_residues::root_residue;
use super::residue::{FACTORS, ORDER, Residue, on_circle, root_of_unity};

/// Powers with integer exponents up to this one are multiplied out; others are exponentials.
const POWERS: i64 = 1 << 10;
/// The exponential of the negative of a larger number has too many digits to be kept.
const SMALLEST: i64 = 10_000;
/// The bits to which the hyperbolic tangent of a larger number is one.
const ENDLESS: usize = 1 << 14;
/// The highest degree of roots that are tried for a rational value.
const ROOTS: usize = 12;

thread_local! {
    static ROOT_OF_UNITY: Option<Residue> = {
        let root = |of: u64| root_residue(&Number::from(RBig::from(of)));
        let [two, three, five, seven, eleven, thirteen] = FACTORS.map(root);
        root_of_unity([two?, three?, five?, seven?, eleven?, thirteen?])
    };
}

impl Number {
    /// The value of a function, or `None` outside its domain or the range of doubles.
    pub fn apply(function: Function, arguments: &[Self]) -> Option<Self> {
        let x = arguments.first()?;
        let second = || arguments.get(1);
        match function {
            Function::Abs => Some(x.abs()),
            Function::Signum => Some(Self::integer(if x.is_negative() { -1 } else { 1 })),
            Function::Floor => Some(x.floor()),
            Function::Ceil => Some(-(-x.clone()).floor()),
            Function::Min => Some(x.min(second()?).clone()),
            Function::Max => Some(x.max(second()?).clone()),
            Function::Sqrt => x.sqrt(),
            Function::Cbrt => x.cbrt(),
            Function::Hypot => {
                let y = second()?;
                (x.clone() * x.clone() + y.clone() * y.clone()).sqrt()
            }
            Function::Powf => x.powf(second()?),
            Function::Exp => x.exp(),
            Function::Ln => x.ln(),
            Function::Sin => x.sin(),
            Function::Cos => x.cos(),
            Function::Tan => x.sin()?.checked_div(&x.cos()?),
            Function::Asin => x.asin(),
            Function::Acos => Some(right_angle() - x.asin()?),
            Function::Atan => x.atan(),
            Function::Atan2 => x.atan2(second()?),
            Function::Sinh | Function::Cosh | Function::Tanh => x.hyperbolic(function),
            // the table is not known here
            Function::Table => None,
        }
    }

    /// The largest integer that is certainly not above the number.
    fn floor(&self) -> Self {
        let near = Self::from(RBig::from(self.value.round()));
        if (self.clone() - near.clone()).is_negative() {
            near - Self::one()
        } else {
            near
        }
    }

    fn sqrt(&self) -> Option<Self> {
        if self.is_negative() {
            return None;
        }
        if self.is_zero() {
            return Some(Self::zero());
        }
        if self.is_rounded() {
            return match self.to_rational() {
                Some(rational) => rational.sqrt(),
                None => Self::value_of(Function::Sqrt, self, None),
            };
        }
        let residue = root_residue(self);
        self.exact_root(2)
            .or_else(|| Self::value_of(Function::Sqrt, self, residue))
    }

    fn cbrt(&self) -> Option<Self> {
        if self.is_negative() {
            return Some(-(-self.clone()).cbrt()?);
        }
        if self.is_zero() {
            return Some(Self::zero());
        }
        self.exact_root(3)
            .or_else(|| Self::value_of(Function::Cbrt, self, None))
    }

    /// A power as for `f64`: negative numbers have powers with integer exponents only.
    fn powf(&self, exponent: &Self) -> Option<Self> {
        if exponent.is_zero() || self.is_one() {
            return Some(Self::one());
        }
        if self.is_zero() {
            return exponent.is_positive().then(Self::zero);
        }
        match exponent.to_integer() {
            Some(whole) if whole.abs() <= POWERS => return self.power(whole),
            _ => {}
        }
        if self.is_negative() {
            let magnitude = self.abs().powf(exponent)?;
            let half = exponent.clone() / Self::integer(2);
            return match (exponent.is_whole(), half.is_whole()) {
                (true, true) => Some(magnitude),
                (true, false) => Some(-magnitude),
                _ => None,
            };
        }
        if let Some((above, below)) = exponent.to_fraction()
            && let (true, Ok(degree)) = (above.abs() <= POWERS, usize::try_from(below))
            && degree <= ROOTS
            && let Some(root) = self.power(above)?.exact_root(degree)
        {
            return Some(root);
        }
        (self.ln()? * exponent.clone()).exp()
    }

    pub fn is_whole(&self) -> bool {
        !self.is_rounded() && self.value.is_int()
    }

    /// Whether its exponential is neither far beyond the range of doubles nor too long a number.
    pub(in crate::symbolic) fn has_exponential(&self) -> bool {
        *self < Self::integer(1000) && *self > Self::integer(-SMALLEST)
    }

    fn exp(&self) -> Option<Self> {
        if !self.has_exponential() {
            return None;
        }
        if self.is_zero() {
            return Some(Self::one());
        }
        if self.is_negative() {
            let grown = (-self.clone()).exp_of_positive()?;
            return Self::one().checked_div(&grown);
        }
        self.exp_of_positive()
    }

    fn exp_of_positive(&self) -> Option<Self> {
        match self.argument(Function::Ln) {
            Some(argument) => Some(argument.clone()),
            None => Self::value_of(Function::Exp, self, None),
        }
    }

    fn ln(&self) -> Option<Self> {
        if !self.is_positive() {
            return None;
        }
        if self.is_one() {
            return Some(Self::zero());
        }
        match self.argument(Function::Exp) {
            Some(argument) => Some(argument.clone()),
            None => Self::value_of(Function::Ln, self, None),
        }
    }

    fn hyperbolic(&self, function: Function) -> Option<Self> {
        if self.is_negative() {
            let value = (-self.clone()).hyperbolic(function)?;
            return Some(if function == Function::Cosh {
                value
            } else {
                -value
            });
        }
        if function == Function::Tanh {
            return self.tanh();
        }
        let grown = self.exp()?;
        let decayed = Self::one().checked_div(&grown)?;
        let twice = match function {
            Function::Sinh => grown - decayed,
            _ => grown + decayed,
        };
        Some(twice / Self::integer(2))
    }

    /// `(1 - e^-2x) / (1 + e^-2x)`; one to [`ENDLESS`] bits where `e^-2x` has too many digits.
    fn tanh(&self) -> Option<Self> {
        let Some(decayed) = (Self::integer(-2) * self.clone()).exp() else {
            return Some(Self::measured(Float::ONE, ENDLESS));
        };
        (Self::one() - decayed.clone()).checked_div(&(Self::one() + decayed))
    }

    /// The number divided by pi, if that is a ratio of small numbers or a multiple of a twelfth.
    fn half_turns(&self) -> Option<Self> {
        let is_equal = |turns: &Self| (turns.clone() * Self::pi() - self.clone()).is_zero();
        let small = (self.residue() * Self::pi().residue().reciprocal()?).to_number();
        let twelfths = || {
            let near = self.clone() * Self::integer(12) / Self::pi();
            Self::from(RBig::from(near.value.round())) / Self::integer(12)
        };
        let turns = small.filter(&is_equal).unwrap_or_else(twelfths);
        is_equal(&turns).then_some(turns)
    }

    fn cos(&self) -> Option<Self> {
        match self.half_turns() {
            Some(turns) => sine_of_half_turns(turns + Self::ratio(1, 2)),
            None if self.is_zero() => Some(Self::one()),
            None => match self.on_circle_by_tangent() {
                Some([cosine, _]) => Some(cosine),
                None => self.abs().on_circle(Function::Cos),
            },
        }
    }

    fn sin(&self) -> Option<Self> {
        match self.half_turns() {
            Some(turns) => sine_of_half_turns(turns),
            None if self.is_zero() => Some(Self::zero()),
            None => match self.on_circle_by_tangent() {
                Some([_, sine]) => Some(sine),
                None if self.is_negative() => Some(-(-self.clone()).on_circle(Function::Sin)?),
                None => self.on_circle(Function::Sin),
            },
        }
    }

    /// The sine or cosine of a number of half turns between zero and one.
    fn of_half_turns(half_turns: &Self, function: Function) -> Option<Self> {
        let angle = half_turns.clone() * Self::pi();
        let parts = half_turns.clone() * Self::from(RBig::from(ORDER / 2));
        let parts = parts
            .to_integer()
            .and_then(|parts| u64::try_from(parts).ok());
        let Some((root, parts)) = ROOT_OF_UNITY.with(|root| *root).zip(parts) else {
            return angle.on_circle(function);
        };
        let on_circle = on_circle(root, parts);
        let residue = match function {
            Function::Sin => on_circle.imaginary,
            _ => on_circle.real,
        };
        Self::value_of(function, &angle, Some(Residue::real(residue)))
    }

    /// The sine or cosine of an angle, by the tangent of half the angle.
    fn on_circle(&self, function: Function) -> Option<Self> {
        let tangent = Residue::stand_in(&(Function::Tan, self.residue()));
        let square = tangent * tangent;
        let above = match function {
            Function::Sin => tangent + tangent,
            _ => Residue::ONE + -square,
        };
        let below = (Residue::ONE + square).reciprocal()?;
        Self::value_of(function, self, Some(above * below))
    }

    fn asin(&self) -> Option<Self> {
        if self.is_negative() {
            return Some(-(-self.clone()).asin()?);
        }
        let square = Self::one() - self.clone() * self.clone();
        if square.is_negative() {
            return None;
        }
        for twelfth in 0..=6 {
            if *self == sine_of_twelfths(twelfth)? {
                return Some(Self::pi() * Self::ratio(twelfth, 12));
            }
        }
        self.checked_div(&square.sqrt()?)?.atan()
    }

    fn atan(&self) -> Option<Self> {
        if self.is_negative() {
            return Some(-(-self.clone()).atan()?);
        }
        for twelfth in 0..=5 {
            let cosine = sine_of_twelfths(6 - twelfth)?;
            if self.clone() * cosine == sine_of_twelfths(twelfth)? {
                return Some(Self::pi() * Self::ratio(twelfth, 12));
            }
        }
        Self::value_of(Function::Atan, self, None)
    }

    /// The angle of the point `(x, self)`; that of the origin is zero, as for `f64`.
    fn atan2(&self, x: &Self) -> Option<Self> {
        if x.is_zero() {
            let right = right_angle();
            return Some(match () {
                () if self.is_zero() => Self::zero(),
                () if self.is_negative() => -right,
                () => right,
            });
        }
        let angle = self.checked_div(x)?.atan()?;
        Some(match (x.is_negative(), self.is_negative()) {
            (false, _) => angle,
            (true, false) => angle + Self::pi(),
            (true, true) => angle - Self::pi(),
        })
    }
}

fn right_angle() -> Number {
    Number::pi() / Number::integer(2)
}

/// `sin(turns pi)`, from an angle of at most an eighth of a turn.
fn sine_of_half_turns(turns: Number) -> Option<Number> {
    let two = Number::integer(2);
    let whole = (turns.clone() / two.clone()).floor() * two;
    let turns = turns - whole;
    if turns >= Number::one() {
        return Some(-sine_of_half_turns(turns - Number::one())?);
    }
    let half = Number::ratio(1, 2);
    let turns = if turns > half {
        Number::one() - turns
    } else {
        turns
    };
    if let Some(twelfth) = (turns.clone() * Number::integer(12)).to_integer() {
        return sine_of_twelfths(twelfth);
    }
    if turns > Number::ratio(1, 4) {
        Number::of_half_turns(&(half - turns), Function::Cos)
    } else {
        Number::of_half_turns(&turns, Function::Sin)
    }
}

/// `sin(twelfth pi / 12)`, up to a right angle.
fn sine_of_twelfths(twelfth: i64) -> Option<Number> {
    let root = |of: i64| Number::integer(of).sqrt();
    let quarter = Number::ratio(1, 4);
    Some(match twelfth {
        0 => Number::zero(),
        1 => (root(6)? - root(2)?) * quarter,
        2 => Number::ratio(1, 2),
        3 => root(2)? * Number::ratio(1, 2),
        4 => root(3)? * Number::ratio(1, 2),
        5 => (root(6)? + root(2)?) * quarter,
        _ => Number::one(),
    })
}
