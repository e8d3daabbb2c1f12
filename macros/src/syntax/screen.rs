//! The tokens of an expression that are passed to syn: those of the language, within fixed limits.
//!
//! All other tokens of Rust's expressions are rejected here, at their places, before anything
//! recurses into them. Units are taken out on the way: syn sees `2[kg * m ^ 2]` as `2[0]`, where 0
//! is the index of the unit.

use proc_macro2::{Delimiter, Group, Ident, Literal, Spacing, TokenStream, TokenTree};

use crate::errors::{Errors, Extent, is_joint};

use super::bare_unit::{BareUnit, lacks_brackets, meant_instead};
use super::brackets::{
    behind_number, component_meant, ends_operand, in_angles, is_list, is_record, is_second_operand,
    is_value_in_brackets, meant,
};
use super::nesting::{DEPTH, Nested, crossed_limit, too_deep};
use super::tokens::{argument_name, has_comma, is_parenthesized, is_punct, start, with_commas};
use super::unit::UnitExpression;
use super::words::{NOT, is_keyword};

/// What other tools write as properties of joints.
const LOADS_OF_JOINTS: [&str; 5] = ["damping", "friction", "stiffness", "spring", "effort"];
/// The most digits of a number, including its point and exponent: every double needs fewer.
const DIGITS: usize = 1200;

/// An expression that is safe for syn.
pub struct Screened {
    pub tokens: TokenStream,
    /// The units, by index; `None` for those already reported.
    pub units: Vec<Option<UnitExpression>>,
}

/// Rejects tokens that are not part of the language; returns `None` if there were any.
pub fn screen(tokens: TokenStream, errors: &mut Errors) -> Option<Screened> {
    if let Some((place, message)) = crossed_limit(&tokens) {
        return errors.report(place, message);
    }
    let mut screen = Screen {
        units: Vec::new(),
        refused: false,
        errors,
    };
    let tokens = screen.stream(tokens, 0, None);
    let Screen { units, refused, .. } = screen;
    (!refused).then_some(Screened { tokens, units })
}

struct Screen<'a> {
    units: Vec<Option<UnitExpression>>,
    /// Whether the remaining tokens would be unreadable for syn.
    refused: bool,
    errors: &'a mut Errors,
}

impl Screen<'_> {
    /// The tokens in one pair of brackets; `function` is the word before them.
    fn stream(
        &mut self,
        tokens: TokenStream,
        depth: usize,
        function: Option<&Ident>,
    ) -> TokenStream {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let mut shown = Vec::with_capacity(tokens.len());
        let mut nested = Nested::default();
        let mut index = 0;
        while let Some(token) = tokens.get(index) {
            let before = index.checked_sub(1).map(|before| &tokens[before]);
            nested.pass(before, token, tokens.get(index + 1));
            if depth + nested.depth() > DEPTH {
                self.errors.push(start(token), too_deep());
                self.refused = true;
                break;
            }
            let read = match token {
                TokenTree::Group(_) if behind_number(&tokens, index, self.errors) => Some(1),
                TokenTree::Group(group) => {
                    let group = &meant(group, &tokens, index, self.errors);
                    shown.push(self.group(group, before, depth + nested.depth(), function));
                    Some(1)
                }
                TokenTree::Ident(word) if lacks_brackets(before, word) => {
                    self.bare_unit(word, before, &tokens[index + 1..])
                }
                TokenTree::Ident(word) if is_second_operand(before, word) => {
                    self.second_operand(word, (before, tokens.get(index + 1)))
                }
                TokenTree::Ident(word) => {
                    let word = self.word(word, &tokens[index + 1..]);
                    word.map(|word| {
                        shown.push(TokenTree::Ident(word));
                        1
                    })
                }
                TokenTree::Literal(literal) => self.literal(literal).inspect(|_| {
                    shown.push(token.clone());
                }),
                TokenTree::Punct(_) => {
                    let of_unit = in_angles(before, &tokens[index..], self.errors);
                    of_unit.or_else(|| {
                        let read = match argument_name(&tokens, index, function) {
                            Some(name) => self.named_argument(name, (token, function)),
                            None => self.sign(&tokens[index..]),
                        };
                        shown.extend(tokens[index..index + read.unwrap_or(0)].iter().cloned());
                        read
                    })
                }
            };
            index += match read {
                Some(read) => read,
                // one mistake gives one error: continue after the next comma
                None => tokens[index..]
                    .iter()
                    .take_while(|token| !is_punct(token, ','))
                    .count(),
            };
        }
        shown.into_iter().collect()
    }

    fn refuse<T>(&mut self, place: impl Into<Extent>, message: &str) -> Option<T> {
        self.errors.push(place, message);
        self.refused = true;
        None
    }

    fn named_argument<T>(
        &mut self,
        name: &Ident,
        (sign, function): (&TokenTree, Option<&Ident>),
    ) -> Option<T> {
        let place = Extent::from(name.span()).to(sign.span().into());
        let is_load = LOADS_OF_JOINTS.iter().any(|word| name == word);
        let joint = function.filter(|word| is_load && is_joint(&word.to_string()));
        let message = match joint {
            Some(joint) => format!(
                "`{joint}` takes points and axes, without names: loads along the joint, such as damping, are written in `drives`"
            ),
            None => format!("arguments have no names: leave `{name} {sign}` out"),
        };
        self.refuse(place, &message)
    }

    /// One token, unless it is a number with too many digits.
    fn literal(&mut self, literal: &Literal) -> Option<usize> {
        let text = literal.to_string();
        if text.starts_with(|first: char| first.is_ascii_digit()) && text.len() > DIGITS {
            let message = format!("a number of more than {DIGITS} digits: `f64` keeps 17 of them");
            return self.refuse(literal.span(), &message);
        }
        Some(1)
    }

    fn group(
        &mut self,
        group: &Group,
        before: Option<&TokenTree>,
        depth: usize,
        function: Option<&Ident>,
    ) -> TokenTree {
        let mut shown = match group.delimiter() {
            Delimiter::Bracket if before.is_some_and(ends_operand) => {
                let unit = self.unit(group, before);
                self.units.push(unit);
                let number = Literal::usize_unsuffixed(self.units.len() - 1);
                Group::new(Delimiter::Bracket, TokenTree::from(number).into())
            }
            Delimiter::Bracket if function.is_some_and(|word| word == "on") => {
                let inner = self.stream(group.stream(), depth + 1, None);
                Group::new(Delimiter::Bracket, inner)
            }
            // the values of a table of two arguments are nested lists
            Delimiter::Bracket if function.is_some_and(|word| word == "table") => {
                let inner = self.stream(group.stream(), depth + 1, function);
                Group::new(Delimiter::Bracket, inner)
            }
            Delimiter::Bracket if is_value_in_brackets(group, before, function) => {
                let message = "a list is not allowed here: leave these brackets out";
                self.errors.push(group.span_open(), message);
                let inner = self.stream(group.stream(), depth + 1, None);
                Group::new(Delimiter::Parenthesis, inner)
            }
            Delimiter::Bracket | Delimiter::Brace if is_list(group, before) => {
                let (place, message) = match function {
                    Some(word) if word == "compose" => (
                        word.span(),
                        "`compose([..])` is a whole body: it stands alone after `inertia:`",
                    ),
                    _ if has_comma(group) => (
                        group.span_open(),
                        "a list is not allowed here: a vector is `world(x, y, z)` or `body(x, y, z)`, \
                         an inertia `principal(x, y, z)` or `tensor { .. }`",
                    ),
                    _ => (
                        group.span_open(),
                        "a list is not allowed here: brackets hold a unit behind a number, as in \
                         `2[kg]`",
                    ),
                };
                let _: Option<()> = self.refuse(place, message);
                Group::new(Delimiter::Bracket, TokenStream::new())
            }
            delimiter => {
                let function = match before {
                    Some(TokenTree::Ident(word)) if delimiter == Delimiter::Parenthesis => {
                        Some(word)
                    }
                    _ => None,
                };
                // other braces are branches
                let inner = match delimiter {
                    Delimiter::Brace if !is_record(before) => group.stream(),
                    _ => with_commas(group.stream(), self.errors),
                };
                let inner = self.stream(inner, depth + 1, function);
                Group::new(delimiter, inner)
            }
        };
        shown.set_span(group.span());
        TokenTree::Group(shown)
    }

    /// The unit in brackets behind an operand.
    fn unit(&mut self, group: &Group, before: Option<&TokenTree>) -> Option<UnitExpression> {
        match component_meant(group) {
            Some(axis) if !matches!(before, Some(TokenTree::Literal(_))) => {
                let message = match before {
                    Some(TokenTree::Ident(word)) if word == "attitude" => {
                        "brackets hold a unit: a part of the quaternion is written `attitude.w`, `.i`, `.j` or `.k`"
                            .to_owned()
                    }
                    _ => format!("brackets hold a unit: a component is written `.in_world().{axis}`"),
                };
                self.errors.report(group.span(), message)
            }
            _ => UnitExpression::parse(group, self.errors),
        }
    }

    /// Reports a word directly behind another operand.
    fn second_operand<T>(
        &mut self,
        word: &Ident,
        (before, after): (Option<&TokenTree>, Option<&TokenTree>),
    ) -> Option<T> {
        let first = match before {
            Some(TokenTree::Ident(first)) => first.to_string(),
            _ => "(..)".to_owned(),
        };
        let text = word.to_string();
        let message = match text.as_str() {
            "and" | "or" | "then" => meant_instead("", &text).unwrap_or_default(),
            // a point, as in `tip lower.hinge`
            _ if after.is_some_and(|next| is_punct(next, '.')) => {
                format!("expected a comma or an operator before `{word}`")
            }
            _ => format!(
                "expected an operator or a comma before this: a product is written `{first} * {word}`"
            ),
        };
        self.refuse(word.span(), &message)
    }

    /// The number of tokens of a unit without brackets. They are left out, so that what stands
    /// around them is still checked.
    fn bare_unit(
        &mut self,
        word: &Ident,
        before: Option<&TokenTree>,
        after: &[TokenTree],
    ) -> Option<usize> {
        let number = match before {
            Some(TokenTree::Literal(number)) => number.to_string(),
            _ => String::new(),
        };
        let message = if after.first().is_some_and(is_parenthesized) {
            let message = format!("a product is written with `*`: write `{number} * {word}(..)`");
            Some(message)
        } else {
            meant_instead(&number, &word.to_string())
        };
        if let Some(message) = message {
            return self.refuse(word.span(), &message);
        }
        let unit = BareUnit::read(word, after);
        let message = format!(
            "a unit goes in brackets: write `{number}[{}]`",
            unit.written
        );
        self.errors.push(unit.extent, message);
        Some(unit.length)
    }

    /// A word in a form that syn can read. A keyword in place of a name becomes a raw name: the
    /// entry that should have defined it was already rejected for that.
    fn word(&mut self, word: &Ident, after: &[TokenTree]) -> Option<Ident> {
        let text = word.to_string();
        if let [bang, next, ..] = after
            && is_punct(bang, '!')
            && !is_keyword(&text)
            && !is_punct(next, '=')
        {
            let place = Extent::from(word.span()).to(bang.span().into());
            let message = match text.as_str() {
                "vector" | "vec" => {
                    "a vector is written `body(..)` or `world(..)`, without a macro"
                }
                _ => "no macro can be called here",
            };
            return self.refuse(place, message);
        }
        let is_value =
            |token: &TokenTree| matches!(token, TokenTree::Ident(_) | TokenTree::Literal(_));
        if text == "not" && after.first().is_some_and(is_value) {
            return self.refuse(word.span(), NOT);
        }
        if matches!(text.as_str(), "if" | "else" | "true" | "false") || !is_keyword(&text) {
            return Some(word.clone());
        }
        if text == "as" {
            return self.refuse(
                word.span(),
                "there are no casts here: all numbers are exact",
            );
        }
        let is_name = match after.first() {
            None => true,
            Some(TokenTree::Punct(sign)) => !matches!(sign.as_char(), '|' | '!' | ':'),
            Some(TokenTree::Group(group)) => group.delimiter() == Delimiter::Bracket,
            Some(_) => false,
        };
        if is_name && !matches!(text.as_str(), "self" | "Self" | "super" | "crate") {
            return Some(Ident::new_raw(&text, word.span()));
        }
        let is_dot = |token: &TokenTree| is_punct(token, '.');
        let message = if text == "self" && after.first().is_some_and(is_dot) {
            "the quantities of the body stand alone: leave `self.` out".to_owned()
        } else if text == "box" {
            "`box` is a keyword of Rust: the solid is called `cuboid`".to_owned()
        } else if matches!(text.as_str(), "crate" | "super" | "self" | "Self") {
            "a Rust constant is declared in `constants`, as in `constants: [m = crate::MASS[kg]]`"
                .to_owned()
        } else {
            format!(
                "`{text}` is not part of the language: write arithmetic, functions, `if` or names"
            )
        };
        self.refuse(word.span(), &message)
    }

    /// The number of tokens of the sign at the beginning of `tokens`. Signs without a meaning here
    /// are rejected.
    fn sign(&mut self, tokens: &[TokenTree]) -> Option<usize> {
        let TokenTree::Punct(first) = &tokens[0] else {
            return Some(1);
        };
        let next = match tokens.get(1) {
            Some(TokenTree::Punct(next)) if first.spacing() == Spacing::Joint => next.as_char(),
            _ => ' ',
        };
        let (length, message) = match (first.as_char(), next) {
            ('&', '&') | ('|', '|') | ('=' | '!' | '<' | '>', '=') => (2, ""),
            (':', ':') if !tokens.get(2).is_some_and(|token| is_punct(token, '<')) => (2, ""),
            (':', ':') => (2, "nothing here takes type arguments"),
            ('.', '.') => (2, "`..` cannot be used here: write every value out"),
            ('-', '>') => (
                2,
                "`->` is not part of the language: arguments are separated by commas",
            ),
            ('+' | '-' | '*' | '/' | '%' | '^', '=') => {
                (2, "nothing can be assigned to: a name means one value")
            }
            ('+' | '-' | '*' | '/' | '%' | '^' | '<' | '>' | '!' | '.' | ',' | ':', _) => (1, ""),
            ('=', _) => (
                1,
                "nothing can be assigned to: compare with `==`, or name the value as a local",
            ),
            ('&', _) => (1, "there are no references here: write the operand alone"),
            ('|', _) => (
                1,
                "there are no closures here; conditions are joined by `||`",
            ),
            ('?', _) => (1, "a choice is written `if .. { .. } else { .. }`"),
            ('#', _) => (1, "a comment begins with `//`"),
            _ => (1, "this sign is not part of the language"),
        };
        let last = &tokens[length - 1];
        let place = Extent::from(first.span()).to(last.span().into());
        if !message.is_empty() {
            return self.refuse(place, message);
        }
        let at_end = tokens.get(length).is_none_or(|next| is_punct(next, ','));
        if at_end && first.as_char() != ',' {
            return self.refuse(place, "expected a value after this");
        }
        Some(length)
    }
}
