//! Constants of the equations that do not fit in a double.

use crate::model::{
    Defaults, Outline, Substance, Violation, Workspace, is_possible, matrix, why_not,
};
use crate::symbolic::{Graph, Id, Node, Number, Stage};

use super::errors::Errors;

/// A body or a system whose constants get values from the defaults of parameters.
pub struct Constants<'a> {
    pub outline: &'a Outline,
    pub bodies: &'a [Substance],
    pub defaults: &'a Defaults,
}

impl Constants<'_> {
    /// Reports constants of the equations that do not fit in a double.
    pub fn check(&self, work: &mut Workspace, roots: &[Id], errors: &mut Errors) {
        let (outline, defaults) = (self.outline, self.defaults);
        let graph = &mut work.graph;
        let early: Vec<Id> = graph
            .reachable(roots, &|id| !graph.is_early(id))
            .into_iter()
            .filter(|id| graph.is_early(*id))
            .collect();
        let values = graph.substitute(&early, |id| defaults.get(&id).copied());
        let has_no_value = values.iter().any(|id| graph.is_undefined(*id));
        if has_no_value && report_without_value(defaults, work, errors) {
            return;
        }
        let graph = &work.graph;
        let parts = graph.nodes_of(&early);
        if parts.into_iter().any(|id| is_undecided(graph, id)) {
            errors.push(
            outline.name.span(),
            format!(
                "a constant in the equations of `{}` is zero to thousands of bits, and not proved to be \
                 zero: write it as a number, or leave it out",
                outline.name
            ),
        );
            return;
        }
        // an undecided value comes from the defaults alone, and is no error: doubles round it to zero
        let out_of_range = |id: &Id| {
            let number = graph.as_number(*id).filter(|number| !number.is_undecided());
            graph.is_undefined(*id) || number.is_some_and(|number| !number.fits_f64())
        };
        if values.iter().any(out_of_range) || outline.has_default() && self.overflows(work, &early)
        {
            if self.report_division(&early, work, errors) {
                return;
            }
            let with = if outline.params.is_empty() {
                ""
            } else {
                " with the defaults of its parameters"
            };
            errors.push(
            outline.name.span(),
            format!(
                "a constant in the equations of `{}` is out of the range of `f64`{with}: choose \
                 units nearer to one",
                outline.name
            ),
        );
            return;
        }
        for body in self.bodies {
            self.check_rounded(body, work, errors);
        }
    }

    /// Reports the first division by zero on the way to the `early` values, if there is one.
    fn report_division(&self, early: &[Id], work: &mut Workspace, errors: &mut Errors) -> bool {
        let (outline, defaults) = (self.outline, self.defaults);
        let graph = &mut work.graph;
        let all = graph.nodes_of(early);
        let values = graph.substitute(&all, |id| defaults.get(&id).copied());
        let graph = &work.graph;
        let value = |id: Id| all.binary_search(&id).ok().map(|place| values[place]);
        let is_zero = |id: Id| {
            value(id).is_some_and(|value| graph.is_zero(value) || is_undecided(graph, value))
        };
        let has_no_value = |id: Id| value(id).is_some_and(|value| graph.is_undefined(value));
        let lost = early.iter().copied().filter(|id| has_no_value(*id));
        let way = graph.reachable(&lost.collect::<Vec<_>>(), &has_no_value);
        let mut divisors = way.into_iter().filter_map(|id| match *graph.node(id) {
            Node::Undefined => Some(None),
            Node::Divide(_, divisor) | Node::Pivot(divisor, _) if is_zero(divisor) => {
                Some(Some(divisor))
            }
            _ => None,
        });
        let Some(divisor) = divisors.next() else {
            return false;
        };
        let params = outline.sources(work, divisor.as_slice());
        let name = &outline.name;
        let message = match params.as_slice() {
            [] => format!(
                "something in the equations of `{name}` is divided by zero, as where loads \
                 cancel an inertia or a length vanishes"
            ),
            [param] => format!(
                "something in the equations of `{name}` is divided by zero with the default of `{param}`: \
                 change it"
            ),
            several => format!(
                "something in the equations of `{name}` is divided by zero with the defaults of `{}`: \
                 change one of them",
                several.join("`, `")
            ),
        };
        errors.push(name.span(), message);
        true
    }

    /// Reports an inertia that is possible as written, but that the constructor would reject with
    /// the defaults of all parameters, because it computes in doubles, or because nothing of it is
    /// left about what holds the body.
    fn check_rounded(&self, body: &Substance, work: &mut Workspace, errors: &mut Errors) {
        let (outline, entries) = (self.outline, body.inertia_entries());
        let graph = &work.graph;
        let is_open = entries
            .iter()
            .any(|id| graph.stage(*id) == Stage::Parameter);
        if !is_open || !graph.are_early(&entries) || !outline.has_default() {
            return;
        }
        if is_possible(&self.rounded(work, &entries), body.swings) {
            return;
        }
        let name = &outline.name;
        let message = if self.vanishes(body, work) {
            let own = body.name.clone().unwrap_or_else(|| name.to_string());
            format!(
                "with the defaults of the parameters `{own}` has no inertia about what holds it: hold it \
                 beside its G, or give it an inertia"
            )
        } else {
            format!(
                "with the defaults of its parameters the inertia of `{name}` about G is lost in rounding: \
                 write it about a point nearer to G"
            )
        };
        errors.push(name.span(), message);
    }

    /// Whether an inertia that is impossible in doubles is so exactly: that of a point mass or a rod
    /// about the point or the axis that holds it.
    fn vanishes(&self, body: &Substance, work: &mut Workspace) -> bool {
        let (graph, entries) = (&mut work.graph, body.inertia.entries());
        let known = graph.substitute(&entries, |id| self.defaults.get(&id).copied());
        let numbers = known.iter().map(|id| graph.as_number(*id).cloned());
        let numbers: Option<Vec<Number>> = numbers.collect();
        match numbers.as_deref() {
            Some([moment]) => !moment.is_positive(),
            Some(rows @ [_, _, _, _, _, _, _, _, _]) => {
                Violation::impossible(&matrix(rows)).is_some()
            }
            _ => false,
        }
    }

    /// Whether the constructor, with the defaults of all parameters, leaves the range of doubles on
    /// its way to one of the `early` values, or to mass and inertia: it computes in doubles, step
    /// by step.
    fn overflows(&self, work: &Workspace, early: &[Id]) -> bool {
        let graph = &work.graph;
        let wanted = early
            .iter()
            .copied()
            .chain(self.bodies.iter().flat_map(Substance::inertia_entries));
        let mass = self.bodies.iter().filter_map(|body| body.mass);
        let wanted: Vec<Id> = wanted
            .chain(mass)
            .filter(|id| graph.is_early(*id))
            .collect();
        let values = self.rounded(work, &wanted);
        values.iter().any(|value| !value.is_finite())
    }

    /// Early values, computed in doubles step by step; NaN if a default is missing.
    fn rounded(&self, work: &Workspace, early: &[Id]) -> Vec<f64> {
        let graph = &work.graph;
        let default = |symbol: Id| graph.as_number(*self.defaults.get(&symbol)?);
        graph.evaluate(early, |symbol| {
            default(symbol).map_or(f64::NAN, Number::to_f64)
        })
    }
}

/// Whether a number cannot be distinguished from zero, and is not proved to be zero.
fn is_undecided(graph: &Graph, id: Id) -> bool {
    graph.as_number(id).is_some_and(Number::is_undecided)
}

/// Reports the first part of the description that has no value with the defaults of parameters.
fn report_without_value(defaults: &Defaults, work: &mut Workspace, errors: &mut Errors) -> bool {
    let graph = &mut work.graph;
    for doubtful in &work.doubtful {
        let all: Vec<Id> = doubtful
            .operands
            .iter()
            .copied()
            .chain([doubtful.value])
            .collect();
        let mut values = graph.substitute(&all, |id| defaults.get(&id).copied());
        let has_value = values.pop().is_some_and(|value| !graph.is_undefined(value));
        let numbers = values.iter().map(|id| graph.as_number(*id).cloned());
        if has_value {
            continue;
        }
        if let Some(numbers) = numbers.collect::<Option<Vec<_>>>() {
            let why = why_not(&doubtful.word, &numbers);
            errors.push(
                doubtful.place,
                format!("with the defaults of the parameters, {why}"),
            );
            return true;
        }
    }
    false
}
