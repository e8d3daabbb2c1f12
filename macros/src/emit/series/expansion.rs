//! The recurrences of Taylor series as a method: initial values, followed by a loop over the
//! orders.
//!
//! ```text
//! products.start::<0, 8, 3>([[(0.5, qy, wz), (-0.5, qz, wy), (0.5, qw, wx)], ..]);
//! series.start(state);
//! let mut rates = products.times([..], 1.0);
//! for n in 1..COUNT - 1 {
//!     let [qx_n, ..] = series.extend(products, n, rates);
//!     let [qx_rate_n, ..] =
//!         products.terms::<0, 8, 3>(n, [[(qy_n, wz_n), (qz_n, wy_n), (qw_n, wx_n)], ..]);
//!     rates = [..];
//! }
//! series.extend(products, COUNT - 1, rates);
//! ```
//!
//! If the sums are the rates of all coordinates, they are used directly.

use std::collections::{BTreeSet, HashMap};
use std::iter::repeat_n;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::emit::code::{Block, Facts, Method, Source, Writer, local, number_literal};
use crate::emit::items::Best;
use crate::mechanics::{Axes, Taylor};
use crate::symbolic::{Graph, Id, Node, Program, Recurrences, Stage, Term};

use super::batch::{Batch, batches, filled};
use super::choice::Counts;
use super::names::{name_coefficients, name_results, name_sums};

/// The names in the method that are taken in addition to those that all functions have.
const TAKEN: [&str; 5] = ["n", "products", "series", "rates", "sums"];

/// The method that expands a motion into a series.
pub struct Expansion {
    pub method: Method,
    /// The number of products of series, including those that pad registers.
    pub width: usize,
    /// The method that takes less time.
    pub best: Best,
}

impl Expansion {
    pub fn write(writer: &Writer<'_>, taylor: &Taylor) -> Self {
        let recurrences = &taylor.recurrences;
        let batches = batches(&recurrences.sums);
        let width = batches.last().map_or(0, Batch::end);
        let held = held(&writer.work.graph, recurrences);

        let mut block = Block::new(writer, false);
        block.taken.extend(TAKEN);
        let mut statements = start(&mut block, recurrences, &batches, &held);
        let targets = name_results(&mut block, recurrences);
        let writer = Writer {
            targets: &targets,
            ..writer.clone()
        };
        let mut block = Block {
            writer: &writer,
            ..block
        };
        statements.extend(orders(&mut block, taylor, &batches));

        let graph = &writer.work.graph;
        let has_equality = |id: &Id| matches!(graph.node(*id), Node::Compare(..));
        let has_combined = |id: &Id| matches!(graph.node(*id), Node::And(..) | Node::Or(..));
        let roots = graph.reachable(&recurrences.roots(), &|id| !graph.is_early(id));
        block.reads.push(Source::State);
        let method = Method {
            body: statements,
            facts: Facts {
                has_notes: !block.noted.is_empty(),
                has_equality: roots.iter().any(has_equality),
                has_combined: roots.iter().any(has_combined),
                reads: block.reads,
                ..Facts::default()
            },
        };
        let counts = Counts {
            width,
            levels: batches.last().map_or(0, |batch| batch.level),
            coordinates: recurrences.rates.len(),
            each_order: graph.late_cost(&of_each_order(recurrences)),
            rates: graph.late_cost(&recurrences.start),
        };
        // in axes that do not spin, steps along the series are much longer
        let best = if taylor.axes.is_some() {
            Best::Series
        } else {
            counts.best()
        };
        Self {
            method,
            width,
            best,
        }
    }
}

/// `Axes::despun(time, [0.0, 0.0, 1.0], spin)`
pub fn write_axes(writer: &Writer<'_>, axes: &Axes) -> Method {
    let (private, time) = (&writer.shapes.private, local("time"));
    let direction = axes.direction.each_ref();
    let direction = direction.map(|part| number_literal(part.to_f64()));
    let mut method = Method::write(
        writer,
        &[axes.spin],
        |values| quote!(#private::Axes::despun(#time, [#(#direction),*], #(#values)*)),
    );
    method.facts.reads.push(Source::Time);
    method
}

/// The symbols that stand for n-th coefficients, and for n.
fn of_order(recurrences: &Recurrences) -> BTreeSet<Id> {
    let sums = recurrences.sums.iter().map(|sum| sum.value);
    let coefficients = recurrences.coefficients.iter().copied();
    let polynomials = recurrences.polynomials.iter().map(|(_, next)| *next);
    let numbers = [recurrences.order, recurrences.inverse];
    sums.chain(coefficients)
        .chain(polynomials)
        .chain(numbers)
        .collect()
}

/// All expressions that are computed for every order.
fn of_each_order(recurrences: &Recurrences) -> Vec<Id> {
    let factors = terms(recurrences).flat_map(|term| term.factors);
    let factors = factors.map(|factor| factor.next);
    let linear = linear(recurrences).map(|(_, next)| *next);
    let rates = recurrences.rates.iter().copied();
    rates.chain(factors).chain(linear).collect()
}

/// The terms that are added to the sums of products: weights and coefficients.
fn linear(recurrences: &Recurrences) -> impl Iterator<Item = &(Id, Id)> {
    recurrences.sums.iter().flat_map(|sum| &sum.linear)
}

fn terms(recurrences: &Recurrences) -> impl Iterator<Item = &Term> {
    recurrences.sums.iter().flat_map(|sum| &sum.terms)
}

/// The expressions that are computed once, at the start of the step, and that every order reads.
fn held(graph: &Graph, recurrences: &Recurrences) -> BTreeSet<Id> {
    let roots = of_each_order(recurrences);
    let mut moves = of_order(recurrences);
    let mut held = BTreeSet::new();
    let order = graph.reachable(&roots, &|id| !graph.is_early(id));
    let read = recurrences.polynomials.iter();
    for (polynomial, _) in read.filter(|(_, next)| order.contains(next)) {
        let coefficients = polynomial.coefficients.iter().copied();
        held.extend(coefficients.filter(|id| !graph.is_early(*id)));
    }
    for id in order {
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
    let weights = linear(recurrences).map(|(weight, _)| *weight);
    held.extend(weights.filter(|weight| !graph.is_early(*weight)));
    held
}

/// Reads the state, and computes the first coefficients of the factors and of the rates.
fn start(
    block: &mut Block<'_>,
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
    let program = block.writer.schedule(&outputs);
    let mut tokens = block.read(&program);
    tokens.extend(block.statements(&program, |_| true).0);
    for id in held {
        if !block.names.contains_key(id) {
            let (name, value) = (block.statement_name(*id), block.definition(*id));
            tokens.extend(quote!(let #name = #value;));
            block.names.insert(*id, name);
        }
    }
    let products = local("products");
    for batch in batches {
        let (sizes, sums) = (
            batch.sizes(),
            batch.rows(&quote!((0.0, 0.0, 0.0)), |term| {
                let [left, right] = term.factors;
                let [weight, left, right] =
                    [term.weight, left.start, right.start].map(|id| block.value(id));
                quote!((#weight, #left, #right))
            }),
        );
        tokens.extend(quote!(#products.start::<#sizes>(#sums);));
    }
    let [series, state, rates] = ["series", "state", "rates"].map(local);
    let values = coordinates(block, &recurrences.start);
    tokens.extend(quote! {
        #series.start(#state);
        let mut #rates = #products.times([#(#values),*], 1.0);
    });
    tokens
}

/// The rates of the coordinates, with padding up to a whole register.
fn coordinates(block: &Block<'_>, rates: &[Id]) -> Vec<TokenStream> {
    let rest = filled(rates.len()) - rates.len();
    rates
        .iter()
        .map(|rate| block.value(*rate))
        .chain(repeat_n(quote!(0.0), rest))
        .collect()
}

/// The loop over the orders.
fn orders(block: &mut Block<'_>, taylor: &Taylor, batches: &[Batch<'_>]) -> TokenStream {
    let recurrences = &taylor.recurrences;
    let graph = &block.writer.work.graph;
    let program = graph.schedule(&of_each_order(recurrences), Stage::State);
    let levels = levels(graph, recurrences, &program);
    let level = |id: Id| levels.get(&id).copied().unwrap_or(0);
    let [n, series, products, rates] = ["n", "series", "products", "rates"].map(local);

    let coefficients = name_coefficients(block, taylor, &program);
    let mut tokens = read_order(block, recurrences, &program);
    for batch in batches {
        let statements = block.statements(&program, |id| level(id) <= batch.level);
        tokens.extend(statements.0);
        let (before, sums) = sums_of_order(block, batch, level);
        tokens.extend(before);
        if is_of_rates(batch, recurrences) {
            tokens.extend(quote!(#rates = #sums;));
            continue;
        }
        let (names, gathered) = name_sums(block, taylor, batch);
        tokens.extend(quote! {
            let [#names] = #sums;
            #gathered
        });
    }
    tokens.extend(block.statements(&program, |_| true).0);
    tokens.extend(complete(block, batches, level));
    if !batches.iter().any(|batch| is_of_rates(batch, recurrences)) {
        let values = coordinates(block, &recurrences.rates);
        tokens.extend(quote!(#rates = [#(#values),*];));
    }
    quote! {
        for #n in 1..COUNT - 1 {
            #coefficients #series.extend(#products, #n, #rates);
            #tokens
        }
        #series.extend(#products, COUNT - 1, #rates);
    }
}

/// The sums of a batch, and the expressions that must be computed before them.
fn sums_of_order(
    block: &Block<'_>,
    batch: &Batch<'_>,
    level: impl Fn(Id) -> usize,
) -> (TokenStream, TokenStream) {
    let known = |id: Id| {
        let is_known = level(id) <= batch.level;
        if is_known {
            block.value(id)
        } else {
            quote!(0.0)
        }
    };
    let rows = batch.rows(&quote!((0.0, 0.0)), |term| {
        let [left, right] = term.factors.map(|factor| known(factor.next));
        quote!((#left, #right))
    });
    let linear = batch.linear(|(weight, next)| {
        let [weight, next] = [*weight, *next].map(|id| block.value(id));
        quote!((#weight, #next))
    });
    let [n, products, name] = ["n", "products", "sums"].map(local);
    let sizes = batch.sizes();
    let sums = quote!(#products.terms::<#sizes>(#n, #rows));
    match linear {
        None => (TokenStream::new(), sums),
        Some(linear) => (
            quote!(let #name = #sums;),
            quote!(#products.plus(#name, #linear)),
        ),
    }
}

/// Whether the sums of a batch are the rates of all coordinates, and nothing else reads them.
fn is_of_rates(batch: &Batch<'_>, recurrences: &Recurrences) -> bool {
    let rates = &recurrences.rates;
    let sums = batch.parts.iter().map(|part| part.sum.value);
    let factors = terms(recurrences).flat_map(|term| term.factors);
    let mut nexts = factors.map(|factor| factor.next);
    sums.eq(rates.iter().copied()) && !nexts.any(|next| rates.contains(&next))
}

/// Reads n, its reciprocal, and the coefficients of `.moving` inputs, if they are used.
fn read_order(block: &mut Block<'_>, recurrences: &Recurrences, program: &Program) -> TokenStream {
    let private = block.writer.shapes.private.clone();
    let n = local("n");
    let is_read = |symbol: &Id| program.symbols.contains(symbol);
    let mut tokens = TokenStream::new();
    let numbers = [
        (recurrences.order, "order"),
        (recurrences.inverse, "inverse"),
    ];
    for (symbol, word) in numbers.into_iter().filter(|(symbol, _)| is_read(symbol)) {
        let (function, name) = (local(word), block.unique(&format!("{word}_n")));
        tokens.extend(quote!(let #name = #private::order::#function(#n);));
        block.names.insert(symbol, name);
    }
    let polynomials = recurrences.polynomials.iter();
    for (polynomial, next) in polynomials.filter(|(_, next)| is_read(next)) {
        let of = block.names.get(&polynomial.symbol);
        let of = of.map_or_else(|| "given".to_owned(), ToString::to_string);
        let name = block.unique(&format!("{of}_n"));
        let coefficients = polynomial.coefficients.iter().map(|id| block.value(*id));
        tokens.extend(quote!(let #name = #private::order::given(#n, [#(#coefficients),*]);));
        block.names.insert(*next, name);
    }
    tokens
}

/// Fills in the factors that were unknown, and were multiplied as zero.
fn complete(
    block: &Block<'_>,
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
            let value = block.value(next);
            quote!((#place, #value))
        });
        pairs.collect::<Vec<_>>()
    };
    let (left, right) = (side(0), side(1));
    let (products, n) = (local("products"), local("n"));
    let is_there = !left.is_empty() || !right.is_empty();
    is_there.then(|| quote!(#products.complete(#n, &[#(#left),*], &[#(#right),*]);))
}

/// The number of levels of convolutions that precede each expression of an order.
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
            let alike = program.values.copies_of(*id).iter().chain([id]);
            levels.extend(alike.map(|id| (*id, level)));
        }
    }
    levels
}
