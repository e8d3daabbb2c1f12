//! Draws random bodies.

use fastrand::Rng;

use super::body::{Body, Input, Local, Motion, Param, Point, Support};
use super::expression::{Axes, Place, Scalar, Vector};
use super::literal::{LENGTHS, Literal};

/// A body in the making, and where its next part comes from.
pub struct Draw {
    pub random: Rng,
    pub body: Body,
    /// What forces on this body are about.
    pub strength: i32,
    /// What points of this body are about.
    pub length: i32,
    /// Whether nothing is to be read that is a velocity, or that changes in a way that nobody knows.
    pub is_slow: bool,
}

/// The same body for the same seed and index, in every build.
pub fn body(seed: u64, index: usize) -> Body {
    let mut draw = Draw::new(seed, index);
    draw.scales();
    draw.motion();
    draw.params_and_inputs();
    draw.own_states(index);
    draw.points();
    draw.mass_and_inertia();
    draw.locals();
    draw.loads();
    draw.following(index);
    draw.own_rates();
    draw.pole();
    draw.body
}

/// A body with few loads, of which claims are made.
pub fn sparse_body(seed: u64, index: usize) -> Body {
    let mut draw = Draw::new(seed, index);
    draw.motion();
    draw.params_and_inputs();
    draw.points();
    draw.mass_and_inertia();
    draw.sparse_loads();
    draw.body
}

impl Draw {
    pub fn new(seed: u64, index: usize) -> Self {
        let index_seed = seed.wrapping_mul(1_000_003).wrapping_add(index as u64);
        Draw {
            random: Rng::with_seed(index_seed.wrapping_mul(0x9E37_79B9_7F4A_7C15)),
            body: Body {
                name: format!("Body{index}"),
                motion: Motion::Spatial,
                params: Vec::new(),
                inputs: Vec::new(),
                rates: Vec::new(),
                is_rich: false,
                changes: false,
                follows: false,
                mass: None,
                inertia: None,
                points: Vec::new(),
                pole: Place::Center,
                locals: Vec::new(),
                constraints: Vec::new(),
                loads: Vec::new(),
            },
            strength: 0,
            length: 0,
            is_slow: false,
        }
    }

    pub fn chance(&mut self, probability: f64) -> bool {
        self.random.f64() < probability
    }

    pub fn pick<T: Clone>(&mut self, from: &[T]) -> T {
        from[self.random.usize(..from.len())].clone()
    }

    /// Everyday sizes for the most part.
    fn scales(&mut self) {
        if self.chance(0.3) {
            self.strength = self.random.i32(-6..=6);
            self.length = self.random.i32(-3..=2);
        }
    }

    /// A number of this order of magnitude with 1 to 12 digits, negative as often as not.
    pub fn signed(&mut self, order: i32) -> Literal {
        let size = self.positive(order);
        if self.random.bool() {
            negative(&size)
        } else {
            size
        }
    }

    /// From 1 to 10, times a power of ten.
    pub fn positive(&mut self, order: i32) -> Literal {
        let digits = self.pick(&[1_u32, 2, 2, 3, 3, 4, 6, 12]);
        let least = 10_i64.pow(digits - 1);
        let number = self.random.i64(least..10 * least);
        Literal::new(number, order + 1 - i32::try_from(digits).expect("few"))
    }

    /// Between two whole numbers of thousandths.
    pub fn between(&mut self, low: i64, high: i64) -> Literal {
        Literal::new(self.random.i64(low..=high), -3)
    }

    fn motion(&mut self) {
        let which = self.random.u32(..100);
        let support = |draw: &mut Self| {
            let point = draw.body.points.len();
            let coordinates = draw.body_coordinates(false);
            draw.body.points.push(Point {
                axes: Axes::Body,
                coordinates,
            });
            let anchor = draw.random.bool().then(|| draw.world_coordinates());
            Support { point, anchor }
        };
        match which {
            0..26 => self.body.motion = Motion::Spatial,
            26..36 => self.body.motion = Motion::Rotation,
            36..44 => self.body.motion = Motion::Translation,
            44..57 => self.body.motion = Motion::Planar,
            57..62 => self.body.motion = Motion::PlanarTranslation,
            62..70 => {
                self.body.motion = Motion::Planar;
                let support = support(self);
                self.body.motion = Motion::Pivot(support);
            }
            70..80 => {
                let support = support(self);
                self.body.motion = Motion::FixedPoint(support);
            }
            80..91 => {
                let support = support(self);
                let axes = self.pick(&[Axes::Body, Axes::World]);
                let direction = self.pick(&AXES_OF_HINGES);
                self.body.motion = Motion::FixedAxis(support, axes, whole(direction));
            }
            _ => {
                let direction = self.pick(&AXES_OF_RODS);
                self.body.motion = Motion::Rod(whole(direction));
            }
        }
    }

    fn params_and_inputs(&mut self) {
        let planar = self.body.motion.is_planar();
        let rod = matches!(self.body.motion, Motion::Rod(_));
        for _ in 0..self.random.usize(..=3) {
            let default = self.signed(0);
            self.body.params.push(Param::Scalar(default));
        }
        if self.chance(0.3) {
            let axes = if rod {
                Axes::World
            } else {
                self.pick(&[Axes::Body, Axes::World])
            };
            let mut parts = [(); 3].map(|()| self.signed(0));
            if planar {
                parts[2] = Literal::new(0, 0);
            }
            self.body.params.push(Param::Vector(axes, parts));
        }
        for _ in 0..self.random.usize(..=2) {
            self.body.inputs.push(Input::Scalar);
        }
        for _ in 0..self.random.usize(..=2) {
            let axes = if rod {
                Axes::World
            } else {
                self.pick(&[Axes::Body, Axes::World])
            };
            self.body.inputs.push(Input::Vector(axes));
        }
    }

    fn points(&mut self) {
        for _ in 0..self.random.usize(1..=3) {
            let with_params = self.chance(0.3);
            let coordinates = self.body_coordinates(with_params);
            self.body.points.push(Point {
                axes: Axes::Body,
                coordinates,
            });
        }
        // where the motion of G is not modeled, no place in space is known from the body
        if self.body.motion.moves() {
            for _ in 0..self.random.usize(1..=2) {
                let coordinates = self.world_coordinates();
                self.body.points.push(Point {
                    axes: Axes::World,
                    coordinates,
                });
            }
        }
    }

    /// A length of this body, in any unit.
    pub fn length(&mut self) -> Literal {
        let order = self.length - self.random.i32(0..=1);
        let length = self.positive(order);
        if self.chance(0.2) {
            let unit = self.pick(&LENGTHS);
            return length.unit(unit);
        }
        length
    }

    fn coordinate(&mut self, with_params: bool) -> Scalar {
        if with_params
            && self.chance(0.5)
            && let Some(param) = self.scalar_param()
        {
            let order = self.length - 1;
            return Scalar::Literal(self.positive(order)) * param;
        }
        let order = self.length - self.random.i32(0..=1);
        match self.random.u32(..5) {
            0 => Scalar::zero(),
            1 => Scalar::Literal(self.length()),
            _ => Scalar::Literal(self.signed(order)),
        }
    }

    /// Of a rod on its axis; in the plane without a third.
    pub fn body_coordinates(&mut self, with_params: bool) -> [Scalar; 3] {
        if let Motion::Rod(direction) = &self.body.motion {
            let direction = direction.clone();
            let digits = self.random.i64(-40..=40);
            let length = self.length;
            return direction.map(|part| match part {
                #[allow(clippy::cast_possible_truncation, reason = "small whole numbers")]
                Scalar::Literal(part) => {
                    Scalar::literal(digits * part.nearest() as i64, length - 2)
                }
                other => unreachable!("{other:?} is a literal"),
            });
        }
        let mut coordinates = [(); 3].map(|()| self.coordinate(with_params));
        if self.body.motion.is_planar() {
            coordinates[2] = Scalar::zero();
        }
        // not G itself
        if coordinates.iter().all(Scalar::is_zero) {
            coordinates[0] = Scalar::Literal(self.length());
        }
        coordinates
    }

    fn world_coordinates(&mut self) -> [Scalar; 3] {
        let mut coordinates = [(); 3].map(|()| {
            let order = self.length + self.random.i32(0..=1);
            Scalar::Literal(self.signed(order))
        });
        if self.body.motion.is_planar() {
            coordinates[2] = Scalar::zero();
        }
        coordinates
    }

    pub fn scalar_param(&mut self) -> Option<Scalar> {
        let params = self.body.params.iter().enumerate();
        let scalars = params.filter(|(_, param)| matches!(param, Param::Scalar(_)));
        let scalars: Vec<usize> = scalars.map(|(i, _)| i).collect();
        (!scalars.is_empty()).then(|| Scalar::Param(self.pick(&scalars)))
    }

    pub fn scalar_input(&mut self) -> Option<Scalar> {
        let inputs = self.body.inputs.iter().enumerate();
        let scalars = inputs.filter(|(_, input)| matches!(input, Input::Scalar));
        let scalars: Vec<usize> = scalars.map(|(i, _)| i).collect();
        (!scalars.is_empty()).then(|| Scalar::Input(self.pick(&scalars)))
    }

    /// A parameter or an input that is a vector.
    pub fn vector_name(&mut self) -> Option<Vector> {
        let params = self.body.params.iter().enumerate();
        let params = params.filter(|(_, param)| matches!(param, Param::Vector(..)));
        let inputs = self.body.inputs.iter().enumerate();
        let inputs = inputs.filter(|(_, input)| matches!(input, Input::Vector(_)));
        let names = params
            .map(|(i, _)| Vector::Param(i))
            .chain(inputs.map(|(i, _)| Vector::Input(i)));
        let names: Vec<Vector> = names.collect();
        (!names.is_empty()).then(|| self.pick(&names))
    }

    /// Points of the body, or of space.
    pub fn place(&mut self, axes: Axes) -> Place {
        let points = self.body.points.iter().enumerate();
        let places: Vec<usize> = points
            .filter(|(_, point)| point.axes == axes)
            .map(|(i, _)| i)
            .collect();
        Place::Named(self.pick(&places))
    }

    fn locals(&mut self) {
        for _ in 0..self.random.usize(..=2) {
            let local = if self.random.bool() {
                Local::Scalar(self.scalar(2))
            } else {
                Local::Vector(self.vector(2))
            };
            self.body.locals.push(local);
        }
    }

    fn pole(&mut self) {
        if self.body.motion.moves() {
            self.body.pole = match self.random.u32(..4) {
                0 => self.place(Axes::Body),
                1 => self.place(Axes::World),
                _ => Place::Center,
            };
        }
    }
}

/// Directions of hinges: axes of space, and others.
const AXES_OF_HINGES: [[i64; 3]; 6] = [
    [0, 0, 1],
    [1, 0, 0],
    [0, -1, 0],
    [0, 0, 3],
    [1, -2, 2],
    [2, 1, -3],
];
const AXES_OF_RODS: [[i64; 3]; 5] = [[1, 0, 0], [0, 1, 0], [0, 0, -1], [3, 0, 4], [1, 2, 2]];

pub fn whole(numbers: [i64; 3]) -> [Scalar; 3] {
    numbers.map(|number| Scalar::literal(number, 0))
}

fn negative(literal: &Literal) -> Literal {
    Literal {
        text: format!("-{}", literal.text),
        value: -literal.value,
    }
}
