//! Bodies from practice, each described in at most 45 lines, and what is known of their motion
//! without the macro.
//!
//! These are fifteen things that engineers model, in their own words. Those that are examples or
//! recipes are tested there.
#![allow(missing_docs, reason = "tests")]
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

mod bicycle;
mod car;
mod driven_pivot;
mod gyroscope;
mod monte_carlo;
mod satellite;
mod scheduled;
mod slung_load;
mod two_cables;

/// What is described, where, and the name of its description.
const PRACTICE: [(&str, &str, &str); 15] = [
    (
        "an aircraft by coefficients",
        include_str!("../../examples/level_turn.rs"),
        "Navion",
    ),
    (
        "a vehicle under water",
        include_str!("../../examples/auv.rs"),
        "Auv",
    ),
    (
        "a rocket",
        include_str!("../../examples/rocket.rs"),
        "Rocket",
    ),
    (
        "a satellite with wheels and magnetorquers",
        include_str!("satellite.rs"),
        "Satellite",
    ),
    ("a car with a tire formula", include_str!("car.rs"), "Car"),
    ("a driven pivot", include_str!("driven_pivot.rs"), "Shaken"),
    (
        "a motor that lags, with a controller",
        include_str!("../../runtime/src/recipes.md"),
        "Arm",
    ),
    (
        "bouncing",
        include_str!("../../runtime/src/recipes.md"),
        "Ball",
    ),
    ("a gyroscope", include_str!("gyroscope.rs"), "Gyroscope"),
    ("two cables", include_str!("two_cables.rs"), "Bar"),
    (
        "a double pendulum",
        include_str!("../../examples/double_pendulum.rs"),
        "DoublePendulum",
    ),
    ("a slung load", include_str!("slung_load.rs"), "Carrier"),
    (
        "many runs and a table of them",
        include_str!("monte_carlo.rs"),
        "Ball",
    ),
    (
        "a linear-quadratic regulator",
        include_str!("../../examples/lqr.rs"),
        "Quadrotor",
    ),
    ("loads by a schedule", include_str!("scheduled.rs"), "Model"),
];

/// The descriptions of this name in a text, from the word of the macro to the parenthesis that closes it.
fn descriptions<'a>(text: &'a str, name: &str) -> Vec<&'a str> {
    let starts = ["rigid_body!", "rigid_system!"].map(|word| {
        let found = text.match_indices(word).map(|(at, _)| at);
        found.collect::<Vec<_>>()
    });
    let named = starts.concat().into_iter().filter_map(|start| {
        let inside = text[start..].split_once('(')?.1;
        let rest = inside.strip_prefix(name)?;
        rest.starts_with([' ', ':']).then_some(&text[start..])
    });
    named.map(closed).collect()
}

/// Until as many parentheses are closed as are open.
fn closed(text: &str) -> &str {
    let mut open = 0;
    let end = text.char_indices().find(|(_, letter)| {
        open += i32::from(*letter == '(') - i32::from(*letter == ')');
        *letter == ')' && open == 0
    });
    &text[..=end.expect("it is closed").0]
}

#[test]
fn descriptions_are_short() {
    for (what, text, name) in PRACTICE {
        let found = descriptions(text, name);
        assert!(!found.is_empty(), "{what}");
        for description in found {
            let lines = description.lines().count();
            println!("{lines:3} lines: {what}");
            assert!(lines > 3 && lines <= 45, "{what}: {lines} lines");
        }
        for written in ["impl State for", "impl Coordinates for"] {
            assert!(!text.contains(written), "{what} writes a state by hand");
        }
    }
}
