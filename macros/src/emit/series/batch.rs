//! Sums of products laid out in registers: each sum in a lane, its products one after another.

use std::iter::{once, repeat_n};

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::symbolic::{Id, LANES, Sum, Term};

/// Half the order of a series: the average number of products of coefficients in a term.
const PRODUCTS: usize = 8;
/// The limit of products in one call: their sums stay in registers.
const MOST: usize = 40;

/// Sums of one level that are computed together.
pub struct Batch<'r> {
    pub level: usize,
    pub first: usize,
    /// Including those that pad the last register.
    pub lanes: usize,
    /// Products in a lane.
    pub count: usize,
    pub parts: Vec<Part<'r>>,
}

/// A sum, or the part of it that a lane holds.
pub struct Part<'r> {
    pub sum: &'r Sum,
    terms: &'r [Term],
    linear: &'r [(Id, Id)],
}

/// The sums in batches, by level.
pub fn batches(sums: &[Sum]) -> Vec<Batch<'_>> {
    let mut batches: Vec<Batch<'_>> = Vec::new();
    for sums in sums.chunk_by(|a, b| a.level == b.level) {
        let count = best_count(sums);
        for sums in calls(sums, count) {
            let end = batches.last().map_or(0, Batch::end);
            let parts: Vec<Part<'_>> = parts(sums, count).collect();
            let lanes = filled(parts.len());
            batches.push(Batch {
                level: sums[0].level,
                // aligned registers are read fastest
                first: if lanes < 4 {
                    end
                } else {
                    end.next_multiple_of(LANES)
                },
                lanes,
                count,
                parts,
            });
        }
    }
    batches
}

/// Splits sums into calls; the parts of one sum are never in two calls.
fn calls(sums: &[Sum], count: usize) -> impl Iterator<Item = &[Sum]> {
    let lanes = move |sum: &Sum| sum.terms.len().div_ceil(count).max(1);
    let mut taken = 0;
    sums.chunk_by(move |sum, next| {
        taken += lanes(sum);
        let fits = (taken + lanes(next)) * count <= MOST;
        if !fits {
            taken = 0;
        }
        fits
    })
}

/// The number of products per lane with the least cost (products in registers, and sums of parts);
/// in a tie the largest.
fn best_count(sums: &[Sum]) -> usize {
    let most = sums.iter().map(|sum| sum.terms.len()).max().unwrap_or(1);
    let cost = |count: &usize| {
        let lanes = parts(sums, *count).count();
        lanes.div_ceil(LANES) * count * PRODUCTS + (lanes - sums.len())
    };
    (1..=most).rev().min_by_key(cost).unwrap_or(1)
}

fn parts(sums: &[Sum], count: usize) -> impl Iterator<Item = Part<'_>> {
    sums.iter().flat_map(move |sum| {
        let (first, rest) = sum.terms.split_at(count.min(sum.terms.len()));
        let first = Part {
            sum,
            terms: first,
            linear: &sum.linear,
        };
        let rest = rest.chunks(count).map(move |terms| Part {
            sum,
            terms,
            linear: &[],
        });
        once(first).chain(rest)
    })
}

/// Up to two lanes stay as they are; more are padded to registers of four.
pub fn filled(lanes: usize) -> usize {
    match lanes {
        1 | 2 => lanes,
        _ => lanes.next_multiple_of(LANES / 2),
    }
}

impl Batch<'_> {
    /// The place after the last product.
    pub fn end(&self) -> usize {
        self.first + self.lanes * self.count
    }

    /// `0, 8, 3`: the first place, the lanes and the products in each.
    pub fn sizes(&self) -> TokenStream {
        let [first, lanes, count] =
            [self.first, self.lanes, self.count].map(Literal::usize_unsuffixed);
        quote!(#first, #lanes, #count)
    }

    /// `[[term, ..], ..]`, lane by lane.
    pub fn rows(&self, fill: &TokenStream, term: impl Fn(&Term) -> TokenStream) -> TokenStream {
        let rows = self.parts.iter().map(|part| part.terms.iter().map(&term));
        self.filled(rows, self.count, fill)
    }

    /// `[[(weight, coefficient), ..], ..]`, lane by lane, of the terms added to the products, if
    /// there are any.
    pub fn linear(&self, term: impl Fn(&(Id, Id)) -> TokenStream) -> Option<TokenStream> {
        let most = self.parts.iter().map(|part| part.linear.len()).max()?;
        let rows = self.parts.iter().map(|part| part.linear.iter().map(&term));
        (most > 0).then(|| self.filled(rows, most, &quote!((0.0, 0.0))))
    }

    fn filled(
        &self,
        rows: impl Iterator<Item = impl Iterator<Item = TokenStream>>,
        count: usize,
        fill: &TokenStream,
    ) -> TokenStream {
        let rows = rows.map(|row| {
            let row = row.chain(repeat_n(fill.clone(), count)).take(count);
            quote!([#(#row),*])
        });
        let count = Literal::usize_unsuffixed(count);
        let empty = quote!([#fill; #count]);
        let rows = rows.chain(repeat_n(empty, self.lanes - self.parts.len()));
        quote!([#(#rows),*])
    }

    /// The products and their places: first the first products of all lanes, and so on.
    pub fn places(&self) -> impl Iterator<Item = (usize, &Term)> {
        let lanes = (self.first..).zip(&self.parts);
        lanes.flat_map(|(lane, part)| {
            let places = (lane..).step_by(self.lanes);
            places.zip(part.terms)
        })
    }
}
