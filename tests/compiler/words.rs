//! Units, powers and numbers near the ends of their domains, and what the compiler says about them.

use crate::expand_description;

/// What the compiler says of a particle in the plane with these entries; nothing if it is accepted.
fn said_of(entries: &str) -> Vec<String> {
    let description = format!("Particle {{ motion: planar_translation, mass: 1[kg], {entries} }}");
    let tokens = expand_description(description.parse().expect("tokens"));
    let text = tokens.to_string();
    let errors = text.split("compile_error ! { \"").skip(1);
    let messages = errors.filter_map(|rest| rest.split("\" ").next());
    messages.map(str::to_owned).collect()
}

/// The components of a force in N that folds, as they are emitted: the mass is 1 kg.
fn folded(x: &str, y: &str) -> String {
    let entries = format!("forces: [push = world(({x}) * 1[N], ({y}) * 1[N])]");
    let description = format!("Particle {{ motion: planar_translation, mass: 1[kg], {entries} }}");
    let text = expand_description(description.parse().expect("tokens")).to_string();
    let body = text.split("fn acceleration").nth(1).expect("a function");
    let result = body
        .split('{')
        .nth(1)
        .and_then(|body| body.split('}').next());
    result.expect("its body").replace(' ', "")
}

#[test]
fn exponents_of_units_are_fractions_in_lowest_terms() {
    for (exponent, reduced) in [
        ("16/12", "4/3"),
        ("4/3", "4/3"),
        ("-8/-6", "4/3"),
        ("1000000/500000", "2"),
        ("3/-2", "-3/2"),
        ("0/3", "0"),
        ("-0", "0"),
    ] {
        let entries = format!(
            "params: [a = 2[m ^ ({exponent})]],
             forces: [push = world(a - 1[m].powf({reduced}), 0[m ^ ({reduced})]) * 1[N / m ^ ({reduced})]]"
        );
        assert_eq!(said_of(&entries), [""; 0], "{exponent}");
    }
    for (power, unit) in [
        ("a.powf(4 / 3)", "m ^ (4/3)"),
        ("a.powf(-1 / 24)", "1 / m ^ (1/24)"),
        ("a.cbrt().cbrt()", "m ^ (1/9)"),
        ("a.powi(2).sqrt()", "m"),
        ("1[kg ^ (1/2)].recip()", "1 / kg ^ (1/2)"),
        ("a.powf(3 / 2) / a.sqrt()", "m"),
    ] {
        let entries = format!("params: [a = 2[m]], forces: [push = world({power}, 0)]");
        let expected = format!("a force is in N, and this is in {unit}");
        assert_eq!(said_of(&entries), [expected], "{power}");
    }
    assert_eq!(
        folded("8[mm ^ (1/3)].powi(3) * 1[1 / m]", "0"),
        "::core::convert::Into::into([0.512,0.0])"
    );
}

#[test]
fn exponents_that_are_none_are_refused() {
    for (exponent, said) in [
        ("3/0", "nothing can be divided by zero"),
        ("1/99999999999999999999", "the exponent of a unit"),
        (
            "9223372036854775807/-9223372036854775808",
            "the exponent of a unit",
        ),
        ("1/13", "the exponent of a unit"),
        ("13", "the exponent of a unit"),
        ("1/2/3", "the exponent of a unit"),
        ("/2", "the exponent of a unit"),
        ("2/", "the exponent of a unit"),
    ] {
        let entries = format!("params: [a = 1[m ^ ({exponent})]]");
        let messages = said_of(&entries);
        assert_eq!(messages.len(), 1, "{exponent}: {messages:?}");
        assert!(messages[0].starts_with(said), "{exponent}: {messages:?}");
    }
    // what is too large is refused, and does not fit everything from there on
    for power in [
        "a.powi(64).powi(64)",
        "a.powi(64).powf(0.001).cbrt().cbrt()",
        "a.powi(-64).powf(50)",
        "a.powi(60).powi(16) * a.powi(60)",
        "(b * a.powi(60).powi(16)).dot(b * a.powi(60))",
    ] {
        let entries = format!(
            "params: [a = 1[m]], locals: [b = world(1, 0)[m]], forces: [push = world({power}, 0)]"
        );
        let messages = said_of(&entries);
        assert_eq!(messages.len(), 1, "{power}: {messages:?}");
        let is_said =
            messages[0].contains("exponent beyond 1000") || messages[0].contains("this power");
        assert!(is_said, "{power}: {messages:?}");
    }
}

/// What parameters bring to where a function has no value is said at the function.
#[test]
fn values_that_do_not_exist() {
    for (value, said) in [
        ("x.sqrt()", "`sqrt` of -2 has no value"),
        ("x.ln()", "`ln` of -2 has no value"),
        ("x.asin()", "`asin` of -2 has no value"),
        (
            "x.powf(0.5)",
            "`powf` of -2 has no value: negative numbers have whole powers, and this exponent is 0.5",
        ),
        (
            "(x + 2).powf(-3)",
            "`powf` of 0 has no value: it divides by it",
        ),
        (
            "(x + 2).powi(-3)",
            "`powi` of 0 has no value: it divides by it",
        ),
        (
            "(x + 2).recip()",
            "`recip` of 0 has no value: it divides by it",
        ),
        ("(x + 2).ln()", "`ln` of 0 has no value"),
        (
            "3 / (x + 2)",
            "this is zero, and nothing can be divided by it",
        ),
        (
            "(-1000 * x).exp()",
            "`exp` of 2000 has no value: it is far beyond the range of `f64`",
        ),
    ] {
        let literal = value.replace('x', "(-2)").replace("e(-2)p", "exp");
        let messages = said_of(&format!("forces: [push = world({literal} * 1[N], 0)]"));
        assert_eq!(messages, [said], "{literal}");
        let defaults = format!("params: [x = -2], forces: [push = world({value} * 1[N], 0)]");
        let expected = format!("with the defaults of the parameters, {said}");
        assert_eq!(said_of(&defaults), [expected], "{value}");
    }
    for value in [
        "x.powf(3)",
        "x.powf(n)",
        "if x > 0 { x.sqrt() } else { 1 }",
        "x.cbrt()",
        "x.atan2(0)",
    ] {
        let entries = format!("params: [x = -2, n = 3], forces: [push = world({value} * 1[N], 0)]");
        assert_eq!(said_of(&entries), [""; 0], "{value}");
    }
}

#[test]
fn constants_fold_to_what_they_are() {
    for (x, y, folded_to) in [
        ("(-2).powf(3)", "(-2).powf(-2)", "[-8.0,0.25]"),
        ("0.powf(0)", "(-8).cbrt()", "[1.0,-2.0]"),
        (
            "1e80 * (1e-70 * PI).sin() * 1e-10",
            "PI.sin()",
            "[3.141592653589793,0.0]",
        ),
        (
            "1e200 * ((1 + 1e-190).sqrt() - 1) * 1e-10",
            "(60[deg]).cos()",
            "[0.5,0.5]",
        ),
        (
            "(2.sqrt() * 2.sqrt()).floor()",
            "1e300 * (1 + 1e-300).ln()",
            "[2.0,1.0]",
        ),
        ("0.atan2(0)", "(-3).hypot(4)", "[0.0,5.0]"),
        (
            "(7e40 * PI + PI).sin()",
            "(9e90 * PI + PI / 6).sin()",
            "[0.0,0.5]",
        ),
        ("1000.tanh()", "(-1e7).tanh()", "[1.0,-1.0]"),
        ("1 + (-2000).exp()", "1e30 * 1e-30.tanh()", "[1.0,1.0]"),
        (
            "800.exp() * (-800).exp()",
            "(1000.ln() / 10.ln()).floor()",
            "[1.0,3.0]",
        ),
        (
            "1e60 * (PI + 1e-60).sin()",
            "1e300.sin()",
            "[-1.0,-0.985750425160377]",
        ),
    ] {
        assert_eq!(
            folded(x, y),
            format!("::core::convert::Into::into({folded_to})"),
            "{x}, {y}"
        );
    }
}

/// The force by an expression of an input c and a parameter p, as it is emitted.
fn force(value: &str) -> String {
    let description = format!(
        "Particle {{ motion: planar_translation, mass: 1[kg], inputs: [c], params: [p = 2],
         forces: [push = world(({value}) * 1[N], 0)] }}"
    );
    let text = expand_description(description.parse().expect("tokens")).to_string();
    let body = text.split("fn acceleration").nth(1).expect("a function");
    let after = body.split_once('{').expect("its body").1;
    let end = after.find("impl ").expect("the next item");
    after[..end].replace(' ', "")
}

/// What is folded, and what keeps the gap where it has no value.
#[test]
fn what_cancels() {
    for (value, folded_to) in [
        ("c / c", "1.0"),
        ("c * (1 / c)", "1.0"),
        ("c * c.recip()", "1.0"),
        ("c * c.powi(-1)", "1.0"),
        ("3 * (c + 1) / (c + 1)", "3.0"),
        ("p / p", "1.0"),
        ("p * p / p - p", "0.0"),
        ("c - c", "0.0"),
        ("0 * c", "0.0"),
        ("0 / c", "0.0"),
        ("0 * c.ln()", "0.0"),
        ("c.sin() / c - c.sin() / c", "0.0"),
        ("c.powi(0)", "1.0"),
        ("c.powf(0)", "1.0"),
    ] {
        assert_eq!(
            force(value),
            format!("::core::convert::Into::into([{folded_to},0.0])}}}}"),
            "{value}"
        );
    }
    for value in [
        "c.sin() / c",
        "c * c / c",
        "(c + 1) / c",
        "c.sqrt() * c.sqrt()",
        "(c * c).sqrt()",
        "c.exp().ln()",
        "(c * c - 1) / (c - 1)",
        "c.tan() / c.sin()",
        "if c == 0 { 1 } else { c.sin() / c }",
    ] {
        let kept = force(value);
        assert!(kept.contains("input"), "{value}: {kept}");
    }
}

/// Equal constants that no identity in use tells to be equal are equal, and what is not known of them is said so.
#[test]
fn constants_that_nobody_tells_apart() {
    for (left, right) in [
        ("3.sqrt()", "3.powf(0.5)"),
        ("2.cbrt().powi(3)", "2"),
        ("2.ln() + 3.ln()", "6.ln()"),
        ("1 + 2.sqrt()", "(3 + 2 * 2.sqrt()).sqrt()"),
    ] {
        for (comparison, holds) in [("==", true), ("!=", false), ("<", false), (">=", true)] {
            let value = format!("if {left} {comparison} {right} {{ 3 }} else {{ 2 }}");
            let expected = if holds { "3.0" } else { "2.0" };
            assert!(folded(&value, "0").contains(expected), "{value}");
        }
        let root = format!("forces: [push = world(1 + ({left} - ({right})).sqrt(), 0)]");
        let said = said_of(&root);
        assert!(
            said.iter().any(|text| text.contains("is not known here")),
            "{said:?}"
        );
    }
}

/// A unit is one with a name, one with a name over a base unit, or a product of base units.
#[test]
fn units_are_spelt_as_readers_would() {
    for (written, shown) in [
        ("N * s / m", "kg / s"),
        ("J / s ^ 2", "W / s"),
        ("kg * m / s ^ 3", "N / s"),
        ("kg / s ^ 2", "N / m"),
        ("J / K", "N * m / K"),
        ("V / A", "V / A"),
        ("Pa * s", "kg / (m * s)"),
        ("N * s", "kg * m / s"),
        ("J * s", "N * m * s"),
        ("kg * m ^ 2", "kg * m ^ 2"),
        ("C / s", "A"),
        ("m / s ^ 2", "m / s ^ 2: multiply it by a mass"),
    ] {
        let entries = format!("forces: [push = world(1[{written}], 0)]");
        let expected = format!("a force is in N, and this is in {shown}");
        assert_eq!(said_of(&entries), [expected], "{written}");
    }
}
