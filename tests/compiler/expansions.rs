//! Expansions in readable form: a few in full, and the lengths of all.

use std::fs;
use std::time::Instant;

use proc_macro2::{Literal, TokenStream, TokenTree};
use quote::{format_ident, quote};

use crate::descriptions::{many_forces, quadrotor};
use crate::from_root::repository;
use crate::{expand_description, expand_system, pretty, printed};

fn plank() -> TokenStream {
    quote!(Plank {
        doc: "A plank thrown in a vertical plane.",
        motion: planar,
        params: [length = 2[m]],
        mass: 4[kg],
        inertia: mass * length.powi(2) / 12,
        fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
        outputs: [energy, momentum],
    })
}

fn satellite() -> TokenStream {
    quote!(Satellite {
        doc: "A satellite with a full inertia tensor and three control torques.",
        motion: rotation,
        inputs: [torque = body(_, _, _)[N * m]],
        inertia: tensor {
            xx: 1.3,
            yy: 1.7,
            zz: 2.1,
            xy: -0.12,
            yz: -0.05,
            zx: 0.07
        }[kg * m ^ 2],
        moments: [control = torque],
        outputs: [balance],
    })
}

fn top() -> TokenStream {
    quote!(Top::<T> {
        doc: "A heavy symmetric top, for any scalar.",
        motion: fixed_point(foot),
        params: [length = 0.1[m]],
        mass: 0.3[kg],
        inertia: principal(0.002, 0.002, 0.001)[kg * m ^ 2],
        points: [foot = (0, 0, -length)],
        fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    })
}

fn towed() -> TokenStream {
    quote!(Towed {
        doc: "A sledge on a rope that pulls with a constant force: its motion in closed form.",
        motion: planar,
        params: [pull = 40[N]],
        mass: 12[kg],
        inertia: 2[kg * m ^ 2],
        points: [hook = (0.5, 0.1)[m]],
        forces: [rope = world(pull, 0).at(hook)],
        outputs: [flow],
    })
}

fn glider() -> TokenStream {
    quote!(Glider {
        doc: "A body that swings about a point, braked, with the series of its motion.",
        motion: fixed_point(hook),
        params: [drag = 0.02[N * m * s ^ 2]],
        mass: 0.5[kg],
        inertia: principal(0.02, 0.03, 0.04)[kg * m ^ 2],
        points: [hook = (0, 0, 0.2)],
        fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
        moments: [brake = -drag * angular_velocity.norm() * angular_velocity],
        outputs: [taylor],
    })
}

fn gyroscope() -> TokenStream {
    quote!(Gyroscope {
        doc: "A heavy symmetric top, with the series of its motion in axes that do not spin with it.",
        motion: fixed_point(foot),
        params: [rotor = 0.0005[kg * m ^ 2], across = 0.0004[kg * m ^ 2]],
        mass: 0.2[kg],
        inertia: principal(across, across, rotor),
        points: [foot = (0, 0, -0.05)],
        fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
        outputs: [taylor],
    })
}

fn double_pendulum() -> TokenStream {
    quote!(DoublePendulum {
        doc: "Two arms in the plane, hinged to each other and to the ground.",
        motion: planar,
        bodies: [
            upper {
                mass: 1.2[kg],
                inertia: 0.04[kg * m ^ 2],
                points: [hinge = (-0.28, 0)[m], tip = (0.32, 0)[m]],
            },
            lower {
                mass: 0.8[kg],
                inertia: 0.015[kg * m ^ 2],
                points: [hinge = (-0.22, 0)[m]],
            },
        ],
        joints: [
            shoulder = revolute(world(0, 0), upper.hinge),
            elbow = revolute(upper.tip, lower.hinge),
        ],
        fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    })
}

fn slider_crank() -> TokenStream {
    quote!(SliderCrank {
        doc: "A crank that drives a slider by a rod: a closed loop.",
        motion: planar,
        inputs: [torque[N * m]],
        bodies: [
            crank {
                inertia: 0.002[kg * m ^ 2],
                mass: 0.5[kg],
                points: [pin = (0.05, 0)[m]],
            },
            rod {
                mass: 0.4[kg],
                inertia: 0.0012[kg * m ^ 2],
                points: [big = (-0.06, 0)[m], small = (0.12, 0)[m]],
            },
            slider { mass: 0.3[kg] },
        ],
        joints: [
            bearing = revolute(world(0, 0), crank.G),
            big_end = revolute(crank.pin, rod.big),
            guide = prismatic(world(0, 0), slider.G, body(1, 0)),
            small_end = revolute(rod.small, slider.G),
        ],
        drives: [motor = torque.on(bearing)],
        outputs: [reactions(small_end)],
    })
}

/// Compares with the file of that name; `BLESS=1` writes it.
fn check(name: &str, expansion: &str) {
    let path = repository()
        .join("tests/compiler/snapshots")
        .join(format!("{name}.rs"));
    if std::env::var_os("BLESS").is_some() {
        fs::write(&path, expansion).expect("a writable snapshot");
    }
    let expected = fs::read_to_string(&path).expect("a snapshot: run with BLESS=1 to write it");
    assert_eq!(
        expansion, expected,
        "the expansion of {name} has changed: run with BLESS=1 and review the difference"
    );
}

fn bodies() -> [(&'static str, TokenStream); 7] {
    [
        ("quadrotor", quadrotor()),
        ("plank", plank()),
        ("satellite", satellite()),
        ("top", top()),
        ("towed", towed()),
        ("glider", glider()),
        ("gyroscope", gyroscope()),
    ]
}

#[test]
fn snapshots() {
    for (name, description) in bodies() {
        check(name, &pretty(description));
    }
    check(
        "double_pendulum",
        &printed(expand_system(double_pendulum())),
    );
    // of a loop, the accelerations: projection and reactions repeat most of their lines
    let crank = printed(expand_system(slider_crank()));
    check("slider_crank", implementation(&crank, "RigidBody"));
}

/// The implementation of a trait in an expansion.
fn implementation<'e>(expansion: &'e str, of: &str) -> &'e str {
    let start = format!("\nimpl ::newton_euler::private::{of} for ");
    let (_, rest) = expansion.split_at(expansion.find(&start).expect("an implementation") + 1);
    let end = rest.find("\n}\n").expect("its end");
    &rest[..end + "\n}\n".len()]
}

#[test]
fn the_same_description_gives_the_same_expansion() {
    let bodies = bodies().map(|(_, body)| (expand_description as fn(_) -> _, body));
    let systems = [double_pendulum(), slider_crank()];
    let systems = systems.map(|system| (expand_system as fn(_) -> _, system));
    for (expand, description) in bodies.into_iter().chain(systems) {
        let first = printed(expand(description.clone()));
        // every hash map has a seed of its own
        for _ in 0..8 {
            assert_eq!(printed(expand(description.clone())), first);
        }
    }
}

/// The first page shows a description, and behind it the lines that come out of it.
#[test]
fn the_first_page_shows_what_comes_out() {
    let page = repository().join("README.md");
    let page = fs::read_to_string(page).expect("the first page");
    let blocks: Vec<&str> = page.split("```").skip(1).step_by(2).collect();
    let described = blocks.iter().find(|block| block.contains("rigid_body!("));
    let (_, rest) = described.unwrap().split_once("rigid_body!(").unwrap();
    let (description, _) = rest.split_once("\n});").expect("its end");
    let expansion = pretty(format!("{description}\n}}").parse().expect("tokens"));
    let shown = blocks.iter().find(|block| block.starts_with("rust,ignore"));
    let shown: Vec<&str> = shown.unwrap().lines().skip(1).map(str::trim).collect();
    let lines: Vec<&str> = expansion.lines().map(str::trim).collect();
    assert!(
        shown.len() > 5 && lines.windows(shown.len()).any(|lines| lines == shown),
        "{shown:#?} are not lines of {expansion}"
    );
}

fn lines_of(expansion: &str, from: &str) -> usize {
    let body = expansion.split_once(from).expect("the function is there").1;
    let indent = "\n        }";
    body.split_once(indent).expect("it ends").0.lines().count() + 1
}

#[test]
fn a_quadrotor_is_a_page() {
    let expansion = pretty(quadrotor());
    assert!(
        expansion.lines().count() <= 212,
        "{} lines",
        expansion.lines().count()
    );
    let acceleration = lines_of(&expansion, "fn acceleration");
    assert!(acceleration <= 40, "{acceleration} lines");
}

/// The equations of a double pendulum can be checked by hand.
#[test]
fn a_double_pendulum_is_a_page() {
    let expansion = printed(expand_system(double_pendulum()));
    let acceleration = lines_of(&expansion, "fn acceleration");
    assert!(acceleration <= 50, "{acceleration} lines");
}

/// Chains of 8, 16 and 32 arms in the plane.
#[test]
fn the_code_of_a_chain_grows_with_the_number_of_bodies() {
    let lines = [8, 16, 32].map(|count| {
        let body = |body: usize| {
            let points = "points: [from = (-0.2, 0)[m], to = (0.2, 0)[m]]";
            format!("b{body} {{ mass: 1[kg], inertia: 0.02[kg * m ^ 2], {points} }},")
        };
        let joint = |body: usize| match body {
            0 => "j0 = revolute(world(0, 0), b0.from),".to_owned(),
            _ => format!("j{body} = revolute(b{}.to, b{body}.from),", body - 1),
        };
        let bodies: String = (0..count).map(body).collect();
        let joints: String = (0..count).map(joint).collect();
        let text = format!("Chain {{ motion: planar, bodies: [{bodies}], joints: [{joints}] }}");
        let expansion = printed(expand_system(text.parse().expect("tokens")));
        lines_of(&expansion, "fn acceleration")
    });
    let [first, second] = [lines[1] - lines[0], lines[2] - lines[1]];
    // lines with longer names break more often
    assert!(second <= 2 * first + first / 20, "{lines:?}");
}

/// Twelve bodies in water, on ball joints: too many for a proof by residues, which it does not need.
#[test]
fn a_long_chain_in_water_is_solved_with_added_inertia() {
    let count = 12;
    let body = |body: usize| {
        let points = "points: [p = (0.1, 0.2, 0.3), q = (-0.1, 0.1, 0.25)]";
        let force = "(-0.3[kg] * q.acceleration()).at(q)";
        let moment = "-0.1[kg * m ^ 2] * angular_acceleration";
        format!(
            "b{body} {{ mass: 1[kg], inertia: principal(0.1, 0.2, 0.25)[kg * m ^ 2], {points}, \
             forces: [water = {force}], moments: [turned = {moment}] }},"
        )
    };
    let joint = |body: usize| match body {
        0 => "j0 = free(b0),".to_owned(),
        _ => format!("j{body} = spherical(b{}.q, b{body}.p),", body - 1),
    };
    let bodies: String = (0..count).map(body).collect();
    let joints: String = (0..count).map(joint).collect();
    let text = format!("Chain {{ bodies: [{bodies}], joints: [{joints}] }}");
    let expansion = printed(expand_system(text.parse().expect("tokens")));
    assert!(!expansion.contains("compile_error"), "{expansion}");
    let lines = lines_of(&expansion, "fn acceleration");
    assert!(lines <= 6600, "{lines} lines");
}

/// A product of series for each of the two components of the angular velocity that move: so each rate is a sum of two, those of attitude
/// and of what the weight turns, and six rates fill eight lanes. Without symmetry seven rates are sums of three.
#[test]
fn series_of_a_symmetric_body_take_fewer_products() {
    let products = |description: TokenStream| {
        let expansion = expand_description(description).to_string();
        let rest = expansion.split_once(":: Products < A ,").expect("series").1;
        rest.split(',').next().map(|count| count.trim().to_owned())
    };
    assert_eq!(products(gyroscope()).as_deref(), Some("16"));
    let hidden = quote!(Gyroscope {
        motion: fixed_point(foot),
        params: [
            rotor = 0.0005[kg * m ^ 2],
            across = 0.0004[kg * m ^ 2],
            again = 0.0004[kg * m ^ 2]
        ],
        mass: 0.2[kg],
        inertia: principal(across, again, rotor),
        points: [foot = (0, 0, -0.05)],
        fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
        outputs: [taylor],
    });
    assert_eq!(products(hidden).as_deref(), Some("24"));
}

/// A body of `count` parts, at places and with masses that differ.
fn many_parts(count: usize) -> TokenStream {
    let numbers = (1..=count).map(Literal::usize_unsuffixed);
    quote!(Heap {
        motion: spatial,
        params: [m = 0.1[kg], d = 0.3[m]],
        inertia: compose([
            #(cylinder(0.05[m], d).mass(m + 0.01 * #numbers)
                .at((0.01 * #numbers, d, -0.1))),*
        ]),
    })
}

#[test]
fn expansions_grow_linearly() {
    let length = |count: usize| expand_description(many_forces(count)).to_string().len();
    let (small, large) = (length(100), length(1000));
    assert!(
        large <= 11 * small,
        "{small} bytes for 100 forces, {large} for 1000"
    );
    let length = |count: usize| expand_description(many_parts(count)).to_string().len();
    let (small, large) = (length(30), length(300));
    assert!(
        large <= 11 * small,
        "{small} bytes for 30 parts, {large} for 300"
    );
}

/// A body with `count` dampers, whose laws are not linear.
fn many_dampers(count: usize) -> TokenStream {
    let names: Vec<_> = (0..count).map(|i| format_ident!("damper_{i}")).collect();
    let points: Vec<_> = (0..count).map(|i| format_ident!("point_{i}")).collect();
    let offsets = (1..=count).map(Literal::usize_unsuffixed);
    quote!(Damped {
        motion: spatial,
        mass: 3[kg],
        inertia: principal(1.3, 1.7, 2.1)[kg * m ^ 2],
        points: [#(#points = (0.01 * #offsets, 0.2, -0.1)),*],
        forces: [#(#names = (-0.1[kg / m] * #points.velocity().norm() * #points.velocity()).at(#points)),*],
    })
}

/// The most `let`s and the most statements of one block.
fn longest_block(tokens: TokenStream) -> [usize; 2] {
    let (mut here, mut most) = ([0, 0], [0, 0]);
    for token in tokens {
        match token {
            TokenTree::Ident(word) if word == "let" => here[0] += 1,
            TokenTree::Punct(mark) if mark.as_char() == ';' => here[1] += 1,
            TokenTree::Group(group) => {
                let inner = longest_block(group.stream());
                most = [0, 1].map(|kind| inner[kind].max(most[kind]));
            }
            _ => {}
        }
    }
    [0, 1].map(|kind| here[kind].max(most[kind]))
}

/// Each `let` is a scope within the one before it, which debug information follows by recursion.
#[test]
fn scopes_of_long_functions_are_not_deep() {
    let [scopes, statements] = longest_block(expand_description(many_dampers(170)));
    assert!(statements > 2100, "{statements} statements");
    assert!(scopes < 100, "{scopes} scopes of {statements} statements");
}

/// Ten times the forces in about ten times the time: least of a few, in one run. What is quadratic takes a hundred times.
#[test]
fn expansion_takes_linear_time() {
    let least = |count: usize| {
        let description = many_forces(count);
        let once = || {
            let start = Instant::now();
            let expansion = expand_description(description.clone());
            (start.elapsed(), expansion.is_empty()).0
        };
        (0..3).map(|_| once()).min().expect("three times")
    };
    let (small, large) = (least(100), least(1000));
    assert!(
        large <= 25 * small,
        "{small:?} for 100 forces, {large:?} for 1000"
    );
}

/// A second `let` of one name would hide the first from what is computed after it.
#[test]
fn names_in_the_constructor_are_distinct() {
    let gate = quote!(Gate {
        motion: fixed_axis(p, world(0, 0, 1)).at(world(a, 0, 1)),
        params: [a = 0.3, b = -0.8],
        mass: 1.5,
        inertia: principal(1, 2, 2.5),
        points: [p = (-a, -0.3, 0), q = (-a, -0.3, a), s = (-a, -a, a)],
        fields: [weight = mass * world(0.1, -9.8, 0.5)],
        forces: [push = body(1, 2, -3).at(q)],
        reactions: [
            hold = world(_, _, -b).at(p),
            rail = world(0, -b, _).at(s),
            guide = moment(body(_, _, 0.2))
        ],
        outputs: [balance, reactions],
    });
    let code = pretty(gate);
    let constructor = code.split("fn new(").nth(1).expect("there are params");
    let constructor = constructor.split("fn params(").next().unwrap_or_default();
    let lets = constructor
        .lines()
        .filter_map(|line| line.trim().strip_prefix("let ")?.split(" = ").next());
    let mut names: Vec<&str> = lets.collect();
    let count = names.len();
    names.sort_unstable();
    names.dedup();
    assert!(count > 10);
    assert_eq!(names.len(), count, "{constructor}");
}

/// Beyond the stated limit there is one error, whatever else is in the description.
#[test]
fn descriptions_have_a_size() {
    let tokens = expand_description(many_forces(2000)).to_string();
    assert!(
        tokens.contains("here this description has more than 50000 tokens"),
        "{tokens}"
    );
    assert_eq!(tokens.matches("compile_error").count(), 1);
}

/// A line of such a number is no case to be read in `tests/compile_fail`.
#[test]
fn numbers_have_a_length() {
    let with_mass = |digits: usize| {
        let mass: proc_macro2::Literal = format!("0.{}", "1".repeat(digits)).parse().unwrap();
        expand_description(quote!(Body { motion: planar_translation, mass: #mass })).to_string()
    };
    assert!(!with_mass(1100).contains("compile_error"));
    let tokens = with_mass(1300);
    assert!(tokens.contains("a number of more than 1200 digits: `f64` keeps 17 of them"));
    assert_eq!(tokens.matches("compile_error").count(), 1);
}
