//! What token streams are made of: words of the language and other words, numbers, signs.

use fastrand::Rng;
use proc_macro2::{Ident, Literal, Punct, Spacing, Span, TokenTree};

/// Keys, kinds of motion, functions, units and built-in names.
const LANGUAGE: &str = "doc motion mass inertia params inputs points locals forces moments joint_forces joint_moments reactions \
    constraints fields potentials outputs pole checks constants functions states rates urdf mjcf locked \
    planar planar_translation pivot spatial translation rotation fixed_point fixed_axis rod \
    principal tensor products about compose cuboid cylinder sphere cone tube shell disc ellipsoid torus hole turned \
    at on moment world body in_body in_world position velocity attitude angular_velocity t G PI TAU \
    dot cross norm norm_squared normalize powi powf sqrt cbrt sin cos tan asin acos atan atan2 exp ln tanh abs signum floor ceil \
    min max clamp hypot recip x y z xx yy zz xy yz zx if else \
    bodies joints drives copies drawing zero_pose revolute prismatic cylindrical screw universal spherical weld cable free on between angle angle_1 angle_2 \
    table cubic extrapolated derivatives moving acceleration angular_acceleration link pin_in_slot driven armature along \
    kinetic_energy potential_energy linear_momentum angular_momentum force moment \
    energy momentum reactions balance checks given turned linearization sensitivity regressor constant mass_matrix jacobian flow taylor inverse kg m s N J W rad deg inch mm lb slug ft K A C V Pa Hz";
/// Words that mean something to Rust, or nothing to anybody.
const OTHERS: &str = "a b c tip arm load k u v self Self super crate type in box fn as let mut match loop while unsafe union dyn yield \
    async await try macro_rules _ __ _a PI2 é Ω 質量 ñandú main core std f64 i32 r#x r#type r#mass r#if T AnyScalar";
const NUMBERS: &str = "0 1 2 3 4 -0 0.0 0.5 1.5 9.80665 1e3 1e308 1e309 1e999 1e-308 1e-324 1e-400 5e-324 1e99999999999999999999 1e5000 1e-5000 \
    1e4999 0x10 0xFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFF 0b101 0o17 1_000 1__0 1f64 2.5f32 2kg 3usize 2. 4_f64 0e0 00012 64 65 127 \
    128 1e18 2147483648 9223372036854775808 18446744073709551616 1.7976931348623157e308 1.7976931348623159e308 4.9e-324 2.4e-324";
/// Literals that are no numbers.
const TEXTS: [&str; 8] = [
    "\"text\"",
    "\"\"",
    "'c'",
    "b'c'",
    "b\"bytes\"",
    "c\"text\"",
    "r#\"raw\"#",
    "\"\\u{0}\\n/**/\"",
];
const SIGNS: &str = "+-*/%^!&|=<>@.,;:#$?~'";

/// A list of words as tokens.
pub struct Words {
    language: Vec<TokenTree>,
    others: Vec<TokenTree>,
    numbers: Vec<TokenTree>,
}

impl Default for Words {
    fn default() -> Self {
        let idents = |list: &str| list.split_whitespace().map(ident).collect();
        let numbers = NUMBERS.split_whitespace().chain(TEXTS);
        Self {
            language: idents(LANGUAGE),
            others: idents(OTHERS),
            numbers: numbers.map(literal).collect(),
        }
    }
}

impl Words {
    /// A word, mostly of the language.
    pub fn word(&self, rng: &mut Rng) -> TokenTree {
        let list = if rng.u8(..4) == 0 {
            &self.others
        } else {
            &self.language
        };
        list[rng.usize(..list.len())].clone()
    }

    /// A number, sometimes one of many digits, sometimes none at all.
    pub fn number(&self, rng: &mut Rng) -> TokenTree {
        match rng.u8(..16) {
            0 => literal(&digits(rng)),
            1 => literal(
                &format!("{:e}", f64::from_bits(rng.u64(..) >> 1))
                    .replace("NaN", "1")
                    .replace("inf", "1"),
            ),
            2..8 => Literal::u8_unsuffixed(rng.u8(..10)).into(),
            _ => self.numbers[rng.usize(..self.numbers.len())].clone(),
        }
    }
}

/// Up to a few thousand digits, as an integer or with a point, in any radix.
fn digits(rng: &mut Rng) -> String {
    let count = 1 << rng.usize(..13);
    let digit = char::from(b'0' + rng.u8(1..8));
    let digits: String = core::iter::repeat_n(digit, count).collect();
    match rng.u8(..5) {
        0 => format!("0x{digits}"),
        1 => format!("0b{}", digits.replace(digit, "1")),
        2 => format!("{digits}.{digits}"),
        3 => format!("0.{digits}e{count}"),
        _ => digits,
    }
}

/// A sign, alone or joined to what follows.
pub fn sign(rng: &mut Rng) -> TokenTree {
    let signs = SIGNS.as_bytes();
    let sign = char::from(signs[rng.usize(..signs.len())]);
    let spacing = if rng.bool() {
        Spacing::Alone
    } else {
        Spacing::Joint
    };
    Punct::new(if sign == '\'' { ',' } else { sign }, spacing).into()
}

pub fn ident(word: &str) -> TokenTree {
    match word.strip_prefix("r#") {
        Some(raw) => Ident::new_raw(raw, Span::call_site()).into(),
        None => Ident::new(word, Span::call_site()).into(),
    }
}

pub fn literal(text: &str) -> TokenTree {
    let literal: Literal = text
        .parse()
        .unwrap_or_else(|error| panic!("`{text}`: {error}"));
    literal.into()
}
