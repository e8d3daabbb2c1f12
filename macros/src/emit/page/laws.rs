//! The balances, written as laws.

use crate::mechanics::{Law, Left, Part, Term};
use crate::symbolic::Number;

use super::markup::{Row, name, number, operator, rounded, table};

/// The laws as text.
pub fn laws_in_text(laws: &[Law]) -> Vec<String> {
    let lines = laws.iter().map(|law| {
        let body = law.body.iter().map(|body| format!("{body}: "));
        let body: String = body.collect();
        let terms = law.right.iter().enumerate().map(|(place, term)| {
            let sign = match (term.is_opposite, place) {
                (true, 0) => "−",
                (true, _) => " − ",
                (false, 0) => "",
                (false, _) => " + ",
            };
            let load = &term.name;
            match term.part {
                Part::Force => format!("{sign}F_{load}"),
                Part::Moment => format!("{sign}M_{load}"),
                Part::MomentOfForce => format!("{sign}r × F_{load}"),
            }
        });
        let right: String = terms.collect();
        let right = if right.is_empty() { "0" } else { &right };
        let (left, value) = left_in_text(&law.left);
        format!("{body}{left} = {right}{value}")
    });
    lines.collect()
}

/// The left side as text, and the value of its mass or inertia.
fn left_in_text(left: &Left) -> (&'static str, String) {
    let one = |letter: char, number: &Option<Number>, unit: &str| {
        let value = number.as_ref().map(|number| rounded(number.to_f64()));
        value.map_or_else(String::new, |value| format!(", {letter} = {value} {unit}"))
    };
    match left {
        Left::Force(mass) => ("m a", one('m', mass, "kg")),
        Left::Plane(moment) => ("J φ″", one('J', moment, "kg m²")),
        Left::Line(moment) => ("J u × u″", one('J', moment, "kg m²")),
        Left::Axis(entries) => ("n · J n φ″", tensor_in_text(entries)),
        Left::Tensor(entries) => ("J ω′ + ω × J ω", tensor_in_text(entries)),
    }
}

fn tensor_in_text(entries: &[[Option<Number>; 3]; 3]) -> String {
    let value = |row: usize, column: usize| {
        let number = entries[row][column].as_ref();
        number.map(|number| rounded(number.to_f64()))
    };
    let off = [(0, 1), (1, 2), (2, 0)].map(|(row, column)| value(row, column));
    let [Some(x), Some(y), Some(z)] = [0, 1, 2].map(|axis| value(axis, axis)) else {
        return String::new();
    };
    let is_diagonal = off.iter().all(|entry| entry.as_deref() == Some("0"));
    if is_diagonal {
        return format!(", J = diag({x}, {y}, {z}) kg m²");
    }
    let [Some(xy), Some(yz), Some(zx)] = off else {
        return String::new();
    };
    format!(", J = [{x}, {xy}, {zx}; {xy}, {y}, {yz}; {zx}, {yz}, {z}] kg m²")
}

/// The laws in `MathML`, each with its unit and its reason, followed by what the letters mean.
pub fn laws_on_page(laws: &[Law]) -> Option<String> {
    let all = laws.iter().flat_map(|law| {
        let right: Vec<String> = law.right.iter().enumerate().map(term).collect();
        let right = if right.is_empty() {
            "<mn>0</mn>".to_owned()
        } else {
            right.concat()
        };
        let (left, value) = left(&law.left);
        let reason = match &law.left {
            Left::Force(_) => "N, world axes (1.3)",
            Left::Plane(_) | Left::Axis(_) => "N m (1.4)",
            Left::Tensor(_) => "N m, body axes (1.4)",
            Left::Line(_) => "N m, world axes (1.4)",
        };
        let of = law.body.as_ref();
        let of = of.map_or_else(String::new, |of| {
            format!("<mtext>{of}:&#160;&#160;</mtext>")
        });
        let law = vec![
            format!("{of}{left}"),
            format!("{}{right}", operator("=")),
            format!("<mspace width=\"2em\"/><mtext>{reason}</mtext>"),
        ];
        let value = value.map(|(letter, value)| {
            vec![
                letter.to_owned(),
                format!("{}{value}", operator("=")),
                String::new(),
            ]
        });
        [law].into_iter().chain(value)
    });
    (!laws.is_empty()).then(|| table(all.map(Row::Cells)))
}

fn term((place, term): (usize, &Term)) -> String {
    let sign = match (term.is_opposite, place) {
        (true, _) => operator("−"),
        (false, 0) => String::new(),
        (false, _) => operator("+"),
    };
    let of = |letter: &str| {
        let load = &term.name;
        format!("<msub><mi>{letter}</mi><mtext>{load}</mtext></msub>")
    };
    let load = match term.part {
        Part::Force => of("F"),
        Part::Moment => of("M"),
        Part::MomentOfForce => format!("{}{}{}", of("r"), operator("×"), of("F")),
    };
    format!("{sign}{load}")
}

/// The left side in `MathML`, and its mass or inertia if that is constant.
fn left(left: &Left) -> (String, Option<(&'static str, String)>) {
    let [m, a, j, n, u, w, angle] = ["m", "a", "J", "n", "u", "ω", "φ"].map(name);
    let cross = operator("×");
    let space = "<mspace width=\"0.2em\"/>";
    let change = |of: &str, times: &str| format!("<msup>{of}<mo>{times}</mo></msup>");
    let (mass, inertia) = ("<mi>m</mi>", "<mi>J</mi>");
    match left {
        Left::Force(value) => (
            format!("{m}{space}{a}"),
            value.as_ref().map(|value| (mass, one(value, "kg"))),
        ),
        Left::Plane(value) => (
            format!("{j}{space}{}", change(&angle, "″")),
            value.as_ref().map(|value| (inertia, one(value, "kg m²"))),
        ),
        Left::Line(value) => (
            format!("{j}{space}{u}{cross}{}", change(&u, "″")),
            value.as_ref().map(|value| (inertia, one(value, "kg m²"))),
        ),
        Left::Axis(entries) => (
            format!(
                "{n}{}{j}{space}{n}{space}{}",
                operator("·"),
                change(&angle, "″")
            ),
            tensor(entries).map(|value| (inertia, value)),
        ),
        Left::Tensor(entries) => (
            format!(
                "{j}{space}{}{}{w}{cross}{j}{space}{w}",
                change(&w, "′"),
                operator("+")
            ),
            tensor(entries).map(|value| (inertia, value)),
        ),
    }
}

fn one(value: &Number, unit: &str) -> String {
    format!("{}<mtext>&#160;{unit}</mtext>", number(value))
}

/// A tensor in `MathML`, if it is constant.
fn tensor(entries: &[[Option<Number>; 3]; 3]) -> Option<String> {
    let mut rows = String::new();
    for row in entries {
        rows.push_str("<mtr>");
        for entry in row {
            rows.push_str("<mtd>");
            rows.push_str(&number(entry.as_ref()?));
            rows.push_str("</mtd>");
        }
        rows.push_str("</mtr>");
    }
    Some(format!(
        "<mo>(</mo><mtable>{rows}</mtable><mo>)</mo><mtext>&#160;kg m²</mtext>"
    ))
}
