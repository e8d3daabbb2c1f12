//! Uniform fields on charges: `world(..)[V / m].on([q1.at(p1), q2.at(p2)])`, (34.7) to (34.9).
//!
//! The potential is `U = -E . (R sum e + p)` with `p = sum e r`. The force E sum e and the moment p
//! x E follow from it, each with its sum folded. A net charge of zero is no special case.

use crate::errors::{Extent, every};
use crate::lower::expressions::{Lowering, Value, dimension};
use crate::model::{Charges, Dimension, Vector};
use crate::symbolic::{Components, Graph, Id};
use crate::syntax::{Charge, Expression, Load};

/// Names of quantities that change with the state, on which a uniform field cannot depend.
const STATE: [&str; 8] = [
    "position",
    "velocity",
    "acceleration",
    "attitude",
    "angular_velocity",
    "angular_acceleration",
    "axis",
    "axis_rate",
];

impl Lowering<'_> {
    /// The energy of the charges in the field, and the sums over the charges.
    pub fn uniform_field(&mut self, written: &Load) -> Option<(Id, Charges)> {
        let name = written.name.to_string();
        let field = written
            .vector
            .as_ref()
            .and_then(|field| self.field_strength(field));
        let charges = written.charges.iter().flatten();
        let of_field = field.map(|(_, dimension)| dimension);
        let charges = every(charges.map(|charge| self.charge(charge, of_field)));
        let ((field, _), charges) = (field?, charges?);
        let graph = &mut self.work.graph;
        let net: Vec<Id> = charges.iter().map(|(charge, _)| *charge).collect();
        let net = graph.sum(&net);
        let dipole = moment(graph, &charges);
        // if the motion of G is not modeled, positions are relative to G; if a point of the body
        // is held, they are relative to that point
        let position = self.state.position;
        let body = self.work.part(position, self.state.body);
        let own = self.work.vector(self.state.body, body);
        let back = self.work.negate(own);
        let elsewhere = self.work.add(position, back);
        let graph = &mut self.work.graph;
        let from_held = charges
            .iter()
            .map(|(charge, offset)| (*charge, graph.add_vectors(body, *offset)));
        let from_held: Vec<(Id, Components)> = from_held.collect();
        let turned = moment(graph, &from_held);
        self.work.labels.name(net, format!("{name}_charge"));
        self.work.labels.vector(&format!("{name}_dipole"), turned);
        let moved = self.work.scale(net, elsewhere);
        let turned = self.work.fixed_in(self.state.body, turned);
        let whole = self.work.add(moved, turned);
        let work = self.work.dot(field, whole);
        let energy = self.work.graph.negate(work);
        let count = charges.len();
        Some((energy, Charges { count, net, dipole }))
    }

    /// The uniform vector of a field, and its dimension.
    fn field_strength(&mut self, written: &Expression) -> Option<(Vector, Dimension)> {
        let value = self.value(written)?;
        let (Some(vector), Some(dimension)) = (self.as_vector(value), dimension(value)) else {
            return self.report(
                written.extent,
                format!("a field is a vector, and this is {}", value.kind()),
            );
        };
        let Some(vector) = self.work.in_parallel_axes(vector) else {
            return self.report(
                written.extent,
                "a uniform field does not turn with the body: write it in world axes",
            );
        };
        self.check_same_everywhere(written, &self.work.entries(&[vector]), "a uniform field")?;
        Some((vector, dimension))
    }

    /// A charge and its offset from G.
    fn charge(
        &mut self,
        written: &Charge,
        of_field: Option<Dimension>,
    ) -> Option<(Id, Components)> {
        let offset = written
            .point
            .as_ref()
            .and_then(|point| self.charged_point(point));
        let charge = written.charge.as_ref().and_then(|charge| {
            let Value::Scalar(id, found) = self.value(charge)? else {
                return self.report(charge.extent, "a charge is a scalar");
            };
            let expected = Dimension::FORCE.over(of_field?)?;
            if !found.fits(expected) {
                let place: Extent = self.culprit(charge, expected);
                let (found, expected) = (found.described(), expected.described());
                return self.report(
                    place,
                    format!(
                        "times this field, a charge {expected} makes a force, and this is {found}"
                    ),
                );
            }
            self.check_same_everywhere(charge, &[id], "a charge")?;
            Some(id)
        });
        Some((charge?, offset?))
    }

    fn charged_point(&mut self, written: &Expression) -> Option<Components> {
        self.body_point(written, |place| {
            format!("the charges of a body are on points of it, and this one is {place}")
        })
    }

    /// Reports a field that depends on the state. It may depend on time, parameters and inputs.
    fn check_same_everywhere(
        &mut self,
        written: &Expression,
        components: &[Id],
        what: &str,
    ) -> Option<()> {
        let state = self.state_symbols();
        if !self.depends(components, &state) {
            return Some(());
        }
        let place = self.dependent_name(written, &state, &STATE);
        self.report(
            place,
            format!(
                "{what} cannot depend on the state: write a force or a potential \
                 instead"
            ),
        )
    }

    /// The symbols of the state, including those of rotated vectors.
    fn state_symbols(&self) -> Vec<Id> {
        let state = &self.state;
        let mut roots = self.work.entries(&[state.position, state.velocity]);
        roots.extend(state.angular_velocity);
        roots.extend(self.work.attitude(self.state.body).coordinates());
        let graph = &self.work.graph;
        let accelerations = self.work.meanings.accelerations();
        roots.extend(accelerations.map(|symbol| graph.symbol_id(symbol)));
        let turns = self.work.turns.iter().flat_map(|turns| &turns.list);
        roots.extend(turns.flat_map(|turn| turn.turned));
        self.late_symbols(&roots)
    }
}

/// `sum e r`
fn moment(graph: &mut Graph, charges: &[(Id, Components)]) -> Components {
    [0, 1, 2].map(|axis| {
        let terms: Vec<Id> = charges
            .iter()
            .map(|(charge, offset)| graph.multiply(*charge, offset[axis]))
            .collect();
        graph.sum(&terms)
    })
}
