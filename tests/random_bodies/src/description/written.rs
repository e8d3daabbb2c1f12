//! A body, written in the language of `rigid_body!`.

mod expressions;

use super::body::{
    Body, Constraint, Inertia, Input, Key, Load, Local, Motion, Param, Part, Potential, Support,
    What,
};
use super::expression::{Axes, Place, Scalar};

/// The whole invocation, with all outputs that are not of a closed form.
pub fn description(body: &Body) -> String {
    let of_reactions = |reactions: bool| {
        let open = |load: &Load| load.is_open() && (load.key == Key::Reactions) == reactions;
        body.loads.iter().any(open)
    };
    let mut outputs = vec!["energy", "momentum", "balance", "linearization"];
    if of_reactions(true) {
        outputs.push("reactions");
    }
    if of_reactions(false) {
        outputs.push("inverse");
    }
    if !body.params.is_empty() {
        outputs.push("sensitivity");
    }
    if !body.changes {
        outputs.push("regressor");
    }
    format!("newton_euler::rigid_body!({});", described(body, &outputs))
}

/// What is described, with these outputs.
pub fn described(body: &Body, outputs: &[&str]) -> String {
    let write = Writer { body };
    let mut keys = vec![format!("motion: {}", write.motion())];
    let list = |entries: Vec<String>| format!("[{}]", entries.join(", "));
    if !body.params.is_empty() {
        let entries = body.params.iter().enumerate();
        keys.push(format!(
            "params: {}",
            list(entries.map(|(i, param)| write.param(i, param)).collect())
        ));
    }
    if !body.inputs.is_empty() {
        let entries = body.inputs.iter().enumerate();
        keys.push(format!(
            "inputs: {}",
            list(entries.map(|(i, input)| write.input(i, *input)).collect())
        ));
    }
    if body.is_rich {
        keys.push("constants: [constant = crate::given::CONSTANT]".to_owned());
        keys.push(
            "functions: [bump(x) = crate::given::bump.derivatives(\
             crate::given::bump_slope.derivatives(crate::given::bump_bend))]"
                .to_owned(),
        );
    }
    if !body.rates.is_empty() {
        let states = (0..body.rates.len()).map(|i| format!("state_{i}"));
        keys.push(format!("states: {}", list(states.collect())));
        let rates = body.rates.iter().enumerate();
        let rates = rates.map(|(i, rate)| format!("state_{i} = {}", write.scalar(rate)));
        keys.push(format!("rates: {}", list(rates.collect())));
    }
    if let Some(mass) = &body.mass {
        keys.push(format!("mass: {}", write.scalar(mass)));
    }
    if let Some(inertia) = &body.inertia {
        keys.push(format!("inertia: {}", write.inertia(inertia)));
    }
    if !body.points.is_empty() {
        let entries = body.points.iter().enumerate().map(|(i, point)| {
            let coordinates = write.components(&point.coordinates);
            match point.axes {
                Axes::Body => format!("point_{i} = ({coordinates})"),
                Axes::World => format!("point_{i} = world({coordinates})"),
            }
        });
        keys.push(format!("points: {}", list(entries.collect())));
    }
    if !matches!(body.pole, Place::Center) {
        keys.push(format!("pole: {}", write.place(&body.pole)));
    }
    if !body.locals.is_empty() {
        let entries = body.locals.iter().enumerate().map(|(i, local)| {
            let value = match local {
                Local::Scalar(scalar) => write.scalar(scalar),
                Local::Vector(vector) => write.vector(vector),
            };
            format!("local_{i} = {value}")
        });
        keys.push(format!("locals: {}", list(entries.collect())));
    }
    if !body.constraints.is_empty() {
        let entries = body.constraints.iter().enumerate().map(|(i, constraint)| {
            let value = match constraint {
                Constraint::Scalar(scalar, _) => write.scalar(scalar),
                Constraint::Vector(vector, _) => write.vector(vector),
            };
            format!("constraint_{i} = {value}")
        });
        keys.push(format!("constraints: {}", list(entries.collect())));
    }
    for (key, word) in KEYS {
        let loads = body.loads.iter().enumerate();
        let entries: Vec<String> = loads
            .filter(|(_, load)| load.key == key)
            .map(|(i, load)| format!("load_{i} = {}", write.load(load)))
            .collect();
        if !entries.is_empty() {
            keys.push(format!("{word}: {}", list(entries)));
        }
    }
    keys.push(format!("outputs: [{}]", outputs.join(", ")));
    let keys = keys.join(",\n    ");
    format!("{} {{\n    {keys},\n}}", body.name)
}

/// Loads are listed in this order.
const KEYS: [(Key, &str); 7] = [
    (Key::Forces, "forces"),
    (Key::Moments, "moments"),
    (Key::JointForces, "joint_forces"),
    (Key::JointMoments, "joint_moments"),
    (Key::Fields, "fields"),
    (Key::Reactions, "reactions"),
    (Key::Potentials, "potentials"),
];

struct Writer<'a> {
    body: &'a Body,
}

impl Writer<'_> {
    fn motion(&self) -> String {
        let support = |word: &str, support: &Support, direction: Option<String>| {
            let direction = direction.map_or(String::new(), |direction| format!(", {direction}"));
            let at = support.anchor.as_ref().map_or(String::new(), |anchor| {
                format!(".at(world({}))", self.components(anchor))
            });
            format!("{word}(point_{}{direction}){at}", support.point)
        };
        match &self.body.motion {
            Motion::Spatial => "spatial".to_owned(),
            Motion::Rotation => "rotation".to_owned(),
            Motion::Translation => "translation".to_owned(),
            Motion::Planar => "planar".to_owned(),
            Motion::PlanarTranslation => "planar_translation".to_owned(),
            Motion::Pivot(held) => support("pivot", held, None),
            Motion::FixedPoint(held) => support("fixed_point", held, None),
            Motion::FixedAxis(held, axes, direction) => {
                let direction = self.written_vector(*axes, direction);
                support("fixed_axis", held, Some(direction))
            }
            Motion::Rod(direction) => {
                format!("rod({})", self.written_vector(Axes::Body, direction))
            }
        }
    }

    fn param(&self, i: usize, param: &Param) -> String {
        match param {
            Param::Scalar(default) => format!("param_{i} = {}", default.text),
            Param::Vector(axes, defaults) => {
                let parts = defaults.clone().map(Scalar::Literal);
                format!("param_{i} = {}", self.written_vector(*axes, &parts))
            }
        }
    }

    fn input(&self, i: usize, input: Input) -> String {
        match input {
            Input::Scalar => format!("input_{i}"),
            Input::Vector(axes) => {
                let blanks = vec!["_"; self.body.axes()].join(", ");
                format!("input_{i} = {}({blanks})", word(axes))
            }
        }
    }

    fn components(&self, components: &[Scalar; 3]) -> String {
        self.list(&components[..self.body.axes()])
    }

    fn list(&self, scalars: &[Scalar]) -> String {
        let parts: Vec<String> = scalars.iter().map(|scalar| self.scalar(scalar)).collect();
        parts.join(", ")
    }

    fn written_vector(&self, axes: Axes, components: &[Scalar; 3]) -> String {
        format!("{}({})", word(axes), self.components(components))
    }

    fn inertia(&self, inertia: &Inertia) -> String {
        let entries = |[xx, yy, zz, xy, yz, zx]: &[Scalar; 6]| {
            let [xx, yy, zz, xy, yz, zx] = [xx, yy, zz, xy, yz, zx].map(|entry| self.scalar(entry));
            format!("{{ xx: {xx}, yy: {yy}, zz: {zz}, xy: {xy}, yz: {yz}, zx: {zx} }}")
        };
        match inertia {
            Inertia::Scalar(scalar) => format!("({})", self.scalar(scalar)),
            Inertia::Principal(moments) => format!("principal({})", self.list(moments)),
            Inertia::Tensor(parts) => format!("tensor {}", entries(parts)),
            Inertia::Products(parts) => format!("products {}", entries(parts)),
            Inertia::Solid(solid, lengths) => {
                format!(
                    "{}({})",
                    format!("{solid:?}").to_lowercase(),
                    self.list(lengths)
                )
            }
            Inertia::Along(inner, direction) => {
                let direction = self.written_vector(Axes::Body, direction);
                format!("{}.along({direction})", self.inertia(inner))
            }
            Inertia::Turned(inner, axis, angle) => {
                let axis = self.written_vector(Axes::Body, axis);
                format!(
                    "{}.turned({axis}, {})",
                    self.inertia(inner),
                    self.scalar(angle)
                )
            }
            Inertia::About(inner, place) => {
                format!("{}.about({})", self.inertia(inner), self.place(place))
            }
            Inertia::Compose(parts) => {
                let parts: Vec<String> = parts.iter().map(|part| self.part(part)).collect();
                format!("compose([{}])", parts.join(", "))
            }
        }
    }

    fn part(&self, part: &Part) -> String {
        let mass = self.scalar(&part.mass);
        let what = match &part.inertia {
            Some(inertia) => format!("{}.mass({mass})", self.inertia(inertia)),
            None => format!("point({mass})"),
        };
        format!("{what}.at({})", self.place(&part.at))
    }

    fn load(&self, load: &Load) -> String {
        let inner = match &load.what {
            What::Force(vector, place) => {
                let vector = self.vector(vector);
                return match place {
                    Place::Center => vector,
                    _ => format!("({vector}).at({})", self.place(place)),
                };
            }
            What::OpenForce(axes, parts, place) => {
                let force = self.open(*axes, parts);
                return match place {
                    Place::Center => force,
                    _ => format!("{force}.at({})", self.place(place)),
                };
            }
            What::Charges(field, charges) => {
                let charges = charges.iter().map(|(charge, place)| {
                    format!("({}).at({})", self.scalar(charge), self.place(place))
                });
                let charges = charges.collect::<Vec<_>>().join(", ");
                return format!("({}).on([{charges}])", self.vector(field));
            }
            What::Potential(potential) => return self.potential(potential),
            What::Moment(vector) => self.vector(vector),
            What::PlaneMoment(scalar) => self.scalar(scalar),
            What::OpenAlong(direction, place) => {
                let force = format!("_ * {}", self.vector_operand(direction));
                return match place {
                    Place::Center => force,
                    _ => format!("({force}).at({})", self.place(place)),
                };
            }
            What::OpenMoment(..) if self.body.motion.is_planar() => "_".to_owned(),
            What::OpenMoment(axes, parts) => self.open(*axes, parts),
        };
        match load.key {
            Key::Fields | Key::Reactions => format!("moment({inner})"),
            _ => inner,
        }
    }

    fn open(&self, axes: Axes, parts: &[Option<Scalar>; 3]) -> String {
        let parts = parts.iter().take(self.body.axes()).map(|part| match part {
            Some(scalar) => self.scalar(scalar),
            None => "_".to_owned(),
        });
        format!("{}({})", word(axes), parts.collect::<Vec<_>>().join(", "))
    }

    fn potential(&self, potential: &Potential) -> String {
        match potential {
            Potential::Spring {
                stiffness,
                rest,
                from,
                to,
            } => {
                let (from, to) = (self.place(from), self.place(to));
                let stiffness = self.operand(stiffness);
                let stretch = format!("({to}.position() - {from}.position())");
                match rest {
                    Some(rest) => {
                        let rest = self.operand(rest);
                        format!("{stiffness} / 2 * ({stretch}.norm() - {rest}).powi(2)")
                    }
                    None => format!("{stiffness} / 2 * {stretch}.norm_squared()"),
                }
            }
            Potential::Central { strength, from, to } => {
                let (from, to) = (self.place(from), self.place(to));
                let strength = self.operand(strength);
                format!("{strength} / ({to}.position() - {from}.position()).norm()")
            }
            Potential::Well { strength, from, to } => {
                let (from, to) = (self.place(from), self.place(to));
                let strength = self.operand(strength);
                format!("{strength} * bump(({to}.position() - {from}.position()).norm() / 1[m])")
            }
            Potential::Uniform { force, at } => {
                let force = self.written_vector(Axes::World, force);
                format!("-{force}.dot({}.position())", self.place(at))
            }
            Potential::Dipole { moment, field } => {
                let moment = self.written_vector(Axes::Body, moment);
                format!("-{moment}.dot({})", self.written_vector(Axes::World, field))
            }
            Potential::Coil { stiffness } => {
                format!("{} / 2 * attitude.powi(2)", self.operand(stiffness))
            }
            Potential::Sum(energies) => {
                let energies = energies.iter().map(|energy| self.potential(energy));
                energies.collect::<Vec<_>>().join(" + ")
            }
        }
    }

    fn place(&self, place: &Place) -> String {
        match place {
            Place::Center => "G".to_owned(),
            Place::Named(i) => format!("point_{i}"),
            Place::Shifted(place, vector) => {
                format!("({} + {})", self.place(place), self.vector_operand(vector))
            }
        }
    }
}

fn word(axes: Axes) -> &'static str {
    match axes {
        Axes::Body => "body",
        Axes::World => "world",
    }
}
