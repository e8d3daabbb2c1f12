//! Taylor series of the motion: coordinates, their rates, and the resulting recurrences.
//!
//! ```text
//! position' = velocity      q' = q (0, w) / 2      angle' = w      u' = rate of the axis of a rod
//! velocity' = a             w' = alpha
//! ```
//!
//! Inputs are held constant. Those that are `.moving` continue with their rates and accelerations.
//!
//! For a symmetric body, the recurrences use axes that do not spin with it, if there are such axes:
//! see [`super::axes`].
//!
//! A series exists where the equations are smooth. A load that is not smooth is reported.

use crate::errors::{Errors, Extent};
use crate::mechanics::structure::Structure;
use crate::model::{Attitude, Frame, Model, Own, Pair, Workspace, input_rates};
use crate::symbolic::{Components, Coordinate, Id, Node, Number, Polynomial, Recurrences};

use super::axes::{self, Axes};
use super::partial::loads;

/// The recurrences of a motion. Its coordinates are in the order in which the runtime lists them.
#[derive(Debug)]
pub struct Taylor {
    /// The symbols of the coordinates.
    pub symbols: Vec<Id>,
    pub recurrences: Recurrences,
    /// The axes in which the recurrences hold, if these are not body axes.
    pub axes: Option<Axes>,
}

impl Taylor {
    /// All expressions that code is generated for.
    pub fn roots(&self) -> Vec<Id> {
        let mut roots = self.recurrences.roots();
        roots.extend(self.axes.as_ref().map(|axes| axes.spin));
        roots
    }
}

/// The recurrences, if they exist. Obstacles are reported where the series is requested.
pub fn derive_taylor(
    model: &Model,
    work: &mut Workspace,
    asked: Extent,
    accelerations: Pair,
    structure: &Structure,
    errors: &mut Errors,
) -> Option<Taylor> {
    // in axes that do not spin, the rates of user-defined states might differ
    let may_turn = model.states.is_empty();
    let axes = may_turn.then(|| axes::derive_axes(model, work, structure));
    let axes = axes.flatten();
    let (axes_rate, angular) = match &axes {
        Some(axes) => (
            axes.rate,
            axes.acceleration(model, work, accelerations.angular),
        ),
        None => (model.state.angular_velocity, accelerations.angular),
    };
    let accelerations = Pair {
        angular,
        ..accelerations
    };
    let coordinates = coordinates(model, work, accelerations, axes_rate);
    let moving = SeriesInput {
        coordinates,
        polynomials: polynomials(Some(model.state.time), &model.derivatives, work),
        loads: loads(model, work),
        cables: Vec::new(),
    };
    moving.expand(work, axes, asked, errors)
}

/// What a series is derived from.
pub struct SeriesInput {
    /// The coordinates of the state.
    pub coordinates: Vec<Coordinate>,
    /// Time, and inputs that move.
    pub polynomials: Vec<Polynomial>,
    /// The loads with their names, for reports.
    pub loads: Vec<(String, Vec<Id>)>,
    /// The names of those that are cables.
    pub cables: Vec<String>,
}

impl SeriesInput {
    /// The recurrences, if they exist.
    pub fn expand(
        &self,
        work: &mut Workspace,
        axes: Option<Axes>,
        asked: Extent,
        errors: &mut Errors,
    ) -> Option<Taylor> {
        self.check_smooth(work, asked, errors)?;
        Some(Taylor {
            symbols: self.coordinates.iter().map(|one| one.symbol).collect(),
            recurrences: work.graph.recurrences(&self.coordinates, &self.polynomials),
            axes,
        })
    }

    /// Reports where the equations are not smooth, with the load that causes it.
    fn check_smooth(&self, work: &Workspace, asked: Extent, errors: &mut Errors) -> Option<()> {
        let graph = &work.graph;
        let all = self.coordinates.iter();
        let moving: Vec<Id> = all
            .clone()
            .filter(|coordinate| !graph.is_zero(coordinate.rate))
            .map(|coordinate| coordinate.symbol)
            .chain(self.polynomials.iter().map(|known| known.symbol))
            .collect();
        let rates: Vec<Id> = all.map(|coordinate| coordinate.rate).collect();
        let kink = graph.first_kink(&rates, &moving);
        let Some(kink) = kink else {
            return Some(());
        };
        let known = errors.count();
        let mut said: Vec<&str> = Vec::new();
        for (name, parts) in &self.loads {
            if let Some(kink) = graph.first_kink(parts, &moving)
                && !said.contains(&name.as_str())
            {
                said.push(name);
                let reason = if self.cables.contains(name) {
                    format!(
                        "a cable goes slack, and its force has a kink where it does, which no series crosses; \
                         {OTHERWISE}"
                    )
                } else {
                    reason(work, kink)
                };
                errors.push(asked, format!("`{name}` has no Taylor series: {reason}"));
            }
        }
        if errors.count() == known {
            let reason = reason(work, kink);
            errors.push(
                asked,
                format!("the equations have no Taylor series: {reason}"),
            );
        }
        None
    }
}

/// Time and inputs that move: at a time s after the given values, `x + x' s + x'' s^2 / 2`.
pub fn polynomials(
    time: Option<Id>,
    derivatives: &[usize],
    work: &mut Workspace,
) -> Vec<Polynomial> {
    let rates = input_rates(work, derivatives);
    let graph = &mut work.graph;
    let (one, half) = (graph.one(), graph.number(Number::ratio(1, 2)));
    let inputs = rates.iter().map(|(symbol, rate)| {
        let second = rates.iter().find(|(of, _)| of == rate);
        let second = second.map(|(_, second)| graph.multiply(half, *second));
        Polynomial {
            symbol: *symbol,
            coefficients: [Some(*rate), second].into_iter().flatten().collect(),
        }
    });
    let inputs: Vec<Polynomial> = inputs.collect();
    let time = time.map(|symbol| Polynomial {
        symbol,
        coefficients: vec![one],
    });
    time.into_iter().chain(inputs).collect()
}

/// The coordinates of the state, grouped by kind, followed by the user-defined states. `axes_rate`
/// is the angular velocity of the axes.
fn coordinates(
    model: &Model,
    work: &mut Workspace,
    Pair { linear, angular }: Pair,
    axes_rate: Components,
) -> Vec<Coordinate> {
    let state = &model.state;
    let moving = model.motion.linear_axes();
    let [position, velocity] =
        [state.position, state.velocity].map(|vector| work.part(vector, Frame::WORLD));
    let mut list = Vec::new();
    let mut push = |symbols: &[Id], rates: &[Id]| {
        let pairs = symbols.iter().zip(rates);
        list.extend(pairs.map(|(symbol, rate)| Coordinate {
            symbol: *symbol,
            rate: *rate,
        }));
    };
    let (angle, rate): (Vec<Id>, Vec<Id>) = state.angle.into_iter().unzip();
    push(&position[moving.clone()], &velocity[moving.clone()]);
    match work.attitude(state.body) {
        Attitude::Fixed => {}
        Attitude::Axis { .. } => push(&angle, &rate),
        Attitude::Quaternion { scalar, vector } => {
            let rates = quaternion_rate(work, scalar, vector, axes_rate);
            let [x, y, z] = vector;
            push(&[x, y, z, scalar], &rates);
        }
        Attitude::Line { axis, .. } => push(&axis, &state.turn_rate()),
    }
    push(&velocity[moving.clone()], &linear[moving]);
    match work.attitude(state.body) {
        Attitude::Fixed => {}
        Attitude::Axis { .. } => push(&rate, &angular[2..]),
        Attitude::Quaternion { .. } | Attitude::Line { .. } => push(&state.turn_rate(), &angular),
    }
    list.extend(model.states.iter().map(Own::coordinate));
    list
}

/// `q' = q (0, w) / 2`, with the scalar part last.
pub fn quaternion_rate(
    work: &mut Workspace,
    scalar: Id,
    vector: Components,
    w: Components,
) -> [Id; 4] {
    let graph = &mut work.graph;
    let (swept, along) = (graph.cross(vector, w), graph.scale_vector(scalar, w));
    let [x, y, z] = graph.add_vectors(along, swept);
    let against = graph.dot(vector, w);
    let against = graph.negate(against);
    let half = graph.number(Number::ratio(1, 2));
    [x, y, z, against].map(|twice| graph.multiply(half, twice))
}

const OTHERWISE: &str = "leave `taylor` out and `integrate` takes Runge-Kutta steps";

/// Why there is no series, and what to do about it.
fn reason(work: &Workspace, kink: Id) -> String {
    let word = match work.graph.node(kink) {
        Node::Foreign(function, _) => {
            let name = &work.functions[function.number()].name;
            return format!(
                "`{name}` is a Rust function, of which only values are known; {OTHERWISE}"
            );
        }
        Node::Unary(function, _) | Node::Binary(function, ..) => function.name(),
        _ => "if",
    };
    format!(
        "`{word}` of moving quantities is not smooth; write it with smooth functions, or {OTHERWISE}"
    )
}
