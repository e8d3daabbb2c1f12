//! Expressions: the part of Rust's that a description may use.

use proc_macro2::{Ident, TokenStream};
use syn::{BinOp, Expr, Lit, UnOp};

use crate::errors::{Errors, Extent, nesting};

use super::unit::UnitExpression;

/// Tokens that one expression may have: a stated limit instead of an exhausted stack.
const TOKENS: usize = 2000;
/// Brackets that may be nested in each other.
const NESTING: usize = 48;
/// Prefixes, methods and branches that may be nested in each other.
const DEPTH: usize = 128;

/// An expression and its place.
#[derive(Clone, Debug)]
pub struct Expression {
    pub kind: Kind,
    pub extent: Extent,
}

/// The forms of an expression.
#[derive(Clone, Debug)]
pub enum Kind {
    /// The digits of a literal.
    Number(String),
    Name(Ident),
    /// `_`
    Placeholder,
    /// `(x, y, z)`
    Tuple(Vec<Expression>),
    /// `operand[unit]`
    Unit(Box<Expression>, UnitExpression),
    Prefix(Prefix, Box<Expression>),
    /// `first op second op third`, from left to right.
    Chain(Box<Expression>, Vec<(Operator, Expression)>),
    /// `function(arguments)`
    Call(Ident, Vec<Expression>),
    /// `receiver.method(arguments)`
    Method(Box<Expression>, Ident, Vec<Expression>),
    /// `receiver.field`
    Field(Box<Expression>, Ident),
    /// `name { field: value, .. }`
    Record(Ident, Vec<(Ident, Expression)>),
    /// `if condition { first } else { second }`
    If(Box<[Expression; 3]>),
}

/// `-` or `!`
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Prefix {
    Minus,
    Not,
}

/// Operators between two operands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
    Equal,
    NotEqual,
    And,
    Or,
}

impl Expression {
    /// Reads an expression that stands between two commas; what is wrong with it is reported.
    pub fn parse(tokens: TokenStream, errors: &mut Errors) -> Option<Self> {
        let extent = Extent::of(&tokens);
        if nesting(&tokens) > NESTING {
            errors.push(extent, format!("brackets nested more than {NESTING} deep: name parts of this expression as `locals`"));
            return None;
        }
        if count(&tokens) > TOKENS {
            errors.push(
                extent,
                format!("an expression of more than {TOKENS} tokens: name parts of it as `locals`"),
            );
            return None;
        }
        if let Some(place) = long_prefix(&tokens) {
            errors.push(place, format!("more than {DEPTH} prefixes in a row"));
            return None;
        }
        let parsed: Expr = errors.catch(syn::parse2(tokens))?;
        let before = errors.len();
        let read = Reader { errors }.expression(&parsed, 0);
        read.filter(|_| errors.len() == before)
    }
}

fn count(tokens: &TokenStream) -> usize {
    let mut pending = vec![tokens.clone()];
    let mut count = 0;
    while let Some(stream) = pending.pop() {
        for token in stream {
            count += 1;
            if let proc_macro2::TokenTree::Group(group) = token {
                pending.push(group.stream());
            }
        }
    }
    count
}

/// The place of a run of `-`, `!` and the like that is too long to be meant.
fn long_prefix(tokens: &TokenStream) -> Option<Extent> {
    let mut pending = vec![tokens.clone()];
    while let Some(stream) = pending.pop() {
        let mut run = 0;
        for token in stream {
            match token {
                proc_macro2::TokenTree::Punct(ref punct) if punct.as_char() != '.' => run += 1,
                proc_macro2::TokenTree::Group(group) => {
                    run = 0;
                    pending.push(group.stream());
                    continue;
                }
                _ => run = 0,
            }
            if run > DEPTH {
                return Some(token.span().into());
            }
        }
    }
    None
}

struct Reader<'a> {
    errors: &'a mut Errors,
}

impl Reader<'_> {
    fn expression(&mut self, expr: &Expr, depth: usize) -> Option<Expression> {
        let extent = Extent::of(expr);
        if depth > DEPTH {
            self.errors.push(
                extent,
                format!("nested more than {DEPTH} deep: name parts of this expression as `locals`"),
            );
            return None;
        }
        let kind = match expr {
            Expr::Paren(inner) => return self.expression(&inner.expr, depth + 1),
            Expr::Group(inner) => return self.expression(&inner.expr, depth + 1),
            Expr::Lit(literal) => self.literal(&literal.lit)?,
            Expr::Infer(_) => Kind::Placeholder,
            Expr::Path(path) => self.name(path)?,
            Expr::Tuple(tuple) => Kind::Tuple(self.all(&tuple.elems, depth)?),
            Expr::Index(index) => {
                let operand = self.expression(&index.expr, depth + 1);
                let extent = Extent::of(&index.index);
                let unit = self.errors.catch(UnitExpression::parse(quote::ToTokens::to_token_stream(&index.index), extent));
                Kind::Unit(Box::new(operand?), unit?)
            }
            Expr::Unary(unary) => {
                let prefix = match unary.op {
                    UnOp::Neg(_) => Prefix::Minus,
                    UnOp::Not(_) => Prefix::Not,
                    _ => return self.refuse(expr, "there are no references here: write the operand alone"),
                };
                Kind::Prefix(prefix, Box::new(self.expression(&unary.expr, depth + 1)?))
            }
            Expr::Binary(_) => self.chain(expr, depth)?,
            Expr::Call(call) => {
                let arguments = self.all(&call.args, depth);
                match &*call.func {
                    Expr::Path(path) if path.path.get_ident().is_some() => {
                        Kind::Call(path.path.get_ident()?.clone(), arguments?)
                    }
                    other => return self.refuse(other, "expected a name in front of the parentheses, such as `world` or `body`"),
                }
            }
            Expr::MethodCall(call) => {
                let receiver = self.expression(&call.receiver, depth + 1);
                let arguments = self.all(&call.args, depth);
                if let Some(turbofish) = &call.turbofish {
                    return self.refuse(turbofish, "methods take no type arguments here");
                }
                Kind::Method(Box::new(receiver?), call.method.clone(), arguments?)
            }
            Expr::Field(field) => {
                let receiver = self.expression(&field.base, depth + 1)?;
                match &field.member {
                    syn::Member::Named(name) => Kind::Field(Box::new(receiver), name.clone()),
                    syn::Member::Unnamed(index) => {
                        return self.refuse(index, "components are called `.x`, `.y` and `.z`");
                    }
                }
            }
            Expr::Struct(record) => self.record(record, depth)?,
            Expr::If(choice) => {
                let condition = self.expression(&choice.cond, depth + 1);
                let first = self.block(&choice.then_branch, depth);
                let second = match &choice.else_branch {
                    Some((_, branch)) => self.expression(branch, depth + 1),
                    None => return self.refuse(choice.if_token, "an `if` needs an `else` here: every expression has a value"),
                };
                Kind::If(Box::new([condition?, first?, second?]))
            }
            Expr::Block(block) if block.label.is_none() => return self.block(&block.block, depth),
            Expr::Assign(assign) => {
                return self.refuse(assign.eq_token, "an assignment has no value: name the value as a local, or compare with `==`");
            }
            Expr::Cast(cast) => return self.refuse(cast.as_token, "there are no casts here: all numbers are exact"),
            Expr::Reference(reference) => {
                return self.refuse(reference.and_token, "there are no references here: write the operand alone");
            }
            Expr::Range(range) => return self.refuse(range, "there are no ranges here"),
            other => return self.refuse(other, "not part of the language of descriptions: write arithmetic, functions, `if` or the name of a local"),
        };
        Some(Expression { kind, extent })
    }

    fn refuse<T>(&mut self, place: impl quote::ToTokens, message: &str) -> Option<T> {
        self.errors.push(Extent::of(place), message);
        None
    }

    fn all<'e>(
        &mut self,
        exprs: impl IntoIterator<Item = &'e Expr>,
        depth: usize,
    ) -> Option<Vec<Expression>> {
        // every one is read, so that every one's mistakes are found
        let read: Vec<Option<Expression>> = exprs
            .into_iter()
            .map(|expr| self.expression(expr, depth + 1))
            .collect();
        read.into_iter().collect()
    }

    fn literal(&mut self, literal: &Lit) -> Option<Kind> {
        let (digits, suffix) = match literal {
            Lit::Int(int) => (int.to_string(), int.suffix().to_owned()),
            Lit::Float(float) => (float.to_string(), float.suffix().to_owned()),
            Lit::Bool(value) => {
                return self.refuse(
                    value,
                    "there are no literal conditions here: write a comparison",
                );
            }
            other => return self.refuse(other, "expected a number"),
        };
        let digits = digits
            .strip_suffix(&suffix)
            .unwrap_or(&digits)
            .trim_end_matches('_')
            .to_owned();
        if matches!(suffix.as_str(), "f32" | "f64") {
            self.errors.push(
                literal.span(),
                format!("numbers have no type here, they are exact: write `{digits}`"),
            );
            return None;
        }
        if !suffix.is_empty() {
            self.errors.push(
                literal.span(),
                format!("a unit stands in brackets: write `{digits}[{suffix}]`"),
            );
            return None;
        }
        Some(Kind::Number(digits))
    }

    fn name(&mut self, path: &syn::ExprPath) -> Option<Kind> {
        if let Some(name) = path.path.get_ident() {
            return Some(Kind::Name(name.clone()));
        }
        let segments: Vec<String> = path
            .path
            .segments
            .iter()
            .map(|segment| segment.ident.to_string())
            .collect();
        let is_constant = segments.len() >= 2 && segments[segments.len() - 2] == "consts";
        match path.path.segments.last() {
            Some(last) if is_constant => Some(Kind::Name(last.ident.clone())),
            _ => self.refuse(
                path,
                "paths cannot be used here: descriptions see only their own names and `PI`",
            ),
        }
    }

    /// Unwinds the left spine in a loop: a long sum is as flat here as it looks.
    fn chain(&mut self, expr: &Expr, depth: usize) -> Option<Kind> {
        let mut rest = Vec::new();
        let mut first = expr;
        while let Expr::Binary(binary) = first {
            rest.push((
                self.operator(&binary.op),
                self.expression(&binary.right, depth + 1),
            ));
            first = &binary.left;
        }
        let first = self.expression(first, depth + 1);
        rest.reverse();
        let rest: Option<Vec<_>> = rest
            .into_iter()
            .map(|(operator, operand)| Some((operator?, operand?)))
            .collect();
        Some(Kind::Chain(Box::new(first?), rest?))
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
            BinOp::BitXor(_) => {
                return self.refuse(operator, "`^` is a power only inside unit brackets: write `.powi(2)`");
            }
            BinOp::Rem(_) => return self.refuse(operator, "there is no remainder here: write `x - (x / y).floor() * y`"),
            other => return self.refuse(other, "not an operator of descriptions: write `+`, `-`, `*`, `/`, a comparison, `&&` or `||`"),
        })
    }

    fn record(&mut self, record: &syn::ExprStruct, depth: usize) -> Option<Kind> {
        if let Some(rest) = &record.rest {
            return self.refuse(rest, "`..` cannot be used here: write every field");
        }
        let Some(name) = record.path.get_ident() else {
            return self.refuse(&record.path, "expected `tensor` or `products`");
        };
        let fields: Vec<Option<(Ident, Expression)>> = record
            .fields
            .iter()
            .map(|field| {
                let value = self.expression(&field.expr, depth + 1);
                match &field.member {
                    syn::Member::Named(member) => Some((member.clone(), value?)),
                    syn::Member::Unnamed(index) => self.refuse(
                        index,
                        "fields have names: `xx`, `yy`, `zz`, `xy`, `yz`, `zx`",
                    ),
                }
            })
            .collect();
        Some(Kind::Record(
            name.clone(),
            fields.into_iter().collect::<Option<_>>()?,
        ))
    }

    fn block(&mut self, block: &syn::Block, depth: usize) -> Option<Expression> {
        match block.stmts.as_slice() {
            [syn::Stmt::Expr(value, None)] => self.expression(value, depth + 1),
            [] => self.refuse(block, "an empty branch has no value"),
            [first, ..] => self.refuse(
                first,
                "a branch is one expression: name intermediate values as `locals`",
            ),
        }
    }
}
