//! Text and numbers in markup, and its colors.

use std::fmt::{self, Write as _};
use std::format;
use std::string::String;

/// Text with the characters of markup escaped. Characters that XML does not allow are replaced.
pub(super) struct Escaped<'t>(pub(super) &'t str);

impl fmt::Display for Escaped<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.chars().try_for_each(|sign| match sign {
            '&' => f.write_str("&amp;"),
            '<' => f.write_str("&lt;"),
            '>' => f.write_str("&gt;"),
            '"' => f.write_str("&quot;"),
            '\'' => f.write_str("&#39;"),
            '\t' | '\n' | '\r' => f.write_char(' '),
            sign if sign.is_control() || matches!(sign, '\u{fffe}' | '\u{ffff}') => {
                f.write_char('\u{fffd}')
            }
            sign => f.write_char(sign),
        })
    }
}

/// A number with at most this many decimals, without trailing zeros; finite.
pub(super) fn short(number: f64, decimals: usize) -> String {
    let text = format!("{number:.decimals$}");
    let text = if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.')
    } else {
        &text
    };
    String::from(if text == "-0" { "0" } else { text })
}

/// The colors of curves and solids, as red, green and blue, after M. Okabe and K. Ito, "Color
/// universal design", 2008. Those that would be faint as text on white are darkened.
pub(super) const COLORS: [[u8; 3]; 7] = [
    [0x00, 0x72, 0xb2],
    [0xd5, 0x5e, 0x00],
    [0x00, 0x8f, 0x68],
    [0xa8, 0x47, 0x8b],
    [0xa8, 0x7b, 0x00],
    [0x3f, 0x9b, 0xd1],
    [0x55, 0x55, 0x55],
];

/// The same on a dark ground.
const ON_DARK: [[u8; 3]; 7] = [
    [0x4d, 0xb1, 0xec],
    [0xff, 0x8f, 0x3d],
    [0x2b, 0xd4, 0xa0],
    [0xe3, 0x93, 0xc8],
    [0xf0, 0xc8, 0x3c],
    [0x9a, 0xd8, 0xff],
    [0xc4, 0xc4, 0xc4],
];

/// Curves beyond the number of colors repeat the colors with dashes.
pub(super) const DASHES: [&str; 3] = ["", "6 3", "2 3"];

/// The rules of style that all pictures share.
pub(super) fn style() -> String {
    let colors = |colors: &[[u8; 3]; 7]| {
        let mut rules = String::new();
        for (k, [r, g, b]) in colors.iter().enumerate() {
            let _ = write!(rules, "--c{k}:#{r:02x}{g:02x}{b:02x};");
        }
        rules
    };
    let mut classes = String::new();
    for k in 0..COLORS.len() {
        let _ = write!(
            classes,
            ".c{k}{{stroke:var(--c{k})}}text.c{k}{{fill:var(--c{k});stroke:none}}"
        );
    }
    format!(
        ":root{{--ground:#fff;--ink:#222;--faint:#6b6b6b;--grid:#e4e4e4;{}}}\
         @media(prefers-color-scheme:dark){{:root{{--ground:#16181c;--ink:#e8e8e8;--faint:#a3a3a3;\
         --grid:#33363c;{}}}}}\
         svg{{background:var(--ground)}}\
         text{{font:12px system-ui,sans-serif;fill:var(--ink)}}\
         .title{{font-size:14px;font-weight:600}}.faint{{fill:var(--faint)}}\
         .grid{{stroke:var(--grid)}}.frame{{stroke:var(--faint);fill:none}}\
         .curve{{fill:none;stroke-width:1.6;stroke-linejoin:round}}\
         .leader{{stroke-width:.8;opacity:.6}}{classes}",
        colors(&COLORS),
        colors(&ON_DARK),
    )
}
