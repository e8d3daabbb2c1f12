//! The factors and dimensions of units.

use proc_macro2::Ident;

use crate::errors::{Errors, Extent, hint};
use crate::fraction::Fraction;
use crate::model::{Dimension, Unit};
use crate::symbolic::{Function, Number};
use crate::syntax::{BUILT_IN, Expression, Kind, Operator, Prefix, Step, UnitExpression};
use crate::units::{ANGLES, CUSTOMARY, METRIC, PREFIXES, SPELT_OUT, is_unit, unit_and_exponent};

use super::lowering::Lowering;

/// The factor that converts a unit to SI units, and its dimension. Unknown names are reported.
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

/// The unit for display, in the words of the user.
pub fn written_unit(unit: &UnitExpression) -> Unit {
    let factors = unit.factors.iter();
    Unit(
        factors
            .map(|(name, exponent)| (name.to_string(), *exponent))
            .collect(),
    )
}

/// The unit with radians in place of other angles.
pub fn in_radians(unit: &UnitExpression) -> UnitExpression {
    let mut unit = unit.clone();
    for (name, _) in &mut unit.factors {
        if ANGLES.iter().any(|(angle, _)| name == angle) {
            *name = Ident::new("rad", name.span());
        }
    }
    unit
}

impl Lowering<'_> {
    /// Reports a unit that is written as factors behind a number: `0.1 * kg * m`, `9.81 * m / s ^ 2`.
    pub fn check_brackets_of_unit(&mut self, first: &Expression, rest: &[Step]) -> Option<()> {
        let number = match &first.kind {
            Kind::Prefix(Prefix::Minus, number) => number,
            _ => first,
        };
        let Kind::Number(digits) = &number.kind else {
            return Some(());
        };
        let mut written = String::new();
        let mut place = None;
        for step in rest {
            let (sign, word) = match (step.operator, &step.operand.kind) {
                (Operator::Multiply, Kind::Name(unit)) if self.is_only_unit(unit) => {
                    (if place.is_some() { " * " } else { "" }, unit.to_string())
                }
                (Operator::Divide, Kind::Name(unit)) if self.is_only_unit(unit) => (
                    if place.is_some() { " / " } else { "1 / " },
                    unit.to_string(),
                ),
                (Operator::Power, Kind::Number(exponent)) if place.is_some() => {
                    (" ^ ", exponent.clone())
                }
                _ => break,
            };
            written.extend([sign, &word]);
            let unit = step.operand.extent;
            place = Some(place.map_or(unit, |place: Extent| place.to(unit)));
        }
        let Some(place) = place else {
            return Some(());
        };
        let message = format!("a unit goes in brackets: write `{digits}[{written}]`");
        self.report(place, message)
    }

    pub fn check_unitless(&mut self, found: Dimension, place: Extent) -> Option<()> {
        if found.is_known() {
            let found = found.described();
            let message = format!("the value is {found} already: leave this unit out");
            return self.report(place, message);
        }
        Some(())
    }

    /// The same for a vector. `[1]` is the unit of numbers, or means its second component.
    pub fn check_no_component(&mut self, found: Dimension, unit: &UnitExpression) -> Option<()> {
        if found.is_known() && unit.factors.is_empty() {
            let message = "brackets hold a unit: a component is written `.in_world().y`";
            return self.report(unit.extent, message);
        }
        self.check_unitless(found, unit.extent)
    }

    /// Whether a name is a unit and nothing else.
    fn is_only_unit(&self, name: &Ident) -> bool {
        let word = name.to_string();
        let is_name = BUILT_IN.contains(&word.as_str())
            || self.members.has(&word)
            || self.scope.knows(&word)
            || self.scope.is_lost(&word);
        is_unit(&word) && !is_name
    }
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

/// The sign for a millionth, as two characters.
const MICRO: [char; 2] = ['\u{b5}', '\u{3bc}'];

/// Units with prefixes, and others that no table lists.
const PREFIXED: [&str; 5] = ["kg", "mm", "cm", "km", "rpm"];

/// A suggestion for an unknown unit, if there is one.
fn advice(word: &str) -> String {
    let lower = word.to_lowercase();
    let singular = lower.strip_suffix('s').unwrap_or(&lower);
    if let Some((_, unit)) = SPELT_OUT.iter().find(|(name, _)| *name == singular) {
        return format!(": write `{unit}`");
    }
    if let Some(unit) = word.strip_prefix(MICRO).map(|unit| format!("u{unit}"))
        && look_up(&unit).is_some()
    {
        return format!(": write `{unit}`");
    }
    if singular.len() > 1 && word.ends_with('s') {
        let unit = &word[..word.len() - 1];
        if look_up(unit).is_some() {
            return format!(": write `{unit}`");
        }
    }
    if let Some((unit, digits)) = unit_and_exponent(word) {
        return format!(": write `{unit} ^ {digits}`");
    }
    if let Some(unit) = PREFIXED.iter().find(|unit| unit.eq_ignore_ascii_case(word)) {
        return format!(": write `{unit}`");
    }
    let halves = word.char_indices().skip(1).map(|(at, _)| word.split_at(at));
    let is_known = |half: &str| half == "kg" || METRIC.iter().any(|unit| unit.0 == half);
    if let Some((a, b)) = halves.into_iter().find(|(a, b)| is_known(a) && is_known(b)) {
        return format!(": write `{a} * {b}`");
    }
    let prefixed = PREFIXED.into_iter();
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

/// What a value in quotes should be.
pub fn unquoted(text: &str) -> String {
    let is_number = |digits: &str| {
        let digits = digits.trim_start_matches('-');
        digits.starts_with(|first: char| first.is_ascii_digit()) && digits.parse::<f64>().is_ok()
    };
    let mut ends = text.char_indices().map(|(end, last)| end + last.len_utf8());
    let Some(end) = ends.rfind(|end| is_number(text[..*end].trim())) else {
        return "a value has no quotes".to_owned();
    };
    let (digits, unit) = (text[..end].trim(), text[end..].trim());
    if unit.is_empty() {
        return format!("a number has no quotes: write `{digits}`");
    }
    format!("a number has no quotes, and its unit goes in brackets: write `{digits}[{unit}]`")
}
