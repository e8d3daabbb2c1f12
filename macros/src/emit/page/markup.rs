//! `MathML`, which browsers render without scripts.

use crate::symbolic::Number;

/// The digits that numbers have on a page. The exact number is in the title.
const DIGITS: usize = 5;

/// A number with few digits.
pub fn number(number: &Number) -> String {
    value(number.to_f64())
}

/// A double with few digits. The exact one is in its title.
pub fn value(value: f64) -> String {
    let (exact, short) = (plain(value), rounded(value));
    if exact == short {
        return format!("<mn>{short}</mn>");
    }
    format!("<mn><span title=\"{exact}\">{short}</span></mn>")
}

/// A double with few digits, as text.
pub fn rounded(value: f64) -> String {
    let digits = format!("{value:.*e}", DIGITS - 1);
    digits.parse().map_or(digits, plain)
}

fn plain(value: f64) -> String {
    if value == 0.0 || (1e-4..1e7).contains(&value.abs()) {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}

/// A name. An axis or a number after its last underscore is an index.
pub fn name(name: &str) -> String {
    let is_index = |end: &str| {
        let is_number = end.chars().all(|letter| letter.is_ascii_digit());
        !end.is_empty() && (is_number || ["x", "y", "z", "w"].contains(&end))
    };
    match name.rsplit_once('_') {
        Some((head, index)) if !head.is_empty() && is_index(index) => {
            let index = format!("<mn>{index}</mn>");
            format!("<msub>{}{index}</msub>", letters(head))
        }
        _ => letters(name),
    }
}

/// A letter in italics, or a word.
fn letters(word: &str) -> String {
    if word.contains('_') {
        format!("<mtext>{word}</mtext>")
    } else {
        format!("<mi>{word}</mi>")
    }
}

pub fn operator(sign: &str) -> String {
    format!("<mo>{sign}</mo>")
}

/// A row of a table.
pub enum Row {
    Cells(Vec<String>),
    /// A text above the rows that it refers to.
    Note(String),
}

/// A table in a block of its own, with aligned cells.
pub fn table(rows: impl IntoIterator<Item = Row>) -> String {
    let rows = rows.into_iter().map(|row| {
        let cells = match row {
            Row::Cells(cells) => {
                let cells = cells.join("</mrow></mtd><mtd style=\"text-align:left\"><mrow>");
                format!("<mtd style=\"text-align:left\"><mrow>{cells}</mrow></mtd>")
            }
            Row::Note(note) => format!(
                "<mtd columnspan=\"3\" style=\"text-align:left;opacity:0.7\"><mtext>{note}</mtext></mtd>"
            ),
        };
        format!("<mtr>{cells}</mtr>")
    });
    let rows: String = rows.collect();
    format!(
        "<div style=\"overflow-x:auto\"><math display=\"block\">\
         <mtable displaystyle=\"true\">{rows}</mtable></math></div>"
    )
}
