//! The recurrences of Taylor series as a method: what they begin with, and a loop over the orders.
//!
//! ```text
//! products.start::<0, 8, 3>([[(0.5, qy, wz), (-0.5, qz, wy), (0.5, qw, wx)], ..]);
//! series.start(state);
//! let mut rates = [..];
//! for n in 1..COUNT - 1 {
//!     let [qx_n, ..] = series.extend(n, rates);
//!     let [qx_rate_n, ..] = products.terms::<0, 8, 3>(n, [[(qy_n, wz_n), (qz_n, wy_n), (qw_n, wx_n)], ..]);
//!     rates = [..];
//! }
//! series.extend(COUNT - 1, rates);
//! ```

use std::collections::{BTreeSet, HashMap};

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote};

use crate::mechanics::{Axes, Taylor};
use crate::symbolic::{Graph, Id, Node, Origin, Program, Recurrences, Stage, Sum, Term};

use super::batch::{Batch, batches};
use super::code::{Body, Fields, Source, Writer};
use super::expression::Precedence;
use super::functions::Function;
use super::naming::local;
use super::scalar::{Scalar, number_literal};

/// Names that the method has beside those of all functions.
const TAKEN: [&str; 4] = ["n", "products", "series", "rates"];

/// The method that expands a motion.
pub struct Expansion {
    pub function: Function,
    /// The number of products of series, those that fill registers included.
    pub width: usize,
}

impl Expansion {
    pub fn write(writer: &Writer<'_>, taylor: &Taylor) -> Self {
        let recurrences = &taylor.recurrences;
        let batches = batches(&recurrences.sums);
        let width = batches.last().map_or(0, Batch::end);
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

/// The symbols that stand for n-th coefficients, and for n.
fn of_order(recurrences: &Recurrences) -> BTreeSet<Id> {
    let sums = recurrences.sums.iter().map(|sum| sum.value);
    let coefficients = recurrences.coefficients.iter().copied();
    let numbers = [recurrences.order, recurrences.inverse];
    sums.chain(coefficients).chain(numbers).collect()
}

/// All that is computed for each order.
fn of_each_order(recurrences: &Recurrences) -> Vec<Id> {
    let factors = terms(recurrences).flat_map(|term| term.factors);
    let factors = factors.map(|factor| factor.next);
    recurrences.rates.iter().copied().chain(factors).collect()
}

fn terms(recurrences: &Recurrences) -> impl Iterator<Item = &Term> {
    recurrences.sums.iter().flat_map(|sum| &sum.terms)
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
    let factors = terms(recurrences).flat_map(|term| {
        let [left, right] = term.factors;
        [term.weight, left.start, right.start]
    });
    let outputs: Vec<Id> = factors
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
    let products = local("products");
    for batch in batches {
        let (sizes, sums) = (
            batch.sizes(),
            batch.rows(&quote!((0.0, 0.0, 0.0)), |term| {
                let [left, right] = term.factors;
                let [weight, left, right] = [term.weight, left.start, right.start]
                    .map(|id| body.expression(id, Precedence::Lowest));
                quote!((#weight, #left, #right))
            }),
        );
        tokens.extend(quote!(#products.start::<#sizes>(#sums);));
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
        let known = |id: Id| {
            let is_known = level(id) <= batch.level;
            let value = || body.expression(id, Precedence::Lowest);
            if is_known { value() } else { quote!(0.0) }
        };
        let (sizes, rows) = (
            batch.sizes(),
            batch.rows(&quote!((0.0, 0.0)), |term| {
                let [left, right] = term.factors.map(|factor| known(factor.next));
                quote!((#left, #right))
            }),
        );
        let (names, gathered) = name_sums(body, taylor, batch);
        tokens.extend(quote! {
            let [#names] = #products.terms::<#sizes>(#n, #rows);
            #gathered
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

/// The names of what a batch gives, and the sums of those that are in parts.
fn name_sums(
    body: &mut Body<'_>,
    taylor: &Taylor,
    batch: &Batch<'_>,
) -> (TokenStream, TokenStream) {
    let (mut names, mut gathered) = (Vec::new(), TokenStream::new());
    for parts in batch.parts.chunk_by(|a, b| a.sum.value == b.sum.value) {
        let name = name_sum(body, taylor, parts[0].sum);
        if parts.len() == 1 {
            names.push(name);
            continue;
        }
        let places = 1..=parts.len();
        let parts: Vec<Ident> = places
            .map(|place| body.unique(&format!("{name}_{place}")))
            .collect();
        gathered.extend(quote!(let #name = #(#parts)+*;));
        names.extend(parts);
    }
    let rest = (batch.parts.len() < batch.lanes).then(|| quote!(..));
    (quote!(#(#names,)* #rest), gathered)
}

/// A sum is called after the coordinate that it is the rate of, or after what it was written for.
fn name_sum(body: &mut Body<'_>, taylor: &Taylor, sum: &Sum) -> Ident {
    let Recurrences { rates, results, .. } = &taylor.recurrences;
    let graph = &body.writer.model.frames.graph;
    let (of, word, is_whole) = match sum.of {
        Origin::Rate(place) => (taylor.symbols[place], "rate_", rates[place] == sum.value),
        Origin::Result(of) => (of, "", results.contains(&(of, sum.value))),
        Origin::Product(of) => {
            let is_product = matches!(graph.node(of), Node::Multiply(..));
            (of, "", is_product && sum.terms.len() == 1)
        }
    };
    let rest = if is_whole { "n" } else { "terms_n" };
    let name = name_after(body, of, &format!("{word}{rest}"));
    body.names.insert(sum.value, name.clone());
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
            let places = batch
                .places()
                .map(move |(place, term)| (place, term.factors[side].next));
            places.filter(|(_, next)| level(*next) > batch.level)
        });
        let pairs = late.map(|(place, next)| {
            let place = Literal::usize_unsuffixed(place);
            let value = body.expression(next, Precedence::Lowest);
            quote!((#place, #value))
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
        .sums
        .iter()
        .map(|sum| (sum.value, sum.level + 1))
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
