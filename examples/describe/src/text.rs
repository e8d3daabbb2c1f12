//! A description as text: what the macro would read again.

use std::io::Write;
use std::process::{Command, Stdio};

use proc_macro2::{Ident, Literal, TokenStream, TokenTree};
use quote::quote;

use mounted::families::LoadKind;
use mounted::fraction::Fraction;
use mounted::syntax::{
    Composition, Declaration, Definition, Description, Expression, Kind, Load, Operator, Prefix,
    Step, System, UnitExpression,
};

/// What stands in the parentheses of `rigid_system!`.
pub fn system(system: &System) -> TokenStream {
    let top = &system.top;
    let mut keys = vec![doc(&top.doc)];
    if system.is_planar {
        keys.push(quote!(motion: planar,));
    }
    if system.centers.is_some() {
        keys.push(quote!(drawing: zero_pose,));
    }
    keys.push(list("params", top.params.iter().map(declaration)));
    let inputs = top.inputs.iter().filter(|input| input.order == 0);
    keys.push(list("inputs", inputs.map(declaration)));
    keys.push(definitions("locals", &top.locals));
    let bodies = system.bodies.iter().map(|one| body(one, system));
    keys.push(list("bodies", bodies));
    let joints = system.joints.iter().chain(&system.cables).map(definition);
    keys.push(list("joints", joints));
    keys.push(list("fields", top.loads.iter().map(load)));
    keys.push(definitions("potentials", &top.potentials));
    keys.push(definitions("constraints", &top.constraints));
    keys.push(definitions("drives", &system.drives));
    keys.push(definitions("forces", &system.forces));
    keys.push(definitions("moments", &system.moments));
    let outputs = top.outputs.iter().map(|output| asked(output, system));
    keys.push(list("outputs", outputs));
    let name = &top.name;
    let scalar = top.scalar.iter().map(|scalar| quote!(::<#scalar>));
    quote!(#name #(#scalar)* { #(#keys)* })
}

fn body(body: &Description, system: &System) -> TokenStream {
    let mut keys = vec![doc(&body.doc)];
    let value = |written: Option<&Expression>| written.map(expression);
    let mass = body
        .mass
        .as_ref()
        .and_then(|mass| value(mass.value.as_ref()));
    if let Some(mass) = mass {
        keys.push(quote!(mass: #mass,));
    } else if body.is_frame {
        keys.push(quote!(mass: 0[kg],));
    }
    let inertia = body.inertia.as_ref();
    if let Some(inertia) = inertia.and_then(|inertia| value(inertia.value.as_ref())) {
        keys.push(quote!(inertia: #inertia,));
    }
    if let Some(composition) = &body.composition {
        let parts = parts(composition);
        keys.push(quote!(inertia: #parts,));
    }
    // points of a file that nothing refers to are left out
    let is_used = |point: &&Definition| {
        let is_given = body.given.iter().any(|given| point.name == given.as_str());
        !is_given || refers(system, body, &point.name)
    };
    let points = body.points.iter().filter(is_used);
    keys.push(list("points", points.map(definition)));
    keys.push(definitions("locals", &body.locals));
    keys.push(definitions("potentials", &body.potentials));
    for (key, kind) in [("forces", LoadKind::Force), ("moments", LoadKind::Moment)] {
        let loads = body.loads.iter().filter(|load| load.kind == kind);
        keys.push(list(key, loads.map(load_of_body)));
    }
    let name = &body.name;
    quote!(#name { #(#keys)* })
}

/// Whether a point of a body is named anywhere.
fn refers(system: &System, body: &Description, point: &Ident) -> bool {
    let own = body
        .points
        .iter()
        .chain(&body.locals)
        .chain(&body.potentials);
    let own = own.filter_map(|one| one.value.as_ref());
    let loads = body
        .loads
        .iter()
        .flat_map(|load| load.vector.iter().chain(load.point.iter().flatten()));
    let is_named = |expression: &Expression| expression.names().contains(&point);
    let top = &system.top;
    let lists = [
        &system.joints,
        &system.cables,
        &system.drives,
        &system.forces,
        &system.moments,
    ];
    let others = lists
        .into_iter()
        .flatten()
        .chain(&top.locals)
        .chain(&top.potentials)
        .chain(&top.constraints);
    let others = others
        .filter_map(|one| one.value.as_ref())
        .chain(&system.points);
    own.chain(loads).any(is_named)
        || others.into_iter().any(|expression| {
            let mut found = false;
            expression.visit(|part| {
                if let Kind::Field(of, name) = &part.kind {
                    let is_own = matches!(&of.kind, Kind::Name(of) if *of == body.name);
                    found |= is_own && name == point;
                }
            });
            found
        })
}

fn doc(lines: &[String]) -> TokenStream {
    if lines.is_empty() {
        return TokenStream::new();
    }
    let text = lines.join("\n");
    quote!(doc: #text,)
}

/// `key: [entries],`, or nothing.
fn list(key: &str, entries: impl Iterator<Item = TokenStream>) -> TokenStream {
    let entries: Vec<TokenStream> = entries.collect();
    if entries.is_empty() {
        return TokenStream::new();
    }
    let key = quote::format_ident!("{key}");
    quote!(#key: [#(#entries,)*],)
}

fn definitions(key: &str, all: &[Definition]) -> TokenStream {
    list(key, all.iter().map(definition))
}

fn definition(definition: &Definition) -> TokenStream {
    let name = &definition.name;
    let value = definition.value.as_ref().map(expression);
    quote!(#name = #value)
}

fn declaration(declaration: &Declaration) -> TokenStream {
    let name = &declaration.name;
    let unit = declaration.unit.as_ref().map(unit);
    let unit = unit.map(|unit| quote!([#unit]));
    let moving = declaration.moving.as_ref().map(|word| quote!(.#word));
    let value = declaration.value.iter().flatten().map(expression);
    quote!(#name #unit #moving #(= #value)*)
}

/// An entry of `fields`.
fn load(load: &Load) -> TokenStream {
    let name = &load.name;
    let vector = load.vector.as_ref().map(expression);
    match load.kind {
        LoadKind::Force => quote!(#name = #vector),
        LoadKind::Moment => quote!(#name = moment(#vector)),
    }
}

/// An entry of `forces` or `moments` of a body.
fn load_of_body(load: &Load) -> TokenStream {
    let name = &load.name;
    let vector = load.vector.as_ref().map(receiver);
    let point = load.point.iter().flatten().map(expression);
    quote!(#name = #vector #(.at(#point))*)
}

fn asked(output: &Ident, system: &System) -> TokenStream {
    if let (true, Some(joints)) = (output == "reactions", &system.held) {
        quote!(#output(#(#joints),*))
    } else if output == "jacobian" {
        let points = system.points.iter().map(expression);
        quote!(#output(#(#points),*))
    } else {
        quote!(#output)
    }
}

fn parts(composition: &Composition) -> TokenStream {
    let parts = composition.parts.iter().flatten().map(|part| {
        let form = receiver(&part.form);
        let mass = part.mass.iter().flatten().map(expression);
        let point = part.point.iter().flatten().map(expression);
        quote!(#form #(.mass(#mass))* #(.at(#point))*)
    });
    quote!(compose([#(#parts),*]))
}

/// How tightly an expression holds together: chains less than signs, these less than all else. What
/// comes last in a chain holds least.
fn strength(expression: &Expression) -> usize {
    match &expression.kind {
        Kind::Chain(_, steps) => steps.last().map_or(7, |step| rank(step.operator)),
        Kind::If(_) => 0,
        Kind::Prefix(..) => 6,
        _ => 7,
    }
}

fn rank(operator: Operator) -> usize {
    match operator {
        Operator::Or => 1,
        Operator::And => 2,
        Operator::Add | Operator::Subtract => 4,
        Operator::Multiply | Operator::Divide => 5,
        _ => 3,
    }
}

/// In parentheses, if it holds together less than it has to.
fn held(inner: &Expression, least: usize) -> TokenStream {
    let tokens = expression(inner);
    if strength(inner) < least {
        quote!((#tokens))
    } else {
        tokens
    }
}

/// What a dot or a bracket may follow.
fn receiver(inner: &Expression) -> TokenStream {
    held(inner, 7)
}

fn expression(whole: &Expression) -> TokenStream {
    let all = |parts: &[Expression]| -> Vec<TokenStream> { parts.iter().map(expression).collect() };
    match &whole.kind {
        Kind::Number(digits) => number(digits),
        Kind::Name(name) => quote!(#name),
        Kind::Text(text) => quote!(#text),
        Kind::Placeholder | Kind::Poisoned => quote!(_),
        Kind::Tuple(parts) => {
            let parts = all(parts);
            quote!((#(#parts),*))
        }
        Kind::List(parts) => {
            let parts = all(parts);
            quote!([#(#parts),*])
        }
        Kind::Unit(operand, written) => {
            let (operand, unit) = (receiver(operand), unit(written));
            quote!(#operand [#unit])
        }
        Kind::Prefix(prefix, operand) => {
            let operand = held(operand, 6);
            match prefix {
                Prefix::Minus => quote!(-#operand),
                Prefix::Not => quote!(!#operand),
            }
        }
        Kind::Chain(first, steps) => chain(first, steps),
        Kind::Call(function, arguments) => {
            let arguments = all(arguments);
            quote!(#function(#(#arguments),*))
        }
        Kind::Method(of, method, arguments) => {
            let (of, arguments) = (receiver(of), all(arguments));
            quote!(#of.#method(#(#arguments),*))
        }
        Kind::Field(of, field) => {
            let of = receiver(of);
            quote!(#of.#field)
        }
        Kind::Record(name, fields) => {
            let fields = fields.iter().map(|(name, value)| {
                let value = expression(value);
                quote!(#name: #value)
            });
            quote!(#name { #(#fields),* })
        }
        Kind::If(parts) => {
            let [condition, first, second] = &**parts;
            let (condition, first, second) =
                (expression(condition), expression(first), expression(second));
            quote!(if #condition { #first } else { #second })
        }
    }
}

/// From left to right: what is there is in parentheses where the next operator holds tighter.
fn chain(first: &Expression, steps: &[Step]) -> TokenStream {
    let (mut all, mut holds) = (expression(first), strength(first));
    for step in steps {
        let rank = rank(step.operator);
        if holds < rank {
            all = quote!((#all));
        }
        let (sign, operand) = (sign(step.operator), held(&step.operand, rank + 1));
        all = quote!(#all #sign #operand);
        holds = rank;
    }
    all
}

/// A literal with these digits; Rust has a digit in front of the point.
fn number(digits: &str) -> TokenStream {
    let digits = match digits.strip_prefix('.') {
        Some(fraction) => format!("0.{fraction}"),
        None => digits.replace(".e", ".0e").replace(".E", ".0E"),
    };
    let literal: Literal = digits.parse().expect("a number that was read");
    TokenTree::Literal(literal).into()
}

fn sign(operator: Operator) -> TokenStream {
    match operator {
        Operator::Add => quote!(+),
        Operator::Subtract => quote!(-),
        Operator::Multiply => quote!(*),
        Operator::Divide => quote!(/),
        Operator::Less => quote!(<),
        Operator::LessOrEqual => quote!(<=),
        Operator::Greater => quote!(>),
        Operator::GreaterOrEqual => quote!(>=),
        Operator::Equal => quote!(==),
        Operator::NotEqual => quote!(!=),
        Operator::And => quote!(&&),
        Operator::Or => quote!(||),
        Operator::Power => quote!(^),
    }
}

/// `kg * m ^ 2 / s`
fn unit(unit: &UnitExpression) -> TokenStream {
    let mut tokens = TokenStream::new();
    for (place, (name, exponent)) in unit.factors.iter().enumerate() {
        let (numerator, denominator) = exponent.parts();
        match (place, numerator < 0) {
            (0, true) => tokens.extend(quote!(1 /)),
            (0, false) => {}
            (_, true) => tokens.extend(quote!(/)),
            (_, false) => tokens.extend(quote!(*)),
        }
        let numerator = Literal::i64_unsuffixed(numerator.abs());
        tokens.extend(
            if *exponent == Fraction::ONE || *exponent == Fraction::ONE.negative() {
                quote!(#name)
            } else if denominator == 1 {
                quote!(#name ^ #numerator)
            } else {
                let denominator = Literal::i64_unsuffixed(denominator);
                quote!(#name ^ (#numerator / #denominator))
            },
        );
    }
    tokens
}

/// As rustfmt lays it out, or as it is if there is no rustfmt.
pub fn laid_out(text: &str) -> String {
    let rustfmt = Command::new("rustfmt")
        .args(["--edition", "2024"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn();
    let formatted = rustfmt.ok().and_then(|mut rustfmt| {
        rustfmt.stdin.take()?.write_all(text.as_bytes()).ok()?;
        let output = rustfmt.wait_with_output().ok()?;
        let text = String::from_utf8(output.stdout).ok()?;
        // in a macro, rustfmt leaves the last comma of a line
        output.status.success().then(|| text.replace(",]", "]"))
    });
    formatted.unwrap_or_else(|| text.to_owned())
}
