//! Euler's equations `J w' = M - w x J w`, solved for `w'` in the form that takes the fewest
//! operations. All forms are exact. A tensor of numbers has forms that a tensor of parameters does
//! not have.

use crate::model::{AXES, Labels, Model, Workspace};
use crate::symbolic::{Components, Graph, Number, PrincipalAxes, Spectrum, scaled};

use super::dyadic::Dyadic;

/// The ways to write `w'`.
#[derive(Clone, Copy, Debug)]
pub enum EulerForm {
    /// The axes of the body are principal.
    Principal,
    /// With the full tensor, minus a multiple of the unit matrix.
    Gauged,
    /// With an axis of symmetry.
    Symmetric,
    /// Rotated into the principal axes.
    TurnedToPrincipal,
}

/// `w'` in one of these forms, and the names of its parts.
struct Written {
    form: EulerForm,
    angular: Components,
    labels: Labels,
}

/// What the equations contain: the angular velocity and the moment in body axes, and the tensor by
/// rows.
struct Balance<'a> {
    graph: &'a mut Graph,
    w: Components,
    rows: &'a [Components; 3],
    moment: Components,
}

/// `w' = J^-1 (M - w x J w)`. Of forms with equal cost, the first is chosen.
pub fn solve_euler(
    model: &Model,
    work: &mut Workspace,
    rows: &[Components; 3],
    moment: Components,
) -> (Components, EulerForm) {
    let mut balance = Balance {
        w: model.state.angular_velocity,
        graph: &mut work.graph,
        rows,
        moment,
    };
    let written =
        if is_diagonal(balance.graph, rows) {
            balance.in_user_axes()
        } else {
            let first = balance.gauged(2);
            let is_fixed = balance.graph.are_early(rows.as_flattened());
            let further = [
                Some(balance.gauged(1)),
                Some(balance.gauged(0)),
                is_fixed.then(|| balance.about_symmetry()).flatten(),
                // if the axes are irrational, not every difference that vanishes is proved to be
                // zero
                if model.is_differentiated || !is_fixed {
                    None
                } else {
                    balance.in_principal_axes()
                },
            ];
            let cost = |one: &Written| balance.graph.late_cost(&one.angular).total();
            further.into_iter().flatten().fold(first, |best, one| {
                if cost(&one) < cost(&best) { one } else { best }
            })
        };
    work.labels.adopt(written.labels);
    (written.angular, written.form)
}

pub fn is_diagonal(graph: &Graph, rows: &[Components; 3]) -> bool {
    [(0, 1), (1, 2), (2, 0)]
        .iter()
        .all(|(i, j)| graph.is_zero(rows[*i][*j]))
}

impl Balance<'_> {
    /// The body axes are principal: `w_1' = M_1 / J_1 + (J_2 - J_3) / J_1 w_2 w_3`, and so on.
    ///
    /// If two moments of inertia are equal, both products contain the rate at which the angular
    /// velocity precesses in the body, which is then computed once.
    fn in_user_axes(&mut self) -> Written {
        let mut labels = Labels::default();
        let (graph, w, moment) = (&mut *self.graph, self.w, self.moment);
        let inertia = [0, 1, 2].map(|i| self.rows[i][i]);
        let inverse = inertia.map(|moment| graph.inverse_of_positive(moment));
        labels.vector("inverse_inertia", inverse);
        labels.describe(
            "precession",
            "rate at which w turns in the body: (J_1 - J_3) / J_1 w_3",
        );
        // (J_j - J_k) / J_i
        let mut coupling = |graph: &mut Graph, i: usize, j: usize, k: usize| {
            let difference = graph.difference(inertia[j], inertia[k]);
            let coupling = graph.multiply(difference, inverse[i]);
            labels.name(coupling, format!("coupling_{}", AXES[i]));
            coupling
        };
        let axis = [0, 1, 2]
            .into_iter()
            .find(|k| inertia[(k + 1) % 3] == inertia[(k + 2) % 3]);
        let precession = axis.map(|k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            let coupling = coupling(graph, i, j, k);
            let rate = graph.multiply(coupling, w[k]);
            (i, j, graph.quantity(rate))
        });
        let angular = [0, 1, 2].map(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let gyroscopic = match precession {
                Some((first, second, rate)) if i == first => graph.multiply(rate, w[second]),
                Some((first, second, rate)) if i == second => {
                    let product = graph.multiply(rate, w[first]);
                    graph.negate(product)
                }
                Some(_) => graph.zero(),
                None => {
                    let coupling = coupling(graph, i, j, k);
                    let product = graph.multiply(w[j], w[k]);
                    graph.multiply(coupling, product)
                }
            };
            let driven = graph.distribute(inverse[i], moment[i]);
            graph.add(driven, gyroscopic)
        });
        if let Some((_, _, rate)) = precession {
            labels.name(rate, "precession");
        }
        Written {
            form: EulerForm::Principal,
            angular,
            labels,
        }
    }

    /// The full tensor. A multiple of the unit matrix does not change `w x J w`, so it is
    /// subtracted first. This is accurate for nearly spherical bodies (H7), and cheaper.
    fn gauged(&mut self, axis: usize) -> Written {
        let mut labels = Labels::default();
        let graph = &mut *self.graph;
        let mut deviator = *self.rows;
        for (i, row) in deviator.iter_mut().enumerate() {
            row[i] = graph.difference(row[i], self.rows[axis][axis]);
        }
        let relative = graph.transform(&deviator, self.w);
        let relative = graph.quantities(relative);
        let gyroscopic = graph.cross(self.w, relative);
        let torque = graph.subtract_vectors(self.moment, gyroscopic);
        let torque = graph.results(torque);
        labels.matrix("deviator", &deviator);
        labels.describe("relative_momentum", "(J - lambda 1) w, body axes");
        labels.vector("relative_momentum", relative);
        labels.describe("net_moment", "M - w x J w about G, body axes");
        labels.vector("net_moment", torque);
        let inverse = inverse_inertia(graph, &mut labels, self.rows);
        let angular = graph.transform(&inverse, torque);
        Written {
            form: EulerForm::Gauged,
            angular,
            labels,
        }
    }

    /// An axis of symmetry n, with the moment B about it and A across it:
    /// `w' = J^-1 M + (A - B) / A (n.w) w x n`. Whatever B is, the gyroscopic moment has no part
    /// along n.
    fn about_symmetry(&mut self) -> Option<Written> {
        let mut labels = Labels::default();
        let graph = &mut *self.graph;
        let inertia = Dyadic::of(graph, self.rows)?;
        let coupling = graph.divide(inertia.excess, inertia.isotropic);
        let coupling = graph.negate(coupling);
        let spin = graph.dot(inertia.axis, self.w);
        let rate = graph.distribute(coupling, spin);
        let rate = graph.quantity(rate);
        let across = graph.cross(self.w, inertia.axis);
        let gyroscopic = graph.scale_vector(rate, across);
        let driven = if graph.is_zero_vector(&self.moment) {
            self.moment
        } else {
            let inverse = Dyadic::of_inverse(graph, self.rows)?;
            inverse.transform(graph, self.moment)
        };
        let angular = graph.add_vectors(driven, gyroscopic);
        labels.describe(
            "precession",
            "rate at which w turns about n in the body: (A - B) / A n.w, over the length of n",
        );
        labels.name(rate, "precession");
        Some(Written {
            form: EulerForm::Symmetric,
            angular,
            labels,
        })
    }

    /// Three principal axes n: Euler's equations along these axes, and back. Each n is written as
    /// its largest component times a vector r, in which that component is one. The largest
    /// component is folded into the coefficients.
    fn in_principal_axes(&mut self) -> Option<Written> {
        let mut labels = Labels::default();
        let graph = &mut *self.graph;
        let Spectrum::General(principal) = graph.spectrum(self.rows)? else {
            return None;
        };
        let PrincipalAxes { moments, axes } = *principal;
        let scaled = axes.map(|axis| scaled(&axis));
        let sizes = scaled.clone().map(|(_, size)| size);
        let axes = scaled.map(|(axis, _)| axis.map(|component| graph.number(component)));
        let rates = axes.map(|axis| graph.dot(axis, self.w));
        let rates = graph.quantities(rates);
        let coefficient = |graph: &mut Graph, value: Number, i: usize| {
            let value = value.checked_div(&moments[i])?;
            Some(graph.number(value))
        };
        let mut along = [graph.zero(); 3];
        for i in 0..3 {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let volume = sizes
                .iter()
                .fold(Number::one(), |all, size| all * size.clone());
            let difference = moments[j].clone() - moments[k].clone();
            let coupling = coefficient(graph, volume * difference, i)?;
            let response = coefficient(graph, sizes[i].clone() * sizes[i].clone(), i)?;
            let product = graph.multiply(rates[j], rates[k]);
            let gyroscopic = graph.multiply(coupling, product);
            let moment = graph.dot(axes[i], self.moment);
            let driven = graph.distribute(response, moment);
            along[i] = graph.add(driven, gyroscopic);
        }
        let along = graph.quantities(along);
        let parts = [0, 1, 2].map(|i| graph.scale_vector(along[i], axes[i]));
        let angular = [0, 1, 2].map(|i| graph.sum(&parts.map(|part| part[i])));
        labels.describe("principal_rate", "r.w, r along a principal axis");
        labels.vector("principal_rate", rates);
        labels.describe(
            "principal_acceleration",
            "w' along the principal axes: w' is the sum of these times r",
        );
        labels.vector("principal_acceleration", along);
        Some(Written {
            form: EulerForm::TurnedToPrincipal,
            angular,
            labels,
        })
    }
}

/// `J^-1`, computed from `J` divided by its trace, so that no determinant leaves the range of
/// doubles (H10).
pub fn inverse_inertia(
    graph: &mut Graph,
    labels: &mut Labels,
    rows: &[Components; 3],
) -> [Components; 3] {
    let trace = graph.sum(&[rows[0][0], rows[1][1], rows[2][2]]);
    let one = graph.one();
    let scale = graph.divide(one, trace);
    let scale = graph.quantity(scale);
    let relative = rows
        .map(|row| graph.scale_vector(scale, row))
        .map(|row| graph.quantities(row));
    let cofactors = graph.cofactors(&relative);
    let determinant = graph.dot(relative[0], cofactors[0]);
    let reciprocal = graph.inverse_of_positive(determinant);
    let inverse = cofactors
        .map(|row| graph.scale_vector(reciprocal, row))
        .map(|row| graph.scale_vector(scale, row));
    labels.name(scale, "inverse_trace");
    labels.describe("relative_inertia", "J over its trace");
    labels.matrix("relative_inertia", &relative);
    labels.name(determinant, "determinant");
    labels.matrix("inverse_inertia", &inverse);
    inverse
}
