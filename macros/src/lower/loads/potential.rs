//! Potentials: scalars U from which forces and moments are derived.
//!
//! They are read with rotated vectors kept apart ([`crate::model::kinematics::turned_vector`]), and
//! so are the locals in them. If a potential takes the length of a vector with parts in body axes
//! and in world axes, either part can be rotated. Then there are two forms, and mechanics takes the
//! cheaper one.

use crate::errors::every;
use crate::lower::definitions::{Definition, definition_order};
use crate::lower::expressions::{Lowering, is_drive, is_unknown};
use crate::model::{Charges, Dimension, Displaced, Form, Frame, Potential, Potentials, Turns};
use crate::symbolic::{Components, Id};
use crate::syntax::{Description, Expression, Load};

/// Words for rates, on which potentials cannot depend.
const RATES: [&str; 5] = [
    "velocity",
    "angular_velocity",
    "angular_velocity_1",
    "angular_velocity_2",
    "axis_rate",
];

impl Lowering<'_> {
    /// Reads all potentials, and the uniform fields on charges.
    pub fn potentials(&mut self, description: &Description) -> Option<Potentials> {
        let loads = description.loads.iter();
        let known: Vec<&Load> = loads
            .filter(|load| !is_unknown(load) && !is_drive(load))
            .collect();
        let on_charges = known
            .iter()
            .enumerate()
            .filter(|(_, load)| load.charges.is_some())
            .map(|(place, load)| (place, &load.name));
        let scalars = description.potentials.iter().enumerate();
        let scalars = scalars.map(|(index, scalar)| (known.len() + index, &scalar.name));
        let mut list: Vec<Potential> = on_charges
            .chain(scalars)
            .map(|(place, name)| Potential {
                name: name.clone(),
                place,
                charges: None,
            })
            .collect();
        let mut forms = Vec::new();
        if !list.is_empty() {
            let (form, has_choice) = self.potential_form(description, self.state.body)?;
            for (potential, charges) in list.iter_mut().zip(&form.charges) {
                potential.charges = Some(*charges);
            }
            forms.push(form);
            if has_choice {
                forms.push(self.potential_form(description, Frame::WORLD)?.0);
            }
        }
        Some(Potentials { list, forms })
    }

    /// The energies in one form, and whether there is another form.
    fn potential_form(&mut self, description: &Description, mixed: Frame) -> Option<(Form, bool)> {
        let (values, position) = (self.scope.values(), self.state.position);
        let zero = self.work.graph.zero();
        self.work.turns = Some(Turns::new(self.motion.axes(), mixed));
        let displacement = self.displacement();
        let is_added = !self.motion.translates();
        self.locals_apart(description);
        let on_charges = description
            .loads
            .iter()
            .filter(|load| load.charges.is_some());
        let fields = every(on_charges.map(|load| self.uniform_field(load)));
        let rates = self.rates();
        let scalars = self.energies(description, &rates);
        self.scope.restore(values);
        self.state.position = position;
        let turns = self.work.turns.take()?;
        let (mut energies, charges): (Vec<Id>, Vec<Charges>) = fields?.into_iter().unzip();
        energies.extend(scalars?);
        let form = Form {
            values: energies,
            charges,
            turns: turns.list,
            bodies: vec![Displaced {
                body: self.state.body,
                displacement,
                velocity: [zero; 3],
                angular_velocity: [zero; 3],
                angle: None,
                has_own_attitude: true,
            }],
            along: Vec::new(),
            stands_for: displacement
                .into_iter()
                .filter(|_| is_added)
                .map(|symbol| (symbol, zero))
                .collect(),
        };
        Some((form, turns.met_mixed))
    }

    /// The position of G, if it is a coordinate; otherwise a virtual displacement that is added to
    /// it.
    fn displacement(&mut self) -> Components {
        if self.motion.translates() {
            return self.work.part(self.state.position, Frame::WORLD);
        }
        let displacement = self.work.free_symbols(0..self.motion.axes());
        let displaced = self.work.vector(Frame::WORLD, displacement);
        self.state.position = self.work.add(self.state.position, displaced);
        displacement
    }

    /// Reads the locals again, with rotated vectors kept apart.
    pub fn locals_apart(&mut self, description: &Description) {
        let (order, _) = definition_order(description);
        for definition in order {
            let (Definition::Local(_), (name, Some(written))) =
                (definition, definition.of(description))
            else {
                continue;
            };
            if self.scope.peek(&name).is_some() {
                let value = self.value(written).map(|value| self.named(value, &name));
                self.scope.redefine(&name, value);
            }
        }
    }

    /// All potentials of a description, as functions of the symbols that stand for the parts kept
    /// apart.
    pub fn energies(&mut self, description: &Description, rates: &[Id]) -> Option<Vec<Id>> {
        let written = description.potentials.iter();
        every(written.map(|potential| self.potential(potential.value.as_ref(), rates)))
    }

    /// A potential. It may depend on the place and the attitude of the body, on time, parameters
    /// and inputs, but on none of these `rates`.
    fn potential(&mut self, written: Option<&Expression>, rates: &[Id]) -> Option<Id> {
        let written = written?;
        let energy = self.scalar(written, Dimension::MOMENT, "a potential")?;
        self.check_no_acceleration(written, &[energy], "a potential")?;
        if !self.depends(&[energy], rates) {
            return Some(energy);
        }
        let place = self.dependent_name(written, rates, &RATES);
        self.report(
            place,
            "a potential depends on where the body is, and not on how it moves: what does is a \
             force or a moment",
        )
    }

    /// The symbols of velocity and angular velocity; for a rod, of the rate of its axis.
    fn rates(&self) -> Vec<Id> {
        let mut all = self.work.entries(&[self.state.velocity]);
        all.extend(self.state.turn_rate());
        self.late_symbols(&all)
    }
}
