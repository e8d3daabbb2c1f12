//! From tokens to an [`Expression`], via the syntax tree of syn.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use quote::ToTokens;
use syn::parse::{ParseStream, Parser};
use syn::{BinOp, Expr, Lit, UnOp, parenthesized};

use crate::errors::{Errors, Extent};

use super::bare_unit::meant_instead;
use super::expression::{Expression, Kind, Operator, Prefix, Step};
use super::nesting::{DEPTH, too_deep};
use super::screen::{Screened, screen};
use super::unit::UnitExpression;

impl Expression {
    /// Reads an expression between two commas; errors are reported.
    pub fn parse(tokens: TokenStream, errors: &mut Errors) -> Option<Self> {
        let last = tokens.clone().into_iter().last()?.span();
        let Screened { tokens, units } = screen(tokens, errors)?;
        // syn reports missing tokens at the span of the group, so that becomes the last token
        let mut group = Group::new(Delimiter::Parenthesis, tokens);
        group.set_span(last);
        let parsed = complete.parse2(TokenTree::Group(group).into());
        let parsed = parsed.map_err(|error| errors.push(error.span(), reworded(&error)));
        Some(Reader { units, errors }.expression(&parsed.ok()?, 0))
    }
}

/// An expression that fills its group.
fn complete(input: ParseStream<'_>) -> syn::Result<Expr> {
    let content;
    parenthesized!(content in input);
    let expr = content.parse()?;
    if !content.is_empty() {
        return Err(content.error(BEFORE));
    }
    Ok(expr)
}

/// An error of syn, in the words of this language.
fn reworded(error: &syn::Error) -> String {
    let message = error.to_string();
    match message.strip_prefix("unexpected end of input, ") {
        Some("expected an expression") => "expected a value after this".to_owned(),
        Some(expected) => format!("{expected} after this"),
        None if message == "expected `,`" => BEFORE.to_owned(),
        None if message.contains("chained") => {
            "comparisons cannot be chained: join two by `&&`".to_owned()
        }
        None => message.replace("an expression", "a value"),
    }
}

struct Reader<'a> {
    units: Vec<Option<UnitExpression>>,
    errors: &'a mut Errors,
}

impl Reader<'_> {
    fn expression(&mut self, expr: &Expr, depth: usize) -> Expression {
        let extent = Extent::of(expr);
        let kind = match expr {
            _ if depth > DEPTH => self.errors.report(extent, too_deep()),
            Expr::Paren(inner) => return self.expression(&inner.expr, depth + 1),
            Expr::Group(inner) => return self.expression(&inner.expr, depth + 1),
            Expr::Block(block) if block.label.is_none() => {
                return self.block(&block.block, depth);
            }
            Expr::Lit(literal) => self.literal(&literal.lit),
            Expr::Infer(_) => Some(Kind::Placeholder),
            Expr::Path(path) => self.name(path),
            Expr::Tuple(tuple) => Some(Kind::Tuple(self.all(&tuple.elems, depth))),
            Expr::Array(list) => Some(Kind::List(self.all(&list.elems, depth))),
            Expr::Index(index) => self.unit(index, depth),
            Expr::Unary(unary) => self.prefix(unary, depth),
            Expr::Binary(_) => Some(self.chain(expr, depth)),
            Expr::Call(call) => self.call(call, depth),
            Expr::MethodCall(call) => {
                let receiver = self.expression(&call.receiver, depth + 1);
                let arguments = self.all(&call.args, depth);
                let method = call.method.clone();
                Some(Kind::Method(Box::new(receiver), method, arguments))
            }
            Expr::Field(field) => self.field(field, depth),
            Expr::Struct(record) => self.record(record, depth),
            Expr::If(choice) => self.choice(choice, depth),
            other => self.refuse(other, FORMS),
        };
        Expression {
            kind: kind.unwrap_or(Kind::Poisoned),
            extent,
        }
    }

    fn refuse<T>(&mut self, place: impl ToTokens, message: &str) -> Option<T> {
        self.errors.report(Extent::of(place), message)
    }

    fn all<'e>(
        &mut self,
        exprs: impl IntoIterator<Item = &'e Expr>,
        depth: usize,
    ) -> Vec<Expression> {
        exprs
            .into_iter()
            .map(|expr| self.expression(expr, depth + 1))
            .collect()
    }

    fn unit(&mut self, index: &syn::ExprIndex, depth: usize) -> Option<Kind> {
        let operand = self.expression(&index.expr, depth + 1);
        let Expr::Lit(number) = &*index.index else {
            return None;
        };
        let Lit::Int(number) = &number.lit else {
            return None;
        };
        let unit = self.units.get(number.base10_parse::<usize>().ok()?)?;
        Some(Kind::Unit(Box::new(operand), unit.clone()?))
    }

    fn prefix(&mut self, unary: &syn::ExprUnary, depth: usize) -> Option<Kind> {
        let prefix = match unary.op {
            UnOp::Neg(_) => Prefix::Minus,
            UnOp::Not(_) => Prefix::Not,
            _ => {
                let message = "`*` stands between two factors; a power is written `x.powi(2)`";
                return self.refuse(unary.op, message);
            }
        };
        let operand = self.expression(&unary.expr, depth + 1);
        Some(Kind::Prefix(prefix, Box::new(operand)))
    }

    fn call(&mut self, call: &syn::ExprCall, depth: usize) -> Option<Kind> {
        let arguments = self.all(&call.args, depth);
        match &*call.func {
            Expr::Path(path) if path.path.get_ident().is_some() => {
                Some(Kind::Call(path.path.get_ident()?.clone(), arguments))
            }
            Expr::Path(path) if is_vector(&path.path) => {
                self.refuse(path, "a vector is written `body(..)` or `world(..)`")
            }
            other => self.refuse(
                other,
                "expected a function in front of the parentheses, such as `world` or `body`; \
                 a product is written with `*`",
            ),
        }
    }

    fn field(&mut self, field: &syn::ExprField, depth: usize) -> Option<Kind> {
        let receiver = self.expression(&field.base, depth + 1);
        match &field.member {
            syn::Member::Named(name) => Some(Kind::Field(Box::new(receiver), name.clone())),
            syn::Member::Unnamed(index) => {
                self.refuse(index, "components are called `.x`, `.y` and `.z`")
            }
        }
    }

    fn choice(&mut self, choice: &syn::ExprIf, depth: usize) -> Option<Kind> {
        let condition = self.expression(&choice.cond, depth + 1);
        let first = self.block(&choice.then_branch, depth);
        let Some((_, branch)) = &choice.else_branch else {
            let message = "an `if` needs an `else` here: every expression has a value";
            return self.refuse(choice.if_token, message);
        };
        let second = self.expression(branch, depth + 1);
        Some(Kind::If(Box::new([condition, first, second])))
    }

    fn literal(&mut self, literal: &Lit) -> Option<Kind> {
        let (digits, suffix) = match literal {
            Lit::Int(int) => (int.to_string(), int.suffix().to_owned()),
            Lit::Float(float) => (float.to_string(), float.suffix().to_owned()),
            Lit::Bool(value) => {
                let message = "there are no literal conditions here: write a comparison";
                return self.refuse(value, message);
            }
            Lit::Str(text) => return Some(Kind::Text(text.value())),
            other => return self.refuse(other, "expected a number"),
        };
        if suffix.is_empty() {
            return Some(Kind::Number(digits));
        }
        let digits = digits.strip_suffix(&suffix).unwrap_or(&digits);
        let digits = digits.trim_end_matches('_');
        let message = if TYPES.contains(&suffix.as_str()) {
            format!("numbers have no type here, they are exact: write `{digits}`")
        } else {
            let of_unit = || format!("a unit goes in brackets: write `{digits}[{suffix}]`");
            meant_instead(digits, &suffix).unwrap_or_else(of_unit)
        };
        self.errors.report(literal.span(), message)
    }

    fn name(&mut self, path: &syn::ExprPath) -> Option<Kind> {
        if let Some(name) = path.path.get_ident() {
            return Some(Kind::Name(name.clone()));
        }
        let mut segments = path.path.segments.iter().rev();
        let (last, module) = (segments.next(), segments.next());
        match (last, module) {
            (Some(last), Some(module)) if module.ident == "consts" => {
                Some(Kind::Name(last.ident.clone()))
            }
            (Some(last), Some(module)) if !TYPES.contains(&module.ident.to_string().as_str()) => {
                let (module, last) = (&module.ident, &last.ident);
                let message = format!(
                    "names are joined by a dot: write `{module}.{last}`; a Rust constant is declared in \
                     `constants: [..]`"
                );
                self.refuse(path, &message)
            }
            _ => self.refuse(
                path,
                "a Rust constant is declared in `constants`, as in `constants: [m = crate::MASS[kg]]`",
            ),
        }
    }

    /// Walks the left side of nested operations in a loop, so that a long sum becomes one flat
    /// chain.
    fn chain(&mut self, expr: &Expr, depth: usize) -> Kind {
        let mut rest = Vec::new();
        let mut first = expr;
        while let Expr::Binary(binary) = first {
            let operator = self.operator(&binary.op);
            let operand = self.expression(&binary.right, depth + 1);
            rest.push((operator, Extent::of(binary.op), operand));
            first = &binary.left;
        }
        let first = self.expression(first, depth + 1);
        let steps = rest
            .into_iter()
            .rev()
            .map(|(operator, place, operand)| Step {
                // an operand of an invalid operator has no value
                operand: match operator {
                    Some(_) => operand,
                    None => Expression {
                        kind: Kind::Poisoned,
                        extent: operand.extent,
                    },
                },
                operator: operator.unwrap_or(Operator::Add),
                place,
            });
        Kind::Chain(Box::new(first), steps.collect())
    }

    fn operator(&mut self, operator: &BinOp) -> Option<Operator> {
        Some(match operator {
            BinOp::Add(_) => Operator::Add,
            BinOp::Sub(_) => Operator::Subtract,
            BinOp::Mul(_) => Operator::Multiply,
            BinOp::Div(_) => Operator::Divide,
            BinOp::Lt(_) => Operator::Less,
            BinOp::Le(_) => Operator::LessOrEqual,
            BinOp::Gt(_) => Operator::Greater,
            BinOp::Ge(_) => Operator::GreaterOrEqual,
            BinOp::Eq(_) => Operator::Equal,
            BinOp::Ne(_) => Operator::NotEqual,
            BinOp::And(_) => Operator::And,
            BinOp::Or(_) => Operator::Or,
            BinOp::BitXor(_) => Operator::Power,
            BinOp::Rem(_) => {
                let message = "there is no remainder here: write `x - (x / y).floor() * y`";
                return self.refuse(operator, message);
            }
            other => return self.refuse(other, OPERATORS),
        })
    }

    fn record(&mut self, record: &syn::ExprStruct, depth: usize) -> Option<Kind> {
        let Some(name) = record.path.get_ident() else {
            return self.refuse(&record.path, "expected `tensor` or `products`");
        };
        let mut fields = Vec::new();
        let mut named = true;
        for field in &record.fields {
            let value = self.expression(&field.expr, depth + 1);
            match &field.member {
                syn::Member::Named(member) => fields.push((member.clone(), value)),
                syn::Member::Unnamed(index) => {
                    named = false;
                    let message = "fields have names: `xx`, `yy`, `zz`, `xy`, `yz`, `zx`";
                    self.errors.push(Extent::of(index), message);
                }
            }
        }
        named.then(|| Kind::Record(name.clone(), fields))
    }

    fn block(&mut self, block: &syn::Block, depth: usize) -> Expression {
        let refused = match block.stmts.as_slice() {
            [syn::Stmt::Expr(value, None)] => return self.expression(value, depth + 1),
            [] => self.refuse(block, "an empty branch has no value"),
            [first, ..] => self.refuse(
                first,
                "a branch is one expression: name intermediate values as `locals`",
            ),
        };
        Expression {
            kind: refused.unwrap_or(Kind::Poisoned),
            extent: Extent::of(block),
        }
    }
}

const BEFORE: &str = "expected an operator or a comma before this";
const FORMS: &str = "not part of the language of descriptions: write arithmetic, functions, `if` \
                     or the name of a local";
const OPERATORS: &str = "not an operator of descriptions: write `+`, `-`, `*`, `/`, a comparison, \
                         `&&` or `||`";
/// Rust's number types, which occur as suffixes of literals.
const TYPES: [&str; 14] = [
    "f32", "f64", "i8", "i16", "i32", "i64", "i128", "isize", "u8", "u16", "u32", "u64", "u128",
    "usize",
];

/// Whether a path is that of a constructor such as `Vector3::new`.
fn is_vector(path: &syn::Path) -> bool {
    let first = path.segments.first();
    first.is_some_and(|word| word.ident.to_string().starts_with("Vec"))
}
