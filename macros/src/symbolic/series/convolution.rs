//! Convolutions gathered into sums. Consider coefficients that are linear in convolutions that
//! nothing else reads,
//!
//! ```text
//! z[n] = w1 (a * b) + w2 (c * d) + .. + rest
//! ```
//!
//! with weights that are constant along a step. Their convolutions of one level form one sum, which
//! is computed in one lane. Terms that are linear in coefficients are added there too.

use std::collections::{BTreeMap, HashMap, HashSet};

use crate::symbolic::graph::{Graph, Id, Node, Stage};

/// The numbers in a register, which are computed side by side.
pub const LANES: usize = 8;

/// A convolution of two series.
#[derive(Clone, Copy, Debug)]
pub struct Product {
    /// The expression that it was written for.
    pub of: Id,
    pub level: usize,
    /// The symbol that stands for its value.
    pub value: Id,
    pub factors: [Factor; 2],
}

/// A factor of a convolution: a series.
#[derive(Clone, Copy, Debug)]
pub struct Factor {
    pub start: Id,
    /// Its n-th coefficient. If that is known only after the convolution, the convolution does not
    /// depend on it.
    pub next: Id,
}

/// A sum of convolutions of one level.
#[derive(Clone, Debug)]
pub struct Sum {
    pub of: Origin,
    pub level: usize,
    /// The symbol that stands for its value.
    pub value: Id,
    pub terms: Vec<Term>,
    /// Coefficients that are added, with weights that are constant along a step.
    pub linear: Vec<(Id, Id)>,
}

/// What a sum is computed for.
#[derive(Clone, Copy, Debug)]
pub enum Origin {
    /// The rate of the coordinate with this index.
    Rate(usize),
    /// The coefficient of a quotient or a function.
    Result(Id),
    /// The expression that a convolution was written for.
    Product(Id),
}

/// A convolution with its weight, which is constant along a step.
#[derive(Clone, Copy, Debug)]
pub struct Term {
    pub weight: Id,
    pub factors: [Factor; 2],
}

/// The readers of convolutions: coefficients, and the factors of further convolutions.
pub(in crate::symbolic) struct Readers<'r> {
    pub rates: &'r mut Vec<Id>,
    pub results: &'r mut Vec<(Id, Id)>,
    /// The symbols that change from order to order, except those of convolutions.
    pub symbols: Vec<Id>,
}

/// A sum of products, given by their indices, and of other terms, all with weights.
struct Weighted {
    level: usize,
    terms: Vec<(Id, usize)>,
    rest: Vec<(Id, Id)>,
}

impl Weighted {
    fn add(&mut self, graph: &mut Graph, weight: Id, other: Self) {
        let mut weighted = |held: Id| graph.multiply(weight, held);
        let terms = other.terms.into_iter();
        self.terms
            .extend(terms.map(|(held, place)| (weighted(held), place)));
        let rest = other.rest.into_iter();
        self.rest
            .extend(rest.map(|(held, part)| (weighted(held), part)));
    }
}

impl Graph {
    /// The sums that are read. The readers are rewritten in terms of them.
    pub(in crate::symbolic) fn gathered(
        &mut self,
        products: &[Product],
        readers: Readers<'_>,
    ) -> Vec<Sum> {
        let Readers {
            rates,
            results,
            symbols,
        } = readers;
        let factors = products.iter().flat_map(|product| product.factors);
        let roots: Vec<Id> = rates
            .iter()
            .copied()
            .chain(factors.map(|factor| factor.next))
            .collect();
        let found = self.weighted(products, &roots, symbols.clone());
        // terms added to a sum were gathered before it; consecutive rates are consecutive next
        // coefficients
        let mut found: Vec<(Id, Weighted)> = found.into_iter().collect();
        let place = |id: Id| rates.iter().position(|rate| *rate == id);
        found.sort_by_key(|(id, sum)| (sum.level, place(*id).unwrap_or(rates.len())));
        let mut sums = Vec::new();
        let mut written = HashMap::new();
        let mut values: HashSet<Id> = products.iter().map(|product| product.value).collect();
        for (id, Weighted { level, terms, rest }) in found {
            let first = products[terms[0].1];
            let is_bare = id == first.value;
            let value = is_bare.then_some(id);
            let value = value.unwrap_or_else(|| self.symbol(Stage::State));
            values.insert(value);
            let mut whole = value;
            let linear = self.added(rest, &mut whole, &written, &symbols, &values);
            written.insert(id, whole);
            let result = results.iter().find(|(_, next)| *next == id);
            let of = match (place(id), result) {
                _ if is_bare => Origin::Product(first.of),
                (_, Some((of, _))) => Origin::Result(*of),
                (Some(place), None) => Origin::Rate(place),
                (None, None) => Origin::Product(first.of),
            };
            let terms = terms.into_iter().map(|(weight, product)| Term {
                weight,
                factors: products[product].factors,
            });
            sums.push(Sum {
                of,
                level,
                value,
                terms: terms.collect(),
                linear,
            });
        }

        self.write_readers(rates, results, &mut sums, &roots, &written);
        if results.is_empty() && rates.len() <= LANES {
            self.all_rates(rates, sums, &symbols, &values)
        } else {
            sums
        }
    }

    /// The terms added to a sum. Those that are linear in coefficients are returned, the others are
    /// added to `whole`.
    fn added(
        &mut self,
        rest: Vec<(Id, Id)>,
        whole: &mut Id,
        written: &HashMap<Id, Id>,
        symbols: &[Id],
        values: &HashSet<Id>,
    ) -> Vec<(Id, Id)> {
        let mut linear = self.zero();
        for (weight, part) in rest {
            let part = self.rewritten(&[part], written)[0];
            let part = self.multiply(weight, part);
            if self.linear_in(part, symbols, values).is_some() {
                linear = self.add(linear, part);
            } else {
                *whole = self.add(part, *whole);
            }
        }
        self.linear_in(linear, symbols, values).unwrap_or_else(|| {
            *whole = self.add(linear, *whole);
            Vec::new()
        })
    }

    /// Rewrites all readers of convolutions in terms of the sums.
    fn write_readers(
        &mut self,
        rates: &mut [Id],
        results: &mut [(Id, Id)],
        sums: &mut [Sum],
        roots: &[Id],
        written: &HashMap<Id, Id>,
    ) {
        let nexts = results.iter().map(|(_, next)| *next);
        let roots: Vec<Id> = roots.iter().copied().chain(nexts).collect();
        let images = self.rewritten(&roots, written);
        let image: HashMap<Id, Id> = roots.into_iter().zip(images).collect();
        let nexts = results.iter_mut().map(|(_, next)| next);
        let terms = sums.iter_mut().flat_map(|sum| &mut sum.terms);
        let factors = terms.flat_map(|term| &mut term.factors);
        let factors = factors.map(|factor| &mut factor.next);
        for id in rates.iter_mut().chain(nexts).chain(factors) {
            *id = image[id];
        }
    }

    /// One sum for each coordinate, so that their rates are computed side by side. This is possible
    /// if there are products and everything that changes is a sum or linear in coefficients;
    /// otherwise the sums are returned unchanged.
    fn all_rates(
        &mut self,
        rates: &mut [Id],
        sums: Vec<Sum>,
        symbols: &[Id],
        values: &HashSet<Id>,
    ) -> Vec<Sum> {
        let mut all = Vec::new();
        for (place, rate) in rates.iter().enumerate() {
            if let Some(sum) = sums.iter().find(|sum| sum.value == *rate) {
                all.push(sum.clone());
            } else if let Some(linear) = self.linear_in(*rate, symbols, values) {
                all.push(Sum {
                    of: Origin::Rate(place),
                    level: 0,
                    value: self.symbol(Stage::State),
                    terms: Vec::new(),
                    linear,
                });
            }
        }
        let is_early = all.iter().all(|sum| sum.level == 0);
        let gathered = all.iter().filter(|sum| !sum.terms.is_empty()).count();
        if sums.is_empty() || !is_early || gathered != sums.len() || all.len() != rates.len() {
            return sums;
        }
        for (rate, sum) in rates.iter_mut().zip(&all) {
            *rate = sum.value;
        }
        all
    }

    /// An expression as a sum of symbols with constant weights, if it is one. The weights contain
    /// neither these symbols nor `values`, the symbols of sums.
    fn linear_in(&mut self, id: Id, symbols: &[Id], values: &HashSet<Id>) -> Option<Vec<(Id, Id)>> {
        let zero = self.zero();
        let found = self.nodes_of(&[id]);
        if found.iter().any(|id| values.contains(id)) {
            return None;
        }
        let read = symbols
            .iter()
            .copied()
            .filter(|symbol| found.contains(symbol));
        let mut terms = Vec::new();
        for symbol in read {
            let weight = self.derivative(&[id], symbol)[0];
            let of_weight = self.nodes_of(&[weight]);
            if symbols.iter().any(|symbol| of_weight.contains(symbol)) {
                return None;
            }
            terms.push((weight, symbol));
        }
        let rest = self.substitute(&[id], |id| symbols.contains(&id).then_some(zero))[0];
        self.is_zero(rest).then_some(terms)
    }

    /// `roots`, with the keys of `written` replaced by its values.
    fn rewritten(&mut self, roots: &[Id], written: &HashMap<Id, Id>) -> Vec<Id> {
        self.rebuild(roots, |graph, id, image| {
            let known = written.get(&id).copied();
            known.unwrap_or_else(|| graph.remake(id, image))
        })
    }

    /// The largest sums that are read, by the expressions that they compute.
    fn weighted(
        &mut self,
        products: &[Product],
        roots: &[Id],
        symbols: Vec<Id>,
    ) -> BTreeMap<Id, Weighted> {
        let places = products.iter().enumerate();
        let places: HashMap<Id, usize> = places
            .map(|(place, product)| (product.value, place))
            .collect();
        let coefficients = symbols.into_iter().map(|symbol| (symbol, 0));
        let values = products
            .iter()
            .map(|product| (product.value, product.level + 1));
        // the expressions that change from order to order, with the number of convolutions that
        // must precede them
        let mut levels: HashMap<Id, usize> = coefficients.chain(values).collect();
        let order = self.nodes_of(roots);
        let readers = self.readers(&order, roots);
        let one = self.one();
        let mut found: BTreeMap<Id, Weighted> = BTreeMap::new();
        for id in order {
            if let Some(place) = places.get(&id) {
                let sum = Weighted {
                    level: products[*place].level,
                    terms: vec![(one, *place)],
                    rest: Vec::new(),
                };
                found.insert(id, sum);
                continue;
            }
            let node = self.node(id).clone();
            let waits = node.operands().filter_map(|operand| levels.get(&operand));
            let Some(waits) = waits.max().copied() else {
                continue;
            };
            levels.entry(id).or_insert(waits);
            let Some(parts) = self.weighted_parts(&node, |part| !levels.contains_key(&part)) else {
                continue;
            };
            // the terms that most convolutions must precede are gathered, unless they are also read
            // elsewhere; the others are added
            let gathered = |part: &Id| found.contains_key(part) && readers.get(part) == Some(&1);
            let is_late = |part: &Id| levels.get(part) == Some(&waits);
            let mut late = parts.iter().filter(|(_, part)| is_late(part));
            if waits == 0 || !late.all(|(_, part)| gathered(part)) {
                continue;
            }
            let mut sum = Weighted {
                level: waits - 1,
                terms: Vec::new(),
                rest: Vec::new(),
            };
            for (weight, part) in parts {
                match is_late(&part).then(|| found.remove(&part)).flatten() {
                    Some(late) => sum.add(self, weight, late),
                    None => sum.rest.push((weight, part)),
                }
            }
            found.insert(id, sum);
        }
        found
    }

    /// The terms of a node, each with its constant weight; `None` if it is not linear.
    fn weighted_parts(
        &mut self,
        node: &Node,
        is_held: impl Fn(Id) -> bool,
    ) -> Option<Vec<(Id, Id)>> {
        let [one, minus_one] = [1, -1].map(|number| self.integer(number));
        match *node {
            Node::Negate(a) => Some(vec![(minus_one, a)]),
            Node::Multiply(a, b) if is_held(a) => Some(vec![(a, b)]),
            Node::Multiply(a, b) if is_held(b) => Some(vec![(b, a)]),
            Node::Add(a, b) => Some(vec![(one, a), (one, b)]),
            Node::Subtract(a, b) => Some(vec![(one, a), (minus_one, b)]),
            _ => None,
        }
    }

    /// How often each expression is read.
    fn readers(&self, order: &[Id], roots: &[Id]) -> HashMap<Id, usize> {
        let mut readers = HashMap::new();
        let operands = order.iter().flat_map(|id| self.node(*id).operands());
        for id in operands.chain(roots.iter().copied()) {
            *readers.entry(id).or_default() += 1;
        }
        readers
    }
}
