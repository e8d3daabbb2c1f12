//! User-defined states, Rust constants and functions, tables, and changing mass.

use super::body::Inertia;
use super::draw::Draw;
use super::expression::{Course, Grid, Scalar};
use super::literal::Literal;

impl Draw {
    /// One body out of three has them.
    pub fn own_states(&mut self, index: usize) {
        self.body.is_rich = index % 3 == 2;
        if self.body.is_rich {
            let count = self.random.usize(..=2);
            self.body.rates = vec![Scalar::zero(); count];
        }
    }

    /// What the states change by, which may follow all else.
    pub fn own_rates(&mut self) {
        for i in 0..self.body.rates.len() {
            self.body.rates[i] = self.scalar(2);
        }
    }

    pub fn rich_leaf(&mut self) -> Scalar {
        let count = self.body.rates.len();
        if count > 0 && self.chance(0.7) {
            return Scalar::State(self.random.usize(..count));
        }
        Scalar::Constant
    }

    /// What a table or a function of Rust makes of a scalar.
    pub fn rich(&mut self, inner: Scalar) -> Scalar {
        if self.random.bool() {
            return Scalar::Called(Box::new(inner));
        }
        let course = Course {
            is_cubic: self.random.bool(),
            is_extrapolated: self.random.bool(),
        };
        if self.chance(0.6) {
            let places = self.places(6).into_iter();
            let rows = places.map(|place| [place, self.between(-4000, 4000)]);
            return Scalar::Table(Box::new(inner), rows.collect(), course);
        }
        let places = [(); 2].map(|()| self.places(4));
        let [rows, columns] = places.each_ref().map(Vec::len);
        let row = |draw: &mut Self| (0..columns).map(|_| draw.between(-4000, 4000)).collect();
        let values = (0..rows).map(|_| row(self)).collect();
        let other = self.scalar(1);
        let grid = Grid { places, values };
        Scalar::Grid(Box::new([inner, other]), Box::new(grid), course)
    }

    /// Places of a table, one behind the other.
    fn places(&mut self, most: i64) -> Vec<Literal> {
        let mut place = self.random.i64(-3000..=0);
        let places = (0..self.random.i64(2..=most)).map(|_| {
            place += self.random.i64(1..=2000);
            Literal::new(place, -3)
        });
        places.collect()
    }

    /// Mass and inertia follow a state, as of a body that is uniformly denser.
    pub fn changing(&mut self) {
        if self.body.rates.is_empty() || self.random.bool() {
            return;
        }
        let state = Scalar::State(self.random.usize(..self.body.rates.len()));
        self.body.changes = true;
        let factor = Scalar::literal(1, 0) + Scalar::Power(Box::new(state), 2);
        if let Some(mass) = &mut self.body.mass {
            denser(&factor, mass);
        }
        if let Some(inertia) = &mut self.body.inertia {
            of_denser(&factor, inertia);
        }
    }
}

fn denser(factor: &Scalar, scalar: &mut Scalar) {
    *scalar = scalar.clone() * factor.clone();
}

/// Solids follow the mass by themselves.
fn of_denser(factor: &Scalar, inertia: &mut Inertia) {
    let parts: &mut [Scalar] = match inertia {
        Inertia::Scalar(scalar) => std::slice::from_mut(scalar),
        Inertia::Principal(moments) => moments,
        Inertia::Tensor(parts) | Inertia::Products(parts) => parts,
        Inertia::Along(inner, _) | Inertia::Turned(inner, ..) | Inertia::About(inner, _) => {
            return of_denser(factor, inner);
        }
        Inertia::Solid(..) | Inertia::Compose(_) => return,
    };
    for part in parts {
        denser(factor, part);
    }
}
