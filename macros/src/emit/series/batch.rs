//! Sums of products, laid out in registers: each sum in one lane, its products one after another.

use std::iter::{once, repeat_n};

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::symbolic::{Id, LANES, Sum, Term};

/// The average number of products of coefficients in a term: half the order of a series.
const PRODUCTS: usize = 8;
/// The most products in one call. Up to this number, their sums stay in registers.
const MOST: usize = 40;

/// Sums of one level that are computed together.
pub struct Batch<'r> {
    pub level: usize,
    pub first: usize,
    /// The number of lanes, including those that pad the last register.
    pub lanes: usize,
    /// The number of products in each lane.
    pub count: usize,
    pub parts: Vec<Part<'r>>,
}

/// A sum, or the part of it that a lane holds.
pub struct Part<'r> {
    pub sum: &'r Sum,
    terms: &'r [Term],
    linear: &'r [(Id, Id)],
}

/// The sums, combined into batches, level by level.
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
                // aligned registers are fastest to read
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

/// Splits sums into groups, one for each call. The parts of a sum are always in the same call.
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

/// The number of products per lane with the least cost (of products in registers, and of sums of
/// parts). In a tie, the largest such number.
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

/// The number of lanes with padding: up to two lanes need none, and more are padded to registers of
/// four.
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

    /// `0, 8, 3`: the first place, the number of lanes, and the number of products in each.
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

    /// `[[(weight, coefficient), ..], ..]`, lane by lane: the terms that are added to the products,
    /// if there are any.
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

    /// The products and their places: the first product of each lane, then the second product of
    /// each lane, and so on.
    pub fn places(&self) -> impl Iterator<Item = (usize, &Term)> {
        let lanes = (self.first..).zip(&self.parts);
        lanes.flat_map(|(lane, part)| {
            let places = (lane..).step_by(self.lanes);
            places.zip(part.terms)
        })
    }
}
