//! The elements of a text, or its first error.

use roxmltree::{Document, Error};

/// The elements of a text, or its first error: a line and a message.
pub fn parse(text: &str) -> Result<Document<'_>, (usize, String)> {
    Document::parse(text).map_err(|error| {
        // the message already begins with the place
        let place = error.pos();
        let line = usize::try_from(place.row).unwrap_or_default();
        let tail = format!(" at {}:{}", place.row, place.col);
        let plain = error.to_string().replace(&tail, "");
        let ends = open_at_end(text);
        match (error, ends) {
            (Error::NoRootNode, _) => (line, "the file has no element".to_owned()),
            (Error::DtdDetected, _) => {
                let line = line_of(text, text.find("<!DOCTYPE").unwrap_or_default());
                let message = "`<!DOCTYPE ..>` is not read: leave it out, and write what its entities stand for";
                (line, message.to_owned())
            }
            (Error::UnexpectedCloseTag(expected, found, _), _) => {
                let message = format!("`</{found}>` stands where `</{expected}>` is expected");
                (line, message)
            }
            (Error::MalformedEntityReference(_), _) => {
                (line, format!("no XML: {plain}: write `&amp;` for `&`"))
            }
            (Error::InvalidAttributeValue(_) | Error::InvalidChar(b'"' | b'\'', b'<', _), _) => {
                let message = "a value of an attribute has no `<`: close it before, or write `&lt;`";
                (line, message.to_owned())
            }
            (_, Some(ends)) => ends,
            (Error::UnknownToken(_), None) => {
                let is_xml = text.trim_start_matches('\u{feff}').trim_start().starts_with('<');
                let message = if is_xml {
                    "this stands outside of the first element of the file, which holds all others"
                } else {
                    "this is no XML, which begins with an element"
                };
                (line, message.to_owned())
            }
            _ => (line, format!("no XML: {plain}")),
        }
    })
}

/// Parts between marks: the marks at their beginning and end, and what they are called.
const MARKED: [(&str, &str, &str); 3] = [
    ("<!--", "-->", "a comment"),
    ("<![CDATA[", "]]>", "`<![CDATA[`"),
    ("<?", "?>", "`<?`"),
];

/// The part that is still open at the end of a text: its line and a message.
fn open_at_end(text: &str) -> Option<(usize, String)> {
    let mut open: Vec<(usize, &str)> = Vec::new();
    let broken = |place: usize, what: &str| {
        let message = format!("the file breaks off in {what}, which begins here");
        Some((line_of(text, place), message))
    };
    let mut place = 0;
    while let Some(found) = text[place..].find('<') {
        place += found;
        let rest = &text[place..];
        let marked = MARKED.iter().find(|(begin, ..)| rest.starts_with(begin));
        if let Some((_, end, what)) = marked {
            let Some(length) = rest.find(end) else {
                return broken(place, what);
            };
            place += length + end.len();
            continue;
        }
        let closes = rest.starts_with("</");
        let name = &rest[if closes { 2 } else { 1 }..];
        let length = name.find(|c: char| c.is_whitespace() || "/><".contains(c));
        let name = &name[..length.unwrap_or(name.len())];
        let Some(length) = length_of_tag(rest) else {
            let shown = if closes {
                format!("`</{name}`")
            } else {
                format!("`<{name}`")
            };
            return broken(place, &shown);
        };
        if closes {
            open.pop();
        } else if !rest[..length].ends_with("/>") {
            open.push((place, name));
        }
        place += length;
    }
    let (place, name) = open.pop()?;
    let message = format!("`<{name}>` is not closed: the file ends before `</{name}>`");
    Some((line_of(text, place), message))
}

/// The length of a tag up to the first `>` that is not inside an attribute value.
fn length_of_tag(text: &str) -> Option<usize> {
    let mut quote = None;
    for (place, c) in text.char_indices() {
        match (quote, c) {
            (None, '>') => return Some(place + 1),
            (None, '"' | '\'') => quote = Some(c),
            (Some(begun), _) if begun == c => quote = None,
            _ => {}
        }
    }
    None
}

fn line_of(text: &str, place: usize) -> usize {
    1 + text[..place].bytes().filter(|byte| *byte == b'\n').count()
}
