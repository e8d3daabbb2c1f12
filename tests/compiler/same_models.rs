//! `MuJoCo` files in short, and the same written out. `MuJoCo` 4.0.0 compiles both of each pair to
//! the same numbers; where these are not obvious, they are told.

use proc_macro2::TokenStream;
use quote::quote;

use crate::models::{BALL, body, written};
use crate::text;
use mounted::errors::Errors;
use mounted::syntax;

/// The description of a file with this text.
fn described(inside: &str) -> String {
    let path = written("same", format!("<mujoco>\n{inside}\n</mujoco>").as_bytes());
    let mut errors = Errors::default();
    let system = syntax::parse_system(quote!((::newton_euler) Robot { mjcf: #path }), &mut errors);
    let said = errors.finish().as_ref().map(TokenStream::to_string);
    assert_eq!(said, None, "{inside}");
    text::system(&system.expect("a description without mistakes")).to_string()
}

fn check(short: &str, long: &str) {
    assert_eq!(described(short), described(long), "{short}");
}

/// A body on the hinge `j`, a body on the slide `k`, a body that is free, and more.
fn with(more: &str) -> String {
    let second = format!("<body name=\"b\"><joint name=\"k\" type=\"slide\"/>{BALL}</body>");
    let third = format!("<body name=\"c\" pos=\"2 3 4\"><freejoint/>{BALL}</body>");
    format!(
        "{}{more}",
        body(&format!("{BALL}{second}")).replace("</worldbody>", &format!("{third}</worldbody>"))
    )
}

#[test]
fn classes_of_equalities_say_which_are_active() {
    let off = "<default><equality active=\"false\"/><default class=\"on\"><equality active=\"true\"/></default></default>";
    let equality =
        "<joint joint1=\"j\" joint2=\"k\"/><connect body1=\"a\" body2=\"c\" anchor=\"0 0 0\"/>";
    check(
        &with(&format!("{off}<equality>{equality}</equality>")),
        &with(""),
    );
    let own = equality.replace("/>", " active=\"true\"/>");
    let class = equality.replace("/>", " class=\"on\"/>");
    let plain = with(&format!("<equality>{equality}</equality>"));
    for on in [own, class] {
        check(&with(&format!("{off}<equality>{on}</equality>")), &plain);
    }
}

#[test]
fn coefficients_that_are_missing_are_those_by_default() {
    let of = |polynomial: &str| {
        with(&format!(
            "<equality><joint joint1=\"j\" joint2=\"k\" polycoef=\"{polynomial}\"/></equality>"
        ))
    };
    // eq_data: 0.5 1 0 0 0
    check(&of("0.5"), &of("0.5 1 0 0 0"));
    check(&of("0.5 2"), &of("0.5 2 0 0 0"));
    assert_ne!(described(&of("0.5")), described(&of("0.5 0 0 0 0")));
}

#[test]
fn a_weld_has_the_pose_that_it_says() {
    let of = |more: &str| {
        with(&format!(
            "<equality><weld body1=\"b\" body2=\"c\" {more}/></equality>"
        ))
    };
    // without a rotation, a relative pose is ignored, as its default is
    for ignored in ["0 1 0 0 0 0 0", "1 1 0 0 0 0 0", "0 0 0 0.0 0 -0 0"] {
        check(&of(&format!("relpose=\"{ignored}\"")), &of(""));
    }
    // the drawn one; its numbers are exact
    check(&of("relpose=\"2 3 4 1 0 0 0\""), &of(""));
    check(
        &of("relpose=\"2 3 4 2 0 0 0\" torquescale=\"0.3\""),
        &of(""),
    );
    assert_ne!(
        described(&of("relpose=\"0 0 0 1 0 0 0\"")),
        described(&of(""))
    );
    // without torque, only the anchor is held, which is fixed in the second body:
    // eq_data: 1 0 0 of the second and 3 3 4 of the first
    let connect = "<equality><connect body1=\"b\" body2=\"c\" anchor=\"3 3 4\"/></equality>";
    check(&of("anchor=\"1 0 0\" torquescale=\"0.0\""), &with(connect));
    let of_both = of("anchor=\"1 0 0\" relpose=\"3 3 4 1 1 0 0\" torquescale=\"0\"");
    check(&of_both, &with(connect));
}

#[test]
fn numbers_that_an_actuator_leaves_out_are_those_of_its_class() {
    let of = |class: &str, own: &str| {
        let class = format!("<default><general {class}/></default>");
        with(&format!(
            "{class}<actuator><general name=\"g\" joint=\"j\" {own}/></actuator>"
        ))
    };
    let affine = "gaintype=\"affine\" biastype=\"affine\"";
    // actuator_gainprm: 7 2 3; actuator_biasprm: 2 -5 -1
    check(
        &of(
            &format!("{affine} gainprm=\"1 2 3\" biasprm=\"0 -5 -1\""),
            "gainprm=\"7\" biasprm=\"2\"",
        ),
        &of(affine, "gainprm=\"7 2 3\" biasprm=\"2 -5 -1\""),
    );
    check(
        &of("gear=\"2 3\"", "gear=\"5\""),
        &of("", "gear=\"5 3 0 0 0 0\""),
    );
}

/// Actuators of nested classes, the outermost first; the actuator has the innermost.
fn nested(classes: &[&str], actuator: &str) -> String {
    let each = classes.iter().enumerate();
    let open = each.map(|(number, inside)| match number {
        0 => format!("<default>{inside}"),
        _ => format!("<default class=\"c{number}\">{inside}"),
    });
    let open: String = open.collect();
    let close = "</default>".repeat(classes.len());
    let class = match classes.len() {
        0 | 1 => String::new(),
        count => format!("class=\"c{}\"", count - 1),
    };
    let actuator = actuator.replace("/>", &format!(" name=\"g\" joint=\"j\" {class}/>"));
    with(&format!("{open}{close}<actuator>{actuator}</actuator>"))
}

#[test]
fn a_kind_of_actuators_takes_from_classes_what_a_class_of_its_kind_or_general_says() {
    let position = "<position kp=\"3\" kv=\"2\"/>";
    let velocity = "<velocity kv=\"4\"/>";
    let spring = "<general biastype=\"affine\" biasprm=\"1 0 -0.3\"/>";
    // the numbers of MuJoCo 4.0: actuator_gainprm and actuator_biasprm
    let cases: [(&[&str], &str, &str); 20] = [
        (&[position], "<position/>", position),
        (
            &["<motor/><position kp=\"50\"/>"],
            "<position/>",
            "<position kp=\"50\"/>",
        ),
        (
            &["<position kp=\"50\"/><motor/>"],
            "<position/>",
            "<position/>",
        ),
        (&[velocity], "<position/>", "<position/>"),
        (
            &[velocity],
            "<position kp=\"2\" kv=\"3\"/>",
            "<position kp=\"2\" kv=\"3\"/>",
        ),
        (
            &[position, "<motor/>"],
            "<position kp=\"7\"/>",
            "<position kp=\"7\" kv=\"2\"/>",
        ),
        (&[position, velocity], "<position/>", position),
        (&[position, velocity], "<velocity/>", velocity),
        (
            &[spring, "<position kp=\"2.5\"/>"],
            "<position/>",
            "<position kp=\"2.5\" kv=\"0.3\"/>",
        ),
        (&[spring], "<position/>", "<position kp=\"1\" kv=\"0.3\"/>"),
        (
            &[position, "<general/>"],
            "<velocity/>",
            "<velocity kv=\"3\"/>",
        ),
        (
            &[position, "<motor/>", "<general/>"],
            "<position/>",
            "<position/>",
        ),
        (
            &[position, "<general gaintype=\"affine\"/>"],
            "<position/>",
            position,
        ),
        (
            &["<general gaintype=\"affine\" gainprm=\"9 8 -7\"/>"],
            "<velocity/>",
            "<velocity/>",
        ),
        (
            &["<general gaintype=\"affine\" gainprm=\"9 8 -7\"/>"],
            "<damper/>",
            "<damper kv=\"7\"/>",
        ),
        (
            &["<damper kv=\"5\"/>", position],
            "<damper/>",
            "<damper kv=\"5\"/>",
        ),
        (&[position], "<damper/>", "<damper kv=\"0\"/>"),
        (&["<muscle/>"], "<position/>", "<position/>"),
        (
            &[position, "<cylinder area=\"4\"/>"],
            "<position/>",
            position,
        ),
        (&["<position timeconst=\"1\"/>"], "<motor/>", "<motor/>"),
    ];
    for (classes, own, whole) in cases {
        check(&nested(classes, own), &nested(&[], whole));
    }
    // a general actuator has the numbers of the class as they are
    let servo = "<general gainprm=\"3\" biastype=\"affine\" biasprm=\"0 -3 -2\"/>";
    check(&nested(&[position], "<general/>"), &nested(&[], servo));
    let motor = "<general biastype=\"affine\"/>";
    check(&nested(&[position, "<motor/>"], motor), &nested(&[], motor));
    let instant = "<general dyntype=\"filterexact\" dynprm=\"0\"/>";
    check(
        &nested(&[instant], "<position/>"),
        &nested(&[], "<position/>"),
    );
    // what is no part of the law is shared by all kinds
    check(
        &nested(&["<motor gear=\"2 3\"/>", "<velocity/>"], "<motor/>"),
        &nested(&[], "<motor gear=\"2 3\"/>"),
    );
}

#[test]
fn a_rotation_replaces_that_of_the_class() {
    let of = |class: &str, own: &str| {
        let class = format!("<default><geom {class}/></default>");
        let geom = format!("<geom type=\"box\" size=\"1 2 3\" mass=\"1\" {own}/>");
        format!("{class}{}", body(&geom))
    };
    let all = [
        "quat=\"1 1 0 0\"",
        "euler=\"10 20 0\"",
        "axisangle=\"1 0 0 5\"",
        "zaxis=\"0 1 0\"",
        "xyaxes=\"1 0 0 0 0 1\"",
    ];
    for class in all {
        for own in all {
            check(&of(class, own), &of("", own));
        }
        check(&of(class, "quat=\"1 0 0 0\""), &of("", ""));
    }
}

#[test]
fn sizes_that_a_geom_leaves_out_are_those_of_its_class() {
    let of = |class: &str, size: &str| {
        let class = format!("<default><geom type=\"box\" size=\"{class}\"/></default>");
        format!(
            "{class}{}",
            body(&format!("<geom mass=\"1\" size=\"{size}\"/>"))
        )
    };
    // geom_size: 0.5 2 3
    check(&of("1 2 3", "0.5"), &of("1 1 1", "0.5 2 3"));
}

#[test]
fn lengths_of_springs_are_compared_as_numbers() {
    let of = |length: &str| {
        let hinge = body(BALL).replace("name=\"j\"", "name=\"j\" springref=\"20\"");
        format!(
            "{hinge}<tendon><fixed stiffness=\"2\" {length}><joint joint=\"j\" coef=\"1\"/></fixed></tendon>"
        )
    };
    // tendon_lengthspring: the length at which the joint's spring is at rest
    for rest in ["-1", "-1.0", "-1e0 -1", "-1 -1.00"] {
        check(&of(&format!("springlength=\"{rest}\"")), &of(""));
    }
    check(
        &of("springlength=\"0.3 0.30\""),
        &of("springlength=\"0.3\""),
    );
}

#[test]
fn geoms_of_groups_that_have_mass_count() {
    let geoms = |range: &str, all: &[(&str, &str)]| {
        let of =
            |(mass, more): &(&str, &str)| format!("<geom size=\"0.1\" mass=\"{mass}\" {more}/>");
        let all: String = all.iter().map(of).collect();
        format!(
            "<default><geom group=\"4\"/></default><compiler {range}/>{}",
            body(&all)
        )
    };
    // body_mass: 11
    let three = [("1", ""), ("5", "group=\"2\""), ("10", "group=\"3\"")];
    check(
        &geoms("inertiagrouprange=\"3 4\"", &three),
        &geoms("", &[("1", ""), ("10", "")]),
    );
    check(
        &geoms("inertiagrouprange=\"0 5\"", &three),
        &geoms("", &three),
    );
}

#[test]
fn mass_properties_remain_where_no_geom_has_mass() {
    let of = |settings: &str, geoms: &str| {
        let inertial = "<inertial pos=\"0.3 0 0\" mass=\"5\" diaginertia=\"1 1 1\"/>";
        format!(
            "<compiler {settings}/>{}",
            body(&format!("{inertial}{geoms}"))
        )
    };
    let from_geoms = "inertiafromgeom=\"true\" inertiagrouprange=\"0 1\"";
    let (light, other) = (
        "<geom size=\"0.1\" mass=\"0\"/>",
        "<geom size=\"0.1\" group=\"3\"/>",
    );
    // body_mass: 5
    for geoms in ["", light, other] {
        check(&of(from_geoms, geoms), &of("", ""));
    }
    let heavy = "<geom size=\"0.1\" mass=\"2\"/>";
    check(&of(from_geoms, heavy), &body(heavy));
}

#[test]
fn settings_of_the_solver_change_nothing() {
    let settings = "<compiler settotalmass=\"-1.0\" boundmass=\"0.0\"><lengthrange timestep=\"1\"/></compiler>\
        <option timestep=\"0.1\" wind=\"0 0.0 -0\" actuatorgroupdisable=\"\"><flag spring=\"enable\" sleep=\"disable\"/></option>";
    check(&with(settings), &with(""));
}
