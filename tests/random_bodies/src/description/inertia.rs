//! Random masses and inertias of bodies that can exist, with room for what their parameters may do.

use super::body::{Inertia, Motion, Part, Point, Solid};
use super::draw::{Draw, whole};
use super::expression::{Axes, Place, Scalar};
use super::literal::MASSES;

impl Draw {
    pub fn mass_and_inertia(&mut self) {
        let turns = self.body.motion.turns();
        // a composed body needs parts of a mass and a size that fit each other: those of its own
        if turns && self.chance(0.2) {
            self.body.inertia = Some(self.composed());
            return;
        }
        self.body.mass = Some(self.mass());
        if turns {
            self.body.inertia = Some(match self.body.motion {
                Motion::Rod(_) => self.of_rod(),
                _ if self.body.motion.is_planar() => self.in_plane(),
                _ => self.in_space(),
            });
        }
        if self.body.is_rich {
            self.changing();
        }
    }

    /// With a parameter, that is changed by a twentieth at most, or without.
    fn positive_scalar(&mut self, order: i32) -> Scalar {
        let number = Scalar::Literal(self.positive(order));
        if self.chance(0.2)
            && let Some(param) = self.scalar_param()
        {
            return number * Scalar::Power(Box::new(param), 2);
        }
        number
    }

    fn mass(&mut self) -> Scalar {
        let order = self.strength - self.random.i32(0..=1);
        if self.chance(0.2) {
            let unit = self.pick(&MASSES);
            return Scalar::Literal(self.positive(order).unit(unit));
        }
        self.positive_scalar(order)
    }

    fn order_of_inertia(&mut self) -> i32 {
        self.strength + 2 * self.length - self.random.i32(0..=2)
    }

    fn in_plane(&mut self) -> Inertia {
        if self.random.u32(..4) == 0 {
            let (solid, lengths) = self.solid();
            return Inertia::Solid(solid, lengths);
        }
        let order = self.order_of_inertia();
        Inertia::Scalar(self.positive_scalar(order))
    }

    fn of_rod(&mut self) -> Inertia {
        if self.chance(0.4) {
            return Inertia::Solid(Solid::Rod, vec![Scalar::Literal(self.length())]);
        }
        let order = self.order_of_inertia();
        Inertia::Scalar(self.positive_scalar(order))
    }

    fn in_space(&mut self) -> Inertia {
        match self.random.u32(..10) {
            0..3 => self.principal(),
            3..6 => self.tensor(),
            6..9 => self.turned_solid(),
            _ => self.about_point(),
        }
    }

    /// Three moments, some of them equal, none near the sum of the others.
    fn principal(&mut self) -> Inertia {
        let order = self.order_of_inertia();
        let one = self.positive_scalar(order);
        let mut moments = match self.random.u32(..4) {
            0 => [one.clone(), one.clone(), one],
            1 => {
                let factor = Scalar::Literal(self.between(600, 1800));
                [one.clone(), one.clone(), factor * one]
            }
            _ => {
                let [a, b] = [(); 2].map(|()| Scalar::Literal(self.between(800, 1400)));
                [one.clone(), a * one.clone(), b * one]
            }
        };
        self.random.shuffle(&mut moments);
        Inertia::Principal(moments)
    }

    /// Of moments that are far from impossible, with products that cannot spoil that.
    fn tensor(&mut self) -> Inertia {
        let order = self.order_of_inertia();
        let scale = self.positive_scalar(order);
        let moments = [(); 3].map(|()| Scalar::Literal(self.between(850, 1250)));
        let some = self.random.u32(..4);
        let mut product = |i: u32| {
            let product = self.between(-90, 90);
            if some == 0 || some - 1 == i {
                Scalar::Literal(product)
            } else {
                Scalar::zero()
            }
        };
        let products = [product(0), product(1), product(2)];
        let [xx, yy, zz] = moments;
        let [xy, yz, zx] = products;
        let entries = [xx, yy, zz, xy, yz, zx].map(|entry| {
            if entry.is_zero() {
                entry
            } else {
                entry * scale.clone()
            }
        });
        if self.random.bool() {
            Inertia::Tensor(entries)
        } else {
            Inertia::Products(entries)
        }
    }

    fn turned_solid(&mut self) -> Inertia {
        let (solid, lengths) = self.solid();
        let has_axis = !matches!(
            solid,
            Solid::Cuboid | Solid::Ellipsoid | Solid::Sphere | Solid::Shell
        );
        let inner = Inertia::Solid(solid, lengths);
        let direction = self.pick(&[[1, 0, 0], [0, -1, 0], [1, 2, 2], [3, 0, 4], [1, 1, -1]]);
        match self.random.u32(..3) {
            0 if has_axis => Inertia::Along(Box::new(inner), whole(direction)),
            1 => {
                let angle = Scalar::Literal(self.between(-3000, 3000));
                Inertia::Turned(Box::new(inner), whole(direction), angle)
            }
            _ => inner,
        }
    }

    /// Numbers that hold about a point: what is moved away is far smaller than they are.
    fn about_point(&mut self) -> Inertia {
        let small = self.length - 1;
        let coordinates = [(); 3].map(|()| Scalar::Literal(self.signed(small)));
        self.body.points.push(Point {
            axes: Axes::Body,
            coordinates,
        });
        let place = Place::Named(self.body.points.len() - 1);
        let mass = self.body.mass.clone().expect("drawn before");
        // at most three times the square of a length below one of this order
        let order = 2 * self.length + 1;
        let square = Scalar::Literal(self.positive(order));
        let moments = [(); 3].map(|()| {
            let factor = Scalar::Literal(self.between(900, 1300));
            factor * square.clone() * mass.clone()
        });
        Inertia::About(Box::new(Inertia::Principal(moments)), place)
    }

    /// With lengths that are all of one order.
    fn solid(&mut self) -> (Solid, Vec<Scalar>) {
        let all = [
            Solid::Cuboid,
            Solid::Ellipsoid,
            Solid::Sphere,
            Solid::Shell,
            Solid::Cylinder,
            Solid::Tube,
            Solid::Cone,
            Solid::Torus,
            Solid::Disc,
        ];
        let solid = self.pick(&all);
        let order = self.length - 1;
        let base = self.positive(order);
        let mut near = |low: i64, high: i64| {
            let factor = self.between(low, high);
            Scalar::Literal(factor) * Scalar::Literal(base.clone())
        };
        let lengths = match solid {
            Solid::Cuboid | Solid::Ellipsoid => {
                vec![near(500, 2000), near(500, 2000), near(500, 2000)]
            }
            Solid::Sphere | Solid::Shell | Solid::Disc | Solid::Rod => vec![near(500, 2000)],
            Solid::Cylinder | Solid::Cone => vec![near(500, 2000), near(500, 4000)],
            Solid::Tube => vec![near(300, 500), near(600, 2000), near(500, 4000)],
            Solid::Torus => vec![near(1000, 2000), near(100, 500)],
        };
        (solid, lengths)
    }

    /// Two to four parts at places of their own.
    fn composed(&mut self) -> Inertia {
        let count = self.random.usize(2..=4);
        let parts = (0..count).map(|i| self.part(i)).collect();
        Inertia::Compose(parts)
    }

    fn part(&mut self, i: usize) -> Part {
        let mass = Scalar::Literal(self.between(500, 2000));
        let coordinates = self.body_coordinates(false);
        self.body.points.push(Point {
            axes: Axes::Body,
            coordinates,
        });
        let at = Place::Named(self.body.points.len() - 1);
        // the first has an extent, so that no body is a line of points
        let is_point = i > 0 && self.chance(0.4);
        let inertia = match self.body.motion {
            _ if is_point => None,
            Motion::Rod(_) => Some(Inertia::Solid(
                Solid::Rod,
                vec![Scalar::Literal(self.length())],
            )),
            _ if self.body.motion.is_planar() => {
                let (solid, lengths) = self.solid();
                Some(Inertia::Solid(solid, lengths))
            }
            _ => Some(self.turned_solid()),
        };
        Part { inertia, mass, at }
    }
}
