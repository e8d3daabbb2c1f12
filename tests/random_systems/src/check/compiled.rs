//! A description as the compiler understands it, and the values of its expressions.

use std::collections::HashMap;

use mounted::errors::Errors;
use mounted::lower::read_system;
use mounted::mechanics::{
    Balance, Consistency, Energy, Inertias, Jacobian, Linearization, Momentum, Regressor,
    SystemEquations, derive_inertias, derive_jacobians, derive_system, derive_system_balances,
    derive_system_consistency, derive_system_driving, derive_system_energy, derive_system_inverse,
    derive_system_momentum, derive_system_open, derive_system_reactions, derive_system_regressors,
    describe_system, differentiated_system, linearize, sensitivity, with_system_potentials,
};
use mounted::model::{Meaning, Outline, System, Variable, Workspace};
use mounted::outputs::offers;
use mounted::symbolic::{Comparison, Components, Function, Id, Node, Number, Table};
use mounted::syntax::parse_system;
use proc_macro2::TokenStream;

use crate::law::functions::called;
use crate::law::kind::Rates;
use crate::wide::Wide;

pub struct Compiled {
    pub system: System,
    pub outline: Outline,
    pub work: Workspace,
    /// By the system's joints, as all that follows; `links` tells which they are.
    pub accelerations: Vec<Vec<Id>>,
    /// Behind those of the tree those that close loops; none if they are not determined.
    pub reactions: Option<Vec<[Components; 2]>>,
    pub driving: Vec<Vec<Id>>,
    /// Of trees alone, as the next.
    pub inverse: Vec<Vec<Id>>,
    pub inertias: Option<Inertias>,
    pub energy: Energy,
    pub momentum: Momentum,
    pub balances: Vec<Balance>,
    pub jacobians: Vec<Jacobian>,
    /// What is said not to be in the equations.
    pub skipped: Vec<String>,
    /// What keeps loops closed.
    pub constraints: Vec<Consistency>,
    /// The link of each joint and body, and of those that close loops.
    pub links: Vec<usize>,
    pub closing: Vec<usize>,
    /// The link of each link without mass, and its tension.
    pub ties: Vec<(usize, Id)>,
    pub linearization: Option<Linearization>,
    pub sensitivity: Option<Linearization>,
    /// By the system's bodies.
    pub regressors: Option<Vec<Regressor>>,
}

/// Values of the symbols.
pub struct Given<'a> {
    pub time: Wide,
    /// Behind them user-defined states.
    pub params: &'a [Wide],
    pub inputs: &'a [Wide],
    /// By link.
    pub rates: &'a [Rates],
    /// Of motions and loads that are asked for.
    pub accelerations: &'a [Vec<Wide>],
    pub loads: &'a [[[Wide; 3]; 2]],
}

/// The number at the end of a name.
fn number_of(name: &impl ToString) -> usize {
    let name = name.to_string();
    let letters = name.trim_end_matches(|letter: char| letter.is_ascii_digit());
    name[letters.len()..].parse().expect("names are numbered")
}

/// The load along each freedom of each joint that makes it accelerate as is given: that of a drive, were
/// one open there.
fn needed(
    system: &mut System,
    work: &mut Workspace,
    equations: &SystemEquations,
    errors: &mut Errors,
) -> Vec<Vec<Id>> {
    let written: Vec<_> = system
        .joints
        .iter()
        .map(|joint| joint.open.clone())
        .collect();
    for joint in system.joints.iter_mut().filter(|joint| !joint.is_driven()) {
        let name = joint.name.clone();
        joint.open.fill(Some(name));
    }
    let mut found = derive_system_inverse(system, work, equations, errors).into_iter();
    let joints = system.joints.iter_mut().zip(written);
    let needed = joints.map(|(joint, written)| {
        let count = if joint.is_driven() { 0 } else { written.len() };
        joint.open = written;
        found.by_ref().take(count).collect()
    });
    needed.collect()
}

impl Compiled {
    /// Its equations, or what is wrong with it.
    pub fn new(text: &str) -> Result<Self, String> {
        let tokens = format!("(::newton_euler) {text}").parse::<TokenStream>();
        let tokens = tokens.map_err(|error| error.to_string())?;
        let mut errors = Errors::default();
        let found = Self::derive(tokens, &mut errors);
        match (errors.finish(), found) {
            (None, Some(found)) => Ok(found),
            (mistakes, _) => Err(mistakes.map_or_else(String::new, |all| all.to_string())),
        }
    }

    fn derive(tokens: TokenStream, errors: &mut Errors) -> Option<Self> {
        let mut description = parse_system(tokens, errors)?;
        let (outline, read) = read_system(&mut description, &offers::<System>(), errors);
        let (system, mut work) = read?;
        let mut system = with_system_potentials(system, &mut work);
        let equations = derive_system(&system, &mut work);
        let is_tree = system.is_tree();
        let is_determined = derive_system_open(&system, &work, &equations).is_empty();
        let reactions = is_determined.then(|| {
            let named = derive_system_reactions(&system, &mut work, &equations);
            let zeros = work.graph.zeros();
            let joints = system.joints.iter().map(|joint| &joint.name);
            let closings = system.closings.iter().map(|closing| &closing.name);
            // what is free has none
            let reactions = joints.chain(closings).map(|joint| {
                let found = named.iter().find(|(name, _)| name == joint);
                found.map_or([zeros; 2], |(_, load)| *load)
            });
            reactions.collect()
        });
        let tensions = equations.kept_loads().iter().copied();
        let ties = system.links.iter().map(|tie| number_of(&tie.name));
        let is_asked = outline.rank("linearization").is_some();
        let has_params = outline.rank("sensitivity").is_some();
        let has_regressor = outline.rank("regressor").is_some();
        let constraints = derive_system_consistency(&system, &mut work, &equations);
        Some(Self {
            links: system
                .joints
                .iter()
                .map(|one| number_of(&one.name))
                .collect(),
            closing: system
                .closings
                .iter()
                .map(|one| number_of(&one.name))
                .collect(),
            ties: ties.zip(tensions).collect(),
            linearization: is_asked.then(|| {
                let differentiated = differentiated_system(&system, &mut work, &equations);
                linearize(&outline, &system, &mut work, differentiated)
            }),
            sensitivity: has_params.then(|| {
                let differentiated = differentiated_system(&system, &mut work, &equations);
                sensitivity(&outline, &mut work, differentiated)
            }),
            regressors: has_regressor
                .then(|| derive_system_regressors(&system, &mut work, &equations)),
            skipped: describe_system(&system, &mut work, &equations).skipped,
            accelerations: equations.accelerations.clone(),
            reactions,
            driving: derive_system_driving(&mut work, &equations),
            inverse: if is_tree {
                needed(&mut system, &mut work, &equations, errors)
            } else {
                Vec::new()
            },
            inertias: is_tree.then(|| derive_inertias(&system, &mut work, &equations)),
            energy: derive_system_energy(&system, &mut work),
            momentum: derive_system_momentum(&system, &mut work),
            balances: derive_system_balances(&system, &mut work, &equations, &outline.holding),
            jacobians: derive_jacobians(&system, &mut work),
            constraints: constraints.into_iter().map(|(one, _)| one).collect(),
            system,
            outline,
            work,
        })
    }

    fn symbols(&self, given: &Given<'_>) -> HashMap<Id, Wide> {
        let mut symbols = HashMap::new();
        for (joint, link) in self.system.joints.iter().zip(&self.links) {
            if joint.is_driven() {
                continue;
            }
            let (q, v) = &given.rates[*link];
            let a = &given.accelerations[*link];
            let all = &joint.coordinates.0;
            // linear parts stand before angular ones
            let linear = all
                .iter()
                .filter(|one| one.variable == Variable::Velocity)
                .count();
            for one in all {
                let value = match one.variable {
                    Variable::Position => q[one.part],
                    Variable::Angle => q[linear + one.part],
                    // its scalar comes first here
                    Variable::Quaternion => q[linear + (one.part + 3) % 4],
                    Variable::Velocity => v[one.part],
                    Variable::AngularVelocity => v[linear + one.part],
                    Variable::LinearAcceleration => a[one.part],
                    Variable::AngularAcceleration => a[linear + one.part],
                    _ => continue,
                };
                symbols.insert(one.id, value);
            }
        }
        symbols
    }

    fn symbol(&self, given: &Given<'_>, known: &HashMap<Id, Wide>, id: Id) -> Wide {
        if let Some(value) = known.get(&id) {
            return *value;
        }
        match self.work.meaning(id) {
            Some(Meaning::Time) => given.time,
            Some(Meaning::Param(i, _)) => given.params[i],
            Some(Meaning::Own(i)) => given.params[self.outline.params.len() + i],
            Some(Meaning::Input(i, _)) => given.inputs[i],
            Some(Meaning::Reaction(i, axis)) => {
                // behind those of joints the tensions, a number each
                let Some(joint) = self.outline.holding.get(i / 2) else {
                    let (link, _) = self.ties[i - 2 * self.outline.holding.len()];
                    return given.loads[link][0][0];
                };
                given.loads[number_of(joint)][i % 2][axis]
            }
            _ => f64::NAN.into(),
        }
    }

    /// In doubles, as the code computes them.
    pub fn doubles(&self, roots: &[Id], given: &Given<'_>) -> Vec<f64> {
        let known = self.symbols(given);
        let graph = &self.work.graph;
        graph.evaluate(roots, |id| self.symbol(given, &known, id).high)
    }

    /// In 106 bits, so that what is wrong is no rounding.
    pub fn values(&self, roots: &[Id], given: &Given<'_>) -> Vec<Wide> {
        let known = self.symbols(given);
        let graph = &self.work.graph;
        let order = graph.nodes_of(roots);
        let end = order.last().map_or(0, |last| last.index() + 1);
        let mut values = vec![Wide::from(f64::NAN); end];
        for id in order {
            let value = |operand: Id| values[operand.index()];
            let truth = |holds: bool| if holds { Wide::ONE } else { Wide::ZERO };
            let holds = |operand: Id| values[operand.index()] != Wide::ZERO;
            values[id.index()] = match *graph.node(id) {
                Node::Number(ref number) => wide(number),
                Node::Truth(holds) => truth(holds),
                Node::Undefined => f64::NAN.into(),
                Node::Foreign(function, arguments) => {
                    let declared = &self.work.functions[function.number()];
                    let name = declared.name.to_string();
                    // what is not given is not called
                    let given = declared.word(function);
                    given.map_or(f64::NAN.into(), |_| {
                        called(&name, function.orders(), arguments.map(value))
                    })
                }
                Node::Symbol(_) => self.symbol(given, &known, id),
                Node::Quantity(a) | Node::Positive(a) => value(a),
                Node::Negate(a) => -value(a),
                Node::Add(a, b) => value(a) + value(b),
                Node::Subtract(a, b) => value(a) - value(b),
                Node::Multiply(a, b) => value(a) * value(b),
                Node::Divide(a, b) => value(a) / value(b),
                Node::Unary(function, a) => unary(function, value(a)),
                Node::Binary(Function::Table, a, table) => {
                    let table = graph.table(table).expect("a table");
                    tabulated(&table, value(a))
                }
                Node::Binary(function, a, b) => binary(function, value(a), value(b)),
                Node::Compare(comparison, a, b) => truth(match comparison {
                    Comparison::Less => value(a) < value(b),
                    Comparison::LessOrEqual => value(a) <= value(b),
                    Comparison::Equal => value(a) == value(b),
                    Comparison::NotEqual => value(a) != value(b),
                }),
                Node::And(a, b) => truth(holds(a) && holds(b)),
                Node::Or(a, b) => truth(holds(a) || holds(b)),
                Node::Not(a) => truth(!holds(a)),
                Node::Pivot(a, _) => Wide::ONE / value(a),
                Node::Select(condition, a, b) => value(if holds(condition) { a } else { b }),
            };
        }
        roots.iter().map(|root| values[root.index()]).collect()
    }
}

/// The polynomial for it.
fn tabulated(table: &Table, x: Wide) -> Wide {
    let pieces = table.pieces.iter().rev();
    let mut pieces = pieces.skip_while(|piece| x < wide(&piece.start));
    let piece = pieces.next().unwrap_or(&table.pieces[0]);
    let beyond = x - wide(&piece.start);
    let coefficients = piece.coefficients.iter().rev();
    coefficients.fold(Wide::ZERO, |sum, one| sum * beyond + wide(one))
}

/// A number, and what its double leaves.
fn wide(number: &Number) -> Wide {
    let high = number.to_f64();
    let rest = number.clone() - Number::from_f64(high);
    Wide::from(high) + Wide::from(rest.to_f64())
}

fn unary(function: Function, a: Wide) -> Wide {
    match function {
        Function::Sqrt => a.sqrt(),
        Function::Sin => a.sin_cos().0,
        Function::Cos => a.sin_cos().1,
        Function::Abs => a.abs(),
        other => panic!("no {other:?} is drawn"),
    }
}

fn binary(function: Function, a: Wide, b: Wide) -> Wide {
    match function {
        Function::Hypot => (a * a + b * b).sqrt(),
        Function::Max => {
            if a < b {
                b
            } else {
                a
            }
        }
        Function::Min => {
            if a < b {
                a
            } else {
                b
            }
        }
        other => panic!("no {other:?} of {a:?} and {b:?} is drawn"),
    }
}
