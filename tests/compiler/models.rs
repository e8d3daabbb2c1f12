//! `MuJoCo` files that are wrong, each with its error message; and such files damaged at random.

use std::fs;
use std::path::Path;

use proc_macro2::{TokenStream, TokenTree};
use quote::quote;

use crate::files::{Random, errors, mutant};
use crate::from_root::repository;
use mounted::errors::Errors;
use mounted::expand::expand_system;
use mounted::syntax;

/// The path of a file with this text; tests that run at once have files of their own.
pub fn written(name: &str, text: &[u8]) -> String {
    let thread = format!("{:?}", std::thread::current().id());
    let number: String = thread.chars().filter(char::is_ascii_digit).collect();
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let path = folder.join(format!("{name}_{number}.xml"));
    fs::write(&path, text).expect("a folder for tests");
    path.to_str().expect("a path in UTF-8").to_owned()
}

/// What is made of a file with this text.
fn expanded(name: &str, text: &[u8]) -> TokenStream {
    let path = written(name, text);
    expand_system(quote!((::newton_euler) Robot { mjcf: #path }))
}

/// What is said, without the file in front of it.
fn said(tokens: TokenStream) -> Vec<String> {
    let mut found = Vec::new();
    let mut is_next = false;
    for token in tokens {
        match token {
            TokenTree::Ident(word) => is_next |= word == "compile_error",
            TokenTree::Group(group) if is_next => {
                let text: syn::LitStr = syn::parse2(group.stream()).expect("a message");
                let text = text.value();
                let start = text.find(".xml:").map_or(0, |place| place + 5);
                found.push(text[start..].to_owned());
                is_next = false;
            }
            _ => {}
        }
    }
    found
}

fn check(inside: &str, expected: &[&str]) {
    let text = format!("<mujoco>\n{inside}\n</mujoco>");
    let found = said(expanded("wrong", text.as_bytes()));
    assert_eq!(found, expected, "{text}");
}

/// A body on a hinge, with something in it.
pub fn body(inside: &str) -> String {
    format!("<worldbody><body name=\"a\">\n<joint name=\"j\"/>{inside}</body></worldbody>")
}

pub const BALL: &str = "<geom size=\"0.1\"/>";

#[test]
fn what_is_wrong_with_bodies_is_said() {
    check("<worldbody/>", &["1, `<mujoco>`: it has no `<body>`"]);
    check(
        &body(""),
        &[
            "2, `<body>`: it moves, and neither it nor what it carries has mass: write its `<inertial>`",
        ],
    );
    check(
        &body("<inertial pos=\"0 0\" mass=\"1\" diaginertia=\"1 1 1\"/>"),
        &["3, `<inertial>` of body `a`: `pos` has 3 numbers with blanks between, and this has 2"],
    );
    check(
        &body("<inertial mass=\"x\" diaginertia=\"1 1 1\"/>"),
        &["3, `<inertial>` of body `a`: `mass` is a decimal number, and this is `x`"],
    );
    check(
        &body("<inertial mass=\"1\"/>"),
        &["3, `<inertial>` of body `a`: it has no `diaginertia` and no `fullinertia`"],
    );
    check(
        &body("<inertial mass=\"1\" quat=\"0 1 0 0\" fullinertia=\"1 1 1 0 0 0\"/>"),
        &[
            "3, `<inertial>` of body `a`: `fullinertia` is in the axes of the body: leave `diaginertia` and turns out",
        ],
    );
    check(
        &body("<inertial mass=\"1\" diaginertia=\"1 1 3\"/>"),
        &[
            "3, `<inertial>` of body `a`: no body has this inertia: its moment about z is larger than the other two together (3 > 2); is a decimal point out of place? `0.3` instead of `3` would be possible",
        ],
    );
    check(
        &body("<geom type=\"mesh\" mesh=\"m\"/>"),
        &[
            "3, `<geom>` of body `a`: the mass of a mesh is not computed: write `<inertial>`, or `mass=\"0\"`",
        ],
    );
    check(
        &body("<geom type=\"bax\" size=\"1 1 1\"/>"),
        &[
            "3, `<geom>` of body `a`: `type` is one of `sphere`, `capsule`, `cylinder`, `box`, `ellipsoid`, `plane`, `hfield`, `mesh`, `sdf`, and this is `bax`",
        ],
    );
    check(
        &body("<geom type=\"box\"/>"),
        &["3, `<geom>` of body `a`: it has no attribute `size`"],
    );
    check(
        &body("<geom type=\"capsule\" size=\"0.1\" fromto=\"1 1 1 1 1 1\"/>"),
        &["3, `<geom>` of body `a`: `fromto`: both ends are in one place"],
    );
    check(
        &body("<geom size=\"0.1\" colour=\"red\"/>"),
        &["3, `<geom>` of body `a`: there is no attribute `colour`"],
    );
    check(
        &body(&format!(
            "{BALL}<body mocap=\"true\" gravcomp=\"1\" quat=\"0 0 0 0\"/>"
        )),
        &[
            "3, `<body>` `body_2`: `mocap`: a body that is moved from outside is not read: write its joint `.driven(..)`",
            "3, `<body>` `body_2`: `gravcomp`: compensated gravity is not read: write it in `forces`",
            "3, `<body>` `body_2`: `quat`: the zero vector has no direction",
        ],
    );
    check(
        &body(&format!("{BALL}<body quat=\"1 0 0 0\" euler=\"1 0 0\"/>")),
        &["3, `<body>` `body_2`: it is turned by `quat` already: leave `euler` out"],
    );
    check(
        &body(&format!("{BALL}<body xyaxes=\"1 2 3 2 4 6\"/>")),
        &["3, `<body>` `body_2`: `xyaxes`: these axes are parallel"],
    );
    check(
        &body(&format!("{BALL}<frame/>")),
        &[
            "3, `<frame>`: this stands for other elements: let MuJoCo write them out, by `mj_saveLastXML`",
        ],
    );
    check(
        &body(&format!("{BALL}<body name=\"a\"/>")),
        &["3, `<body>`: the name `a` is taken already"],
    );
}

#[test]
fn what_is_wrong_with_joints_is_said() {
    let joint = |attributes: &str| body(&format!("<joint name=\"k\" {attributes}/>{BALL}"));
    let cases = [
        (
            "type=\"ball\" armature=\"0.1\"",
            "`armature`: an armature of several coordinates is not read: set it to 0, or give the rotor a body of its own",
        ),
        (
            "frictionloss=\"1\"",
            "`frictionloss`: dry friction is not read: set it to 0, and write it in `drives`",
        ),
        (
            "springdamper=\"1 1\"",
            "`springdamper`: springs that are given by times are not read: write `stiffness` and `damping`",
        ),
        (
            "type=\"ball\" stiffness=\"2\"",
            "`stiffness`: a spring of a joint of several coordinates is not read: set it to 0",
        ),
        (
            "type=\"ben\"",
            "`type` is one of `hinge`, `slide`, `ball`, `free`, and this is `ben`",
        ),
        ("axis=\"0 0 0\"", "`axis`: the zero vector has no direction"),
        ("damping=\"1 2\"", "`damping` is one number, and this has 2"),
        ("class=\"arm\"", "there is no class `arm`"),
        (
            "axes=\"0 0 1\"",
            "there is no attribute `axes`; did you mean `axis`?",
        ),
    ];
    for (attributes, expected) in cases {
        check(
            &joint(attributes),
            &[&format!("3, `<joint>` of body `a`: {expected}")],
        );
    }
    check(
        &joint("type=\"free\" damping=\"1\""),
        &[
            "3, `<joint>` of body `a`: `damping`: damping of a free body is not read: set it to 0, and write it in `forces`",
            "3, `<joint>` of body `a`: a free joint is the only one of a body in the world",
        ],
    );
}

#[test]
fn bodies_of_negative_mass_are_named() {
    check(
        &body("<geom size=\"0.1\" mass=\"-1\"/>"),
        &[
            "3, `<geom>` of body `a`: the mass of a body that moves is positive, and that of these parts together is -1",
        ],
    );
}

/// What is said of something beside the bodies, in one of its lines.
fn check_beside(cases: &[(&str, &str)]) {
    for (inside, expected) in cases {
        let text = format!("<mujoco>\n{}\n{inside}\n</mujoco>", body(BALL));
        let found = said(expanded("wrong", text.as_bytes()));
        let expected = format!("4, {expected}");
        assert!(found.contains(&expected), "{found:#?} and {expected}");
    }
}

#[test]
fn what_is_wrong_with_actuators_is_said() {
    check_beside(&[
        (
            "<actuator><muscle joint=\"j\"/></actuator>",
            "`<muscle>`: only `<motor>`, `<position>`, `<velocity>`, `<damper>`, `<general>` are read: write what `muscle` does in `drives`, and leave it out",
        ),
        (
            "<actuator><general joint=\"j\" dyntype=\"filter\"/></actuator>",
            "`<general>`: `dyntype`: actuators with a state of their own are not read",
        ),
        (
            "<actuator><general joint=\"j\" gaintype=\"muscle\"/></actuator>",
            "`<general>`: `gaintype`: `fixed` and `affine` are read, and this is `muscle`",
        ),
        (
            "<actuator><position joint=\"j\" timeconst=\"1\"/></actuator>",
            "`<position>`: `timeconst`: actuators with a state of their own are not read",
        ),
        (
            "<actuator><position joint=\"j\" kv=\"-1\"/></actuator>",
            "`<position>`: `kv` is at least 0",
        ),
        (
            "<actuator><position joint=\"j\" dampratio=\"1\"/></actuator>",
            "`<position>`: `dampratio`: damping by a ratio is not read: write `kv`",
        ),
        (
            "<actuator><general joint=\"j\" gainprm=\"2\" biastype=\"affine\" biasprm=\"0 -2 0.5\"/></actuator>",
            "`<general>`: `biasprm`: beside a spring, a third number above 0 is a damping ratio, and this is not read",
        ),
        (
            "<actuator><motor tendon=\"t\"/></actuator>",
            "`<motor>`: there is no tendon `t`",
        ),
        (
            "<actuator><motor joint=\"l\"/></actuator>",
            "`<motor>`: there is no joint `l`",
        ),
        (
            "<actuator><motor site=\"l\"/></actuator>",
            "`<motor>`: there is no attribute `site`",
        ),
    ]);
}

#[test]
fn what_is_wrong_beside_the_bodies_is_said() {
    check_beside(&[
        (
            "<equality><joint joint1=\"l\"/></equality>",
            "`<joint>`: there is no joint `l`",
        ),
        (
            "<equality><connect body1=\"b\" anchor=\"0 0 0\"/></equality>",
            "`<connect>`: there is no body `b`",
        ),
        (
            "<equality><connect body1=\"a\"/></equality>",
            "`<connect>`: it has no attribute `anchor`",
        ),
        (
            "<tendon><spatial/></tendon>",
            "`<spatial>`: this is not read, and may change the motion",
        ),
        (
            "<tendon><fixed/></tendon>",
            "`<fixed>`: it has no `<joint>` that changes its length",
        ),
        (
            "<option density=\"1.2\"/>",
            "`<option>`: `density`: forces of a fluid are not read: write them in `forces` and `moments`",
        ),
        (
            "<option><flag spring=\"disable\"/></option>",
            "`<flag>`: `spring` cannot be switched off here: leave out what it is about",
        ),
        (
            "<compiler eulerseq=\"xyw\"/>",
            "`<compiler>`: `eulerseq` is three letters of `xyzXYZ`",
        ),
        (
            "<compiler angle=\"grad\"/>",
            "`<compiler>`: `angle` is one of `degree`, `radian`, and this is `grad`",
        ),
        (
            "<compiler balanceinertia=\"true\"/>",
            "`<compiler>`: `balanceinertia`: masses and inertias are those of the file: write them as they are",
        ),
        (
            "<default><default><joint/></default></default>",
            "`<default>`: it has no attribute `class`",
        ),
        (
            "<include file=\"b.xml\"/>",
            "`<include>`: this stands for other elements: let MuJoCo write them out, by `mj_saveLastXML`",
        ),
        (
            "<actuators/>",
            "`<actuators>`: this is not read, and may change the motion; did you mean `actuator`?",
        ),
    ]);
}

/// A file, and all that is said of it.
/// Each letter adds its rotation: after the others if its axis rotates with the body, before them if
/// it is fixed, as in `mju_euler2Quat`.
#[test]
fn axes_of_euler_angles_may_be_fixed_and_rotating_together() {
    let of = |order: &str, angles: &str| {
        let text = format!(
            "<mujoco><compiler eulerseq=\"{order}\"/><worldbody><body euler=\"{angles}\"><joint/><geom size=\".1\" pos=\"1 2 3\"/></body></worldbody></mujoco>"
        );
        expanded("euler", text.as_bytes()).to_string()
    };
    assert_eq!(of("xYz", "10 20 30"), of("yxz", "20 10 30"));
    assert_eq!(of("ZyX", "10 20 30"), of("xzy", "30 10 20"));
    assert_eq!(of("XYZ", "10 20 30"), of("zyx", "30 20 10"));
    assert_ne!(of("xYz", "10 20 30"), of("xyz", "10 20 30"));
}

fn check_file(text: &str, expected: &[&str]) {
    assert_eq!(said(expanded("wrong", text.as_bytes())), expected, "{text}");
}

#[test]
fn a_file_that_breaks_off_is_told_by_what_it_leaves_open() {
    let whole = format!(
        "<mujoco>\n<!-- > -->\n{}\n</mujoco>",
        body("\n<geom size=\"1\"/>")
    );
    let to = |part: &str| &whole[..whole.find(part).expect("it is there")];
    let cases = [
        (
            "</mujoco>",
            "1: `<mujoco>` is not closed: the file ends before `</mujoco>`",
        ),
        (
            "</body>",
            "3: `<body>` is not closed: the file ends before `</body>`",
        ),
        (
            "=\"1\"/>",
            "5: the file breaks off in `<geom`, which begins here",
        ),
        (
            "ody></worldbody>",
            "5: the file breaks off in `</b`, which begins here",
        ),
        (
            "-->",
            "2: the file breaks off in a comment, which begins here",
        ),
    ];
    for (part, expected) in cases {
        check_file(to(part), &[expected]);
    }
    check_file("", &["1: the file has no element"]);
    check_file(
        "{ \"a\": 1 }",
        &["1: this is no XML, which begins with an element"],
    );
    let second = "4: this stands outside of the first element of the file, which holds all others";
    check_file("<mujoco>\n\n</mujoco>\n<mujoco/>", &[second]);
}

#[test]
fn what_another_mistake_brings_about_is_not_said() {
    let elsewhere =
        "this stands for other elements: let MuJoCo write them out, by `mj_saveLastXML`";
    let of_others = "<actuator><motor joint=\"j\"/></actuator>\n<equality>\
        <connect body1=\"a\" anchor=\"0 0 0\"/></equality>";
    let included = format!("<mujoco>\n<include file=\"b.xml\"/>\n{of_others}</mujoco>");
    check_file(&included, &[&format!("2, `<include>`: {elsewhere}")]);
    let turned = body("<geom size=\"1\"/>").replace("<joint", "<joint type=\"revolute\"");
    let expected = "3, `<joint>` of body `a`: `type` is one of `hinge`, `slide`, `ball`, `free`, and this is \
                    `revolute`; did you mean `hinge`?";
    check_file(
        &format!("<mujoco>\n{turned}\n{of_others}</mujoco>"),
        &[expected],
    );
}

#[test]
fn what_equations_say_of_a_coupling_has_its_line() {
    let geom = "<geom size=\"1\" pos=\"1 0 0\"/>";
    let coupled = |inside: &str| {
        format!(
            "<mujoco>\n{}\n<equality>\n{inside}\n</equality>\n</mujoco>",
            body(geom)
        )
    };
    let one = "<joint joint1=\"j\" polycoef=\"0\"/>";
    let twice = "6, `<joint>`: `coupling_2` restrains the same motion as `coupling_1`: leave one of them out";
    check_file(&coupled(&format!("{one}\n{one}")), &[twice]);
    let itself = "5, `<joint>`: `coupling_1` does not depend on where the body is or how it moves: no load can \
                  keep it at zero";
    check_file(&coupled("<joint joint1=\"j\" joint2=\"j\"/>"), &[itself]);
    let large =
        "5, `<joint>`: `1e400` is out of the range of `f64`, which is about 5e-324 to 1.8e308";
    check_file(
        &coupled("<joint joint1=\"j\" polycoef=\"1e400\"/>"),
        &[large],
    );
}

#[test]
fn no_model_makes_the_compiler_panic() {
    let folder = repository().join("tests/mjcf");
    let text = fs::read_to_string(folder.join("quadruped.xml")).expect("the file is there");
    let (mut random, mut refused) = (Random(0x2545_f491_4f6c_dd1d), 0);
    for number in 0..500 {
        let bytes = mutant(&text, &mut random);
        let is_wrong = !is_read("mutant", &bytes);
        refused += usize::from(is_wrong);
        // to derive equations takes longer than to read
        if number % 50 == 0 {
            let tokens = expanded("mutant", &bytes);
            assert!(errors(&tokens) > 0 || !is_wrong);
        }
    }
    assert!((100..500).contains(&refused), "{refused}");
}

/// Whether a file with this text is read without mistakes.
fn is_read(name: &str, text: &[u8]) -> bool {
    let path = written(name, text);
    let mut errors = Errors::default();
    syntax::parse_system(quote!((::newton_euler) Robot { mjcf: #path }), &mut errors);
    errors.finish().is_none()
}
