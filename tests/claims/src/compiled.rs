//! A description as the compiler understands it.

use mounted::errors::Errors;
use mounted::lower::read_body;
use mounted::mechanics::{
    Equations, Flow, Structure, derive_equations, derive_flow, describe_equations, with_potentials,
};
use mounted::model::{Meaning, Model, Workspace};
use mounted::outputs::{derive_outputs, offers};
use mounted::symbolic::{Id, Node};
use mounted::syntax::parse_description;
use proc_macro2::TokenStream;

use crate::description::body::Body;
use crate::given::Given;
use crate::layout::Layout;

pub struct Compiled {
    pub model: Model,
    pub work: Workspace,
    pub equations: Equations,
    /// What integrators are told.
    pub structure: Structure,
    /// What the equations are said not to contain.
    pub skipped: Vec<String>,
    /// The motion in closed form, if it is asked for.
    pub flow: Option<Flow>,
}

impl Compiled {
    /// Its equations, or what is wrong with it.
    pub fn new(description: &str) -> Result<Self, String> {
        let tokens: TokenStream = format!("(::newton_euler) {description}")
            .parse()
            .expect("descriptions are made of tokens");
        let mut errors = Errors::default();
        let described = parse_description(tokens, &mut errors);
        let solved = described.and_then(|description| {
            let (outline, read) = read_body(&description, &offers::<Model>(), &mut errors);
            let (model, mut work) = read?;
            let model = with_potentials(model, &mut work);
            let (model, equations) = derive_equations(model, &mut work, &mut errors)?;
            derive_outputs(&outline, &model, &mut work, &equations, &mut errors)?;
            let accelerations = equations.accelerations;
            let flow = outline.place("flow").and_then(|place| {
                derive_flow(&model, &mut work, place, accelerations, &mut errors)
            });
            let structure = equations.structure(&model, &mut work).clone();
            let skipped = describe_equations(&model, &mut work, &equations).skipped;
            Some(Self {
                model,
                work,
                equations,
                structure,
                skipped,
                flow,
            })
        });
        match (errors.finish(), solved) {
            (None, Some(compiled)) => Ok(compiled),
            (mistakes, _) => {
                Err(mistakes.map_or_else(String::new, |mistakes| mistakes.to_string()))
            }
        }
    }

    /// Whether a pivot vanishes, so that no acceleration is computed: its divisor is nothing but
    /// rounding.
    pub fn has_no_pivot(&self, body: &Body, given: &Given) -> bool {
        let graph = &self.work.graph;
        let roots: Vec<Id> = self.accelerations();
        let pivots = graph.nodes_of(&roots).into_iter();
        let parts: Vec<Id> = pivots
            .filter_map(|id| match *graph.node(id) {
                Node::Pivot(divisor, scale) => Some([divisor, scale]),
                _ => None,
            })
            .flatten()
            .collect();
        let values = self.values(body, &parts, given);
        // the guard of the runtime
        values
            .chunks(2)
            .any(|pair| pair[0].abs() <= 8.0 * f64::EPSILON * pair[1])
    }

    /// Linear, and angular.
    pub fn accelerations(&self) -> Vec<Id> {
        self.equations.accelerations.entries()
    }

    /// The values of expressions, in doubles.
    pub fn values(&self, body: &Body, roots: &[Id], given: &Given) -> Vec<f64> {
        let layout = Layout::of(&body.motion);
        let (params, inputs) = (body.param_offsets().0, body.input_offsets().0);
        self.work.graph.evaluate(roots, |id| {
            let Some(meaning) = self.work.meaning(id) else {
                return f64::NAN;
            };
            match meaning {
                Meaning::Time => given.time,
                Meaning::Param(i, part) => given.params[params[i] + part.unwrap_or(0)],
                Meaning::Input(i, part) => given.inputs[inputs[i] + part.unwrap_or(0)],
                other => layout
                    .place(other)
                    .map_or(f64::NAN, |place| given.state[place]),
            }
        })
    }
}
