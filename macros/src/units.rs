//! The words of units, with their factors and dimensions.

/// Units that take the prefixes of [`PREFIXES`]: name, and powers of kg, m, s, A, K, mol, cd. The
/// gram stands in for the kilogram.
pub const METRIC: [(&str, [i16; 7]); 18] = [
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

pub const PREFIXES: [(&str, i64); 12] = [
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

/// Units with a rational factor: name, numerator, denominator, and powers of kg, m, s, A, K, mol,
/// cd.
pub const CUSTOMARY: [(&str, i64, u64, [i16; 7]); 17] = [
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

/// Units of angles: name, and how many make one turn.
pub const ANGLES: [(&str, u64); 4] = [
    ("deg", 360),
    ("arcmin", 21_600),
    ("arcsec", 1_296_000),
    ("rev", 1),
];

/// Names of units that have to be written as symbols.
pub const SPELT_OUT: [(&str, &str); 21] = [
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

/// Whether a word is a unit.
pub fn is_unit(word: &str) -> bool {
    let is_metric = |word: &str| METRIC.iter().any(|unit| unit.0 == word);
    let is_prefixed = |(prefix, _): &(&str, i64)| word.strip_prefix(prefix).is_some_and(is_metric);
    is_metric(word)
        || word == "rpm"
        || CUSTOMARY.iter().any(|unit| unit.0 == word)
        || ANGLES.iter().any(|unit| unit.0 == word)
        || PREFIXES.iter().any(is_prefixed)
}

/// The halves of a word such as `s2`: a unit and its exponent.
pub fn unit_and_exponent(word: &str) -> Option<(&str, &str)> {
    let digits = word.trim_start_matches(char::is_alphabetic);
    let unit = word.strip_suffix(digits)?;
    let is_number = !digits.is_empty() && digits.bytes().all(|digit| digit.is_ascii_digit());
    (is_number && is_unit(unit)).then_some((unit, digits))
}
