//! The recurrences of Taylor series as a method: what they begin with, and a loop over the orders.
//!
//! ```text
//! products.start([(wy, wz), ..]);
//! series.start(state);
//! let mut rates = [..];
//! for n in 1..COUNT - 1 {
//!     let [wx_n, ..] = series.extend(n, rates);
//!     let [wy_wz_n, ..] = products.terms::<0, 4>(n, [(wy_n, wz_n), ..]);
//!     rates = [..];
//! }
//! series.extend(COUNT - 1, rates);
//! ```

use std::collections::{BTreeSet, HashMap};

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote};

use crate::mechanics::{Axes, Taylor};
use crate::symbolic::{Graph, Id, Node, Product, Program, Recurrences, Stage};

use super::code::{Body, Fields, Source, Writer};
use super::expression::Precedence;
use super::functions::Function;
use super::naming::local;
use super::scalar::{Scalar, number_literal};

/// The most products of one call: their sums stay in registers.
const BATCH: usize = 24;
/// Products are added up to so many: what fills a register.
const LANES: usize = 4;

/// Names that the method has beside those of all functions.
const TAKEN: [&str; 4] = ["n", "products", "series", "rates"];

/// The method that expands a motion.
pub struct Expansion {
    pub function: Function,
    /// The number of products of series, those that fill registers included.
    pub width: usize,
}

/// Products of one level that are computed together.
struct Batch<'r> {
    level: usize,
    first: usize,
    /// With those that fill the last register.
    count: usize,
    products: &'r [Product],
}

impl Expansion {
    pub fn write(writer: &Writer<'_>, taylor: &Taylor) -> Self {
        let recurrences = &taylor.recurrences;
        let batches = batches(&recurrences.products);
        let width = batches.iter().map(|batch| batch.count).sum();
        let held = held(&writer.model.frames.graph, recurrences);

        let mut body = Body::new(writer, false);
        body.taken.extend(TAKEN.map(str::to_owned));
        let mut statements = start(&mut body, recurrences, &batches, &held);
        let targets = name_results(&mut body, recurrences);
        let writer = Writer {
            targets: &targets,
            scalar: Scalar::double(writer.outline),
            private: writer.private.clone(),
            ..*writer
        };
        let mut body = Body {
            writer: &writer,
            ..body
        };
        statements.extend(orders(&mut body, taylor, &batches));

        let graph = &writer.model.frames.graph;
        let has_equality = |id: &Id| matches!(graph.node(*id), Node::Compare(..));
        let roots = graph.reachable(&recurrences.roots(), |id| !graph.is_early(id));
        body.reads.push(Source::State);
        let function = Function {
            body: statements,
            has_notes: !body.noted.is_empty(),
            has_equality: roots.iter().any(has_equality),
            reads: body.reads,
            ..Function::default()
        };
        Self { function, width }
    }
}

/// `Axes::despun(time, [0.0, 0.0, 1.0], spin)`
pub fn write_axes(writer: &Writer<'_>, axes: &Axes) -> Function {
    let (private, time) = (&writer.private, local("time"));
    let direction = axes
        .direction
        .each_ref()
        .map(|part| number_literal(part.to_f64()));
    let mut function = Function::write(
        writer,
        &[axes.spin],
        |values| quote!(#private::Axes::despun(#time, [#(#direction),*], #(#values)*)),
    );
    function.reads.push(Source::Time);
    function
}

fn batches(products: &[Product]) -> Vec<Batch<'_>> {
    let mut batches: Vec<Batch<'_>> = Vec::new();
    let levels = products.chunk_by(|a, b| a.level == b.level);
    for products in levels.flat_map(|level| level.chunks(BATCH)) {
        let last = batches.last();
        batches.push(Batch {
            level: products[0].level,
            first: last.map_or(0, |last| last.first + last.count),
            count: match products.len() {
                count @ (1 | 2) => count,
                count => count.next_multiple_of(LANES),
            },
            products,
        });
    }
    batches
}

/// The symbols that stand for n-th coefficients, and for n.
fn of_order(recurrences: &Recurrences) -> BTreeSet<Id> {
    let sums = recurrences.products.iter().map(|product| product.sum);
    let coefficients = recurrences.coefficients.iter().copied();
    let numbers = [recurrences.order, recurrences.inverse];
    sums.chain(coefficients).chain(numbers).collect()
}

/// All that is computed for each order.
fn of_each_order(recurrences: &Recurrences) -> Vec<Id> {
    let factors = recurrences
        .products
        .iter()
        .flat_map(|product| product.factors);
    let factors = factors.map(|factor| factor.next);
    recurrences.rates.iter().copied().chain(factors).collect()
}

/// What is computed once, from the start of the step, and read by every order.
fn held(graph: &Graph, recurrences: &Recurrences) -> BTreeSet<Id> {
    let roots = of_each_order(recurrences);
    let mut moves = of_order(recurrences);
    let mut held = BTreeSet::new();
    for id in graph.reachable(&roots, |id| !graph.is_early(id)) {
        if graph
            .node(id)
            .operands()
            .any(|operand| moves.contains(&operand))
        {
            moves.insert(id);
        }
    }
    for id in &moves {
        let operands = graph.node(*id).operands();
        let is_held = |operand: &Id| !moves.contains(operand) && !graph.is_early(*operand);
        held.extend(operands.filter(is_held));
    }
    held
}

/// Reads the state, and computes the first coefficients of what is multiplied and of the rates.
fn start(
    body: &mut Body<'_>,
    recurrences: &Recurrences,
    batches: &[Batch<'_>],
    held: &BTreeSet<Id>,
) -> TokenStream {
    let factors = recurrences
        .products
        .iter()
        .flat_map(|product| product.factors);
    let outputs: Vec<Id> = factors
        .map(|factor| factor.start)
        .chain(recurrences.start.iter().copied())
        .chain(held.iter().copied())
        .collect();
    let program = body.writer.schedule(&outputs);
    let mut tokens = body.read(&program);
    tokens.extend(body.statements(&program, |_| true).0);
    for id in held {
        if !body.names.contains_key(id) {
            let (name, value) = (body.statement_name(*id), body.definition(*id));
            tokens.extend(quote!(let #name = #value;));
            body.names.insert(*id, name);
        }
    }
    if !batches.is_empty() {
        let pairs = batches.iter().flat_map(|batch| {
            let starts = |product: &Product| product.factors.map(|factor| Some(factor.start));
            pairs(body, batch, starts)
        });
        let (pairs, products) = (pairs.collect::<Vec<_>>(), local("products"));
        tokens.extend(quote!(#products.start([#(#pairs),*]);));
    }
    let (series, state, rates) = (local("series"), local("state"), local("rates"));
    let values = coordinates(body, &recurrences.start);
    tokens.extend(quote! {
        #series.start(#state);
        let mut #rates = [#(#values),*];
    });
    tokens
}

/// The n-th coefficients of quotients and functions are called after these.
fn name_results(body: &mut Body<'_>, recurrences: &Recurrences) -> Fields {
    let graph = &body.writer.model.frames.graph;
    let results = recurrences.results.iter();
    let computed = results.filter(|(_, next)| !matches!(graph.node(*next), Node::Symbol(_)));
    let named = computed.map(|(result, next)| (*next, name_after(body, *result, "n")));
    Fields(named.collect())
}

/// A name after that of an expression at the start, or after what it is.
fn name_after(body: &mut Body<'_>, id: Id, suffix: &str) -> Ident {
    let known = body.names.get(&id).map(ToString::to_string);
    let base = known.unwrap_or_else(|| body.describe(id));
    body.unique(&format!("{base}_{suffix}"))
}

/// The rates of the coordinates, without that of time.
fn coordinates(body: &Body<'_>, rates: &[Id]) -> Vec<TokenStream> {
    let rates = rates.split_last().map_or(rates, |(_, rates)| rates);
    rates
        .iter()
        .map(|rate| body.expression(*rate, Precedence::Lowest))
        .collect()
}

/// `(left, right)` of the products of a batch, with zero for what is not known.
fn pairs(
    body: &Body<'_>,
    batch: &Batch<'_>,
    factors: impl Fn(&Product) -> [Option<Id>; 2],
) -> Vec<TokenStream> {
    let known = |factor: Id| body.expression(factor, Precedence::Lowest);
    let value = |factor: Option<Id>| factor.map_or_else(|| quote!(0.0), known);
    let products = batch.products.iter();
    let mut pairs: Vec<TokenStream> = products
        .map(|product| {
            let [left, right] = factors(product).map(value);
            quote!((#left, #right))
        })
        .collect();
    pairs.resize(batch.count, quote!((0.0, 0.0)));
    pairs
}

/// The loop over the orders.
fn orders(body: &mut Body<'_>, taylor: &Taylor, batches: &[Batch<'_>]) -> TokenStream {
    let recurrences = &taylor.recurrences;
    let graph = &body.writer.model.frames.graph;
    let program = graph.schedule(&of_each_order(recurrences), Stage::State);
    let levels = levels(graph, recurrences, &program);
    let level = |id: Id| levels.get(&id).copied().unwrap_or(0);
    let (n, series, products, rates) = (
        local("n"),
        local("series"),
        local("products"),
        local("rates"),
    );

    let coefficients = name_coefficients(body, taylor, &program);
    let mut tokens = read_order(body, recurrences, &program);
    for batch in batches {
        let statements = body.statements(&program, |id| level(id) <= batch.level);
        tokens.extend(statements.0);
        let known = |next: Id| (level(next) <= batch.level).then_some(next);
        let pairs = pairs(body, batch, |product| {
            product.factors.map(|factor| known(factor.next))
        });
        let names: Vec<Ident> = batch
            .products
            .iter()
            .map(|product| name_term(body, product))
            .collect();
        let rest = (batch.products.len() < batch.count).then(|| quote!(..));
        let (first, count) = (
            Literal::usize_unsuffixed(batch.first),
            Literal::usize_unsuffixed(batch.count),
        );
        tokens.extend(quote! {
            let [#(#names,)* #rest] = #products.terms::<#first, #count>(#n, [#(#pairs),*]);
        });
    }
    tokens.extend(body.statements(&program, |_| true).0);
    tokens.extend(complete(body, batches, level));
    let values = coordinates(body, &recurrences.rates);
    quote! {
        for #n in 1..COUNT - 1 {
            #coefficients #series.extend(#n, #rates);
            #tokens
            #rates = [#(#values),*];
        }
        #series.extend(COUNT - 1, #rates);
    }
}

/// `let [qx_n, _, ..] =`
fn name_coefficients(body: &mut Body<'_>, taylor: &Taylor, program: &Program) -> TokenStream {
    let pairs = taylor.symbols.iter().zip(&taylor.recurrences.coefficients);
    let count = taylor.symbols.len() - 1;
    let mut pattern = Vec::new();
    for (symbol, coefficient) in pairs.take(count) {
        let is_read = program.symbols.contains(coefficient);
        let base = body.names.get(symbol).filter(|_| is_read);
        let Some(base) = base.map(|base| format!("{base}_n")) else {
            pattern.push(quote!(_));
            continue;
        };
        let name = body.unique(&base);
        body.names.insert(*coefficient, name.clone());
        pattern.push(name.into_token_stream());
    }
    let is_read = taylor.recurrences.coefficients[..count]
        .iter()
        .any(|coefficient| program.symbols.contains(coefficient));
    if is_read {
        quote!(let [#(#pattern),*] =)
    } else {
        TokenStream::new()
    }
}

/// n, its reciprocal, and the coefficient of time, if they are read.
fn read_order(body: &mut Body<'_>, recurrences: &Recurrences, program: &Program) -> TokenStream {
    let private = body.writer.private.clone();
    let n = local("n");
    let time = recurrences.coefficients.last().copied();
    let given = [
        (Some(recurrences.order), "order"),
        (Some(recurrences.inverse), "inverse"),
        (time, "time"),
    ];
    let mut tokens = TokenStream::new();
    for (symbol, word) in given {
        let Some(symbol) = symbol.filter(|symbol| program.symbols.contains(symbol)) else {
            continue;
        };
        let (function, name) = (local(word), body.unique(&format!("{word}_n")));
        tokens.extend(quote!(let #name = #private::order::#function(#n);));
        body.names.insert(symbol, name);
    }
    tokens
}

/// A convolution is called after what it was written for.
fn name_term(body: &mut Body<'_>, product: &Product) -> Ident {
    let graph = &body.writer.model.frames.graph;
    let is_product = matches!(graph.node(product.of), Node::Multiply(..));
    let suffix = if is_product { "n" } else { "terms_n" };
    let name = name_after(body, product.of, suffix);
    body.names.insert(product.sum, name.clone());
    name
}

/// The factors that were not known when they were multiplied by zero.
fn complete(
    body: &Body<'_>,
    batches: &[Batch<'_>],
    level: impl Fn(Id) -> usize,
) -> Option<TokenStream> {
    let side = |side: usize| {
        let late = batches.iter().flat_map(|batch| {
            let products = (batch.first..).zip(batch.products);
            let nexts = products.map(move |(index, product)| (index, product.factors[side].next));
            nexts.filter(|(_, next)| level(*next) > batch.level)
        });
        let pairs = late.map(|(index, next)| {
            let index = Literal::usize_unsuffixed(index);
            let value = body.expression(next, Precedence::Lowest);
            quote!((#index, #value))
        });
        pairs.collect::<Vec<_>>()
    };
    let (left, right) = (side(0), side(1));
    let (products, n) = (local("products"), local("n"));
    let is_there = !left.is_empty() || !right.is_empty();
    is_there.then(|| quote!(#products.complete(#n, &[#(#left),*], &[#(#right),*]);))
}

/// How many levels of convolutions stand before each expression of an order; none are left out.
fn levels(graph: &Graph, recurrences: &Recurrences, program: &Program) -> HashMap<Id, usize> {
    let mut levels: HashMap<Id, usize> = recurrences
        .products
        .iter()
        .map(|product| (product.sum, product.level + 1))
        .collect();
    for id in &program.nodes {
        let operands = graph.node(*id).operands();
        let highest = operands.filter_map(|operand| levels.get(&operand)).max();
        if let Some(level) = highest.copied() {
            levels.insert(*id, level);
        }
    }
    levels
}
