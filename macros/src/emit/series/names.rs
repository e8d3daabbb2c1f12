//! The names of coefficients and of their sums.

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};

use crate::emit::code::{Block, Fields};
use crate::mechanics::Taylor;
use crate::symbolic::{Id, Node, Origin, Program, Recurrences, Sum};

use super::batch::{Batch, filled};

/// Names the n-th coefficients of quotients and functions after these quotients and functions.
pub fn name_results(block: &mut Block<'_>, recurrences: &Recurrences) -> Fields {
    let graph = &block.writer.work.graph;
    let results = recurrences.results.iter();
    let computed = results.filter(|(_, next)| !matches!(graph.node(*next), Node::Symbol(_)));
    let named = computed.map(|(result, next)| (*next, name_after(block, *result, "n")));
    Fields(named.collect())
}

/// A name made from the name of an expression at the start, or from its kind.
fn name_after(block: &mut Block<'_>, id: Id, suffix: &str) -> Ident {
    let known = block.names.get(&id).map(ToString::to_string);
    let base = known.unwrap_or_else(|| block.describe(id));
    block.unique(&format!("{base}_{suffix}"))
}

/// `let [qx_n, _, ..] =`
pub fn name_coefficients(block: &mut Block<'_>, taylor: &Taylor, program: &Program) -> TokenStream {
    let pairs = taylor.symbols.iter().zip(&taylor.recurrences.coefficients);
    let count = taylor.symbols.len();
    let mut pattern = Vec::new();
    for (symbol, coefficient) in pairs {
        let is_read = program.symbols.contains(coefficient);
        let base = block.names.get(symbol).filter(|_| is_read);
        let Some(base) = base.map(|base| format!("{base}_n")) else {
            pattern.push(quote!(_));
            continue;
        };
        let name = block.unique(&base);
        block.names.insert(*coefficient, name.clone());
        pattern.push(name.into_token_stream());
    }
    let mut coefficients = taylor.recurrences.coefficients.iter();
    let is_read = coefficients.any(|coefficient| program.symbols.contains(coefficient));
    if is_read {
        let rest = (filled(count) > count).then(|| quote!(..));
        quote!(let [#(#pattern,)* #rest] =)
    } else {
        TokenStream::new()
    }
}

/// The names of the results of a batch, and the sums of those that are split into parts.
pub fn name_sums(
    block: &mut Block<'_>,
    taylor: &Taylor,
    batch: &Batch<'_>,
) -> (TokenStream, TokenStream) {
    let (mut names, mut gathered) = (Vec::new(), TokenStream::new());
    for parts in batch.parts.chunk_by(|a, b| a.sum.value == b.sum.value) {
        let name = name_sum(block, taylor, parts[0].sum);
        if parts.len() == 1 {
            names.push(name);
            continue;
        }
        let places = 1..=parts.len();
        let parts: Vec<Ident> = places
            .map(|place| block.unique(&format!("{name}_{place}")))
            .collect();
        gathered.extend(quote!(let #name = #(#parts)+*;));
        names.extend(parts);
    }
    let rest = (batch.parts.len() < batch.lanes).then(|| quote!(..));
    (quote!(#(#names,)* #rest), gathered)
}

/// The name of a sum: after the coordinate whose rate it is, or after its purpose.
fn name_sum(block: &mut Block<'_>, taylor: &Taylor, sum: &Sum) -> Ident {
    let Recurrences { rates, results, .. } = &taylor.recurrences;
    let graph = &block.writer.work.graph;
    let (of, word, is_whole) = match sum.of {
        Origin::Rate(place) => (taylor.symbols[place], "rate_", rates[place] == sum.value),
        Origin::Result(of) => (of, "", results.contains(&(of, sum.value))),
        Origin::Product(of) => {
            let is_product = matches!(graph.node(of), Node::Multiply(..));
            (of, "", is_product && sum.terms.len() == 1)
        }
    };
    let rest = if is_whole { "n" } else { "terms_n" };
    let name = name_after(block, of, &format!("{word}{rest}"));
    block.names.insert(sum.value, name.clone());
    name
}
