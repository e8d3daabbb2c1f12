//! The units allowed in brackets, and their SI values.

use crate::errors::{Errors, hint};
use crate::fraction::Fraction;
use crate::model::{Dimension, Unit};
use crate::symbolic::{Function, Number};
use crate::syntax::UnitExpression;

/// Units that take the prefixes of [`PREFIXES`]: name, powers of kg, m, s, A, K, mol, cd; the gram
/// stands in for the kilogram.
const METRIC: [(&str, [i16; 7]); 18] = [
    ("g", [1, 0, 0, 0, 0, 0, 0]),
    ("m", [0, 1, 0, 0, 0, 0, 0]),
    ("s", [0, 0, 1, 0, 0, 0, 0]),
    ("A", [0, 0, 0, 1, 0, 0, 0]),
    ("K", [0, 0, 0, 0, 1, 0, 0]),
    ("mol", [0, 0, 0, 0, 0, 1, 0]),
    ("cd", [0, 0, 0, 0, 0, 0, 1]),
    ("rad", [0, 0, 0, 0, 0, 0, 0]),
    ("sr", [0, 0, 0, 0, 0, 0, 0]),
    ("Hz", [0, 0, -1, 0, 0, 0, 0]),
    ("N", [1, 1, -2, 0, 0, 0, 0]),
    ("Pa", [1, -1, -2, 0, 0, 0, 0]),
    ("J", [1, 2, -2, 0, 0, 0, 0]),
    ("W", [1, 2, -3, 0, 0, 0, 0]),
    ("C", [0, 0, 1, 1, 0, 0, 0]),
    ("V", [1, 2, -3, -1, 0, 0, 0]),
    ("T", [1, 0, -2, -1, 0, 0, 0]),
    ("Wb", [1, 2, -2, -1, 0, 0, 0]),
];

const PREFIXES: [(&str, i64); 12] = [
    ("n", -9),
    ("u", -6),
    ("m", -3),
    ("c", -2),
    ("d", -1),
    ("h", 2),
    ("k", 3),
    ("M", 6),
    ("G", 9),
    ("T", 12),
    ("da", 1),
    ("p", -12),
];

/// Units with a rational factor: name, numerator, denominator, powers of kg, m, s, A, K, mol, cd.
const CUSTOMARY: [(&str, i64, u64, [i16; 7]); 17] = [
    ("min", 60, 1, [0, 0, 1, 0, 0, 0, 0]),
    ("h", 3600, 1, [0, 0, 1, 0, 0, 0, 0]),
    ("day", 86_400, 1, [0, 0, 1, 0, 0, 0, 0]),
    ("t", 1000, 1, [1, 0, 0, 0, 0, 0, 0]),
    ("L", 1, 1000, [0, 3, 0, 0, 0, 0, 0]),
    ("bar", 100_000, 1, [1, -1, -2, 0, 0, 0, 0]),
    ("inch", 254, 10_000, [0, 1, 0, 0, 0, 0, 0]),
    ("ft", 3048, 10_000, [0, 1, 0, 0, 0, 0, 0]),
    ("yd", 9144, 10_000, [0, 1, 0, 0, 0, 0, 0]),
    ("mi", 1_609_344, 1000, [0, 1, 0, 0, 0, 0, 0]),
    ("nmi", 1852, 1, [0, 1, 0, 0, 0, 0, 0]),
    ("knot", 1852, 3600, [0, 1, -1, 0, 0, 0, 0]),
    ("lb", 45_359_237, 100_000_000, [1, 0, 0, 0, 0, 0, 0]),
    ("oz", 45_359_237, 1_600_000_000, [1, 0, 0, 0, 0, 0, 0]),
    (
        "lbf",
        44_482_216_152_605,
        10_000_000_000_000,
        [1, 1, -2, 0, 0, 0, 0],
    ),
    ("kgf", 980_665, 100_000, [1, 1, -2, 0, 0, 0, 0]),
    // 1 lbf accelerates a slug by 1 ft / s^2
    (
        "slug",
        44_482_216_152_605,
        3_048_000_000_000,
        [1, 0, 0, 0, 0, 0, 0],
    ),
];

/// Angles, in turns.
const ANGLES: [(&str, u64); 4] = [
    ("deg", 360),
    ("arcmin", 21_600),
    ("arcsec", 1_296_000),
    ("rev", 1),
];

/// Names that are written as symbols.
const SPELT_OUT: [(&str, &str); 21] = [
    ("newton", "N"),
    ("meter", "m"),
    ("metre", "m"),
    ("second", "s"),
    ("sec", "s"),
    ("kilogram", "kg"),
    ("gram", "g"),
    ("radian", "rad"),
    ("degree", "deg"),
    ("minute", "min"),
    ("hour", "h"),
    ("hr", "h"),
    ("foot", "ft"),
    ("feet", "ft"),
    ("inche", "inch"),
    ("pound", "lb"),
    ("joule", "J"),
    ("watt", "W"),
    ("volt", "V"),
    ("hertz", "Hz"),
    ("tonne", "t"),
];

/// The factor to SI and the dimension of a unit; unknown names are reported.
pub fn lower_unit(unit: &UnitExpression, errors: &mut Errors) -> Option<(Number, Dimension)> {
    let mut known = Some((Number::one(), Dimension::NONE));
    let mut is_known = true;
    for (name, exponent) in &unit.factors {
        let word = name.to_string();
        let Some((factor, dimension)) = look_up(&word) else {
            errors.push(
                name.span(),
                format!("unknown unit `{word}`{}", advice(&word)),
            );
            is_known = false;
            continue;
        };
        let raised = raised(&factor, dimension, *exponent);
        known = known.and_then(|(total, product)| {
            let (factor, dimension) = raised?;
            Some((total * factor, product.times(dimension)?))
        });
        if known.is_none() {
            return errors.report(name.span(), TOO_LARGE);
        }
    }
    known.filter(|_| is_known)
}

/// The unit for display: in the written words.
pub fn written_unit(unit: &UnitExpression) -> Unit {
    let factors = unit.factors.iter();
    Unit(
        factors
            .map(|(name, exponent)| (name.to_string(), *exponent))
            .collect(),
    )
}

/// The message for an impossible dimension.
pub const TOO_LARGE: &str =
    "this has a unit with an exponent beyond 1000, or with a fraction of larger numbers";

fn raised(
    factor: &Number,
    dimension: Dimension,
    exponent: Fraction,
) -> Option<(Number, Dimension)> {
    let (above, below) = exponent.parts();
    let power = Number::ratio(above, below.unsigned_abs());
    let factor = Number::apply(Function::Powf, &[factor.clone(), power])?;
    Some((factor, dimension.power(exponent)?))
}

/// A suggestion for an unknown unit, if there is one.
fn advice(word: &str) -> String {
    let lower = word.to_lowercase();
    let singular = lower.strip_suffix('s').unwrap_or(&lower);
    if let Some((_, unit)) = SPELT_OUT.iter().find(|(name, _)| *name == singular) {
        return format!(": write `{unit}`");
    }
    if singular.len() > 1 && word.ends_with('s') {
        let unit = &word[..word.len() - 1];
        if look_up(unit).is_some() {
            return format!(": write `{unit}`");
        }
    }
    let digits = word.trim_start_matches(char::is_alphabetic);
    let unit = word.trim_end_matches(digits);
    if !digits.is_empty() && look_up(unit).is_some() {
        return format!(": write `{unit} ^ {digits}`");
    }
    let halves = word.char_indices().skip(1).map(|(at, _)| word.split_at(at));
    let is_known = |half: &str| half == "kg" || METRIC.iter().any(|unit| unit.0 == half);
    if let Some((a, b)) = halves.into_iter().find(|(a, b)| is_known(a) && is_known(b)) {
        return format!(": write `{a} * {b}`");
    }
    let prefixed = ["kg", "mm", "cm", "km", "rpm"].into_iter();
    let metric = METRIC.iter().map(|unit| unit.0);
    let customary = CUSTOMARY.iter().map(|unit| unit.0);
    let angles = ANGLES.iter().map(|unit| unit.0);
    hint(word, prefixed.chain(metric).chain(customary).chain(angles))
}

fn look_up(word: &str) -> Option<(Number, Dimension)> {
    if let Some((_, numerator, denominator, exponents)) =
        CUSTOMARY.iter().find(|unit| unit.0 == word)
    {
        return Some((
            Number::ratio(*numerator, *denominator),
            Dimension::base(*exponents),
        ));
    }
    if let Some((_, parts)) = ANGLES.iter().find(|unit| unit.0 == word) {
        return Some((Number::pi() * Number::ratio(2, *parts), Dimension::NONE));
    }
    if word == "rpm" {
        return Some((Number::pi() / Number::integer(30), Dimension::FREQUENCY));
    }
    let metric = |name: &str, power: i64| {
        let (_, exponents) = METRIC.iter().find(|unit| unit.0 == name)?;
        let power = if name == "g" { power - 3 } else { power };
        Some((Number::power_of_ten(power), Dimension::base(*exponents)))
    };
    metric(word, 0).or_else(|| {
        PREFIXES
            .iter()
            .find_map(|(prefix, power)| metric(word.strip_prefix(prefix)?, *power))
    })
}
