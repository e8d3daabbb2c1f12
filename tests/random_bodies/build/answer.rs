//! The function that evaluates all outputs of a body: from lists of numbers to its own types, and
//! back.

use crate::description::body::{Body, Input, Key, Load, Param, What};
use crate::description::written::description;

/// A module with the body and `pub fn answer(..)`.
pub fn module(body: &Body, index: usize) -> String {
    let (description, answer) = (description(body), answer(body));
    format!("pub mod body_{index} {{\nuse super::*;\n{description}\n{answer}}}\n")
}

/// `pub fn answer(..)`: from flat lists of numbers to the body's types, and back.
fn answer(body: &Body) -> String {
    let (make, input) = constructed(body, "return answers.refuse()");
    let open = |reactions: bool| {
        let loads = body.loads.iter().enumerate();
        let open = loads
            .filter(move |(_, load)| load.is_open() && (load.key == Key::Reactions) == reactions);
        open.collect::<Vec<_>>()
    };
    let tell = |open: &[(usize, &Load)], values: &str| -> String {
        let lines = open.iter().map(|(i, load)| match load.what {
            What::OpenForce(..) => format!("answers.unknown_force({i}, &{values}.load_{i});\n"),
            _ => format!("answers.unknown_moment({i}, &{values}.load_{i});\n"),
        });
        lines.collect()
    };
    let (reactions, drives) = (open(true), open(false));
    let solve = if reactions.is_empty() {
        "let reactions = ();".to_owned()
    } else {
        let lines = tell(&reactions, "reactions");
        format!("let reactions = body.reactions(given.time, &state, &input);\n{lines}")
    };
    let invert = if drives.is_empty() {
        String::new()
    } else {
        let lines = tell(&drives, "drives");
        format!("let drives = body.inverse(given.time, &state, &motion, &input);\n{lines}")
    };
    let [state, accelerations, motion] = stated(body);
    let own = body.rates.len();
    let sensitivity = if body.params.is_empty() {
        ""
    } else {
        "answers.sensitivity(&body.sensitivity(given.time, &state, &input).by_params());"
    };
    let regressor = if body.changes {
        String::new()
    } else {
        let (forces, moments) = body.regressor_rows();
        format!(
            "answers.regressor(&body.regressor(given.time, &state, &motion, &input), \
             &body.inertial_parameters(), [{forces}, {moments}]);"
        )
    };
    format!(
        "pub fn answer(given: &Given, answers: &mut Answers) {{
{make}
{input}
{state}
{accelerations}
answers.energy(&body, given.time, &state, &input);
answers.momentum(&body, given.time, &state);
answers.loads(&body.applied(given.time, &state, &input), &body.loads(given.time, &state, &input));
{solve}
{motion}
answers.residual(&body.residual(given.time, &state, &motion, &reactions, &input));
{invert}
{regressor}
answers.linearization(&body.linearize(given.time, &state, &input).a(), {own});
{sensitivity}
}}
"
    )
}

/// The lines that make `state`, tell accelerations, and make `motion`.
fn stated(body: &Body) -> [String; 3] {
    let name = &body.name;
    if body.rates.is_empty() {
        return [
            "let state = state(given);",
            "answers.acceleration(&state, &body.acceleration(given.time, &state, &input));",
            "let motion = motion(given);",
        ]
        .map(str::to_owned);
    }
    let count = body.rates.len();
    let fields = |value: &dyn Fn(usize) -> String| {
        let fields = (0..count).map(|i| format!("state_{i}: {}", value(i)));
        fields.collect::<Vec<_>>().join(", ")
    };
    let own = fields(&|i| format!("given.own[{i}]"));
    let still = fields(&|_| "0.0".to_owned());
    let rates = (0..count).map(|i| format!("answers.rate({i}, found.state_{i});\n"));
    let rates = rates.collect::<Vec<_>>().concat();
    [
        format!("let state = {name}State {{ motion: state(given), {own} }};"),
        format!(
            "let found = body.acceleration(given.time, &state, &input);\n\
             answers.acceleration(&state.motion, &found.motion);\n{rates}"
        ),
        format!("let motion = {name}Acceleration {{ motion: motion(given), {still} }};"),
    ]
}

/// The lines that make `body` and `input`.
pub fn constructed(body: &Body, refused: &str) -> (String, String) {
    let name = &body.name;
    let fields = |prefix: &str, vectors: Vec<bool>, list: &str| {
        let mut next = 0;
        let mut fields = Vec::new();
        for (i, is_vector) in vectors.into_iter().enumerate() {
            let count = if is_vector { body.axes() } else { 1 };
            let numbers: Vec<String> = (next..next + count)
                .map(|n| format!("{list}[{n}]"))
                .collect();
            next += count;
            let numbers = numbers.join(", ");
            fields.push(if is_vector {
                format!("{prefix}_{i}: [{numbers}].into()")
            } else {
                format!("{prefix}_{i}: {numbers}")
            });
        }
        fields.join(", ")
    };
    let params = body
        .params
        .iter()
        .map(|param| matches!(param, Param::Vector(..)));
    let params = fields("param", params.collect(), "given.params");
    let inputs = body
        .inputs
        .iter()
        .map(|input| matches!(input, Input::Vector(_)));
    let inputs = fields("input", inputs.collect(), "given.inputs");
    let make = if body.params.is_empty() && body.is_rich {
        format!("let Ok(body) = {name}::new() else {{ {refused} }};")
    } else if body.params.is_empty() {
        format!("let body = {name}::default();")
    } else {
        format!("let Ok(body) = {name}::new({name}Params {{ {params} }}) else {{ {refused} }};")
    };
    let input = if body.inputs.is_empty() {
        "let input = ();".to_owned()
    } else {
        format!("let input = {name}Input {{ {inputs} }};")
    };
    (make, input)
}
